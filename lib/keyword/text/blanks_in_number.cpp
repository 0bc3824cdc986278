#include "keyword/text/blanks_in_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "base/number.hpp"

namespace gapcheck::keyword {
namespace {

constexpr std::string_view between = " \t";

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t begin = text.find_first_not_of(between); begin != std::string_view::npos;
       begin = text.find_first_not_of(between, begin)) {
    const std::size_t end = std::min(text.find_first_of(between, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

/// Or names of parameters, which stand for numbers.
bool all_numbers(const std::vector<std::string_view>& words) {
  return std::all_of(words.begin(), words.end(), [](std::string_view word) {
    return parse_real(word).has_value() || word.starts_with('&') || word.starts_with("-&");
  });
}

std::string columns_of(const NumberField& field) {
  return fmt::format("columns {} to {}", field.column + 1, field.column + field.width);
}

/// If the line has a number for each of its first fields, the one that belongs to this field.
std::string number_in_order(const NumberField& field) {
  const std::vector<std::string_view> words = words_of(field.line);
  if (words.size() > field.fields || field.position >= words.size() || !all_numbers(words)) return "";
  return fmt::format("; number {} of the line is {}, which is probably meant", field.position + 1,
                     words[field.position].substr(0, 40));
}

}  // namespace

std::string about_blanks(const NumberField& field) {
  const std::vector<std::string_view> words = words_of(field.text);
  if (words.size() < 2) return "";
  const std::string text(field.text.substr(0, 80));
  if (all_numbers(words)) {
    if (field.free_format)
      return fmt::format("\"{}\" is {} numbers without a comma between them; add it", text, words.size());
    return fmt::format(
        "\"{}\" is {} numbers in one field ({}): the numbers of the line do not stand in their columns{}; "
        "move them",
        text, words.size(), columns_of(field), number_in_order(field));
  }
  std::string joined;
  for (const std::string_view word : words) joined += word;
  if (!parse_real(joined)) return "";
  return fmt::format("\"{}\" has blanks inside; probably {} is meant; remove them", text, joined.substr(0, 40));
}

bool only_zeros(std::string_view text) {
  const std::vector<std::string_view> words = words_of(text);
  return words.size() > 1 && std::all_of(words.begin(), words.end(), [](std::string_view word) {
           const std::optional<double> number = parse_real(word);
           return number && *number == 0;
         });
}

std::string marked_line(const NumberField& field) {
  constexpr std::size_t most = 160;
  std::string line;
  std::size_t begin = field.column, end = field.column + field.width;
  const auto text_at = static_cast<std::size_t>(field.text.data() - field.line.data());
  for (std::size_t i = 0; i < field.line.size(); ++i) {
    if (field.free_format && i == text_at) begin = line.size();
    if (field.line[i] == '\t')
      line.resize((line.size() / 8 + 1) * 8, ' ');
    else
      line += field.line[i];
    if (field.free_format && i + 1 == text_at + field.text.size()) end = line.size();
  }
  const std::size_t cut = end > most ? end - most : 0;
  line = line.substr(std::min(cut, line.size()), most);
  return line + "\n" + std::string(begin - std::min(begin, cut), ' ') + std::string(std::min(end - begin, most), '^');
}

}  // namespace gapcheck::keyword
