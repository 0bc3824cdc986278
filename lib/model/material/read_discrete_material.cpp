#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

using DiscreteKind = DiscreteMaterial::Kind;

/// The same line again, with another layout.
Card read_again(const Context& context, const Block& block, const Card& card, const keyword::CardLayout& layout) {
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end() && reader.peek_line() < card.line()) reader.skip();
  return reader.next(layout);
}

}  // namespace

std::optional<DiscreteMaterial> read_discrete_material(const Context& context, const Block& block, const Card& card,
                                                       std::string_view name) {
  using keyword::card_layout;
  const keyword::Transform& units = context.transform(block);
  const double time = units.time_factor, stiffness = units.mass_factor / (time * time);
  const double force = stiffness * units.length_factor;
  DiscreteMaterial material;
  material.length_factor = units.length_factor;
  if (name == "SPRING_ELASTIC") {
    material.constant = card.real(1) * units.mass_factor / (time * time);
  } else if (name == "DAMPER_VISCOUS") {
    material.kind = DiscreteKind::damper;
    material.constant = card.real(1) * units.mass_factor / time;
  } else if (name == "SPRING_ELASTOPLASTIC") {
    material.kind = DiscreteKind::plastic_spring;
    material.constant = card.real(1) * stiffness;
    material.tangent = card.real(2) * stiffness;
    material.yield = card.real(3) * force;
  } else if (name == "SPRING_NONLINEAR_ELASTIC") {
    material.kind = DiscreteKind::nonlinear_spring;
    const Card curves = read_again(context, block, card, card_layout("MAT_SPRING_NONLINEAR_ELASTIC", "card1"));
    material.curve = curves.integer("lcd");
    material.rate_curve = curves.integer("lcr");
  } else if (name == "DAMPER_NONLINEAR_VISCOUS") {
    material.kind = DiscreteKind::nonlinear_damper;
    material.curve =
        read_again(context, block, card, card_layout("MAT_DAMPER_NONLINEAR_VISCOUS", "card1")).integer("lcdr");
  } else if (name == "SPRING_MAXWELL") {
    material.kind = DiscreteKind::maxwell_spring;
    material.constant = card.real(1) * stiffness;
    material.long_time = card.real(2) * stiffness;
    material.decay = card.real(3) / time;
    material.cutoff = card.real(4) * time;
    material.cutoff_force = card.real(5) * force;
    material.option = card.real(6);
  } else if (name == "SPRING_INELASTIC") {
    material.kind = DiscreteKind::inelastic_spring;
    const Card written = read_again(context, block, card, card_layout("MAT_SPRING_INELASTIC", "card1"));
    material.curve = written.integer("lcfd");
    material.constant = written.real("ku") * stiffness;
    material.sense = written.real("ctf");
  } else {
    return std::nullopt;
  }
  return material;
}

}  // namespace gapcheck::model
