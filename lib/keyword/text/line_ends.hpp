#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace gapcheck::keyword {

/// A line without the CRs at its end: one of CR LF, more where a file was converted twice.
[[nodiscard]] inline std::string_view without_returns(std::string_view line) {
  while (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Where a keyword line or a comment holds a line break that is neither LF nor CR LF, so that what follows would be
/// lost: CR, U+0085, U+2028 or U+2029; npos: nowhere. In comments the last three count only in front of `*` and `$`,
/// since they may be part of the text.
[[nodiscard]] std::size_t foreign_break(std::string_view line);

/// What most lines at the beginning of a file end with, if that is neither LF nor CR LF: "CR alone", "U+2028"; empty
/// for all others.
[[nodiscard]] std::string foreign_line_ends(std::string_view bytes);

/// "has lines that end with CR alone; …": what is wrong with such a file, and what to do.
[[nodiscard]] std::string about_line_ends(std::string_view ends);

}  // namespace gapcheck::keyword
