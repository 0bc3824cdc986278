#pragma once
#include <cstddef>
#include <string>

#include "records/start.hpp"

namespace gapcheck::report {

/// Appends what will meet along straight lines, one line for each contact and two parts, the worst first; nothing if
/// nothing moves. `top`: as many lines of each list.
void append_expected(const StartReport& report, std::size_t top, std::string& out);

}  // namespace gapcheck::report
