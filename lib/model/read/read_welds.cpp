#include <fmt/format.h>

#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

Weld begin_weld(Context& context, CardReader& reader, const Options& options, bool generalized) {
  Weld weld;
  weld.generalized = generalized;
  weld.id = static_cast<std::int64_t>(context.model.welds.size()) + 1;
  weld.place = Context::place(reader.block(), reader.peek_line());
  if (options.has("ID"))
    if (const auto id = reader.next(keyword::card_layout("CONSTRAINED_GENERALIZED_WELD_SPOT", "ID")).integer("wid"))
      weld.id = id;
  return weld;
}

/// Where a weld fails, with forces and times in the model's units.
void read_failure(const keyword::Transform& units, const Card& card, Weld& weld) {
  const double force = units.mass_factor * units.length_factor / (units.time_factor * units.time_factor);
  weld.normal_force = card.real("sn") * force;
  weld.shear_force = card.real("ss") * force;
  weld.normal_power = card.real("n");
  weld.shear_power = card.real("m");
  weld.failure_time = card.real(weld.generalized ? "tfail" : "tf") * units.time_factor;
  weld.plastic_strain = card.real(weld.generalized ? "epsf" : "ep");
}

void add_weld(Context& context, Weld weld) {
  if (weld.nodes.size() >= 2)
    context.model.welds.push_back(std::move(weld));
  else
    context.warning(weld.place, fmt::format("weld {} holds fewer than two nodes; it is left out", weld.id));
}

}  // namespace

void read_spot_weld(Context& context, const Block& block, const Options& options) {
  const auto& layout = keyword::card_layout("CONSTRAINED_SPOTWELD", "card2");
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    Weld weld = begin_weld(context, reader, options, false);
    const Card card = reader.next(layout);
    for (const std::string_view field : {"n1", "n2"}) {
      if (const auto node = context.model.mesh.nodes.lookup.find(card.integer(field)))
        weld.nodes.emplace_back(*node);
      else
        context.unknown(fmt::format("spot weld {} names node {}, which is not defined", weld.id, card.integer(field)),
                        weld.place);
    }
    read_failure(context.transform(block), card, weld);
    if (options.has("FILTERED")) reader.skip();
    add_weld(context, std::move(weld));
  }
}

void read_generalized_weld(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    Weld weld = begin_weld(context, reader, options, true);
    const std::int64_t set =
        reader.next(keyword::card_layout("CONSTRAINED_GENERALIZED_WELD_SPOT", "card1")).integer("nsid");
    if (const auto found = context.model.sets.nodes.find(set); found != context.model.sets.nodes.end())
      weld.nodes = found->second.members;
    else
      context.unknown(fmt::format("weld {} names node set {}, which is not defined", weld.id, set), weld.place);
    read_failure(context.transform(block),
                 reader.next(keyword::card_layout("CONSTRAINED_GENERALIZED_WELD_SPOT", "card2")), weld);
    add_weld(context, std::move(weld));
  }
}

}  // namespace gapcheck::model
