#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "solver/condition/condition_builder.hpp"
#include "solver/condition/loads.hpp"
#include "solver/element/nodal_mass.hpp"

namespace gapcheck::solver {
namespace {

using PressureKind = model::PressureLoad::Kind;

/// Its independent nodes carry the load of a dependent one (*CONSTRAINED_INTERPOLATION).
bool is_carried(const model::Model& model, NodeIndex node, std::size_t freedom) {
  const auto carries = [&](const model::Interpolation& one) {
    return one.dependent == model.mesh.nodes.id[node.value] &&
           std::to_string(one.freedoms).find(std::to_string(freedom + 1)) != std::string::npos;
  };
  return std::any_of(model.interpolations.begin(), model.interpolations.end(), carries);
}

/// Something must carry the load: a mass, an inertia, a rigid body or a constraint.
void check_target(ConditionBuilder& builder, const model::ConcentratedLoad& load, NodeIndex node, std::size_t freedom) {
  const Structure& structure = builder.structure;
  const bool moment = freedom >= 3;
  const double mass = (moment ? structure.state.inertia : structure.state.mass)[node.value];
  const unsigned mask = structure.constraints.mask(node.value), three = moment ? mask >> 3 : mask & 7u;
  const bool local = structure.constraints.axes(node.value) != nullptr;
  const bool held = local ? three == 7u : (mask >> freedom & 1u) != 0;
  if (mass > 0 || structure.rigid.holds(node.value) || held || is_carried(builder.model, node, freedom)) return;
  builder.fail(Failure::Kind::zero_mass, load.keyword, load.place,
               fmt::format("node {} has no {} to take up the load; give it one, hold it or remove the load",
                           structure.node_id[node.value], moment ? "rotational inertia" : "mass"));
}

/// The nodes M1 to M3; nothing after a failure.
std::optional<std::array<NodeIndex, 3>> followed_nodes(ConditionBuilder& builder, const model::ConcentratedLoad& load) {
  std::array<NodeIndex, 3> nodes;
  if (std::count(load.followed.begin(), load.followed.end(), 0) > 0)
    builder.fail(Failure::Kind::contradiction, load.keyword, load.place,
                 fmt::format("DOF {} follows the normal of three nodes; give M1, M2 and M3", load.freedom));
  for (std::size_t k = 0; k < 3 && !builder.failed(); ++k) {
    const auto found = builder.nodes({load.followed[k], false}, load.keyword, load.place);
    if (found.empty()) return std::nullopt;
    nodes[k] = found[0];
  }
  if (builder.failed()) return std::nullopt;
  const std::vector<Vector>& x = builder.structure.state.x;
  const Vector a = x[nodes[1].value] - x[nodes[0].value], b = x[nodes[2].value] - x[nodes[0].value];
  if (a.cross(b).norm() > 1e-9 * a.norm() * b.norm()) return nodes;
  builder.fail(Failure::Kind::contradiction, load.keyword, load.place,
               fmt::format("the nodes {}, {} and {} (M1 to M3) lie in one line and give no direction", load.followed[0],
                           load.followed[1], load.followed[2]));
  return std::nullopt;
}

/// A load along one axis, or along one of a local system by its three components.
void add_direct(ConditionBuilder& builder, const model::ConcentratedLoad& load, const TimedValue& value,
                ConcentratedLoads& loads) {
  const bool moment = load.freedom >= 5;
  const auto axis = static_cast<int>(load.freedom - (moment ? 5 : 1));
  Vector direction = Vector::Unit(axis);
  if (load.system != 0) {
    const auto axes = builder.system(load.system, load.keyword, load.place);
    if (!axes) return;
    direction = axes->col(axis);
  }
  const auto body = load.rigid ? builder.body(load.part, load.keyword, load.place) : std::nullopt;
  const std::vector<NodeIndex> nodes =
      load.rigid ? std::vector<NodeIndex>() : builder.nodes(load.nodes, load.keyword, load.place);
  for (std::size_t k = 0; k < 3; ++k) {
    const double share = direction[static_cast<int>(k)];
    if (share == 0) continue;
    TimedValue part = value;
    part.scale *= share;
    const std::size_t freedom = k + (moment ? 3 : 0);
    if (body) loads.add_body(*body, freedom, part);
    for (const NodeIndex node : nodes) {
      check_target(builder, load, node, freedom);
      loads.add_node(node, freedom, part);
    }
  }
}

void add_follower(ConditionBuilder& builder, const model::ConcentratedLoad& load, const TimedValue& value,
                  ConcentratedLoads& loads) {
  const bool moment = load.freedom == 8;
  if (load.system != 0)
    return builder.fail(Failure::Kind::contradiction, load.keyword, load.place,
                        fmt::format("DOF {} follows nodes and has no local system; set CID to 0", load.freedom));
  const auto followed = followed_nodes(builder, load);
  if (!followed) return;
  if (load.rigid) {
    if (const auto body = builder.body(load.part, load.keyword, load.place))
      loads.follow_normal(*body, true, moment, *followed, value);
    return;
  }
  for (const NodeIndex node : builder.nodes(load.nodes, load.keyword, load.place)) {
    for (std::size_t k = 0; k < 3; ++k) check_target(builder, load, node, k + (moment ? 3 : 0));
    loads.follow_normal(node.value, false, moment, *followed, value);
  }
}

void apply_concentrated(ConditionBuilder& builder) {
  if (builder.model.loads.concentrated.empty()) return;
  auto loads = std::make_unique<ConcentratedLoads>();
  for (const model::ConcentratedLoad& load : builder.model.loads.concentrated) {
    if (load.freedom < 1 || load.freedom > 8)
      builder.fail(Failure::Kind::not_calculated, load.keyword, load.place,
                   fmt::format("DOF {} is not calculated; 1 to 8 are", load.freedom));
    const TimedValue value{builder.curve(load.curve, load.keyword, load.place), load.scale, 0,
                           builder.phases(load.curve)};
    if (builder.failed()) return;
    if (load.freedom == 4 || load.freedom == 8)
      add_follower(builder, load, value, *loads);
    else
      add_direct(builder, load, value, *loads);
    if (builder.failed()) return;
  }
  builder.forces.push_back(std::move(loads));
}

/// The segment of four node ids.
std::vector<model::SegmentNodes> written_segment(ConditionBuilder& builder, const model::PressureLoad& load) {
  model::SegmentNodes nodes;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::int64_t id = k == 3 && load.nodes[3] == 0 ? load.nodes[2] : load.nodes[k];
    const auto found = builder.nodes({id, false}, load.keyword, load.place);
    if (found.empty()) return {};
    nodes[k] = found[0];
  }
  return {nodes};
}

std::vector<model::SegmentNodes> segments_of(ConditionBuilder& builder, const model::PressureLoad& load) {
  const model::Model& model = builder.model;
  const auto missing = [&](std::string_view what) {
    builder.fail(Failure::Kind::unknown_reference, load.keyword, load.place,
                 fmt::format("{} {} is not defined; define it or remove the load", what, load.id));
    return std::vector<model::SegmentNodes>();
  };
  std::vector<model::SegmentNodes> segments;
  switch (load.kind) {
    case PressureKind::segment:
      return written_segment(builder, load);
    case PressureKind::segment_set: {
      const auto set = model.sets.segments.find(load.id);
      return set == model.sets.segments.end() ? missing("segment set") : set->second.members;
    }
    case PressureKind::shell: {
      const auto shell = model.mesh.shells.lookup.find(load.id);
      if (!shell) return missing("shell");
      return {model.mesh.shells.nodes[*shell]};
    }
    case PressureKind::shell_set: {
      const auto set = model.sets.shells.find(load.id);
      if (set == model.sets.shells.end()) return missing("shell set");
      for (const std::uint32_t shell : set->second.members) segments.push_back(model.mesh.shells.nodes[shell]);
    }
  }
  return segments;
}

void apply_pressures(ConditionBuilder& builder) {
  if (builder.model.loads.pressures.empty()) return;
  auto pressures = std::make_unique<Pressures>();
  for (const model::PressureLoad& load : builder.model.loads.pressures) {
    const TimedValue value{builder.curve(load.curve, load.keyword, load.place), load.scale, load.arrival,
                           builder.phases(load.curve)};
    for (const model::SegmentNodes& segment : segments_of(builder, load)) {
      for (const NodeIndex node : segment)
        if (node.value >= builder.structure.state.x.size())
          builder.fail(Failure::Kind::unknown_reference, load.keyword, load.place, "a segment has no node");
      if (!builder.failed()) pressures->add_segment(segment, value);
    }
    if (builder.failed()) return;
  }
  builder.forces.push_back(std::move(pressures));
}

/// Masses at the nodes of the parts of *LOAD_BODY_PARTS; empty: all parts.
std::vector<double> masses_of_parts(ConditionBuilder& builder) {
  const model::Model& model = builder.model;
  if (model.loads.body_parts.empty()) return {};
  std::vector<bool> wanted(model.parts.size());
  for (const auto& [set, place] : model.loads.body_parts)
    for (const PartIndex part : builder.part_set(set, "LOAD_BODY_PARTS", place)) wanted[part.value] = true;
  std::vector<double> masses = nodal_masses(model, wanted);
  for (std::size_t i = 0; i < model.mesh.masses.size(); ++i) {
    const PartIndex part = model.mesh.masses.part[i];
    const NodeIndex node = model.mesh.masses.nodes[i][0];
    if (part.value < wanted.size() && wanted[part.value] && node.value < masses.size())
      masses[node.value] += model.mesh.mass_values[i];
  }
  return masses;
}

/// Its value over time; LCIDDR takes the place of LCID in a relaxation.
std::vector<TimedValue> body_load_values(ConditionBuilder& builder, const model::BodyLoad& load) {
  TimedValue value{builder.curve(load.curve, load.keyword, load.place), load.scale, 0, builder.phases(load.curve)};
  if (load.relaxation_curve == 0 || !builder.relaxing) return {value};
  value.phases.relaxation = false;
  TimedValue before{builder.curve(load.relaxation_curve, load.keyword, load.place), load.scale, 0, {false, true}};
  if (!builder.failed() && !builder.phases(load.relaxation_curve).relaxation)
    builder.fail(Failure::Kind::contradiction, load.keyword, load.place,
                 fmt::format("curve {} (LCIDDR) is for dynamic relaxation, but has SIDR = 0; set its SIDR to 1 or 2",
                             load.relaxation_curve));
  return {value, before};
}

/// Whether its length scales the load is not documented.
void check_direction(ConditionBuilder& builder, const model::BodyLoad& load) {
  constexpr double written_digits = 1e-3;
  const double length = load.direction.norm();
  if (load.by_vector && !(std::abs(length - 1) < written_digits))
    builder.fail(Failure::Kind::not_calculated, load.keyword, load.place,
                 fmt::format("the vector V1, V2, V3 has the length {:g}; give one of length 1 and scale the load by SF",
                             length));
}

void apply_gravity(ConditionBuilder& builder) {
  if (builder.model.loads.bodies.empty()) return;
  auto gravity = std::make_unique<Gravity>(masses_of_parts(builder));
  for (const model::BodyLoad& load : builder.model.loads.bodies) {
    builder.refuse_system(load.system, load.keyword, load.place);
    check_direction(builder, load);
    for (const TimedValue& value : body_load_values(builder, load))
      if (load.by_vector)
        gravity->add_direction(load.direction.normalized(), value);
      else if (load.rotation)
        gravity->add_rotation(load.axis, load.center, value);
      else
        gravity->add_axis(load.axis, value);
  }
  if (!builder.failed()) builder.forces.push_back(std::move(gravity));
}

void apply_damping(ConditionBuilder& builder) {
  constexpr std::string_view keyword = "DAMPING_GLOBAL";
  if (!builder.model.loads.damping) return;
  const model::GlobalDamping& damping = *builder.model.loads.damping;
  TimedValue constant{nullptr, damping.value, 0, {true, true}};
  if (damping.curve != 0)
    constant = {builder.curve(damping.curve, keyword, damping.place), damping.scale, 0, builder.phases(damping.curve)};
  else
    constant.curve = std::make_shared<const TimeCurve>(std::vector<TimeCurve::Point>{{0, 1}});
  if (!builder.failed()) builder.forces.push_back(std::make_unique<GlobalDamping>(constant, damping.factors));
}

/// One part or those of a set; empty after a failure.
std::vector<PartIndex> damped_parts(ConditionBuilder& builder, const model::PartDamping& damping) {
  if (damping.set) return builder.part_set(damping.id, damping.keyword, damping.place);
  const auto part = builder.model.part_of_id.find(damping.id);
  if (part != builder.model.part_of_id.end()) return {part->second};
  builder.fail(Failure::Kind::unknown_reference, damping.keyword, damping.place,
               fmt::format("part {} is not defined; define it or remove the damping", damping.id));
  return {};
}

/// The masses at nodes and the rigid bodies of some parts.
struct DampedMasses {
  std::vector<double> nodes;
  std::vector<std::size_t> bodies;
};

std::optional<DampedMasses> damped_masses(ConditionBuilder& builder, std::string_view keyword, model::Place place,
                                          const std::vector<PartIndex>& parts) {
  const model::Model& model = builder.model;
  std::vector<bool> wanted(model.parts.size());
  std::vector<std::size_t> bodies;
  for (const PartIndex part : parts) {
    const auto beam = std::find(model.mesh.beams.part.begin(), model.mesh.beams.part.end(), part);
    if (beam != model.mesh.beams.part.end())
      builder.fail(Failure::Kind::not_calculated, keyword, place,
                   fmt::format("part {} has beams, whose masses are not damped by part; use *DAMPING_GLOBAL",
                               model.part(part).id.value));
    if (!model.rigid(part))
      wanted[part.value] = true;
    else if (const auto body = builder.body(model.part(part).id.value, keyword, place))
      bodies.push_back(*body);
  }
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  if (builder.failed()) return std::nullopt;
  std::vector<double> masses = nodal_masses(model, wanted);
  for (std::size_t i = 0; i < masses.size(); ++i)
    if (builder.structure.rigid.holds(i)) masses[i] = 0;
  return DampedMasses{std::move(masses), std::move(bodies)};
}

void apply_part_dampings(ConditionBuilder& builder) {
  const model::Model& model = builder.model;
  if (model.loads.part_dampings.empty()) return;
  auto dampings = std::make_unique<PartDampings>();
  for (const model::PartDamping& damping : model.loads.part_dampings) {
    const TimedValue constant{builder.curve(damping.curve, damping.keyword, damping.place), damping.scale, 0,
                              builder.phases(damping.curve)};
    auto masses = damped_masses(builder, damping.keyword, damping.place, damped_parts(builder, damping));
    if (!masses) return;
    dampings->add_part(constant, damping.factors, masses->nodes, std::move(masses->bodies));
  }
  builder.forces.push_back(std::move(dampings));
}

/// The constant 4 π FREQ CDAMP over time.
TimedValue relative_constant(ConditionBuilder& builder, const model::RelativeDamping& damping,
                             std::string_view keyword) {
  const double critical = 4 * std::numbers::pi * damping.frequency;
  if (damping.curve != 0)
    return {builder.curve(damping.curve, keyword, damping.place), critical, 0, builder.phases(damping.curve)};
  const std::vector<TimeCurve::Point> points{{0, 1}};
  return {std::make_shared<const TimeCurve>(points), critical * damping.fraction, 0, {true, true}};
}

void apply_relative_dampings(ConditionBuilder& builder) {
  constexpr std::string_view keyword = "DAMPING_RELATIVE";
  const model::Model& model = builder.model;
  if (model.loads.relative_dampings.empty()) return;
  auto dampings = std::make_unique<PartDampings>();
  for (const model::RelativeDamping& damping : model.loads.relative_dampings) {
    const auto fail = [&](Failure::Kind kind, std::string_view why) {
      builder.fail(kind, keyword, damping.place, why);
    };
    if (damping.fraction < 0 || damping.frequency < 0)
      fail(Failure::Kind::contradiction,
           fmt::format("CDAMP = {:g} and FREQ = {:g} would feed the motion; set numbers from 0 up", damping.fraction,
                       damping.frequency));
    if (damping.squared != 0)
      fail(Failure::Kind::not_calculated,
           fmt::format("a force with the square of the velocity (DV2 = {:g}) is not calculated; set DV2 to 0",
                       damping.squared));
    if (damping.part_set == 0) fail(Failure::Kind::contradiction, "no part is damped; name a part set in PSID");
    const TimedValue constant = relative_constant(builder, damping, keyword);
    const auto frame = builder.body(damping.body, keyword, damping.place);
    if (builder.failed()) return;
    auto masses =
        damped_masses(builder, keyword, damping.place, builder.part_set(damping.part_set, keyword, damping.place));
    if (!masses) return;
    std::erase(masses->bodies, *frame);
    dampings->add_part(constant, {1, 1, 1, 1, 1, 1}, masses->nodes, std::move(masses->bodies), frame);
  }
  builder.forces.push_back(std::move(dampings));
}

}  // namespace

void apply_loads(ConditionBuilder& builder) {
  for (const auto apply : {apply_concentrated, apply_pressures, apply_gravity, apply_damping, apply_part_dampings,
                           apply_relative_dampings})
    if (!builder.failed()) apply(builder);
}

}  // namespace gapcheck::solver
