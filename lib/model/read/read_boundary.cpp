#include <algorithm>
#include <array>

#include "keyword/text/line_ends.hpp"
#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// The ID card before each condition; blank lines between conditions are skipped.
bool start_condition(CardReader& reader, const Options& options) {
  while (!reader.at_end() && skip_blank(reader)) {
  }
  if (options.has("ID") && !reader.at_end()) reader.skip();
  return !reader.at_end();
}

Lifetime read_lifetime(const Context& context, const Block& block, const Card& card) {
  Lifetime lifetime;
  const double factor = context.transform(block).time_factor;
  lifetime.birth = card.real("birth") * factor;
  if (card.real("death") > 0) lifetime.death = std::min(card.real("death") * factor, Lifetime::forever);
  return lifetime;
}

/// Nonblank columns of TC and RC in a line of *NODE: nothing for most lines of most decks.
bool has_codes(std::string_view line, std::size_t column) {
  if (line.starts_with('$')) return false;
  if (line.find(',') != std::string_view::npos) return std::count(line.begin(), line.end(), ',') >= 4;
  return line.size() > column && line.find_first_not_of(" \t\r0", column) != std::string_view::npos;
}

/// Visits the lines of a block with their numbers.
template <class Visit>
void for_each_line(const Block& block, const Visit& visit) {
  std::uint32_t number = block.line + 1;
  for (std::size_t at = 0; at < block.body.size(); ++number) {
    const std::size_t end = std::min(block.body.find('\n', at), block.body.size());
    visit(keyword::without_returns(block.body.substr(at, end - at)), number);
    at = end + 1;
  }
}

}  // namespace

std::uint8_t freedoms_of_code(std::int64_t code) {
  constexpr std::array<std::uint8_t, 8> freedoms{0, 1, 2, 4, 3, 6, 5, 7};
  return code < 0 || code > 7 ? std::uint8_t{0} : freedoms[static_cast<std::size_t>(code)];
}

void read_spc(Context& context, const Block& block, const Options& options) {
  const bool set = block.name.starts_with("BOUNDARY_SPC_SET");
  const bool timed = options.has("BIRTH");
  const auto& layout = keyword::card_layout(set ? "BOUNDARY_SPC_SET" : "BOUNDARY_SPC_NODE", "card1");
  const auto& times = keyword::card_layout("BOUNDARY_SPC_NODE_BIRTH_DEATH", "card2");
  constexpr std::array freedoms{"dofx", "dofy", "dofz", "dofrx", "dofry", "dofrz"};
  CardReader reader(context.deck, block, context.diagnostics);
  while (start_condition(reader, options)) {
    const Card card = reader.next(layout);
    SinglePointConstraint spc;
    spc.nodes = {card.integer(set ? "nsid" : "nid"), set};
    spc.system = card.integer("cid");
    note_system(context, spc.system);
    for (std::size_t i = 0; i < freedoms.size(); ++i)
      if (card.integer(freedoms[i]) != 0) spc.freedoms = static_cast<std::uint8_t>(spc.freedoms | 1u << i);
    spc.place = Context::place(block, card.line());
    if (timed) spc.lifetime = read_lifetime(context, block, reader.next(times));
    context.model.spcs.push_back(spc);
  }
}

void read_prescribed_motion(Context& context, const Block& block, const Options& options) {
  const bool rigid = block.name.starts_with("BOUNDARY_PRESCRIBED_MOTION_RIGID");
  const bool set = block.name.starts_with("BOUNDARY_PRESCRIBED_MOTION_SET");
  const auto& layout = keyword::card_layout(rigid ? "BOUNDARY_PRESCRIBED_MOTION_RIGID"
                                            : set ? "BOUNDARY_PRESCRIBED_MOTION_SET"
                                                  : "BOUNDARY_PRESCRIBED_MOTION_NODE",
                                            "card1");
  const keyword::Transform& units = context.transform(block);
  CardReader reader(context.deck, block, context.diagnostics);
  while (start_condition(reader, options)) {
    const Card card = reader.next(layout);
    PrescribedMotion motion;
    motion.keyword = block.name;
    motion.rigid = rigid;
    if (rigid)
      motion.part = card.integer("pid");
    else
      motion.nodes = {card.integer(set ? "nsid" : "nid"), set};
    motion.freedom = card.integer("dof");
    motion.quantity = card.integer("vad");
    motion.curve = card.integer("lcid");
    const double scale = card.real("sf") == 0 ? 1 : card.real("sf");
    const double per_time = motion.quantity == 0 ? units.time_factor : units.time_factor * units.time_factor;
    motion.turn_scale = motion.quantity == 2 ? scale : scale / per_time;
    motion.scale = motion.turn_scale * units.length_factor;
    motion.vector = card.integer("vid");
    motion.lifetime = read_lifetime(context, block, card);
    motion.place = Context::place(block, card.line());
    const bool about_a_point = motion.freedom >= 9 || motion.freedom <= -9 || motion.quantity == 4;
    if (about_a_point && !reader.at_end()) reader.skip();
    context.model.prescribed_motions.push_back(std::move(motion));
  }
}

void read_vector(Context& context, const Block& block, const Options& options) {
  const auto& layout = keyword::card_layout("DEFINE_VECTOR", "card1");
  const keyword::Transform& transform = context.transform(block);
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (options.has("TITLE")) reader.skip();
    if (reader.at_end()) break;
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    DirectionVector vector;
    vector.direction =
        Vector(card.real("xh") - card.real("xt"), card.real("yh") - card.real("yt"), card.real("zh") - card.real("zt"));
    if (transform.places) vector.direction = (transform.matrix * vector.direction).eval();
    vector.system = card.integer("cid");
    vector.place = Context::place(block, card.line());
    const auto [entry, is_new] = context.model.vectors.try_emplace(card.integer("vid"), vector);
    if (!is_new) context.duplicate("vector", entry->first, entry->second.place, vector.place);
  }
}

void read_node_constraints(Context& context, const Block& block) {
  const CardLayout& layout = keyword::card_layout("NODE", "card1");
  const std::size_t column = keyword::locate(layout, block.format, layout.index("tc")).column;
  const Nodes& nodes = context.model.mesh.nodes;
  std::array<std::uint32_t, 64> place_of{};  // position + 1 among the constraints, by freedoms
  for_each_line(block, [&](std::string_view line, std::uint32_t number) {
    if (!has_codes(line, column)) return;
    const Card card(context.deck, block, layout, line, number, context.diagnostics);
    const auto freedoms =
        static_cast<std::uint8_t>(freedoms_of_code(card.integer("tc")) | freedoms_of_code(card.integer("rc")) << 3);
    const auto node = nodes.lookup.find(card.integer("nid"));
    if (freedoms == 0 || !node) return;
    std::vector<NodeConstraint>& all = context.model.node_constraints;
    if (place_of[freedoms] == 0) {
      all.push_back({freedoms, {}, Context::place(block, number)});
      place_of[freedoms] = static_cast<std::uint32_t>(all.size());
    }
    all[place_of[freedoms] - 1].nodes.emplace_back(*node);
  });
}

}  // namespace gapcheck::model
