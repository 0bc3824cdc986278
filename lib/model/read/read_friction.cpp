#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// The fields FS, FD, DC and VC whose names end so.
FrictionLaw law(const Context& context, const Block& block, const Card& card, const std::string& ending) {
  const auto field = [&](const char* name) { return card.real(name + ending); };
  return {field("fs"), field("fd"), context.decay(block, field("dc")), context.stress(block, field("vc"))};
}

bool is_set(const Card& card, const char* field) { return card.text(field).find("PSET") != std::string::npos; }

}  // namespace

void read_friction_table(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("TITLE")) reader.skip();
  const Card card = reader.next(keyword::card_layout("DEFINE_FRICTION", "card1"));
  FrictionTable table;
  table.id = card.integer("id");
  table.others = law(context, block, card, "_d");
  table.place = Context::place(block, card.present() ? card.line() : block.line);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card row = reader.next(keyword::card_layout("DEFINE_FRICTION", "card2"));
    const bool i_is_set = is_set(row, "ptypei"), j_is_set = is_set(row, "ptypej");
    const auto id = [&](const char* field, bool set) {
      return context.with_offset(block, set ? keyword::IdKind::set : keyword::IdKind::part, row.integer(field));
    };
    table.rows.push_back(
        {id("pid_i", i_is_set), id("pid_j", j_is_set), i_is_set, j_is_set, law(context, block, row, "_ij")});
  }
  context.model.friction_tables.try_emplace(table.id, table);
}

}  // namespace gapcheck::model
