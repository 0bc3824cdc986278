#pragma once
#include <string>
#include <string_view>

namespace gapcheck::app::lsp {

/// The path of a file: URI, with %20 and the like decoded. Empty: another scheme, another machine, or a NUL in it.
[[nodiscard]] std::string path_of(std::string_view uri);

/// The URI of a path; relative ones start from the working folder.
[[nodiscard]] std::string uri_of(const std::string& path);

/// The path without links, `.` and `..`, whether or not there is such a file.
[[nodiscard]] std::string canonical(const std::string& path);

}  // namespace gapcheck::app::lsp
