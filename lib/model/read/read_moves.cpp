#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "keyword/transformation.hpp"
#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// Nodes that *NODE_TRANSFORM may move in all, as a multiple of the model's: keeps a hostile deck from moving the same
/// large set again and again.
constexpr std::size_t most_transforms = 100;
constexpr std::size_t most_immediate_moves = 1000;

/// Nodes of the parts that move, each once per part.
template <std::size_t N>
void add_moves(const Elements<N>& elements, const std::map<std::uint32_t, Vector>& moves,
               std::vector<std::pair<NodeIndex, std::uint32_t>>& nodes) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::uint32_t part = elements.part[i].value;
    if (!moves.contains(part)) continue;
    for (const NodeIndex n : elements.nodes[i])
      if (n != none<NodeIndex>) nodes.emplace_back(n, part);
  }
}

/// The block that defines a transformation; nullptr: none does.
const Block* find_transformation(Context& context, std::int64_t id) {
  if (context.transformations.empty()) {
    Diagnostics unused;  // includes that name one report its faults
    for (const Block& block : context.deck.blocks())
      if (keyword::is_transformation(block.name))
        context.transformations.emplace(keyword::transformation_id(context.deck, block, unused), &block);
  }
  const auto found = context.transformations.find(id);
  return found == context.transformations.end() ? nullptr : found->second;
}

/// A reference of a move to nothing: a fault, and a move that is not made.
void unknown_in_move(Context& context, std::string_view keyword, Place place, const std::string& what) {
  context.unknown(fmt::format("*{} names {}, which is not defined", keyword, what), place);
  context.model.not_moved.push_back({std::string(keyword), what + " is not defined", place});
}

/// Where a transformation places points; nothing (and a report) if it is not defined or has a fault. `again`: its
/// faults have been reported.
std::optional<keyword::Placement> placement_of(Context& context, std::int64_t id, Place place, bool again) {
  Diagnostics unused;
  const Block* definition = find_transformation(context, id);
  if (definition == nullptr) {
    if (!again) unknown_in_move(context, "NODE_TRANSFORM", place, fmt::format("transformation {}", id));
    return std::nullopt;
  }
  const Nodes& nodes = context.model.mesh.nodes;
  const auto node = [&](std::int64_t node_id) -> Result<Vector> {
    const auto position = nodes.lookup.find(node_id);
    if (!position) return plain_error(fmt::format("node {} is not defined", node_id));
    return nodes.x[*position];
  };
  return keyword::read_transformation(context.deck, *definition, node, again ? unused : context.diagnostics);
}

/// The same, once for each transformation.
const std::optional<keyword::Placement>& find_placement(Context& context, std::int64_t id, Place place) {
  const auto [entry, is_new] = context.placements.try_emplace(id);
  if (is_new) entry->second = placement_of(context, id, place, !context.placements_reported.insert(id).second);
  return entry->second;
}

/// The same for a row with IMMED = 1: nodes that the transformation refers to may have moved since it was used last.
std::optional<keyword::Placement> find_placement_now(Context& context, std::int64_t id, Place place) {
  const Block* definition = find_transformation(context, id);
  if (definition == nullptr || keyword::transformation_nodes(context.deck, *definition).empty())
    return find_placement(context, id, place);
  if (++context.immediate_moves > most_immediate_moves) {
    context.error(place, fmt::format("*NODE_TRANSFORM: more than {} rows with IMMED = 1 move nodes by transformations "
                                     "that refer to nodes; this one was not read",
                                     most_immediate_moves));
    return std::nullopt;
  }
  return placement_of(context, id, place, !context.placements_reported.insert(id).second);
}

void move_set(Context& context, const Set<NodeIndex>& set, const keyword::Placement& placement, Place place) {
  Nodes& nodes = context.model.mesh.nodes;
  context.transformed_nodes += set.members.size();
  if (context.transformed_nodes > most_transforms * (nodes.size() + 1)) {
    context.error(place, "*NODE_TRANSFORM: the deck moves its nodes too many times; the rest was not read");
    return;
  }
  for (const NodeIndex n : set.members) nodes.x[n.value] = placement.matrix * nodes.x[n.value] + placement.shift;
}

}  // namespace

void read_part_move(Context& context, const Block& block, const Options&) {
  static const CardLayout layout = [] {
    CardLayout card = keyword::card_layout("PART_MOVE", "card1");
    card.fields[0].id = IdKind::plain;  // a part or a set
    return card;
  }();
  const keyword::Transform& transform = context.transform(block);
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    const Place place = Context::place(block, card.line());
    const bool of_set = card.integer("ifset") == 1;
    const std::int64_t id = context.with_offset(block, of_set ? IdKind::set : IdKind::part, card.integer("pid"));
    const Vector written(card.real("xmov"), card.real("ymov"), card.real("zmov"));
    Vector along = transform.places ? Vector(transform.matrix * written) : written;
    if (const std::int64_t system = context.with_offset(block, IdKind::define, card.integer("cid")); system != 0) {
      const auto axes = axes_of_system(context, system);
      if (!axes) {
        const std::string why =
            fmt::format("its move is given in the coordinate system {}: {}", system, axes.error().message);
        context.warning(place, fmt::format("*PART_MOVE: {} {} is checked where its nodes stand in the deck, since {}",
                                           of_set ? "part set" : "part", id, why));
        context.model.not_moved.push_back({"PART_MOVE", why, place});
        continue;
      }
      along = axes.value() * written;
    }
    const auto add = [&](PartIndex part) {
      context.part_moves.try_emplace(part.value, Vector::Zero()).first->second += context.length(block, 1) * along;
    };
    if (of_set) {
      const auto set = context.model.sets.parts.find(id);
      if (set == context.model.sets.parts.end())
        unknown_in_move(context, "PART_MOVE", place, fmt::format("part set {}", id));
      else
        for (const PartIndex part : set->second.members) add(part);
    } else if (const PartIndex part = context.part(id); part != none<PartIndex>) {
      add(part);
    } else {
      unknown_in_move(context, "PART_MOVE", place, fmt::format("part {}", id));
    }
  }
}

void finish_part_moves(Context& context) {
  if (context.part_moves.empty()) return;
  Mesh& mesh = context.model.mesh;
  std::vector<std::pair<NodeIndex, std::uint32_t>> nodes;
  add_moves(mesh.shells, context.part_moves, nodes);
  add_moves(mesh.solids, context.part_moves, nodes);
  add_moves(mesh.thick_shells, context.part_moves, nodes);
  add_moves(mesh.beams, context.part_moves, nodes);
  add_moves(mesh.discrete, context.part_moves, nodes);
  add_moves(mesh.masses, context.part_moves, nodes);
  add_moves(mesh.particles, context.part_moves, nodes);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (const auto& [position, along] : context.part_moves) {
    const Part& part = context.model.parts[position];
    if (part.inertia && part.inertia->center_node == 0 && along != Vector::Zero())
      context.model.not_moved.push_back(
          {"PART_MOVE",
           fmt::format("it moves part {}, and whether the centre in its *PART_INERTIA goes along is not known",
                       part.id.value),
           part.place});
  }
  for (const auto& [node, part] : nodes) mesh.nodes.x[node.value] += context.part_moves.at(part);
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  const auto twice = std::adjacent_find(nodes.begin(), nodes.end(), same);
  if (twice == nodes.end()) return;
  const auto node = twice->first.value;
  context.warning(
      {mesh.nodes.origins.file(node), mesh.nodes.line[node]},
      fmt::format("node {} and perhaps others belong to several parts that *PART_MOVE moves: they are moved "
                  "with each of these",
                  mesh.nodes.id[node]));
}

void read_node_transform(Context& context, const Block& block, const Options&) {
  const CardLayout& layout = keyword::card_layout("NODE_TRANSFORM", "card1");
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    const Place place = Context::place(block, card.line());
    const auto set = context.model.sets.nodes.find(card.integer("nsid"));
    const std::int64_t transformation = card.integer("trsid");
    if (set == context.model.sets.nodes.end()) {
      unknown_in_move(context, "NODE_TRANSFORM", place, fmt::format("node set {}", card.integer("nsid")));
    } else if (card.integer("immed") == 1) {
      if (!context.model.boxes.empty() && context.immediate_moves_read++ == 0) {
        context.warning(place,
                        "*NODE_TRANSFORM with IMMED = 1: sets by *DEFINE_BOX are chosen before it moves nodes, not "
                        "after it as in the solver");
        context.model.not_moved.push_back(
            {"NODE_TRANSFORM", "with IMMED = 1 it moves nodes before sets by *DEFINE_BOX are chosen", place});
      }
      if (const auto placement = find_placement_now(context, transformation, place))
        move_set(context, set->second, *placement, place);
    } else {
      context.node_moves.push_back({&set->second, transformation, place});
    }
  }
}

void finish_node_transforms(Context& context) {
  // Transformations that refer to nodes take their original coordinates, so all are read before any node moves.
  context.placements.clear();
  for (const Context::NodeMove& move : context.node_moves) find_placement(context, move.transformation, move.place);
  for (const Context::NodeMove& move : context.node_moves)
    if (const auto& placement = find_placement(context, move.transformation, move.place))
      move_set(context, *move.set, *placement, move.place);
}

}  // namespace gapcheck::model
