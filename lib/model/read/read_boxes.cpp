#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "model/read/cards.hpp"
#include "model/read/context.hpp"
#include "model/read/field_values.hpp"

namespace gapcheck::model {
namespace {

/// Axes from a point on the local x axis and one in the local xy plane, both seen from the origin. False if they are on
/// one line.
bool set_axes(const Vector& along_x, const Vector& in_plane, Eigen::Matrix3d& axes) {
  const Vector z = along_x.cross(in_plane);
  if (!(z.norm() > 1e-12 * along_x.norm() * in_plane.norm())) return false;
  axes.row(0) = along_x.normalized();
  axes.row(2) = z.normalized();
  axes.row(1) = axes.row(2).cross(axes.row(0));
  return true;
}

void read_local_axes(Context& context, CardReader& reader, Box& box) {
  const Card directions = reader.next(keyword::card_layout("DEFINE_BOX_LOCAL", "card2"));
  const Card origin = reader.next(keyword::card_layout("DEFINE_BOX_LOCAL", "card3"));
  box.origin = vector_at(origin, 0);
  if (!set_axes(vector_at(directions, 0), vector_at(directions, 3), box.axes))
    context.error(box.place, fmt::format("box {}: the two vectors of its local system do not span a plane; "
                                         "the global axes are used",
                                         box.id));
}

/// An included box moves with its include: it keeps its own coordinates and gets new axes.
void place_box(Context& context, const keyword::Transform& transform, Box& box) {
  box.low *= transform.length_factor;
  box.high *= transform.length_factor;
  box.origin *= transform.length_factor;
  if (!transform.places) return;
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(transform.matrix);
  if (!lu.isInvertible()) {
    context.error(box.place, fmt::format("box {}: the transformation of its include cannot be inverted", box.id));
    return;
  }
  box.origin = transform.apply(box.origin);
  box.axes = (box.axes * lu.inverse()).eval();
}

}  // namespace

void read_box(Context& context, const Block& block, const Options& options) {
  const CardLayout& layout = keyword::card_layout("DEFINE_BOX", "card1");
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (options.has("TITLE")) reader.skip();
    if (reader.at_end()) break;
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    Box box;
    box.id = card.integer("boxid");
    box.place = Context::place(block, card.line());
    box.low = Vector(card.real("xmn"), card.real("ymn"), card.real("zmn"));
    box.high = Vector(card.real("xmx"), card.real("ymx"), card.real("zmx"));
    if (options.has("LOCAL")) read_local_axes(context, reader, box);
    place_box(context, context.transform(block), box);
    const auto [entry, is_new] = context.model.boxes.try_emplace(box.id, box);
    if (!is_new) context.duplicate("box", box.id, entry->second.place, box.place);
  }
}

}  // namespace gapcheck::model
