#include "keyword/template_fields.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/number.hpp"
#include "keyword/card.hpp"
#include "keyword/write_back.hpp"

namespace gapcheck::keyword {
namespace {

constexpr std::string_view opening = "<<", closing = ">>";
/// No card is wider; keeps a hostile width from filling the memory.
constexpr std::size_t most_columns = 160;

/// What stands between `<<` and `>>`.
struct TemplateField {
  std::string_view expression;
  std::size_t width = 0;  ///< 0: not given
  bool whole = false;
};

TemplateField template_field(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return {trimmed(text)};
  std::string_view format = text.substr(colon + 1);
  const bool whole = format.starts_with('i') || format.starts_with('I');
  if (whole) format.remove_prefix(1);
  const auto width =
      format.find_first_not_of("0123456789") == std::string_view::npos ? parse_integer(format) : std::nullopt;
  if (!width || *width < 1) return {trimmed(text)};
  return {trimmed(text.substr(0, colon)), std::min(static_cast<std::size_t>(*width), most_columns), whole};
}

class TemplateFields {
 public:
  TemplateFields(const Deck& deck, const Block& block, Diagnostics& diagnostics)
      : deck_(deck), block_(block), diagnostics_(diagnostics), line_(block.line) {}

  std::string replace_all() {
    std::string_view rest = block_.body;
    text_.reserve(rest.size());
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
      ++line_;
      replace(rest.substr(0, end));
      rest.remove_prefix(end);
    }
    return std::move(text_);
  }

 private:
  void replace(std::string_view line) {
    for (std::size_t begin = line.starts_with('$') ? std::string_view::npos : line.find(opening);
         begin != std::string_view::npos; begin = line.find(opening)) {
      const std::size_t end = line.find(closing, begin + opening.size());
      if (end == std::string_view::npos) break;
      const std::string_view inside = line.substr(begin + opening.size(), end - begin - opening.size());
      const std::size_t behind = end + closing.size();
      if (trimmed(inside).empty() || trimmed(inside).find_first_of(" \t") != std::string_view::npos) {
        text_ += line.substr(0, behind);
        line.remove_prefix(behind);
        continue;
      }
      text_ += line.substr(0, begin);
      line.remove_prefix(behind);
      put(template_field(inside), behind - begin, line);
    }
    text_ += line;
  }

  /// The value of a field; where it needs more columns than the field had, blanks behind it make room.
  void put(const TemplateField& field, std::size_t columns, std::string_view& behind) {
    const std::size_t width = field.width > 0 ? field.width : columns;
    const std::string value = value_of(field);
    if (value.size() < width) text_.append(width - value.size(), ' ');
    text_ += value;
    if (field.width > 0) return;
    for (std::size_t more = value.size(); more > width && behind.starts_with(' '); --more) behind.remove_prefix(1);
  }

  std::string value_of(const TemplateField& field) {
    const std::string* given = is_plain_name(field.expression) ? deck_.parameters().given(field.expression) : nullptr;
    if (given != nullptr && !field.whole) {
      const auto number = parse_real(*given);
      return number && field.width > 0 && given->size() > field.width ? in_columns(*number, field.width) : *given;
    }
    Parameters::Missing missing;
    const auto value = deck_.parameters().evaluate(field.expression, block_.scope, block_.order, &missing);
    if (value) return field.whole ? whole(value.value(), field.width) : in_columns(value.value(), field.width);
    const std::string& file = deck_.file(block_.file).path;
    if (missing.name.empty())
      diagnostics_.error(file, line_, "*" + block_.name + ", template field: " + value.error().message);
    else if (!missing.told)
      report_missing_parameter(missing.name, file, line_, "*" + block_.name, diagnostics_);
    return "&" + std::string(unread_parameter);
  }

  static std::string whole(double value, std::size_t width) {
    const double nearest = std::round(value);
    return std::abs(nearest) < 1e15 ? std::to_string(static_cast<long long>(nearest)) : in_columns(nearest, width);
  }

  static std::string in_columns(double value, std::size_t width) {
    const std::string text = number_text(value, width);
    return text.empty() ? number_text(value, 0) : text;
  }

  const Deck& deck_;
  const Block& block_;
  Diagnostics& diagnostics_;
  std::uint32_t line_;
  std::string text_;
};

}  // namespace

std::string with_template_fields(const Deck& deck, const Block& block, Diagnostics& diagnostics) {
  return TemplateFields(deck, block, diagnostics).replace_all();
}

}  // namespace gapcheck::keyword
