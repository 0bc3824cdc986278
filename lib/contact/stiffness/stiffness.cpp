#include "contact/stiffness/stiffness.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::contact {
namespace {

/// Share of the critical stiffness m / Δt² that SOFT = 1 and 2 start from.
constexpr double soft_share = 0.5;

double quotient(double dividend, double divisor) { return divisor > 0 ? dividend / divisor : 0; }

double reduced_mass(double mass1, double mass2) { return quotient(mass1 * mass2, mass1 + mass2); }

}  // namespace

double contact_modulus(const model::Material& material) {
  if (!material.fabric) return material.bulk;
  return quotient(material.young, 1 - material.poisson * material.poisson);
}

double contact_modulus(const model::Model& model, PartIndex part) {
  if (part == none<PartIndex> || !model.part(part).material) return 0;
  return contact_modulus(model.materials[*model.part(part).material]);
}

double solid_segment_stiffness(double scale, double modulus, double area, double volume) {
  return quotient(scale * modulus * area * area, volume);
}

double shell_segment_stiffness(double scale, double modulus, double area, double longest_diagonal) {
  return quotient(scale * modulus * area, longest_diagonal);
}

double spring_stiffness(std::int64_t penopt, const PairStiffness& pair) {
  switch (penopt) {
    case 2:
      return pair.segment;
    case 3:
      return pair.node;
    case 4:
      return pair.node_weighted;
    case 5:
      return quotient(pair.node_weighted, pair.thickness);
    default:
      return std::min(pair.node, pair.segment);
  }
}

double soft_1_stiffness(double node_mass, double segment_mass, double timestep) {
  return quotient(soft_share * std::min(node_mass, segment_mass), timestep * timestep);
}

double soft_1_spring(double soft_0, double sofscl, double soft_1) { return std::max(soft_0, sofscl * soft_1); }

double soft_2_stiffness(double scale, double mass1, double mass2, double timestep) {
  return quotient(soft_share * scale * reduced_mass(mass1, mass2), timestep * timestep);
}

}  // namespace gapcheck::contact
