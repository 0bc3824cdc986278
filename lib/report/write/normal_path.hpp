#pragma once
#include <string>
#include <string_view>

namespace gapcheck::report {

/// The path as used by programs that compare it with the files of a repository: "models/../common/./mesh.inc" is
/// "common/mesh.inc". Links are not followed.
[[nodiscard]] std::string normal_path(std::string_view path);

}  // namespace gapcheck::report
