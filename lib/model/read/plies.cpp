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

double read_plies(CardReader& reader, const CardLayout& element, bool one_per_line) {
  static const CardLayout plies = [] {
    CardLayout layout = id_and_reals(IdKind::material, 7);
    layout.fields[4].type = FieldType::integer;
    return layout;
  }();
  double sum = 0;
  while (!reader.at_end() && !at_element(reader, element)) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(plies);
    sum += card.real(1);
    if (!one_per_line) sum += card.real(5);
  }
  return sum;
}

}  // namespace gapcheck::model
