#include "model/read/plies.hpp"

#include "base/number.hpp"

namespace gapcheck::model {
namespace {

/// Whether a text may be in an integer field of an element's line.
bool names_something(std::string_view text) {
  if (keyword::is_parameter_reference(text)) return true;
  const auto number = parse_integer(text);
  return number && *number > 0;
}

bool at_element(const CardReader& reader, const CardLayout& line) {
  const Card card = reader.peek(line);
  for (std::size_t i = 0; i < 5; ++i)
    if (!names_something(card.text(i))) return false;
  return true;
}

}  // namespace

const CardLayout& ply_line() {
  static const CardLayout line = [] {
    CardLayout layout = id_and_reals(IdKind::material, 7);
    layout.fields[3].type = layout.fields[4].type = layout.fields[7].type = FieldType::integer;
    layout.fields[4].id = IdKind::material;
    return layout;
  }();
  return line;
}

ElementPlies read_plies(CardReader& reader, const CardLayout& element, bool one_per_line) {
  ElementPlies result;
  while (!reader.at_end() && !at_element(reader, element)) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(ply_line());
    for (const std::size_t first : {std::size_t{0}, std::size_t{4}}) {
      const double thickness = card.real(first + 1);
      if (first > 0 && (one_per_line || thickness == 0)) break;
      result.plies.push_back({card.integer(first), thickness, std::nullopt});
      result.thickness += thickness;
    }
  }
  return result;
}

}  // namespace gapcheck::model
