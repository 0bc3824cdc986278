#include <fmt/format.h>

#include <array>

#include "model/read/context.hpp"
#include "model/read/field_values.hpp"

namespace gapcheck::model {
namespace {

/// The nodes of a set; an unknown set is reported.
std::vector<NodeIndex> nodes_of_set(Context& context, std::int64_t set, const std::string& user, Place place) {
  const auto found = context.model.sets.nodes.find(set);
  if (found != context.model.sets.nodes.end()) return found->second.members;
  context.unknown(fmt::format("{} names node set {}, which is not defined", user, set), place);
  return {};
}

/// A part that must exist.
bool find_part(Context& context, std::int64_t id, std::string_view user, Place place, std::vector<PartIndex>& parts) {
  const PartIndex part = context.part(id);
  if (part == none<PartIndex>) {
    context.unknown(fmt::format("*{} names part {}, which is not defined", user, id), place);
    return false;
  }
  parts.push_back(part);
  return true;
}

/// Cards after the first one of a nodal rigid body.
void read_body_options(Context& context, CardReader& reader, const Options& options, RigidGroup& group) {
  if (options.has("SPC")) {
    const Card card = reader.next(keyword::card_layout("CONSTRAINED_NODAL_RIGID_BODY_SPC", "card2"));
    group.constraint = {card.real("cmo"), card.integer("con1"), card.integer("con2")};
  }
  if (options.has("INERTIA")) group.inertia = read_body_inertia(context, reader);
  skip_lines(reader, static_cast<std::int64_t>(options.count({"OVERRIDE", "THERMAL"})));
}

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

/// Weights that are not given are the first one.
Interpolation::Independent read_independent(const Card& card, bool set) {
  Interpolation::Independent one;
  one.nodes = {card.integer("inid"), set};
  one.freedoms = or_default(card.integer("idof"), one.freedoms);
  constexpr std::array weight_fields{"twghtx", "twghty", "twghtz", "rwghtx", "rwghty", "rwghtz"};
  const double first = or_default(card.real(weight_fields[0]), 1);
  for (std::size_t i = 0; i < weight_fields.size(); ++i)
    one.weights[i] = or_default(card.real(weight_fields[i]), first);
  one.place.line = card.line();
  return one;
}

Joint::Kind joint_kind(const Options& options) {
  using Kind = Joint::Kind;
  if (options.has("REVOLUTE")) return Kind::revolute;
  if (options.has("CYLINDRICAL")) return Kind::cylindrical;
  if (options.has("PLANAR")) return Kind::planar;
  if (options.has("UNIVERSAL")) return Kind::universal;
  return options.has("TRANSLATIONAL") ? Kind::translational : Kind::spherical;
}

}  // namespace

void read_nodal_rigid_body(Context& context, const Block& block, const Options& options) {
  const auto& layout = keyword::card_layout("CONSTRAINED_NODAL_RIGID_BODY", "card1");
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (options.has("TITLE")) reader.skip();
    if (reader.at_end()) break;
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    RigidGroup group{RigidGroup::Kind::nodal_rigid_body, card.integer("pid"), {}, {}, {}, {}, {}};
    group.place = Context::place(block, card.line());
    // Without its own set the body takes the node set of the same number.
    const std::int64_t set = card.integer("nsid") != 0 ? card.integer("nsid") : group.id;
    group.nodes = nodes_of_set(context, set, fmt::format("nodal rigid body {}", group.id), group.place);
    read_body_options(context, reader, options, group);
    context.model.rigid_groups.push_back(std::move(group));
  }
}

void read_extra_nodes(Context& context, const Block& block, const Options& options) {
  const bool sets = options.has("SET");
  const auto& layout =
      keyword::card_layout(sets ? "CONSTRAINED_EXTRA_NODES_SET" : "CONSTRAINED_EXTRA_NODES_NODE", "card1");
  const Nodes& nodes = context.model.mesh.nodes;
  CardReader reader(context.deck, block, context.diagnostics);
  bool group_open = false;
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    const std::int64_t part = card.integer("pid");
    const Place place = Context::place(block, card.line());
    if (sets || !group_open || part != context.model.rigid_groups.back().id) {
      RigidGroup group{RigidGroup::Kind::extra_nodes, part, {}, {}, {}, {}, place};
      group_open = find_part(context, part, block.name, place, group.parts);
      if (group_open) context.model.rigid_groups.push_back(std::move(group));
    }
    if (!group_open) continue;
    RigidGroup& group = context.model.rigid_groups.back();
    if (sets) {
      group.nodes = nodes_of_set(context, card.integer("nsid"), fmt::format("*{} of part {}", block.name, part), place);
    } else if (const auto node = nodes.lookup.find(card.integer("nid"))) {
      group.nodes.emplace_back(*node);
    } else {
      context.unknown(
          fmt::format("*{} of part {} names node {}, which is not defined", block.name, part, card.integer("nid")),
          place);
    }
  }
}

void read_rigid_bodies(Context& context, const Block& block, const Options& options) {
  const bool sets = options.has("SET");
  const auto& layout =
      keyword::card_layout(sets ? "CONSTRAINED_RIGID_BODIES_SET" : "CONSTRAINED_RIGID_BODIES", "card1");
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    const Place place = Context::place(block, card.line());
    const std::int64_t lead = card.integer("pidl"), other = card.integer("pidc");
    RigidGroup group{RigidGroup::Kind::merged_parts, lead, {}, {}, {}, {}, place};
    if (!find_part(context, lead, block.name, place, group.parts)) continue;
    if (!sets) {
      if (!find_part(context, other, block.name, place, group.parts)) continue;
    } else if (const auto set = context.model.sets.parts.find(other); set != context.model.sets.parts.end()) {
      group.parts.insert(group.parts.end(), set->second.members.begin(), set->second.members.end());
    } else {
      context.unknown(fmt::format("*{} names part set {}, which is not defined", block.name, other), place);
      continue;
    }
    context.model.rigid_groups.push_back(std::move(group));
  }
}

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

void read_linear_constraint(Context& context, const Block& block, const Options&) {
  CardReader reader(context.deck, block, context.diagnostics);
  LinearConstraint constraint;
  constraint.local = block.name.find("LOCAL") != std::string::npos;
  const std::string_view keyword = constraint.local ? "CONSTRAINED_LINEAR_LOCAL" : "CONSTRAINED_LINEAR_GLOBAL";
  const Card card = reader.next(keyword::card_layout(keyword, "card1"));
  constraint.id = card.integer("lcid");
  constraint.place = Context::place(block, block.line);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card term = reader.next(keyword::card_layout(keyword, "card2"));
    const std::int64_t system = constraint.local ? term.integer("cid") : 0;
    note_system(context, system);
    constraint.terms.push_back(
        {term.integer("nid"), term.integer("dof"), system, term.real("coef"), Context::place(block, term.line())});
  }
  context.model.linear_constraints.push_back(std::move(constraint));
}

void read_joined_set(Context& context, const Block& block, const Options& options) {
  const auto& id = keyword::card_layout("CONSTRAINED_NODE_SET", "ID");
  const auto& layout = keyword::card_layout("CONSTRAINED_NODE_SET", "card1");
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    JoinedSet set;
    if (options.has("ID")) set.id = reader.next(id).integer("id");
    const Card card = reader.next(layout);
    set.node_set = card.integer("nsid");
    set.code = card.integer("dof");
    set.failure_time = card.real("tf") * context.transform(block).time_factor;
    set.place = Context::place(block, card.line());
    context.model.joined_sets.push_back(set);
  }
}

void read_interpolation(Context& context, const Block& block, const Options& options) {
  const auto layout = [](std::string_view card) -> const keyword::CardLayout& {
    return keyword::card_layout("CONSTRAINED_INTERPOLATION", card);
  };
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end() && skip_blank(reader)) continue;
  if (reader.at_end()) return;
  const Card card = reader.next(layout("card1"));
  Interpolation one;
  one.keyword = block.name;
  one.place = Context::place(block, card.line());
  one.id = card.integer("icid");
  one.dependent = card.integer("dnid");
  one.freedoms = or_default(card.integer("ddof"), one.freedoms);
  one.by_set = card.integer("ityp");
  one.deletion = or_default(card.integer("idnsw"), one.deletion);
  const bool local = options.has("LOCAL");
  if (local) one.system = card.integer("cidd");
  note_system(context, one.system);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    one.independents.push_back(
        read_independent(reader.next(layout(one.by_set == 1 ? "set" : "node")), one.by_set == 1));
    Interpolation::Independent& independent = one.independents.back();
    independent.place.file = block.file;
    if (local && !reader.at_end()) independent.system = reader.next(layout("axes")).integer("cidi");
    note_system(context, independent.system);
  }
  context.model.interpolations.push_back(std::move(one));
}

void read_joint(Context& context, const Block& block, const Options& options) {
  if (!options.any({"SPHERICAL", "REVOLUTE", "CYLINDRICAL", "PLANAR", "UNIVERSAL", "TRANSLATIONAL"})) return;
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    Joint joint;
    joint.kind = joint_kind(options);
    joint.keyword = block.name;
    joint.id = static_cast<std::int64_t>(context.model.joints.size()) + 1;
    if (options.has("ID"))
      if (const auto id = reader.next(keyword::card_layout("CONSTRAINED_JOINT", "ID")).integer("id")) joint.id = id;
    const Card card = reader.next(keyword::card_layout("CONSTRAINED_JOINT", "card1"));
    joint.place = Context::place(block, card.line());
    joint.nodes = {card.integer("n1"), card.integer("n2"), card.integer("n3"),
                   card.integer("n4"), card.integer("n5"), card.integer("n6")};
    joint.stiffness = or_default(card.real("rps"), 1);
    joint.damping = or_default(card.real("damp"), 1);
    context.model.joints.push_back(std::move(joint));
  }
}

}  // namespace gapcheck::model
