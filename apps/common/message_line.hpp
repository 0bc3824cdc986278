#pragma once
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"

namespace gapcheck::app {

/// "PROGRAM: error: FILE:LINE: message\n"; empty file and line 0 are left out, control characters become '?'.
[[nodiscard]] std::string line_of(std::string_view program, const Diagnostic& diagnostic);

}  // namespace gapcheck::app
