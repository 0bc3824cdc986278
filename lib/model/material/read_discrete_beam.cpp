#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

using BeamKind = DiscreteBeamMaterial::Kind;
using Six = DiscreteBeamMaterial::Six;

/// Factors of the deck's units on what belongs to translations and to rotations.
struct SixUnits {
  double translation = 1, rotation = 1;
};

Six six_reals(const Card& card, std::size_t first, const SixUnits& units) {
  Six values;
  for (std::size_t i = 0; i < 6; ++i) values[i] = card.real(first + i) * (i < 3 ? units.translation : units.rotation);
  return values;
}

Six read_six(CardReader& reader, const SixUnits& units) {
  static const CardLayout layout = real_line(6, 10);
  return six_reals(reader.next(layout), 0, units);
}

std::array<std::int64_t, 6> six_curves(const Context& context, const Block& block, const Card& card,
                                       std::size_t first) {
  std::array<std::int64_t, 6> ids;
  for (std::size_t i = 0; i < 6; ++i) ids[i] = context.curve_id(block, card.real(first + i));
  return ids;
}

DiscreteBeamMaterial::Cable read_cable(const Context& context, CardReader& reader, const Card& card) {
  static const CardLayout five = real_line(5, 10);
  const keyword::Transform& units = context.transform(reader.block());
  const double time = units.time_factor, force = units.mass_factor * units.length_factor / (time * time);
  DiscreteBeamMaterial::Cable cable;
  cable.young = card.real(2);
  cable.young *= cable.young > 0 ? context.stress(reader.block(), 1) : units.mass_factor / (time * time);
  cable.curve = context.curve_id(reader.block(), card.real(3));
  cable.force = card.real(4) * force;
  cable.end = card.real(5) * time;
  cable.ramp = card.real(6) * time;
  if (!(card.real(7) > 1)) return cable;  // IREAD
  const Card more = reader.next(five);
  cable.start = more.real(1) * time;
  cable.shortening = more.real(2);
  cable.failure_strain = more.real(3);
  cable.failure_force = more.real(4) * force;
  return cable;
}

}  // namespace

std::optional<DiscreteBeamMaterial> read_discrete_beam(const Context& context, CardReader& reader, const Card& card,
                                                       std::string_view name) {
  static const CardLayout six = real_line(6, 10);
  const Block& block = reader.block();
  const keyword::Transform& units = context.transform(block);
  const double time = units.time_factor, mass = units.mass_factor, length = units.length_factor;
  const SixUnits plain{length, 1}, stiffness{mass / (time * time), mass * length * length / (time * time)},
      damping{mass / time, mass * length * length / time},
      force{mass * length / (time * time), mass * length * length / (time * time)};
  DiscreteBeamMaterial data;
  if (name == "CABLE_DISCRETE_BEAM") {
    data.kind = BeamKind::cable;
    data.cable = read_cable(context, reader, card);
    return data;
  }
  const bool plastic = name == "NONLINEAR_PLASTIC_DISCRETE_BEAM";
  if (plastic || name == "LINEAR_ELASTIC_DISCRETE_BEAM") {
    data.stiffness = six_reals(card, 2, stiffness);
    data.damping = read_six(reader, damping);
  } else if (name == "NONLINEAR_ELASTIC_DISCRETE_BEAM") {
    data.kind = BeamKind::nonlinear;
    data.curve = six_curves(context, block, card, 2);
    data.damping_curve = six_curves(context, block, reader.next(six), 0);
    data.preload = read_six(reader, force);
  } else {
    return std::nullopt;
  }
  if (plastic) {
    data.kind = BeamKind::plastic;
    data.curve = six_curves(context, block, reader.next(six), 0);
  }
  if (data.kind != BeamKind::linear) {
    data.failure_force = read_six(reader, force);
    data.failure_motion = read_six(reader, plain);
  }
  if (data.kind != BeamKind::nonlinear) data.preload = read_six(reader, force);
  return data;
}

}  // namespace gapcheck::model
