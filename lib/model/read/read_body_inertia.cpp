#include "model/read/context.hpp"
#include "model/read/field_values.hpp"

namespace gapcheck::model {
namespace {

const keyword::CardLayout& inertia_card_layout(std::string_view card) {
  return keyword::card_layout("PART_INERTIA", card);
}

Eigen::Matrix3d tensor_of(const Card& card) {
  const double xx = card.real("ixx"), xy = card.real("ixy"), xz = card.real("ixz");
  const double yy = card.real("iyy"), yz = card.real("iyz"), zz = card.real("izz");
  Eigen::Matrix3d tensor;
  tensor << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return tensor;
}

/// The tensor in the axes of the card with the local ones: x, and a vector in the xy plane.
void turn_to_local(const Card& card, BodyInertia& inertia) {
  inertia.system = card.integer("cid");
  const Vector x = vector_at(card, 0), in_plane = vector_at(card, 3), z = x.cross(in_plane);
  if (inertia.system != 0 || !(z.norm() > 1e-12 * x.norm() * in_plane.norm())) return;
  Eigen::Matrix3d axes;
  axes.row(0) = x.normalized();
  axes.row(2) = z.normalized();
  axes.row(1) = axes.row(2).cross(axes.row(0));
  inertia.tensor = (axes.transpose() * inertia.tensor * axes).eval();
}

}  // namespace

BodyInertia read_body_inertia(Context& context, CardReader& reader) {
  const keyword::Transform& transform = context.transform(reader.block());
  const Card card = reader.next(inertia_card_layout("card3"));
  BodyInertia inertia;
  const double length = transform.length_factor;
  inertia.center = transform.apply(length * Vector(card.real("xc"), card.real("yc"), card.real("zc")));
  inertia.center_node = card.integer("nodeid");
  inertia.mass = card.real("tm") * transform.mass_factor;
  inertia.tensor = tensor_of(reader.next(inertia_card_layout("card4"))) * (transform.mass_factor * length * length);
  const Card motion = reader.next(inertia_card_layout("card5"));
  inertia.velocity = vector_at(motion, 0) * (length / transform.time_factor);
  inertia.spin = vector_at(motion, 3) / transform.time_factor;
  if (card.integer("ircs") == 1) turn_to_local(reader.next(inertia_card_layout("card6")), inertia);
  if (transform.places) {
    const Eigen::Matrix3d& turn = transform.matrix;
    inertia.tensor = (turn * inertia.tensor * turn.transpose()).eval();
    inertia.velocity = (turn * inertia.velocity).eval();
    inertia.spin = (turn * inertia.spin).eval();
  }
  return inertia;
}

}  // namespace gapcheck::model
