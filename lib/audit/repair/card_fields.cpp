#include "audit/repair/card_fields.hpp"

#include <fmt/format.h>

#include "keyword/write_back.hpp"

namespace gapcheck::audit {

const keyword::Block* CardFields::block(const model::Place& place) const {
  const keyword::Block* found = nullptr;
  for (const keyword::Block& block : deck_.blocks())
    if (block.file == place.file && block.line <= place.line && (found == nullptr || block.line > found->line))
      found = &block;
  return found;
}

Status CardFields::check(const keyword::Block& block) const {
  const model::Place place{block.file, block.line};
  if (const Status status = edits_.check(block.file); !status.ok()) return error(place, status.error().message);
  if (block.transform.value != 0) return error(place, "its include has a transformation");
  return {};
}

keyword::Card CardFields::card_at(const keyword::Block& block, std::uint32_t line, const keyword::CardLayout& layout) {
  return {deck_, block, layout, edits_.line(block.file, line), line, ignored_};
}

std::string CardFields::written(const keyword::Block& block, std::uint32_t line, const keyword::CardLayout& layout,
                                std::string_view field) {
  return std::string(card_at(block, line, layout).written(layout.index(field)));
}

Status CardFields::set(const keyword::Block& block, std::uint32_t line, const keyword::CardLayout& layout,
                       std::string_view field, double value) {
  const keyword::Card card = card_at(block, line, layout);
  const std::size_t index = layout.index(field);
  if (Status status = keyword::check_replaceable(card, index); !status.ok())
    return error({block.file, line}, status.error().message);
  edits_.replace(block.file, line, keyword::with_number(card, index, value));
  return {};
}

Status CardFields::set_text(const keyword::Block& block, std::uint32_t line, const keyword::CardLayout& layout,
                            std::string_view field, std::string_view text, bool moves) {
  const keyword::Card card = card_at(block, line, layout);
  const std::size_t index = layout.index(field);
  const bool parameter = moves && keyword::is_parameter_reference(card.written(index));
  if (Status status = keyword::check_replaceable(card, index); !status.ok() && !parameter)
    return error({block.file, line}, status.error().message);
  edits_.replace(block.file, line, keyword::with_text(card, index, text));
  return {};
}

std::string CardFields::card(const keyword::Block& block, const keyword::CardLayout& layout,
                             std::span<const std::pair<std::string_view, double>> values) {
  std::vector<std::pair<std::string_view, std::string>> fields;
  for (const auto& [field, value] : values) {
    const std::size_t width = keyword::locate(layout, block.format, layout.index(field)).width;
    fields.emplace_back(field, keyword::number_text(value, width - 1));
  }
  return keyword::card_line(layout, block.format, fields);
}

Diagnostic CardFields::error(const model::Place& place, const std::string& what) const {
  return {Severity::error, place.file.value < deck_.files().size() ? deck_.file(place.file).path : "", place.line,
          what};
}

}  // namespace gapcheck::audit
