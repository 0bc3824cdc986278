#include "solver/element/nodal_mass.hpp"

#include <algorithm>
#include <cmath>

#include "base/quad.hpp"
#include "contact/stiffness/node_masses.hpp"
#include "model/entity/faces.hpp"
#include "solver/element/solid.hpp"

namespace gapcheck::solver {
namespace {

/// Positions of an element's nodes; nothing if one is missing.
template <std::size_t N>
std::optional<std::array<Vector, N>> places(const model::Mesh& mesh, const std::array<NodeIndex, N>& nodes) {
  std::array<Vector, N> x;
  for (std::size_t k = 0; k < N; ++k) {
    if (nodes[k].value >= mesh.nodes.size()) return std::nullopt;
    x[k] = mesh.nodes.x[nodes[k].value];
  }
  return x;
}

template <std::size_t N>
void share(const std::array<NodeIndex, N>& nodes, std::size_t corners, double mass, std::vector<double>& masses) {
  if (!(mass > 0) || !std::isfinite(mass)) return;
  for (std::size_t k = 0; k < corners; ++k) masses[nodes[k].value] += mass / static_cast<double>(corners);
}

void add_shells(const model::Model& model, const std::vector<bool>& wanted, std::vector<double>& masses) {
  const model::Shells& shells = model.mesh.shells;
  auto own = shells.own_thickness.begin();
  for (std::uint32_t i = 0; i < shells.size(); ++i) {
    while (own != shells.own_thickness.end() && own->shell < i) ++own;
    const PartIndex part = shells.part[i];
    if (part.value >= wanted.size() || !wanted[part.value] || !model.part(part).section) continue;
    const auto x = places(model.mesh, shells.nodes[i]);
    if (!x) continue;
    const bool has_own = own != shells.own_thickness.end() && own->shell == i;
    const double thickness =
        mean_thickness(model.sections[*model.part(part).section], has_own ? &own->thickness : nullptr);
    const double area = quad_normal(*x).norm() / 2;
    share(shells.nodes[i], shells.nodes[i][2] == shells.nodes[i][3] ? 3 : 4,
          contact::shell_density(model, i) * area * thickness, masses);
  }
}

void add_solids(const model::Model& model, const std::vector<bool>& wanted, std::vector<double>& masses) {
  const model::Elements<8>& solids = model.mesh.solids;
  for (std::uint32_t i = 0; i < solids.size(); ++i) {
    const PartIndex part = solids.part[i];
    if (part.value >= wanted.size() || !wanted[part.value]) continue;
    const auto x = places(model.mesh, solids.nodes[i]);
    if (!x) continue;
    if (model::is_tetrahedron(solids.nodes[i])) {
      share(solids.nodes[i], 4, contact::density(model, part) * tetrahedron_volume(*x), masses);
      continue;
    }
    const auto section = model.part(part).section;
    const SolidRule rule =
        section
            ? solid_rules(model.sections[*section].elform, model.controls.solid_esort).of(solid_shape(solids.nodes[i]))
            : SolidRule::one_point;
    const double mass =
        contact::density(model, part) * (has_eight_points(rule) ? brick_volume(*x) : one_point_volume(*x));
    if (!(mass > 0) || !std::isfinite(mass)) continue;
    const std::array<double, 8> shares = corner_shares(rule, solids.nodes[i]);
    for (std::size_t k = 0; k < 8; ++k) masses[solids.nodes[i][k].value] += mass * shares[k];
  }
}

void share_thick_shells(const model::Model& model, const std::vector<bool>& wanted, std::vector<double>& masses) {
  const model::Elements<8>& shells = model.mesh.thick_shells;
  for (std::uint32_t i = 0; i < shells.size(); ++i) {
    const PartIndex part = shells.part[i];
    if (part.value >= wanted.size() || !wanted[part.value]) continue;
    const auto x = places(model.mesh, shells.nodes[i]);
    if (x) share(shells.nodes[i], 8, contact::density(model, part) * one_point_volume(*x), masses);
  }
}

}  // namespace

double mean_thickness(const model::Section& section, const std::array<double, 4>* own) {
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += own != nullptr && (*own)[k] > 0 ? (*own)[k] : section.thickness[k];
  return sum / 4;
}

std::vector<double> nodal_masses(const model::Model& model, const std::vector<bool>& wanted) {
  std::vector<double> masses(model.mesh.nodes.size(), 0);
  add_shells(model, wanted, masses);
  add_solids(model, wanted, masses);
  share_thick_shells(model, wanted, masses);
  return masses;
}

}  // namespace gapcheck::solver
