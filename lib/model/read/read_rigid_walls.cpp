#include <fmt/format.h>

#include <cmath>

#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

using Shape = RigidWall::Shape;

Vector point_at(const Card& card, std::string_view x, std::string_view y, std::string_view z) {
  return {card.real(x), card.real(y), card.real(z)};
}

/// The solver treats a length of zero as infinite.
double length_or_infinite(double value) { return value > 0 ? value : RigidWall::infinite; }

Shape shape_of(const Options& options) {
  if (options.has("PRISM")) return Shape::prism;
  if (options.has("CYLINDER")) return Shape::cylinder;
  return options.has("SPHERE") ? Shape::sphere : Shape::plane;
}

/// Edges of a rectangle: l as given, but in the plane of the wall; m is n x l. False if l is along the normal.
bool set_edges(const Card& card, RigidWall& wall) {
  wall.length_l = length_or_infinite(card.real("lenl"));
  wall.length_m = length_or_infinite(card.real("lenm"));
  const Vector along = point_at(card, "xhev", "yhev", "zhev") - wall.tail;
  const Vector in_plane = along - along.dot(wall.normal) * wall.normal;
  const bool needed = std::isfinite(wall.length_l) || std::isfinite(wall.length_m);
  if (!(in_plane.norm() > 1e-12 * along.norm())) return !needed;
  wall.edge_l = in_plane.normalized();
  wall.edge_m = wall.normal.cross(wall.edge_l);
  return true;
}

/// Both cards of _ORTHO.
void read_friction(Context& context, CardReader& reader, RigidWall& wall) {
  const keyword::Transform& units = context.transform(reader.block());
  const double per_speed = units.time_factor / units.length_factor;
  const Card values = reader.next(keyword::card_layout("RIGIDWALL_PLANAR_ORTHO", "card3"));
  const Card where = reader.next(keyword::card_layout("RIGIDWALL_PLANAR_ORTHO", "card4"));
  OrthotropicFriction& ortho = wall.ortho;
  ortho = {values.real("sfrica"),
           values.real("sfricb"),
           values.real("dfrica"),
           values.real("dfricb"),
           values.real("decaya") * per_speed,
           values.real("decayb") * per_speed,
           where.integer("node1"),
           where.integer("node2"),
           point_at(where, "d1", "d2", "d3")};
  if (units.places) ortho.direction = units.matrix * ortho.direction;
}

/// The card of _MOVING.
void read_moving(Context& context, CardReader& reader, RigidWall& wall) {
  const keyword::Transform& units = context.transform(reader.block());
  const Card card = reader.next(keyword::card_layout("RIGIDWALL_PLANAR_MOVING", "card3"));
  wall.mass = card.real("mass") * units.mass_factor;
  wall.velocity = card.real("v0") * units.length_factor / units.time_factor;
}

/// The card of _MOTION.
void read_motion(Context& context, CardReader& reader, RigidWall& wall) {
  const keyword::Transform& units = context.transform(reader.block());
  const Card card = reader.next(keyword::card_layout("RIGIDWALL_GEOMETRIC", "motion"));
  wall.motion_curve = card.integer("lcid");
  wall.motion_option = card.integer("opt");
  wall.motion_direction = point_at(card, "vx", "vy", "vz");
  if (units.places) wall.motion_direction = units.matrix * wall.motion_direction;
}

/// Reads the cards after the first two. False: they do not define a shape.
bool read_shape(Context& context, CardReader& reader, const Options& options, bool planar, RigidWall& wall) {
  const auto& edges = keyword::card_layout("RIGIDWALL_GEOMETRIC", "edges");
  if (planar) {
    if (options.has("ORTHO")) read_friction(context, reader, wall);
    const bool good = !options.has("FINITE") || set_edges(reader.next(edges), wall);
    if (options.has("MOVING")) read_moving(context, reader, wall);
    if (options.has("FORCES"))
      wall.soft = reader.next(keyword::card_layout("RIGIDWALL_PLANAR_FORCES", "card3")).integer("soft");
    return good;
  }
  bool good = true;
  if (wall.shape == Shape::plane || wall.shape == Shape::prism) {
    const Card card = reader.next(edges);
    good = set_edges(card, wall);
    wall.length_p = length_or_infinite(card.real("lenp"));
  } else {
    const Card card = reader.next(keyword::card_layout("RIGIDWALL_GEOMETRIC", "round"));
    wall.radius = card.real("radius");
    if (wall.shape == Shape::cylinder) {
      wall.length_l = length_or_infinite(card.real("length"));
      skip_lines(reader, card.integer("nsegs"));
    }
    good = wall.radius > 0;
  }
  if (options.has("MOTION")) read_motion(context, reader, wall);
  return good;
}

/// The wall moves with its include.
void place_wall(const keyword::Transform& transform, RigidWall& wall) {
  const auto turn = [&](Vector& direction, double& length) {
    const Vector turned = transform.places ? Vector(transform.matrix * direction) : direction;
    length *= transform.length_factor * turned.norm();
    direction = turned.normalized();
  };
  double across = 1;
  wall.tail = transform.apply(transform.length_factor * wall.tail);
  turn(wall.edge_l, wall.shape == Shape::cylinder ? across : wall.length_l);
  turn(wall.edge_m, wall.length_m);
  double& along = wall.shape == Shape::cylinder ? wall.length_l : wall.length_p;
  turn(wall.normal, along);
  wall.radius *= transform.length_factor;
  wall.offset *= transform.length_factor;
}

/// One wall; false if it has no shape.
bool read_wall(Context& context, const Block& block, CardReader& reader, const Options& options, RigidWall& wall) {
  const bool planar = block.name.starts_with("RIGIDWALL_PLANAR");
  wall.place = Context::place(block, block.line);
  wall.keyword = block.name;
  wall.id = static_cast<std::int64_t>(context.model.rigid_walls.size()) + 1;
  if (options.has("ID")) {
    const Card card = reader.next(keyword::card_layout("RIGIDWALL_GEOMETRIC", "ID"));
    if (card.integer("id") != 0) wall.id = card.integer("id");
    wall.title = card.text("title");
  }
  const Card card1 = planar ? reader.next(keyword::card_layout("RIGIDWALL_PLANAR", "card1"))
                            : reader.next(keyword::card_layout("RIGIDWALL_GEOMETRIC", "card1"));
  wall.node_set = card1.integer("nsid");
  wall.exempted_set = card1.integer("nsidex");
  wall.box = card1.integer("boxid");
  const double time = context.transform(block).time_factor;
  wall.birth = card1.real("birth") * time;
  wall.death = card1.real("death") * time;
  if (planar) {
    wall.offset = card1.real("offset");
    if (card1.real("rwksf") != 0) wall.stiffness_scale = card1.real("rwksf");
  }
  const Card card2 = reader.next(keyword::card_layout("RIGIDWALL_GEOMETRIC", "card2"));
  if (!card2.present()) {
    context.error(wall.place, fmt::format("*{}: the card with tail and head is missing", block.name));
    return false;
  }
  wall.friction = card2.real("fric");
  const keyword::Transform& units = context.transform(block);
  if (planar) wall.weld_velocity = card2.real("wvel") * units.length_factor / units.time_factor;
  wall.moving = options.any({"MOVING", "MOTION"});
  wall.orthotropic = options.has("ORTHO");
  wall.shape = shape_of(options);
  wall.interior = options.has("INTERIOR");
  wall.tail = point_at(card2, "xt", "yt", "zt");
  const Vector direction = point_at(card2, "xh", "yh", "zh") - wall.tail;
  const bool directed = direction.norm() > 0;
  if (directed) wall.normal = direction.normalized();
  const bool shaped = read_shape(context, reader, options, planar, wall);
  if ((directed || wall.shape == Shape::sphere) && shaped) return true;
  context.error(wall.place,
                fmt::format("rigid wall {}: {}; the wall is left out", wall.id,
                            !shaped ? "its edge or radius makes no shape" : "its tail and head are one point"));
  return false;
}

}  // namespace

void read_rigid_wall(Context& context, const Block& block, const Options& options) {
  CardReader reader(context.deck, block, context.diagnostics);
  const bool geometric = block.name.starts_with("RIGIDWALL_GEOMETRIC");
  if (geometric && !options.any({"FLAT", "PRISM", "CYLINDER", "SPHERE"})) {
    context.warning(Context::place(block, block.line), fmt::format("*{} has no shape and is not read", block.name));
    return;
  }
  // The first card of the first wall may be blank; further walls start at a line that is not.
  for (bool first = true; !reader.at_end(); first = false) {
    if (!first && skip_blank(reader)) continue;
    RigidWall wall;
    const bool good = read_wall(context, block, reader, options, wall);
    place_wall(context.transform(block), wall);
    if (good) context.model.rigid_walls.push_back(std::move(wall));
    // The number of lines for displaying a wall differs between versions.
    if (options.has("DISPLAY")) break;
  }
}

}  // namespace gapcheck::model
