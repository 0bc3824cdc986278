#include "model/read/cards.hpp"

#include <string>

namespace gapcheck::model {
namespace {

void add_field(CardLayout& layout, std::string name, std::uint16_t width, FieldType type, IdKind kind) {
  const std::uint16_t column =
      layout.fields.empty() ? std::uint16_t{0}
                            : static_cast<std::uint16_t>(layout.fields.back().column + layout.fields.back().width);
  layout.fields.push_back({std::move(name), column, width, type, kind});
}

}  // namespace

const CardLayout& text_line() {
  static const CardLayout layout{"title", {{"title", 0, 80, FieldType::text, IdKind::plain}}};
  return layout;
}

CardLayout element_line(std::size_t nodes) {
  CardLayout layout{"element", {}};
  add_field(layout, "eid", 8, FieldType::integer, IdKind::element);
  add_field(layout, "pid", 8, FieldType::integer, IdKind::part);
  for (std::size_t i = 1; i <= nodes; ++i)
    add_field(layout, "n" + std::to_string(i), 8, FieldType::integer, IdKind::node);
  return layout;
}

CardLayout id_line(std::size_t count, std::uint16_t width, IdKind kind) {
  CardLayout layout{"ids", {}};
  for (std::size_t i = 1; i <= count; ++i) add_field(layout, "id" + std::to_string(i), width, FieldType::integer, kind);
  return layout;
}

CardLayout real_line(std::size_t count, std::uint16_t width) {
  CardLayout layout{"values", {}};
  for (std::size_t i = 1; i <= count; ++i)
    add_field(layout, "value" + std::to_string(i), width, FieldType::real, IdKind::plain);
  return layout;
}

CardLayout id_and_reals(IdKind kind, std::size_t reals) {
  CardLayout layout{"id_and_values", {}};
  add_field(layout, "id", 10, FieldType::integer, kind);
  for (std::size_t i = 1; i <= reals; ++i)
    add_field(layout, "value" + std::to_string(i), 10, FieldType::real, IdKind::plain);
  return layout;
}

}  // namespace gapcheck::model
