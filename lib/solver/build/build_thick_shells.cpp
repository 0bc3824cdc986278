#include "solver/build/build_thick_shells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "solver/build/build.hpp"
#include "solver/build/build_hourglass.hpp"
#include "solver/build/material/build_johnson_cook.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::int64_t most_layers = 10;

/// Layers in plane stress cannot have it.
bool unsuitable_in_layers(const Material& material) {
  return material.kind == MaterialKind::rubber || material.kind == MaterialKind::hydro;
}

/// Adds thick shells one by one and builds what those of a part share.
class ThickShells {
 public:
  ThickShells(const model::Model& model, Diagnostics& diagnostics) : model_(model), diagnostics_(diagnostics) {}
  [[nodiscard]] SolverStatus add(std::uint32_t shell, const MassScaling& scaling, Structure& structure);

 private:
  [[nodiscard]] SolverResult<std::uint32_t> build(std::uint32_t shell, Structure& structure);
  const model::Model& model_;
  Diagnostics& diagnostics_;
  std::map<std::uint32_t, std::uint32_t> properties_;  ///< by part
};

SolverResult<std::uint32_t> ThickShells::build(std::uint32_t shell, Structure& structure) {
  const model::Elements<8>& shells = model_.mesh.thick_shells;
  const model::Place place{shells.origins.file(shell), shells.line[shell]};
  const PartIndex index = shells.part[shell];
  const model::Part* part = index == none<PartIndex> ? nullptr : &model_.part(index);
  if (part == nullptr || !part->section || !part->material)
    return Failure{
        Failure::Kind::missing_material,
        fmt::format("thick shell {} has no part, section or material; define them or leave it out", shells.id[shell]),
        place};
  const model::Section& section = model_.sections[*part->section];
  const model::Material& written = model_.materials[*part->material];
  if (section.kind != model::SectionKind::thick_shell)
    return Failure{Failure::Kind::missing_material,
                   fmt::format("thick shell {} is in part {}, whose section {} is for other elements", shells.id[shell],
                               part->id.value, section.id),
                   place};
  auto material = build_material(model_, written);
  if (!material) return material.error();
  if (unsuitable_in_layers(material.value()) || written.weld)
    return Failure{Failure::Kind::bad_material,
                   fmt::format("material {} is calculated in solids only, but thick shell {} is of it", written.id,
                               shells.id[shell]),
                   place};
  if (material.value().johnson_cook)
    if (SolverStatus good = check_johnson_cook_shell(written); !good.ok()) return good.error();
  name_what_is_not_calculated(model_, written, diagnostics_);
  const auto warn = [&](const std::string& message) {
    diagnostics_.warning(model_.file(section.place), section.place.line, message);
  };
  if (section.elform > 1)
    warn(fmt::format("section {}: thick shells of ELFORM {} are calculated as ELFORM 1", section.id, section.elform));
  if (material.value().can_fail())
    warn(fmt::format("section {}: thick shells do not fail; layers of material {} that do have no stress", section.id,
                     written.id));
  const std::int64_t layers = std::clamp<std::int64_t>(section.nip, 1, most_layers);
  if (layers != section.nip)
    warn(fmt::format("section {}: NIP is {}; {} points are calculated", section.id, section.nip, layers));
  if (!(section.shrf > 0) || !std::isfinite(section.shrf))
    return Failure{
        Failure::Kind::bad_element,
        fmt::format("section {} has the shear factor SHRF {:g}; set it above zero", section.id, section.shrf),
        section.place};
  ShellProperties properties;
  properties.material = std::move(material).value();
  properties.layers = gauss_rule(static_cast<int>(layers));
  properties.shear_factor = section.shrf;
  properties.thins = true;
  properties.hourglass = element_control(model_, *part, ElementFamily::shells, {}, diagnostics_).hourglass;
  return structure.thick_shells.add_properties(std::move(properties));
}

SolverStatus ThickShells::add(std::uint32_t shell, const MassScaling& scaling, Structure& structure) {
  const model::Elements<8>& shells = model_.mesh.thick_shells;
  const PartIndex part = shells.part[shell];
  auto found = properties_.find(part.value);
  if (found == properties_.end()) {
    const auto built = build(shell, structure);
    if (!built) return built.error();
    found = properties_.emplace(part.value, built.value()).first;
  }
  const double volume = structure.thick_shells.add(shells.nodes[shell], found->second, shell, structure.state, scaling,
                                                   &structure.added_mass);
  if (volume > 0) return {};
  return Failure{
      Failure::Kind::bad_element,
      fmt::format("thick shell {} has no volume or no fibres from its lower side n1 to n4 to its upper side n5 "
                  "to n8; mend the order of its nodes",
                  shells.id[shell]),
      {shells.origins.file(shell), shells.line[shell]}};
}

}  // namespace

SolverStatus add_thick_shells(const model::Model& model, const MassScaling& scaling, std::vector<RigidPart>& rigid,
                              Structure& structure, Diagnostics& diagnostics) {
  const model::Elements<8>& shells = model.mesh.thick_shells;
  const std::vector<Vector>& x = structure.state.x;
  ThickShells thick(model, diagnostics);
  for (std::uint32_t i = 0; i < shells.size(); ++i) {
    const auto& nodes = shells.nodes[i];
    if (std::any_of(nodes.begin(), nodes.end(), [&](NodeIndex node) { return node.value >= x.size(); }))
      return Failure{Failure::Kind::bad_element,
                     fmt::format("thick shell {} has a node that is not there", shells.id[i]),
                     {shells.origins.file(i), shells.line[i]}};
    const PartIndex part = shells.part[i];
    if (!model.rigid(part)) {
      if (SolverStatus added = thick.add(i, scaling, structure); !added.ok()) return added;
      continue;
    }
    std::array<Vector, 8> places;
    for (std::size_t k = 0; k < 8; ++k) places[k] = x[nodes[k].value];
    const std::vector<PointMass> points =
        solid_mass_points(places, model.materials[*model.part(part).material].density);
    RigidPart& body = rigid[part.value];
    body.nodes.insert(body.nodes.end(), nodes.begin(), nodes.end());
    body.points.insert(body.points.end(), points.begin(), points.end());
  }
  return {};
}

}  // namespace gapcheck::solver
