#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "keyword/card.hpp"

namespace gapcheck::keyword {

/// A finite number as text of at most `width` characters (0: as many as it needs) that reads back as the nearest number
/// expressible in that many characters. Empty: not even one digit fits, or the number is not finite.
[[nodiscard]] std::string number_text(double value, std::size_t width);

/// An error if the number in a field of a line cannot be replaced by another one: a parameter, tabs in fixed columns, a
/// line that was cut off. A blank field can.
[[nodiscard]] Status check_replaceable(const Card& card, std::size_t field);

/// The card's line with another number in one of its fields; all other characters stay. Fixed columns: right-aligned in
/// the field, with as many digits as fit after one blank; free format: all digits, between the same commas and blanks.
/// Lines that end before the field are extended. Only if check_replaceable() succeeds; a number that does not fit at
/// all leaves the line unchanged.
[[nodiscard]] std::string with_number(const Card& card, std::size_t field, double value);

/// The same with any text that a field can hold; trimmed. Unchanged if the text is wider than the field.
[[nodiscard]] std::string with_text(const Card& card, std::size_t field, std::string_view text);

/// A line of a card with some of its fields, in the format of a block; the other fields are blank.
[[nodiscard]] std::string card_line(const CardLayout& layout, Format format,
                                    std::span<const std::pair<std::string_view, std::string>> fields);

/// Finds the lines of a file by number. The bytes must outlive it. 8 bytes per line.
class LineIndex {
 public:
  explicit LineIndex(std::string_view bytes);
  [[nodiscard]] std::size_t size() const { return starts_.size(); }
  /// From 1, without its line end (`\n` or `\r\n`); empty where there is no such line.
  [[nodiscard]] std::string_view line(std::uint32_t number) const;

 private:
  std::string_view bytes_;
  std::vector<std::size_t> starts_;
};

/// Another text for one line, or several lines in its place.
struct LineEdit {
  std::uint32_t line = 0;  ///< from 1
  std::string text;        ///< without the last line end; `\n` between lines becomes the line end of the file
};

/// The file's bytes with some lines replaced; line ends and everything else stay byte for byte. `edits`: ascending by
/// line, at most one for each; lines that the file does not have are skipped.
[[nodiscard]] std::string with_lines(std::string_view bytes, const LineIndex& index, std::span<const LineEdit> edits);

}  // namespace gapcheck::keyword
