#pragma once
#include <cstddef>
#include <string>

#include "records/report.hpp"

namespace gapcheck::report {

/// How many findings were left out on purpose, and one line for each of the first `top` comments or settings that did
/// it; `list`: all of them, with their findings. Nothing if there are none.
void append_ignored(const Report& report, std::size_t top, bool list, std::string& out);

}  // namespace gapcheck::report
