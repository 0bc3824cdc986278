#include "solver/build/build_shells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/build/build_full_shells.hpp"
#include "solver/build/build_hourglass.hpp"
#include "solver/build/build_shell_layers.hpp"
#include "solver/quadrature/gauss.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::int64_t belytschko_wong_chiang = 10;
/// Thin triangles, of which the first is calculated as the thick one, which is second.
constexpr std::int64_t bciz_triangle = 3, c0_triangle = 4, dkt_triangle = 17;

bool in_set(const model::Model& model, std::int64_t id, PartIndex part) {
  const auto set = model.sets.parts.find(id);
  if (set == model.sets.parts.end()) return false;
  const auto& members = set->second.members;
  return std::find(members.begin(), members.end(), part) != members.end();
}

/// ISTUPD, PSTUPD and SIDT4TU.
void set_thinning(const model::Model& model, PartIndex part, ShellProperties& properties) {
  const model::Controls& controls = model.controls;
  const bool asked = controls.istupd == 1 || controls.istupd == 3 || controls.istupd == 4;
  const bool chosen = controls.pstupd == 0 || (controls.pstupd > 0) == in_set(model, std::abs(controls.pstupd), part);
  const bool by_flow = controls.istupd == 4 || (controls.sidt4tu > 0 && in_set(model, controls.sidt4tu, part));
  properties.thins = asked && chosen;
  properties.thins_by_flow = properties.thins && by_flow;
}

/// The triangle whose quads a formulation has none of: a part of triangles alone is what it says.
bool has_quads(const model::Model& model, PartIndex part) {
  const model::Shells& shells = model.mesh.shells;
  for (std::size_t i = 0; i < shells.size(); ++i)
    if (shells.part[i] == part && shells.nodes[i][2] != shells.nodes[i][3]) return true;
  return false;
}

bool has_triangles(const model::Shells& shells) {
  return std::any_of(shells.nodes.begin(), shells.nodes.end(), [](const auto& n) { return n[2] == n[3]; });
}

/// INN of shells: ±2, and ±4 of solids too.
ShellAxes axes_of(const model::Controls& controls) {
  const std::int64_t inn = std::abs(controls.inn);
  return inn == 2 || inn == 4 ? ShellAxes::invariant : ShellAxes::side;
}

void set_projection(const model::Model& model, std::int64_t elform, ShellProperties& properties) {
  properties.sides_shear = elform == belytschko_wong_chiang;
  if (model.controls.bwc != 1 && !properties.sides_shear) return;
  properties.projection = model.controls.proj == 1 ? ShellProjection::full : ShellProjection::drill;
}

void name_formulation(const model::Model& model, PartIndex part, const model::Section& section,
                      Diagnostics& diagnostics) {
  const std::int64_t elform = section.elform;
  if (elform == 0 || elform == 2 || elform == belytschko_wong_chiang || full_shell(section) || membrane(section))
    return;
  const bool triangles = elform == bciz_triangle || elform == c0_triangle || elform == dkt_triangle;
  if (triangles && !has_quads(model, part)) {
    if (elform == bciz_triangle)
      diagnostics.warning(
          model.file(section.place), section.place.line,
          fmt::format("section {}: ELFORM {} is calculated as the C0 triangle (ELFORM 4)", section.id, elform));
    return;
  }
  diagnostics.warning(
      model.file(section.place), section.place.line,
      fmt::format("section {}: ELFORM {} is calculated as the one-point shell (ELFORM 2)", section.id, elform));
}

void set_viscosity(const model::Model& model, const ElementControl& control, ShellProperties& properties) {
  const std::int64_t type = model.controls.bulk_type;
  if (type != -1 && type != -2) return;
  properties.viscosity = {control.quadratic_viscosity, control.linear_viscosity, type == -2};
}

}  // namespace

SolverResult<ShellProperties> shell_properties(const model::Model& model, PartIndex index,
                                               const model::Section& section, Material material,
                                               const Hourglass& otherwise, Diagnostics& diagnostics,
                                               const model::Layup* layup) {
  const model::Part& part = model.part(index);
  ShellProperties all;
  all.material = std::move(material);
  const std::int64_t layers = std::clamp<std::int64_t>(section.nip, 1, 10);
  const auto rule = model.controls.intgrd == 1 ? lobatto_rule : gauss_rule;
  all.membrane = membrane(section);
  all.layers = rule(all.membrane ? 1 : static_cast<int>(layers));
  if (layup != nullptr || !part.plies.empty()) {
    const LayeredBy by = layup != nullptr ? LayeredBy{fmt::format("a shell of part {}", part.id.value), layup->place}
                                          : LayeredBy{fmt::format("part {}", part.id.value), part.place};
    if (SolverStatus plies = layup != nullptr ? set_plies(model, layup->plies, layup->thickness, by, all)
                                              : set_plies(model, part.plies, part.composite_thickness, by, all);
        !plies.ok())
      return plies.error();
  } else if (section.rule < 0) {
    if (SolverStatus ruled = set_rule(model, part, section, all); !ruled.ok()) return ruled.error();
  } else if (section.nip != layers) {
    diagnostics.warning(
        "", 0,
        fmt::format("part {}: NIP of its section is {}; {} points are calculated", part.id.value, section.nip, layers));
  }
  all.shear_factor = section.shrf;
  all.axes = axes_of(model.controls);
  set_thinning(model, index, all);
  name_formulation(model, index, section, diagnostics);
  Diagnostics of_no_effect;  // fully integrated shells have no hourglass modes
  const ElementControl control =
      element_control(model, part, ElementFamily::shells, otherwise, full_shell(section) ? of_no_effect : diagnostics);
  set_viscosity(model, control, all);
  all.discrete_kirchhoff = section.elform == dkt_triangle && !has_quads(model, index);
  if (full_shell(section)) {
    make_full(model, index, section, all, diagnostics);
  } else {
    all.hourglass = control.hourglass;
    set_projection(model, section.elform, all);
  }
  return all;
}

void name_element_controls(const model::Model& model, Diagnostics& diagnostics) {
  const model::Controls& controls = model.controls;
  const auto warn = [&](model::Place place, std::string message) {
    diagnostics.warning(model.file(place), place.line, std::move(message));
  };
  if (model.mesh.shells.size() > 0) {
    if (controls.drcpsid != 0)
      warn(controls.shell_place, "*CONTROL_SHELL: the drilling constraint of DRCPSID is not calculated");
    if (controls.bwc == 1 && controls.shell_normals == -2)
      warn(controls.shell_place, "*CONTROL_SHELL: IRNXX = -2 is calculated as -1: normals follow from the shape");
    if ((controls.inn == 2 || controls.inn == 4) && has_triangles(model.mesh.shells))
      warn(controls.accuracy_place,
           fmt::format("*CONTROL_ACCURACY: INN = {} is calculated as {} in triangles: their first axis lies along the "
                       "side from node 1 to 2",
                       controls.inn, -controls.inn));
  }
  if (controls.bulk_type == 2)
    warn(controls.bulk_place, "*CONTROL_BULK_VISCOSITY: TYPE 2 is for plane solids; it is calculated as 1");
  if (controls.bulk_beams != 0 && model.mesh.beams.size() > 0)
    warn(controls.bulk_place, "*CONTROL_BULK_VISCOSITY: BTYPE is not calculated: beams have no bulk viscosity");
}

double shell_reference(const model::Section& section, const double* offset, double thickness) {
  return offset != nullptr ? -2 * *offset / thickness : section.nloc;
}

}  // namespace gapcheck::solver
