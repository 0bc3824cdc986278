#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"

namespace gapcheck::app {

/// Writes a whole file; the error that stopped it, if there was one.
std::optional<Diagnostic> write_file(const std::string& path, std::string_view text);

/// The same, but whatever happens the file is either as it was or as it should be: it is written beside and renamed.
std::optional<Diagnostic> replace_file(const std::string& path, std::string_view text);

/// "PROGRAM: error: FILE:LINE: message\n"; empty file and line 0 are left out, control characters become '?'.
[[nodiscard]] std::string line_of(std::string_view program, const Diagnostic& diagnostic);

}  // namespace gapcheck::app
