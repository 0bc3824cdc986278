#include <fmt/format.h>

#include <array>
#include <cmath>

#include "solver/condition/condition_builder.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::array names{"x", "y", "z", "rotation about x", "rotation about y", "rotation about z"};

/// The degrees of freedom that a DOF moves, with the share of the motion for each.
struct Directions {
  bool rotation = false;
  Vector share = Vector::Zero();
  unsigned bits = 0;  ///< of the three
  /// Of nodes, where the direction is none of the global axes: theirs, and it is the first of them.
  std::optional<Matrix> axes = std::nullopt;
};

/// Axes whose first one is a unit vector.
Matrix axes_along(const Vector& first) {
  Eigen::Index least = 0;
  first.cwiseAbs().minCoeff(&least);
  Matrix axes;
  axes.col(0) = first;
  axes.col(1) = first.cross(Vector(Vector::Unit(least))).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

/// Along or about a vector. A positive DOF leaves the directions across the vector free, for rigid bodies only along
/// the global axes; a negative one holds them.
std::optional<Directions> along_vector(ConditionBuilder& builder, const model::PrescribedMotion& motion) {
  const auto found = builder.model.vectors.find(motion.vector);
  if (found == builder.model.vectors.end()) {
    builder.fail(Failure::Kind::unknown_reference, motion.keyword, motion.place,
                 fmt::format("vector {} is not defined by a *DEFINE_VECTOR", motion.vector));
    return std::nullopt;
  }
  builder.refuse_system(found->second.system, motion.keyword, motion.place);
  const double length = found->second.direction.norm();
  if (!(length > 0) || !std::isfinite(length)) {
    builder.fail(Failure::Kind::unknown_reference, motion.keyword, motion.place,
                 fmt::format("vector {} has no direction", motion.vector));
    return std::nullopt;
  }
  Directions directions{motion.freedom == 8 || motion.freedom == -8, found->second.direction / length, 7};
  if (motion.freedom < 0) return directions;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(directions.share[axis]) >= 1 - 1e-12) {
      directions.share = Vector::Unit(axis) * std::copysign(1, directions.share[axis]);
      directions.bits = 1u << axis;
      return directions;
    }
  if (!motion.rigid) return Directions{directions.rotation, Vector::UnitX(), 1, axes_along(directions.share)};
  builder.fail(
      Failure::Kind::not_calculated, motion.keyword, motion.place,
      fmt::format("DOF {} along a vector that is not an axis is not calculated; use DOF {}, which also holds what is "
                  "across it",
                  motion.freedom, -motion.freedom));
  return std::nullopt;
}

std::optional<Directions> directions_of(ConditionBuilder& builder, const model::PrescribedMotion& motion) {
  const std::int64_t freedom = motion.freedom;
  if (freedom >= 1 && freedom <= 3)
    return Directions{false, Vector::Unit(static_cast<int>(freedom) - 1), 1u << (freedom - 1)};
  if (freedom >= 5 && freedom <= 7)
    return Directions{true, Vector::Unit(static_cast<int>(freedom) - 5), 1u << (freedom - 5)};
  if (freedom == 4 || freedom == -4 || freedom == 8 || freedom == -8) return along_vector(builder, motion);
  builder.fail(Failure::Kind::not_calculated, motion.keyword, motion.place,
               fmt::format("DOF {} is not calculated; 1 to 8 are", freedom));
  return std::nullopt;
}

/// What a motion does in a dynamic relaxation, or after it, where that is not documented.
void check_relaxation(ConditionBuilder& builder, const model::PrescribedMotion& motion, const Motion& result) {
  if (!builder.relaxing) return;
  if (!result.phases.relaxation)
    return builder.warn(motion.keyword, motion.place,
                        fmt::format("curve {} is not used in the dynamic relaxation (SIDR = 0), which leaves what it "
                                    "moves free; hold it there by a second motion with SIDR = 1 if it should stay",
                                    motion.curve));
  const auto refuse = [&](const std::string& why) {
    builder.fail(Failure::Kind::not_calculated, motion.keyword, motion.place, why);
  };
  if (result.quantity == Motion::Quantity::acceleration)
    refuse("an acceleration (VAD = 1) in dynamic relaxation is not calculated; give the velocity or displacement");
  if (result.quantity == Motion::Quantity::displacement && result.phases.run)
    refuse(
        fmt::format("where the displacement of curve {} begins in the run after a dynamic relaxation (SIDR = 2) is "
                    "not documented; give a curve with SIDR = 1 and another with SIDR = 0",
                    motion.curve));
  if (!motion.lifetime.always())
    refuse("BIRTH and DEATH of a motion in dynamic relaxation are not calculated; let its curve begin and end");
}

/// The motion of a whole DOF; nothing after a failure.
std::optional<Motion> motion_of(ConditionBuilder& builder, const model::PrescribedMotion& motion, bool rotation) {
  constexpr std::array quantities{Motion::Quantity::velocity, Motion::Quantity::acceleration,
                                  Motion::Quantity::displacement};
  if (motion.quantity < 0 || motion.quantity > 2) {
    builder.fail(Failure::Kind::not_calculated, motion.keyword, motion.place,
                 fmt::format("VAD {} is not calculated; 0, 1 and 2 are", motion.quantity));
    return std::nullopt;
  }
  Motion result;
  result.quantity = quantities[static_cast<std::size_t>(motion.quantity)];
  result.curve = builder.curve(motion.curve, motion.keyword, motion.place);
  if (result.curve == nullptr) return std::nullopt;
  result.phases = builder.phases(motion.curve);
  check_relaxation(builder, motion, result);
  result.scale = rotation ? motion.turn_scale : motion.scale;
  result.birth = motion.lifetime.birth;
  if (motion.lifetime.death < model::Lifetime::forever) result.death = motion.lifetime.death;
  return result;
}

bool overlap(const Motion& a, const Motion& b) {
  return a.birth < b.death && b.birth < a.death && a.phases.meet(b.phases);
}

/// Moves one degree of freedom of a body.
void move_body(ConditionBuilder& builder, const model::PrescribedMotion& motion, std::size_t body, std::size_t freedom,
               Motion given) {
  RigidBodies& rigid = builder.structure.rigid;
  bool twice = (rigid.held(body) >> freedom & 1u) != 0;
  for (const auto& [other, present] : rigid.motions(body))
    twice = twice || (other == freedom && overlap(present, given));
  if (twice)
    builder.fail(Failure::Kind::contradiction, motion.keyword, motion.place,
                 fmt::format("{} of rigid body {} is held or moved already; keep one of the conditions", names[freedom],
                             motion.part));
  if (given.quantity == Motion::Quantity::acceleration) {
    const auto axis = static_cast<int>(freedom % 3);
    given.initial = (freedom < 3 ? rigid[body].velocity() : rigid[body].angular_velocity())[axis];
  }
  rigid.move(body, freedom, std::move(given));
}

/// The motions of nodes so far, to find two on one degree of freedom.
using Present = std::map<std::uint64_t, std::vector<Motion>>;

void move_node(ConditionBuilder& builder, const model::PrescribedMotion& motion, NodeIndex node, std::size_t freedom,
               const Motion& given, std::uint32_t position, Present& present) {
  Structure& structure = builder.structure;
  const std::int64_t id = structure.node_id[node.value];
  if (structure.rigid.holds(node.value))
    return builder.fail(Failure::Kind::contradiction, motion.keyword, motion.place,
                        fmt::format("node {} belongs to a rigid body; move the body (_RIGID)", id));
  auto& lifetimes = present[6 * std::uint64_t{node.value} + freedom];
  bool twice = (structure.constraints.held(node.value) >> freedom & 1u) != 0;
  for (const Motion& other : lifetimes) twice = twice || overlap(other, given);
  if (twice)
    return builder.fail(
        Failure::Kind::contradiction, motion.keyword, motion.place,
        fmt::format("{} of node {} is held or moved already; keep one of the conditions", names[freedom], id));
  lifetimes.push_back(given);
  const auto axis = static_cast<int>(freedom % 3);
  const Vector& velocity = (freedom < 3 ? structure.state.v : structure.state.w)[node.value];
  const Matrix* axes = structure.constraints.axes(node.value);
  const double initial = axes != nullptr ? velocity.dot(axes->col(axis)) : velocity[axis];
  if (given.quantity == Motion::Quantity::acceleration && initial != 0) {
    Motion own = given;
    own.initial = initial;
    structure.constraints.move(node, freedom, std::move(own));
  } else {
    structure.constraints.move(node, freedom, position);
  }
}

void apply(ConditionBuilder& builder, const model::PrescribedMotion& motion, Present& present) {
  const auto directions = directions_of(builder, motion);
  if (!directions || builder.failed()) return;
  const auto whole = motion_of(builder, motion, directions->rotation);
  if (!whole) return;
  const bool rigid = motion.rigid;
  const std::vector<NodeIndex> nodes =
      rigid ? std::vector<NodeIndex>() : builder.nodes(motion.nodes, motion.keyword, motion.place);
  const auto body = rigid ? builder.body(motion.part, motion.keyword, motion.place) : std::nullopt;
  if (directions->axes && !builder.failed()) builder.use_axes(nodes, *directions->axes, motion.keyword, motion.place);
  if (!directions->axes) builder.refuse_axes(nodes, motion.keyword, motion.place);
  for (std::size_t axis = 0; axis < 3 && !builder.failed(); ++axis) {
    if ((directions->bits >> axis & 1u) == 0) continue;
    Motion given = *whole;
    given.scale *= directions->share[static_cast<int>(axis)];
    const std::size_t freedom = directions->rotation ? axis + 3 : axis;
    if (body) {
      move_body(builder, motion, *body, freedom, std::move(given));
      continue;
    }
    const std::uint32_t position = builder.structure.constraints.add(given);
    for (const NodeIndex node : nodes) move_node(builder, motion, node, freedom, given, position, present);
  }
}

/// Supports with a birth or death.
void add_supports(ConditionBuilder& builder, Present& present) {
  for (const model::SinglePointConstraint& spc : builder.model.spcs) {
    if (spc.lifetime.always()) continue;
    Motion held;
    held.birth = spc.lifetime.birth;
    held.death = spc.lifetime.death;
    held.phases = {true, true};
    for (const NodeIndex node : builder.nodes(spc.nodes, "BOUNDARY_SPC", spc.place))
      for (std::size_t freedom = 0; freedom < 6; ++freedom)
        if ((spc.freedoms >> freedom & 1u) != 0) present[6 * std::uint64_t{node.value} + freedom].push_back(held);
  }
}

}  // namespace

void apply_prescribed_motions(ConditionBuilder& builder) {
  Present present;
  if (!builder.model.prescribed_motions.empty()) add_supports(builder, present);
  for (const model::PrescribedMotion& motion : builder.model.prescribed_motions) {
    apply(builder, motion, present);
    if (builder.failed()) return;
  }
}

}  // namespace gapcheck::solver
