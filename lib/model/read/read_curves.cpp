#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// A curve over time that begins later is zero before: two points lead to 0.999 of the offset, from where it rises to
/// the first value (S. Bala, "Curve offset in LS-DYNA", 2008).
void add_start(double offset, Curve& curve) {
  constexpr double zero_until = 0.999;
  curve.points.push_back({0, 0});
  curve.points.push_back({zero_until * offset, 0});
}

/// Keeps the curve; a table that waits for one takes it.
void keep(Context& context, std::int64_t id, Curve curve) {
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

/// The time at which a smooth curve ends, and its height; false: its fields do not say.
struct Smooth {
  double start = 0, end = 0, rise = 0, most = 0;
  [[nodiscard]] bool good() const {
    return std::isfinite(most) && std::isfinite(end) && rise >= 0 && end - start >= 2 * rise && end > start;
  }
};

/// Half a cosine up, level, half a cosine down, over the times of the card. The area is DIST: VMAX (end - start -
/// rise).
void add_smooth_points(const Smooth& shape, Curve& curve) {
  constexpr int pieces = 50;
  const auto half = [&](double from, double low, double high) {
    for (int i = 0; i <= pieces; ++i) {
      const double share = static_cast<double>(i) / pieces;
      const double height = low + (high - low) * (1 - std::cos(share * std::numbers::pi)) / 2;
      curve.points.push_back({from + share * shape.rise, height});
    }
  };
  half(shape.start, 0, shape.most);
  half(shape.end - shape.rise, shape.most, 0);
}

}  // namespace

void read_smooth_curve(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("TITLE")) reader.skip();
  const Card card = reader.next(keyword::card_layout("DEFINE_CURVE_SMOOTH", "card1"));
  Curve curve;
  curve.place = Context::place(block, card.line());
  curve.abscissa_time = context.transform(block).time_factor;
  curve.relaxation = card.integer("sidr");
  const double distance = card.real("dist");
  Smooth shape{card.real("tstart"), card.real("tend"), card.real("trise"), card.real("vmax")};
  // One of TEND and VMAX follows from DIST.
  if (shape.end == 0 && shape.most != 0) shape.end = shape.start + shape.rise + distance / shape.most;
  if (shape.most == 0) shape.most = distance / (shape.end - shape.start - shape.rise);
  if (!shape.good())
    return context.error(curve.place, fmt::format("curve {}: DIST {:g}, TSTART {:g}, TEND {:g}, TRISE {:g} and VMAX "
                                                  "{:g} make no curve",
                                                  card.integer("lcid"), distance, shape.start, card.real("tend"),
                                                  shape.rise, card.real("vmax")));
  add_smooth_points(shape, curve);
  keep(context, card.integer("lcid"), std::move(curve));
}

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
  curve.discretization = card.integer("lcint");
  const bool over_time = card.integer("dattyp") == 0;
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card point = reader.next(pair);
    if (curve.points.empty() && over_time && offa > 0 && point.real("a1") >= 0) add_start(sfa * offa, curve);
    curve.points.push_back({sfa * (point.real("a1") + offa), sfo * (point.real("o1") + offo)});
  }
  keep(context, id, std::move(curve));
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
