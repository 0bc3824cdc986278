#pragma once
#include <cstddef>
#include <string>

#include "records/report.hpp"

namespace gapcheck::report {

/// What is new, worse or gone compared with the baseline, the first `top` of each; nothing without a baseline.
void append_baseline(const Report& report, std::size_t top, std::string& out);

}  // namespace gapcheck::report
