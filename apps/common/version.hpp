#pragma once
#include <string>
#include <string_view>

namespace gapcheck::app {

/// "0.1.0"
[[nodiscard]] std::string_view version();

/// What --version prints: "PROGRAM 0.1.0 (commit 0123456789ab, g++ 12.2.0, CGAL 5.5.1, Release)".
[[nodiscard]] std::string version_line(std::string_view program);

}  // namespace gapcheck::app
