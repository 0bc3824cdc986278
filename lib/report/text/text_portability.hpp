#pragma once
#include <cstddef>
#include <string>

#include "records/report.hpp"

namespace gapcheck::report {

/// What of the contacts other programs do not read: one line each, at most `limit` of them and the number of the
/// others. Nothing if it was not asked for.
void append_portability(const Report& report, std::size_t limit, std::string& out);

}  // namespace gapcheck::report
