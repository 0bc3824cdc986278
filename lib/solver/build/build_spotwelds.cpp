#include "solver/build/build_spotwelds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/quadrature/solid_rule.hpp"

namespace gapcheck::solver {

SolverResult<WeldLimits> weld_limits(const model::Material& written) {
  if (!written.weld) return WeldLimits{};
  constexpr double most_vectors = 10000;
  const model::SpotWeld& weld = *written.weld;
  const auto refused = [&](Failure::Kind kind, std::string_view why) {
    return Failure{kind, fmt::format("material {} (*{}): {}", written.id, written.keyword, why), written.place};
  };
  if (std::any_of(weld.strength.begin(), weld.strength.end(), [](double value) { return value < 0; }))
    return refused(Failure::Kind::not_calculated,
                   "a resultant at failure below zero names a curve over the rate, which is not calculated; give it as "
                   "a number above zero");
  for (const auto& [name, value] :
       {std::pair("DT", weld.step), {"TFAIL", weld.failure_time}, {"EFAIL", weld.failure_strain}, {"NF", weld.filter}})
    if (!(value >= 0) || !std::isfinite(value))
      return refused(Failure::Kind::bad_material, fmt::format("{} is {:g}; set a number not below zero", name, value));
  if (weld.filter > most_vectors)
    return refused(Failure::Kind::bad_material,
                   fmt::format("NF is {:g}; at most {:g} force vectors are averaged", weld.filter, most_vectors));
  return WeldLimits{weld.strength, weld.failure_strain, weld.failure_time, static_cast<std::size_t>(weld.filter),
                    weld.step};
}

SolverStatus check_weld_brick(const model::Model& model, std::uint32_t solid) {
  const model::Elements<8>& solids = model.mesh.solids;
  const auto& material = model.part(solids.part[solid]).material;
  if (!material || !model.materials[*material].weld) return {};
  const std::array<NodeIndex, 8>& nodes = solids.nodes[solid];
  const SolidShape shape = solid_shape(nodes);
  // A wedge between two sheets has a triangle on each: n1 n2 n3 n3 n5 n6 n7 n7.
  if (shape == SolidShape::brick || (nodes[2] == nodes[3] && nodes[6] == nodes[7] && nodes[4] != nodes[5])) return {};
  return Failure{
      Failure::Kind::bad_element,
      fmt::format("solid {} is of spotweld material {} and has no faces n1 to n4 and n5 to n8 for two sheets; "
                  "make it a brick or a wedge n1 n2 n3 n3 n5 n6 n7 n7",
                  solids.id[solid], model.materials[*material].id),
      {solids.origins.file(solid), solids.line[solid]}};
}

void name_free_bending(const model::Model& model, const model::Material& written, const WeldLimits& limits,
                       const Hourglass& hourglass, Diagnostics& diagnostics) {
  if (hourglass.kind == HourglassKind::stiffness || hourglass.kind == HourglassKind::assumed_strain) return;
  if (std::none_of(limits.strength.begin() + 3, limits.strength.end(), [](double value) { return value > 0; })) return;
  diagnostics.warning(model.file(written.place), written.place.line,
                      fmt::format("material {} (*{}): MRR, MSS and MTT hardly count, because one-point bricks resist "
                                  "bending and torsion by their hourglass control only; set IHQ to 4, 5 or 6",
                                  written.id, written.keyword));
}

}  // namespace gapcheck::solver
