#include "model/context.hpp"

namespace gapcheck::model {

// The pairs of parts are only counted: friction does not decide anything at t = 0.
void read_friction_table(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("TITLE")) reader.skip();
  const Card card = reader.next(keyword::card_layout("DEFINE_FRICTION", "card1"));
  FrictionTable table;
  table.id = card.integer("id");
  table.place = Context::place(block, card.present() ? card.line() : block.line);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    reader.skip();
    ++table.pairs;
  }
  context.model.friction_tables.try_emplace(table.id, table);
}

}  // namespace gapcheck::model
