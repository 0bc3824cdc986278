#include <fmt/format.h>

#include <Eigen/Geometry>
#include <utility>

#include "model/read/cards.hpp"
#include "model/read/context.hpp"
#include "model/read/field_values.hpp"

namespace gapcheck::model {
namespace {

/// Columns: the local axes, from a direction along x and another one in the local xy plane.
Result<Eigen::Matrix3d> local_axes(const Vector& along_x, const Vector& in_plane) {
  constexpr double least_sine = 1e-9;
  const Vector z = along_x.cross(in_plane);
  if (!(z.norm() > least_sine * along_x.norm() * in_plane.norm())) return plain_error("its axes do not span a plane");
  Eigen::Matrix3d axes;
  axes.col(0) = along_x.normalized();
  axes.col(2) = z.normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

/// A direction that a block gives by its components.
Vector placed(const keyword::Transform& transform, const Vector& direction) {
  return transform.places ? Vector(transform.matrix * direction) : direction;
}

Result<Eigen::Matrix3d> axes_by_points(Context& context, const Block& block, const Card& card, const Card& second) {
  if (card.integer("cidl") != 0) return plain_error("it is given in another system (CIDL), which is not supported");
  if (second.integer("type") != 0) return plain_error("it is not Cartesian (TYPE)");
  const Vector origin = vector_at(card, 1);
  const keyword::Transform& transform = context.transform(block);
  return local_axes(placed(transform, vector_at(card, 4) - origin), placed(transform, vector_at(second, 0) - origin));
}

Result<Eigen::Matrix3d> axes_by_nodes(Context& context, const Card& card) {
  if (card.integer("type") != 0) return plain_error("it is not Cartesian (TYPE)");
  if (const std::string_view axis = card.text("dir"); !axis.empty() && axis != "X" && axis != "x")
    return plain_error(fmt::format("its first axis is {} (DIR); only X is supported", axis));
  const Nodes& nodes = context.model.mesh.nodes;
  std::array<Vector, 3> x;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::int64_t id = card.integer(i + 1);
    const auto position = nodes.lookup.find(id);
    if (!position) return plain_error(fmt::format("its node {} is not defined", id));
    x[i] = nodes.x[*position];
  }
  return local_axes(x[1] - x[0], x[2] - x[0]);
}

Result<Eigen::Matrix3d> axes_by_vectors(Context& context, const Block& block, const Card& card) {
  const keyword::Transform& transform = context.transform(block);
  return local_axes(placed(transform, vector_at(card, 1)), placed(transform, vector_at(card, 4)));
}

/// All systems of the deck; of one id the first.
void read_systems(Context& context) {
  constexpr std::string_view family = "DEFINE_COORDINATE_";
  for (const Block& block : context.deck.blocks()) {
    std::string_view form = block.name;
    if (!form.starts_with(family)) continue;
    form.remove_prefix(family.size());
    const bool titled = form.ends_with("_TITLE");
    if (titled) form.remove_suffix(std::string_view("_TITLE").size());
    if (form != "SYSTEM" && form != "NODES" && form != "VECTOR") continue;
    CardReader reader(context.deck, block, context.diagnostics);
    while (!reader.at_end()) {
      if (titled) reader.skip();
      if (reader.at_end()) break;
      if (skip_blank(reader)) continue;
      const auto& layout = [&](std::string_view card) -> const CardLayout& {
        return keyword::card_layout(std::string(family) + std::string(form), card);
      };
      const Card card = reader.next(layout("card1"));
      const std::int64_t id = card.integer("cid");
      if (form == "NODES" && card.integer("flag") != 0) context.moving_systems.insert(id);
      context.systems.try_emplace(id, form == "SYSTEM"
                                          ? axes_by_points(context, block, card, reader.next(layout("card2")))
                                      : form == "NODES" ? axes_by_nodes(context, card)
                                                        : axes_by_vectors(context, block, card));
    }
  }
}

}  // namespace

Result<Eigen::Matrix3d> axes_of_system(Context& context, std::int64_t id) {
  if (!std::exchange(context.systems_read, true)) read_systems(context);
  const auto found = context.systems.find(id);
  if (found == context.systems.end()) return plain_error("no *DEFINE_COORDINATE_SYSTEM, _NODES or _VECTOR defines it");
  return found->second;
}

void note_system(Context& context, std::int64_t id) {
  if (id == 0 || context.model.systems.count(id) > 0) return;
  LocalSystem system;
  const Result<Eigen::Matrix3d> axes = axes_of_system(context, id);
  if (!axes)
    system.fault = axes.error().message;
  else if (context.moving_systems.count(id) > 0)
    system.fault = "it moves with its nodes (FLAG = 1)";
  else
    system.axes = axes.value();
  context.model.systems.emplace(id, std::move(system));
}

}  // namespace gapcheck::model
