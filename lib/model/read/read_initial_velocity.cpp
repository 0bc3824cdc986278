#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// Velocities of a block in the model's units and axes.
struct Motions {
  const keyword::Transform& transform;

  [[nodiscard]] Vector turned(const Vector& direction) const {
    return transform.places ? Vector(transform.matrix * direction) : direction;
  }
  [[nodiscard]] Vector velocity(const Card& card, std::string_view x, std::string_view y, std::string_view z) const {
    const double factor = transform.length_factor / transform.time_factor;
    return turned(factor * Vector(card.real(x), card.real(y), card.real(z)));
  }
  [[nodiscard]] Vector spin(const Card& card, std::string_view x, std::string_view y, std::string_view z) const {
    return turned(Vector(card.real(x), card.real(y), card.real(z)) / transform.time_factor);
  }
};

InitialVelocity start(const Block& block, InitialVelocity::Kind kind, const Card& card) {
  InitialVelocity initial;
  initial.kind = kind;
  initial.keyword = block.name;
  initial.place = Context::place(block, card.line());
  return initial;
}

}  // namespace

void read_initial_velocity(Context& context, const Block& block, const Options&) {
  const Motions motions{context.transform(block)};
  CardReader reader(context.deck, block, context.diagnostics);
  // The first card of the first set may be blank: all nodes.
  for (bool first = true; !reader.at_end(); first = false) {
    if (!first && skip_blank(reader)) continue;
    const Card head = reader.next(keyword::card_layout("INITIAL_VELOCITY", "card1"));
    InitialVelocity initial = start(block, InitialVelocity::Kind::general, head);
    initial.id = head.integer("nsid");
    initial.exempted_set = head.integer("nsidex");
    initial.box = head.integer("boxid");
    initial.irigid = head.integer("irigid");
    initial.system = head.integer("icid");
    const Card card = reader.next(keyword::card_layout("INITIAL_VELOCITY", "card2"));
    initial.velocity = motions.velocity(card, "vx", "vy", "vz");
    initial.spin = motions.spin(card, "vxr", "vyr", "vzr");
    if (initial.exempted_set > 0) {
      const Card others = reader.next(keyword::card_layout("INITIAL_VELOCITY", "card3"));
      initial.exempted_velocity = motions.velocity(others, "vxe", "vye", "vze");
      initial.exempted_spin = motions.spin(others, "vxre", "vyre", "vzre");
    }
    context.model.initial_velocities.push_back(std::move(initial));
  }
}

void read_initial_velocity_node(Context& context, const Block& block, const Options&) {
  const auto& layout = keyword::card_layout("INITIAL_VELOCITY_NODE", "card1");
  const Motions motions{context.transform(block)};
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    context.model.node_velocities.push_back(
        {card.integer("nid"), card.integer("icid"), motions.velocity(card, "vx", "vy", "vz"),
         motions.spin(card, "vxr", "vyr", "vzr"), Context::place(block, card.line())});
  }
}

void read_initial_velocity_rigid_body(Context& context, const Block& block, const Options&) {
  const auto& layout = keyword::card_layout("INITIAL_VELOCITY_RIGID_BODY", "card1");
  const Motions motions{context.transform(block)};
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    InitialVelocity initial = start(block, InitialVelocity::Kind::rigid_body, card);
    initial.id = card.integer("pid");
    initial.velocity = motions.velocity(card, "vx", "vy", "vz");
    initial.spin = motions.spin(card, "vxr", "vyr", "vzr");
    initial.system = card.integer("icid");
    context.model.initial_velocities.push_back(std::move(initial));
  }
}

void read_initial_velocity_generation(Context& context, const Block& block, const Options&) {
  const keyword::Transform& transform = context.transform(block);
  const Motions motions{transform};
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(keyword::card_layout("INITIAL_VELOCITY_GENERATION", "card1"));
    const Card axis = reader.next(keyword::card_layout("INITIAL_VELOCITY_GENERATION", "card2"));
    InitialVelocity initial = start(block, InitialVelocity::Kind::generation, card);
    initial.target = card.integer("styp");
    initial.id = context.with_offset(block, initial.target == 2 ? IdKind::part : IdKind::set, card.integer("id"));
    initial.velocity = motions.velocity(card, "vx", "vy", "vz");
    initial.system = card.integer("icid");
    initial.rate = card.real("omega") / transform.time_factor;
    initial.origin =
        transform.apply(transform.length_factor * Vector(axis.real("xc"), axis.real("yc"), axis.real("zc")));
    constexpr double axis_by_nodes = -999;
    if (axis.real("nx") == axis_by_nodes) {
      for (const auto& [place, name] : {std::pair{0, "ny"}, std::pair{1, "nz"}})
        if (const double id = axis.real(name); id > 0 && id < 1e15)
          initial.axis_nodes[place] = context.with_offset(block, IdKind::node, static_cast<std::int64_t>(id));
    } else {
      const Vector direction = motions.turned({axis.real("nx"), axis.real("ny"), axis.real("nz")});
      const double length = direction.norm();
      initial.spin = length > 0 ? Vector(initial.rate / length * direction) : Vector::Zero();
    }
    initial.phase = axis.integer("phase");
    initial.irigid = axis.integer("irigid");
    context.model.initial_velocities.push_back(std::move(initial));
  }
}

}  // namespace gapcheck::model
