#include "contact/stiffness/node_masses.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/mesh/node_sums.hpp"

namespace gapcheck::contact {
namespace {

/// Densities by part; elements without a part get none.
class Densities {
 public:
  explicit Densities(const model::Model& model) {
    for (std::uint32_t p = 0; p < model.parts.size(); ++p) of_part_.push_back(density(model, PartIndex{p}));
  }
  [[nodiscard]] double at(PartIndex part) const { return part == none<PartIndex> ? 0 : of_part_[part.value]; }
  [[nodiscard]] double of_shell(const model::Model& model, std::size_t shell) const {
    return model.mesh.shells.own_layup.empty() ? at(model.mesh.shells.part[shell])
                                               : shell_density(model, static_cast<std::uint32_t>(shell));
  }

 private:
  std::vector<double> of_part_;
};

double density_of(const model::Model& model, const std::optional<std::uint32_t>& material) {
  return material ? model.materials[*material].density : 0;
}

double density_of(const model::Model& model, const std::vector<model::Ply>& plies, double thickness) {
  double sum = 0;
  for (const model::Ply& ply : plies) sum += density_of(model, ply.material) * ply.thickness;
  return sum / thickness;
}

/// Of a shell's rule whose points have materials of their own; nothing: they have not.
std::optional<double> by_rule(const model::Model& model, const model::Part& part) {
  if (!part.section || model.sections[*part.section].kind != model::SectionKind::shell) return std::nullopt;
  const auto rule = model.shell_rules.find(-model.sections[*part.section].rule);
  if (rule == model.shell_rules.end() || rule->second.equal == 1) return std::nullopt;
  double sum = 0, weights = 0;
  bool own = false;
  for (const model::ShellRule::Point& point : rule->second.points) {
    const auto other = model.part_of_id.find(point.part_id);
    const bool has_own = point.part_id != 0 && other != model.part_of_id.end();
    sum += point.weight * density_of(model, has_own ? model.part(other->second).material : part.material);
    weights += point.weight;
    own = own || has_own;
  }
  return own && weights > 0 ? std::optional(sum / weights) : std::nullopt;
}

bool counts(double mass) { return mass > 0 && std::isfinite(mass); }

/// `printed`: see node_masses().
void add_shells(const model::Model& model, const ElementSizes& sizes, const Densities& densities, bool printed,
                std::vector<double>& masses) {
  const model::Mesh& mesh = model.mesh;
  sum_at_nodes(masses, mesh.shells.nodes, [&](std::size_t i, const auto& add) {
    const double mass = densities.of_shell(model, i) * sizes.shell_area[i] * sizes.shell_thickness[i];
    if (!counts(mass)) return;
    const auto& n = mesh.shells.nodes[i];
    const bool all_listed = printed && model.rigid(mesh.shells.part[i]);
    const std::size_t corners = n[2] == n[3] && !all_listed ? 3 : 4;
    for (std::size_t c = 0; c < corners; ++c) add(n[c], mass / static_cast<double>(corners));
  });
}

/// By part: whether ELFORM makes its elements tetrahedra or wedges.
std::vector<bool> parts_of_tetrahedra(const model::Model& model) {
  constexpr std::array<std::int64_t, 6> few_nodes{4, 10, 13, 15, 16, 17};
  std::vector<bool> of_part;
  for (const model::Part& part : model.parts) {
    const model::Section* section = part.section ? &model.sections[*part.section] : nullptr;
    of_part.push_back(section != nullptr && section->kind == model::SectionKind::solid &&
                      std::ranges::count(few_nodes, section->elform) > 0);
  }
  return of_part;
}

/// `printed`: see node_masses().
void add_solids(const model::Model& model, const model::Elements<8>& elements, const std::vector<double>& volumes,
                const Densities& densities, bool printed, std::vector<double>& masses) {
  const std::vector<bool> few_nodes = parts_of_tetrahedra(model);
  sum_at_nodes(masses, elements.nodes, [&](std::size_t i, const auto& add) {
    const PartIndex part = elements.part[i];
    const double mass = densities.at(part) * volumes[i];
    if (!counts(mass)) return;
    if (printed && !few_nodes[part.value]) {
      for (const NodeIndex n : elements.nodes[i]) add(n, mass / 8);
      return;
    }
    std::array<NodeIndex, 8> distinct{};
    std::size_t count = 0;
    for (const NodeIndex n : elements.nodes[i])
      if (std::find(distinct.begin(), distinct.begin() + count, n) == distinct.begin() + count) distinct[count++] = n;
    for (std::size_t c = 0; c < count; ++c) add(distinct[c], mass / static_cast<double>(count));
  });
}

double beam_mass(const model::Model& model, std::size_t beam, double density) {
  const auto& beams = model.mesh.beams;
  const PartIndex part = beams.part[beam];
  const auto& [a, b] = beams.nodes[beam];
  if (part == none<PartIndex> || b == none<NodeIndex> || !model.part(part).section) return 0;
  const model::Section& section = model.sections[*model.part(part).section];
  if (section.elform == model::discrete_beam) return 0;  // its mass is not that of a bar
  return density * section.beam_area * (model.mesh.nodes.x[a.value] - model.mesh.nodes.x[b.value]).norm();
}

}  // namespace

double density(const model::Model& model, PartIndex part) {
  if (part == none<PartIndex>) return 0;
  const model::Part& p = model.part(part);
  if (p.plies.empty() || !(p.composite_thickness > 0)) return by_rule(model, p).value_or(density_of(model, p.material));
  return density_of(model, p.plies, p.composite_thickness);
}

double shell_density(const model::Model& model, std::uint32_t shell) {
  const model::Shells& shells = model.mesh.shells;
  const auto own = shells.layup_of(shell);
  if (!own || !(shells.layups[*own].thickness > 0)) return density(model, shells.part[shell]);
  return density_of(model, shells.layups[*own].plies, shells.layups[*own].thickness);
}

std::vector<double> node_masses(const model::Model& model, const ElementSizes& sizes, bool printed) {
  const model::Mesh& mesh = model.mesh;
  std::vector<double> masses(mesh.nodes.size(), 0.0);
  const Densities densities(model);
  add_shells(model, sizes, densities, printed, masses);
  add_solids(model, mesh.solids, sizes.solid_volume, densities, printed, masses);
  add_solids(model, mesh.thick_shells, sizes.thick_shell_volume, densities, printed, masses);
  sum_at_nodes(masses, mesh.beams.nodes, [&](std::size_t i, const auto& add) {
    const double mass = beam_mass(model, i, densities.at(mesh.beams.part[i]));
    if (!counts(mass)) return;
    for (const NodeIndex n : mesh.beams.nodes[i]) add(n, mass / 2);
  });
  sum_at_nodes(masses, mesh.masses.nodes, [&](std::size_t i, const auto& add) {
    if (counts(mesh.mass_values[i])) add(mesh.masses.nodes[i][0], mesh.mass_values[i]);
  });
  return masses;
}

}  // namespace gapcheck::contact
