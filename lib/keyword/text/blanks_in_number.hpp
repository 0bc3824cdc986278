#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace gapcheck::keyword {

/// A field that should be one number, as a line has it.
struct NumberField {
  std::string_view line, text;  ///< text: of the field, trimmed, in the line
  std::size_t position = 0;     ///< among the fields of its card, from 0
  std::size_t fields = 0;       ///< of the card
  std::size_t column = 0, width = 0;
  bool free_format = false;
};

/// What is likely meant by a field with blanks inside; empty if it has none.
[[nodiscard]] std::string about_blanks(const NumberField& field);

/// Whether a field is several numbers, all of them 0, so that it is 0 however its blanks are read.
[[nodiscard]] bool only_zeros(std::string_view text);

/// The line, and below it marks under the field. Long lines are cut to the part around it.
[[nodiscard]] std::string marked_line(const NumberField& field);

}  // namespace gapcheck::keyword
