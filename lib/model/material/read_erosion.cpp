#include <fmt/format.h>

#include <array>

#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// Zero stands for "not given" here whatever EXCL says, for the sake of decks that are older than the field.
std::optional<double> newer_field(const Card& card, std::string_view name, double exclusion) {
  const double value = card.real(name);
  return value == exclusion || value == 0 ? std::nullopt : std::optional(value);
}

std::optional<double> field(const Card& card, std::string_view name, double exclusion) {
  const double value = card.real(name);
  return value == exclusion ? std::nullopt : std::optional(value);
}

void scale(std::optional<double>& value, double factor) {
  if (value) *value *= factor;
}

/// What cards 3 and later ask for.
std::string first_unread(CardReader& reader) {
  constexpr std::array<std::string_view, 8> names{"IDAM",   "DMGTYP", "LCSDG",  "ECRIT",
                                                  "DMGEXP", "DCRIT",  "FADEXP", "LCREGD"};
  static const CardLayout eight = real_line(8, 10);
  for (std::size_t number = 3; !reader.at_end(); ++number) {
    const Card card = reader.next(eight);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (const double value = card.real(i); value != 0)
        return number == 3 ? fmt::format("{} = {:g}", names[i], value)
                           : fmt::format("field {} of card {} = {:g}", i + 1, number, value);
  }
  return "";
}

}  // namespace

void read_erosion(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("TITLE")) reader.skip();
  const Place start = Context::place(block, block.line);
  if (reader.at_end()) {
    context.warning(start, fmt::format("*{} has no card; it is left out", block.name));
    return;
  }
  const Card first = reader.next(keyword::card_layout("MAT_ADD_EROSION", "card1"));
  Erosion erosion;
  erosion.place = Context::place(block, first.line());
  erosion.material_id = first.integer("mid");
  const double exclusion = first.real("excl");
  erosion.mxpres = newer_field(first, "mxpres", exclusion);
  erosion.mneps = newer_field(first, "mneps", exclusion);
  erosion.effeps = newer_field(first, "effeps", exclusion);
  erosion.voleps = newer_field(first, "voleps", exclusion);
  if (const double points = first.real("numfip"); points != 0) erosion.numfip = points;
  if (const double criteria = first.real("ncs"); criteria != 0) erosion.ncs = criteria;
  const Card second = reader.next(keyword::card_layout("MAT_ADD_EROSION", "card2"));
  erosion.mnpres = field(second, "mnpres", exclusion);
  erosion.sigp1 = field(second, "sigp1", exclusion);
  erosion.sigvm = field(second, "sigvm", exclusion);
  erosion.mxeps = field(second, "mxeps", exclusion);
  erosion.epssh = field(second, "epssh", exclusion);
  erosion.sigth = field(second, "sigth", exclusion);
  erosion.impulse = field(second, "impulse", exclusion);
  const double time = context.transform(block).time_factor, stress = context.stress(block, 1);
  erosion.failtm = newer_field(second, "failtm", exclusion).value_or(0) * time;
  for (std::optional<double>* value :
       {&erosion.mxpres, &erosion.mnpres, &erosion.sigp1, &erosion.sigvm, &erosion.sigth})
    scale(*value, stress);
  scale(erosion.impulse, stress * stress * time);
  erosion.unread = first_unread(reader);
  context.model.erosions.push_back(std::move(erosion));
}

}  // namespace gapcheck::model
