#pragma once
#include <cstddef>

#include "records/report.hpp"

namespace gapcheck::audit {

struct AuditOptions;

/// Moves findings from position `first` on (of the rules on ignores) into `report.ignored` if entries of
/// `options.ignores` leave them out: these are about comments of the deck. Findings about the entries themselves stay.
void leave_out_reviews(Report& report, std::size_t first, const AuditOptions& options);

}  // namespace gapcheck::audit
