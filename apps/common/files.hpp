#pragma once
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "base/result.hpp"

namespace gapcheck::app {

/// Writes a whole file.
Status write_file(const std::string& path, std::string_view text);

/// The same, but atomic: the file is either unchanged or complete; it is written under another name and renamed.
Status replace_file(const std::string& path, std::string_view text);

/// "PROGRAM: error: FILE:LINE: message\n"; empty file and line 0 are left out, control characters become '?'.
[[nodiscard]] std::string line_of(std::string_view program, const Diagnostic& diagnostic);

}  // namespace gapcheck::app
