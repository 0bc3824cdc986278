#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

FrictionLaw law(const Card& card, const char* fs, const char* fd, const char* dc, const char* vc) {
  return {card.real(fs), card.real(fd), card.real(dc), card.real(vc)};
}

bool is_set(const Card& card, const char* field) { return card.text(field).find("PSET") != std::string::npos; }

}  // namespace

void read_friction_table(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  if (options.has("TITLE")) reader.skip();
  const Card card = reader.next(keyword::card_layout("DEFINE_FRICTION", "card1"));
  FrictionTable table;
  table.id = card.integer("id");
  table.others = law(card, "fs_d", "fd_d", "dc_d", "vc_d");
  table.place = Context::place(block, card.present() ? card.line() : block.line);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card row = reader.next(keyword::card_layout("DEFINE_FRICTION", "card2"));
    const bool i_is_set = is_set(row, "ptypei"), j_is_set = is_set(row, "ptypej");
    const auto id = [&](const char* field, bool set) {
      return context.with_offset(block, set ? keyword::IdKind::set : keyword::IdKind::part, row.integer(field));
    };
    table.rows.push_back({id("pid_i", i_is_set), id("pid_j", j_is_set), i_is_set, j_is_set,
                          law(row, "fs_ij", "fd_ij", "dc_ij", "vc_ij")});
  }
  context.model.friction_tables.try_emplace(table.id, table);
}

}  // namespace gapcheck::model
