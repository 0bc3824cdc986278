#pragma once
#include <cstddef>

#include "records/report.hpp"

namespace gapcheck::audit {

struct AuditOptions;

/// Moves those of the findings from position `first` on, which are of the rules on ignores, into `report.ignored` that
/// entries of `options.ignores` leave out: they are about comments of the deck. What is said of the entries themselves
/// stays.
void leave_out_reviews(Report& report, std::size_t first, const AuditOptions& options);

}  // namespace gapcheck::audit
