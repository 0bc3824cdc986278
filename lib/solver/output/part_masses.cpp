#include "solver/output/part_masses.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "contact/stiffness/node_masses.hpp"

namespace gapcheck::solver {

PartMasses::PartMasses(const model::Model& model, const contact::ElementSizes& sizes) : shares_(model.parts.size()) {
  const auto add = [&](PartIndex part, std::span<const NodeIndex> nodes, double mass) {
    if (part == none<PartIndex> || !(mass > 0) || !std::isfinite(mass)) return;
    for (const NodeIndex node : nodes)
      if (node.value < model.mesh.nodes.size())
        shares_[part.value].push_back({node.value, mass / static_cast<double>(nodes.size())});
  };
  std::vector<double> density;
  for (std::uint32_t part = 0; part < model.parts.size(); ++part)
    density.push_back(contact::density(model, PartIndex{part}));
  const auto density_of = [&](PartIndex part) { return part == none<PartIndex> ? 0 : density[part.value]; };
  const model::Mesh& mesh = model.mesh;
  for (std::uint32_t i = 0; i < mesh.shells.size(); ++i) {
    const auto& nodes = mesh.shells.nodes[i];
    const bool layered = !mesh.shells.own_layup.empty();
    add(mesh.shells.part[i], std::span(nodes).first(nodes[2] == nodes[3] ? 3 : 4),
        (layered ? contact::shell_density(model, i) : density_of(mesh.shells.part[i])) * sizes.shell_area[i] *
            sizes.shell_thickness[i]);
  }
  for (std::size_t i = 0; i < mesh.solids.size(); ++i) {
    const auto& nodes = mesh.solids.nodes[i];
    add(mesh.solids.part[i], std::span(nodes).first(nodes[3] == nodes[7] ? 4 : 8),
        density_of(mesh.solids.part[i]) * sizes.solid_volume[i]);
  }
  for (std::size_t i = 0; i < mesh.thick_shells.size(); ++i)
    add(mesh.thick_shells.part[i], mesh.thick_shells.nodes[i],
        density_of(mesh.thick_shells.part[i]) * sizes.thick_shell_volume[i]);
  const std::vector<Vector>& x = mesh.nodes.x;
  for (std::size_t i = 0; i < mesh.beams.size(); ++i) {
    const auto& [a, b] = mesh.beams.nodes[i];
    const PartIndex part = mesh.beams.part[i];
    if (part == none<PartIndex> || !model.part(part).section || a.value >= x.size() || b.value >= x.size()) continue;
    const double area = model.sections[*model.part(part).section].beam_area;
    add(part, mesh.beams.nodes[i], density_of(part) * area * (x[b.value] - x[a.value]).norm());
  }
  for (std::vector<Share>& shares : shares_) {
    std::stable_sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.node < b.node; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < shares.size(); ++i)
      if (shares[i].node == shares[last].node)
        shares[last].mass += shares[i].mass;
      else
        shares[++last] = shares[i];
    if (!shares.empty()) shares.resize(last + 1);
    shares.shrink_to_fit();
  }
}

std::vector<PartMotion> PartMasses::motion(const State& state) const {
  std::vector<PartMotion> parts(shares_.size());
  parallel_for(shares_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part)
      for (const auto& [node, mass] : shares_[part]) {
        parts[part].mass += mass;
        parts[part].kinetic += mass / 2 * state.v[node].squaredNorm();
        parts[part].momentum += mass * state.v[node];
      }
  });
  return parts;
}

}  // namespace gapcheck::solver
