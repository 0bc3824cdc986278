#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// EPS1 to EPS16 and ES1 to ES16, up to the last one with a yield stress.
std::vector<std::array<double, 2>> read_yield_points(CardReader& reader, double stress) {
  static const CardLayout eight = real_line(8, 10);
  std::array<Card, 4> cards;
  for (Card& card : cards) card = reader.next(eight);
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = 0; i < 16; ++i) {
    const double yield = cards[2 + i / 8].real(i % 8);
    if (cards[2 + i / 8].present() && yield != 0) points.push_back({cards[i / 8].real(i % 8), yield * stress});
  }
  return points;
}

}  // namespace

Fluid read_fluid(const Context& context, const Block& block, const Card& card) {
  const double stress = context.stress(block, 1);
  return {card.real(2) * stress, card.real(3) * stress * context.transform(block).time_factor, card.real(4),
          card.real(5)};
}

Hydro read_hydro(const Context& context, CardReader& reader, const Card& card, std::string_view name) {
  const double stress = context.stress(reader.block(), 1);
  Hydro hydro;
  hydro.shear = card.real(2) * stress;
  hydro.sigy = card.real(3) * stress;
  hydro.eh = card.real(4) * stress;
  hydro.pc = card.real(5) * stress;
  hydro.fs = card.real(6);
  hydro.charl = card.real(7);
  hydro.stochastic = name.find("STOCHASTIC") != std::string_view::npos;
  if (name.find("SPALL") != std::string_view::npos) {
    const Card spall = reader.next(keyword::card_layout("MAT_ELASTIC_PLASTIC_HYDRO_SPALL", "card2"));
    hydro.a1 = spall.real("a1");
    hydro.a2 = spall.real("a2");
    hydro.spall = spall.real("spall");
  }
  hydro.points = read_yield_points(reader, stress);
  return hydro;
}

JohnsonCook read_johnson_cook(const Context& context, CardReader& reader, const Card& card, std::string_view name) {
  const keyword::Transform& units = context.transform(reader.block());
  const double stress = context.stress(reader.block(), 1);
  JohnsonCook data;
  data.simplified = name == "SIMPLIFIED_JOHNSON_COOK";
  const auto strength = [&](const Card& of) {
    data.a = of.real("a") * stress;
    data.b = of.real("b") * stress;
    data.n = of.real("n");
    data.c = of.real("c");
    data.rate = of.real("epso") / units.time_factor;
  };
  if (data.simplified) {
    data.vp = card.real(4);
    const Card limits = reader.next(keyword::card_layout("MAT_SIMPLIFIED_JOHNSON_COOK", "card2"));
    strength(limits);
    data.failure_strain = limits.real("psfail");
    data.most_stress = limits.real("sigmax") * stress;
    data.saturation = limits.real("sigsat") * stress;
    return data;
  }
  data.shear = card.real(2) * stress;
  data.dtf = card.real(5);
  data.vp = card.real(6);
  data.rateop = card.real(7);
  const Card second = reader.next(keyword::card_layout("MAT_JOHNSON_COOK", "card2"));
  strength(second);
  data.m = second.real("m");
  data.melting = second.real("tm");
  data.room = second.real("tr");
  const Card third = reader.next(keyword::card_layout("MAT_JOHNSON_COOK", "card3"));
  const double velocity = units.length_factor / units.time_factor;
  data.heat = third.real("cp") * velocity * velocity;
  data.pc = third.real("pc") * stress;
  data.spall = third.real("spall");
  data.iterate = third.real("it");
  for (std::size_t i = 0; i < 4; ++i) data.d[i] = third.real(4 + i);
  const Card fourth = reader.next(keyword::card_layout("MAT_JOHNSON_COOK", "card4"));
  data.d[4] = fourth.real("d5");
  data.c2p = fourth.real("c2p");
  data.erod = fourth.real("erod");
  data.efmin = fourth.real("efmin");
  data.numint = fourth.real("numint");
  return data;
}

}  // namespace gapcheck::model
