#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// Points are used up to the last one with a yield stress.
std::vector<std::array<double, 2>> read_points(CardReader& reader, double stress) {
  static const CardLayout eight = real_line(8, 10);
  const Card strains = reader.next(eight), stresses = reader.next(eight);
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = 0; i < 8 && strains.present() && stresses.present(); ++i)
    if (stresses.real(i) != 0) points.push_back({strains.real(i), stresses.real(i) * stress});
  return points;
}

/// HLCID, the last field of the first card of material 037. The card was split into real numbers, which have no
/// offsets.
std::int64_t curve_at(const Context& context, const Block& block, const Card& card) {
  const double id = card.real(7);
  if (!(id >= 1 && id < 1e9)) return 0;
  return context.with_offset(block, keyword::IdKind::function, static_cast<std::int64_t>(id));
}

void set_rate_formulation(double vp, Plasticity& plasticity) {
  plasticity.viscoplastic = vp == 1;
  if (vp != 0 && vp != 1) plasticity.other_vp = vp;
}

/// Material 018: K, N, SRC, SRP in the first card; SIGY, VP and EPSF in the second.
Plasticity read_power_law(CardReader& reader, const Card& card, double stress, double time) {
  Plasticity plasticity;
  plasticity.power_k = card.real(4) * stress;
  plasticity.power_n = card.real(5);
  plasticity.rate_c = card.real(6) / time;
  plasticity.rate_p = card.real(7);
  const Card second = reader.next(keyword::card_layout("MAT_POWER_LAW_PLASTICITY", "card2"));
  plasticity.sigy = second.real("sigy");  // a strain below 0.02, a stress above it
  constexpr double least_stress = 0.02;
  if (plasticity.sigy >= least_stress) plasticity.sigy *= stress;
  set_rate_formulation(second.real("vp"), plasticity);
  plasticity.failure_strain = second.real("epsf");
  return plasticity;
}

}  // namespace

std::optional<Plasticity> read_plasticity(Context& context, CardReader& reader, const Card& card,
                                          std::string_view name) {
  static const CardLayout eight = real_line(8, 10);
  const bool kinematic = name == "PLASTIC_KINEMATIC", modified = name == "MODIFIED_PIECEWISE_LINEAR_PLASTICITY";
  const bool damaged = name == "PLASTICITY_WITH_DAMAGE", power = name == "POWER_LAW_PLASTICITY";
  const bool piecewise = name == "PIECEWISE_LINEAR_PLASTICITY" || modified || damaged;
  const bool anisotropic = name == "TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC";
  if (!kinematic && !piecewise && !anisotropic && !power) return std::nullopt;
  const keyword::Transform& units = context.transform(reader.block());
  const double stress = units.mass_factor / (units.length_factor * units.time_factor * units.time_factor);
  if (power) return read_power_law(reader, card, stress, units.time_factor);
  Plasticity plasticity;
  plasticity.sigy = card.real(4) * stress;
  plasticity.etan = card.real(5) * stress;
  if (kinematic) plasticity.beta = card.real(6);
  if (kinematic) {
    const Card rate = reader.next(eight);
    plasticity.rate_c = rate.real(std::size_t{0}) / units.time_factor;
    plasticity.rate_p = rate.real(1);
    plasticity.failure_strain = rate.real(2);
    set_rate_formulation(rate.real(3), plasticity);
    return plasticity;
  }
  if (anisotropic) {
    plasticity.anisotropy = card.real(6, 1);
    plasticity.lcss = curve_at(context, reader.block(), card);
    return plasticity;
  }
  (damaged ? plasticity.softening : plasticity.failure_strain) = card.real(6);
  const std::string keyword = modified  ? "MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY"
                              : damaged ? "MAT_PLASTICITY_WITH_DAMAGE"
                                        : "MAT_PIECEWISE_LINEAR_PLASTICITY";
  const Card rate = reader.next(keyword::card_layout(keyword, "card2"));
  plasticity.rupture = rate.real("eppfr");
  plasticity.damage_curve = rate.integer("lcdm");
  plasticity.thinning = rate.real("epsthin");
  plasticity.major_strain = rate.real("epsmaj");
  plasticity.failed_points = rate.real("numint");
  plasticity.rate_c = rate.real("c") / units.time_factor;
  plasticity.rate_p = rate.real("p");
  plasticity.lcss = rate.integer("lcss");
  plasticity.lcsr = rate.integer("lcsr");
  set_rate_formulation(rate.real("vp"), plasticity);
  plasticity.points = read_points(reader, stress);
  return plasticity;
}

SpotWeld read_spotweld(Context& context, CardReader& reader, const Card& card, std::string_view name) {
  SpotWeld weld;
  if (name.ends_with("_TITLE")) name.remove_suffix(6);
  if (name != "SPOTWELD" && name != "100") {
    weld.variant = name;
    return weld;
  }
  const Block& block = reader.block();
  const keyword::Transform& units = context.transform(block);
  if (const double curve = -card.real(4); curve >= 1 && curve < 1e9)
    weld.curve = context.with_offset(block, keyword::IdKind::function, static_cast<std::int64_t>(curve));
  else
    weld.sigy = context.stress(block, card.real(4));
  weld.hardening = context.stress(block, card.real(5));
  weld.step = card.real(6) * units.time_factor;
  weld.failure_time = card.real(7) * units.time_factor;
  const Card limits = reader.next(keyword::card_layout("MAT_SPOTWELD", "card2"));
  weld.failure_strain = limits.real("efail");
  const double force = context.stress(block, units.length_factor * units.length_factor);
  constexpr std::array<std::string_view, 6> names{"nrr", "nrs", "nrt", "mrr", "mss", "mtt"};
  for (std::size_t i = 0; i < names.size(); ++i)
    weld.strength[i] = limits.real(names[i]) * force * (i < 3 ? 1 : units.length_factor);
  weld.filter = limits.real("nf");
  return weld;
}

}  // namespace gapcheck::model
