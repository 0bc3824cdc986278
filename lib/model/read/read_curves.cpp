#include <fmt/format.h>

#include "model/read/context.hpp"

namespace gapcheck::model {

void read_curve(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("TITLE")) reader.skip();
  const auto& head = keyword::card_layout("DEFINE_CURVE", "card1");
  const auto& pair = keyword::card_layout("DEFINE_CURVE", "card2");
  if (reader.at_end()) {
    context.error(Context::place(block, block.line), "the curve's card is missing");
    return;
  }
  const Card card = reader.next(head);
  const std::int64_t id = card.integer("lcid");
  Curve curve;
  curve.place = Context::place(block, card.line());
  curve.abscissa_time = context.transform(block).time_factor;
  curve.relaxation = card.integer("sidr");
  const auto or_one = [](double scale) { return scale == 0 ? 1 : scale; };
  const double sfa = or_one(card.real("sfa")), sfo = or_one(card.real("sfo"));
  const double offa = card.real("offa"), offo = card.real("offo");
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card point = reader.next(pair);
    curve.points.push_back({sfa * (point.real("a1") + offa), sfo * (point.real("o1") + offo)});
  }
  if (id <= 0) {
    context.bad_id(curve.place, fmt::format("curve id {} is not positive; the curve is left out", id));
    return;
  }
  if (!context.waiting_rows.empty()) {
    const auto [table, row] = context.waiting_rows.back();
    context.model.tables.at(table).rows[row].curve = id;
    context.waiting_rows.pop_back();
  }
  const Place again = curve.place;
  const auto [entry, is_new] = context.model.curves.try_emplace(id, std::move(curve));
  if (!is_new) context.duplicate("curve", id, entry->second.place, again);
}

void read_table(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("TITLE")) reader.skip();
  if (reader.at_end()) {
    context.error(Context::place(block, block.line), "the table's card is missing");
    return;
  }
  const bool names_curves = options.has("2D");
  const Card card = reader.next(keyword::card_layout("DEFINE_TABLE", "card1"));
  const std::int64_t id = card.integer("tbid");
  const double scale = card.real("sfa") == 0 ? 1 : card.real("sfa"), offset = card.real("offa");
  Table table;
  table.place = Context::place(block, card.line());
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card row = reader.next(keyword::card_layout("DEFINE_TABLE", "card2"));
    table.rows.push_back({scale * (row.real("value") + offset), names_curves ? row.integer("curve") : 0});
  }
  context.waiting_rows.clear();
  if (id <= 0) {
    context.bad_id(table.place, fmt::format("table id {} is not positive; the table is left out", id));
    return;
  }
  const Place again = table.place;
  const auto [entry, is_new] = context.model.tables.try_emplace(id, std::move(table));
  if (!is_new) return context.duplicate("table", id, entry->second.place, again);
  for (std::size_t row = entry->second.rows.size(); !names_curves && row > 0; --row)
    context.waiting_rows.emplace_back(id, row - 1);
}

}  // namespace gapcheck::model
