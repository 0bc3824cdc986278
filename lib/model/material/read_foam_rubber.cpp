#include <fmt/format.h>

#include <algorithm>

#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// What a rubber asks for that is not calculated: the first named field that is not zero.
void name_unread(const Card& card, std::initializer_list<std::string_view> names, std::string& unread) {
  for (const std::string_view field : names)
    if (const double value = card.real(field); value != 0 && unread.empty()) {
      std::string upper(field);
      for (char& c : upper) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
      unread = fmt::format("{} = {:g}", upper, value);
    }
}

LowDensityFoam read_low_density_foam(const Context& context, CardReader& reader, const Card& card) {
  const Block& block = reader.block();
  const double stress = context.stress(block, 1), time = context.transform(block).time_factor;
  LowDensityFoam foam;
  foam.curve = context.curve_id(block, card.real(3));
  foam.cutoff = card.real(4) * stress;
  foam.unloading = card.real(5);
  foam.decay = card.real(6) / time;
  foam.damping = card.real(7);
  const Card second = reader.next(keyword::card_layout("MAT_LOW_DENSITY_FOAM", "card2"));
  foam.shape = second.real("shape");
  foam.fail = second.real("fail");
  foam.bulk_viscosity = second.real("bvflag");
  foam.relaxing = second.real("ed") * stress;
  foam.relaxation_rate = second.real("beta1") / time;
  foam.contact = second.real("kcon") * stress;
  foam.reference = second.real("ref");
  return foam;
}

SpecimenTest read_test(const Card& card, double length, std::string_view curve) {
  return {card.real("sgl") * length, card.real("sw") * length, card.real("st") * length, card.integer(curve)};
}

TabulatedRubber read_tabulated(const Context& context, CardReader& reader, const Card& card, std::string_view name) {
  const Block& block = reader.block();
  TabulatedRubber rubber;
  rubber.bulk = context.stress(block, card.real(2));
  rubber.damping = card.real(3);
  for (const auto& [field, what] : {std::pair<std::size_t, std::string_view>(4, "G"), {5, "SIGF"}, {6, "REF"}})
    if (const double value = card.real(field); value != 0 && rubber.unread.empty())
      rubber.unread = fmt::format("{} = {:g}", what, value);
  if (name.find("LOG_LOG") != std::string_view::npos) rubber.unread = "LOG_LOG_INTERPOLATION";
  const Card second = reader.next(keyword::card_layout("MAT_SIMPLIFIED_RUBBER/FOAM", "card2"));
  rubber.test = read_test(second, context.transform(block).length_factor, "tbid");
  rubber.poisson = second.real("pr");
  rubber.tension = second.real("tension");
  rubber.rate_type = second.real("rtype");
  rubber.averaging = second.real("avgopt");
  if (rubber.averaging < 0) rubber.averaging *= context.transform(block).time_factor;
  if (name.find("WITH_FAILURE") != std::string_view::npos) {
    rubber.unread = "WITH_FAILURE";
    reader.skip();
  }
  const Card third = reader.next(keyword::card_layout("MAT_SIMPLIFIED_RUBBER/FOAM", "card3"));
  rubber.unloading_curve = third.integer("lcunld");
  rubber.unloading = third.real("hu");
  rubber.shape = third.real("shape");
  name_unread(third, {"visco"}, rubber.unread);
  return rubber;
}

/// Both begin with MID, RO, PR, N, NV, G, SIGF, REF.
ConstantRubber read_constants(const Context& context, CardReader& reader, const Card& card, bool ogden) {
  static const CardLayout eight = real_line(8, 10);
  const double stress = context.stress(reader.block(), 1);
  ConstantRubber rubber;
  rubber.ogden = ogden;
  for (const auto& [field, what] :
       {std::pair<std::size_t, std::string_view>(3, "N"), {5, "G"}, {6, "SIGF"}, {7, "REF"}})
    if (const double value = card.real(field); value != 0 && rubber.unread.empty())
      rubber.unread = fmt::format("{} = {:g}", what, value);
  if (!rubber.unread.empty()) return rubber;
  const Card constants = reader.next(eight);
  if (ogden) {
    const Card exponents = reader.next(eight);
    for (std::size_t i = 0; i < 8; ++i) {
      rubber.mu[i] = constants.real(i) * stress;
      rubber.alpha[i] = exponents.real(i);
    }
  } else {
    for (std::size_t i = 0; i < 6; ++i) rubber.c[i] = constants.real(i) * stress;
  }
  while (!reader.at_end()) {
    const Card relaxation = reader.next(eight);
    if (const double modulus = relaxation.real(std::size_t{0}); modulus != 0 && rubber.unread.empty())
      rubber.unread = fmt::format("the relaxation modulus {:g}", modulus);
  }
  return rubber;
}

/// E and ν of small strains by G and K.
void set_moduli(double shear, double bulk, Material& material) {
  material.bulk = bulk;
  material.stiffness_known = bulk != 0;
  if (!(shear > 0) || !(bulk > 0)) return;
  material.young = 9 * bulk * shear / (3 * bulk + shear);
  material.poisson = (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
}

double bulk_of(double shear, double poisson) { return 2 * shear * (1 + poisson) / (3 * (1 - 2 * poisson)); }

/// A and B by least squares of the nominal stress, 2 (λ − λ⁻²) A + 2 (1 − λ⁻³) B, at the points of the test. Nothing
/// without a test or where it does not decide both.
void fit_to_test(const Model& model, Material& material) {
  MooneyRivlin& rubber = *material.mooney_rivlin;
  const SpecimenTest& test = rubber.test;
  const auto curve = model.curves.find(test.curve);
  if (test.curve == 0 || rubber.a != 0 || rubber.b != 0 || curve == model.curves.end()) return;
  if (!(test.length > 0 && test.width > 0 && test.thickness > 0)) return;
  double aa = 0, ab = 0, bb = 0, at = 0, bt = 0;
  for (const auto& [elongation, force] : curve->second.points) {
    const double stretch = 1 + elongation / test.length, stress = force / (test.width * test.thickness);
    if (!(stretch > 0)) return;
    const double a = 2 * (stretch - 1 / (stretch * stretch)), b = 2 * (1 - 1 / (stretch * stretch * stretch));
    aa += a * a;
    ab += a * b;
    bb += b * b;
    at += a * stress;
    bt += b * stress;
  }
  constexpr double alike = 1e-9;
  const double determinant = aa * bb - ab * ab;
  if (!(determinant > alike * aa * bb)) return;
  rubber.a = (at * bb - bt * ab) / determinant;
  rubber.b = (bt * aa - at * ab) / determinant;
  set_small_strain_moduli(material);
}

/// G of 077 at small strains.
double shear_of(const ConstantRubber& rubber) {
  double sum = 2 * (rubber.c[0] + rubber.c[1]);
  for (std::size_t i = 0; i < 8; ++i) sum += rubber.mu[i] * rubber.alpha[i] / 2;
  return sum;
}

}  // namespace

void read_foam_rubber(Context& context, CardReader& reader, const Card& card, std::string_view name,
                      std::string_view whole_name, Material& material) {
  const Block& block = reader.block();
  const double stress = context.stress(block, 1), time = context.transform(block).time_factor;
  if (name == "LOW_DENSITY_FOAM") {
    material.foam_rubber = read_low_density_foam(context, reader, card);
  } else if (name == "CRUSHABLE_FOAM") {
    material.foam_rubber =
        CrushableFoam{context.curve_id(block, card.real(4)), card.real(5) * stress, card.real(6), card.real(7)};
  } else if (name == "VISCOELASTIC") {
    const Viscoelastic data{card.real(2) * stress, card.real(3) * stress, card.real(4) * stress, card.real(5) / time};
    material.foam_rubber = data;
    set_moduli(data.shear, data.bulk, material);
  } else if (name == "BLATZ-KO_RUBBER") {
    constexpr double poisson = 0.463;
    const BlatzKo data{card.real(2) * stress, card.real(3)};
    material.foam_rubber = data;
    set_moduli(data.shear, bulk_of(data.shear, poisson), material);
  } else if (name == "SIMPLIFIED_RUBBER") {
    material.foam_rubber = read_tabulated(context, reader, card, whole_name);
  } else if (name == "OGDEN_RUBBER" || name == "HYPERELASTIC_RUBBER") {
    const ConstantRubber data = read_constants(context, reader, card, name == "OGDEN_RUBBER");
    material.foam_rubber = data;
    if (material.poisson > -1 && material.poisson < 0.5 && data.unread.empty())
      set_moduli(shear_of(data), bulk_of(shear_of(data), material.poisson), material);
  }
}

void set_small_strain_moduli(Material& material) {
  const MooneyRivlin& rubber = *material.mooney_rivlin;
  material.young = 4 * (rubber.a + rubber.b) * (1 + material.poisson);
  constexpr double nearly_incompressible = 0.4999;
  material.bulk = material.young / (3 * (1 - 2 * std::min(material.poisson, nearly_incompressible)));
  material.stiffness_known = material.young > 0;
}

void finish_foams(Context& context) {
  for (Material& material : context.model.materials) {
    if (material.mooney_rivlin) fit_to_test(context.model, material);
    const auto* foam = std::get_if<LowDensityFoam>(&material.foam_rubber);
    if (foam == nullptr) continue;
    const auto curve = context.model.curves.find(foam->curve);
    const double steepest = curve == context.model.curves.end() ? 0 : largest_slope(curve->second.points);
    if (!(foam->contact > 0) && !(steepest > 0)) continue;
    material.bulk = foam->contact > 0 ? foam->contact : steepest;
    material.wave_modulus = std::max(material.bulk, material.young);
  }
}

}  // namespace gapcheck::model
