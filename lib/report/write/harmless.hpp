#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace gapcheck::report {

/// Bytes of the UTF-8 character that the text starts with, if it is not ASCII; 0 if it is none or not allowed in XML.
[[nodiscard]] std::size_t wide_character(std::string_view text);

/// True for the characters U+0080 to U+009F, two bytes each: terminals obey them like escape sequences.
[[nodiscard]] bool is_wide_control(std::string_view character);

/// Text of a deck made safe for a terminal and for the logs of CI services: control characters, also U+0080 to U+009F,
/// line separators and marks that turn the direction of writing become '?'; so does the first character of what would
/// be a command where it begins a line ("::error") or wherever it stands ("##[error]").
[[nodiscard]] std::string printable(std::string_view text);

/// A path that begins neither a command of a CI service nor a formula of a spreadsheet: "./::error", "./=1+2".
[[nodiscard]] std::string harmless_path(std::string_view path);

/// printable() of a path, which still names the file where that is possible.
[[nodiscard]] std::string printable_path(std::string_view path);

}  // namespace gapcheck::report
