#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace gapcheck::keyword {

/// A line that structures a file: one that starts with `*`, or the first or last line of an encrypted block; or a
/// comment for gapcheck; or a keyword or comment with a line break in it that is no line end (line_ends.hpp), beside
/// its other mark; or a line of data with `<<`.
struct Mark {
  enum class Kind : std::uint8_t {
    keyword,
    encrypted_begin,
    encrypted_end,
    directive,
    foreign_break,
    template_field
  } kind = Kind::keyword;
  std::uint32_t line = 0;  ///< from 1
  std::size_t offset = 0;  ///< of the line's first character
};

/// All marks of a file in order, found in parallel; the result does not depend on the number of threads.
std::vector<Mark> find_marks(std::string_view bytes);

/// The text after `$ gapcheck:` in a line; blanks before the name and its case do not matter. Nothing in other lines.
std::optional<std::string_view> directive_text(std::string_view line);

/// The line that starts at `offset`, without its line end (LF, CR LF, CR CR LF); `next` is where the following line
/// starts.
std::string_view line_at(std::string_view bytes, std::size_t offset, std::size_t& next);

}  // namespace gapcheck::keyword
