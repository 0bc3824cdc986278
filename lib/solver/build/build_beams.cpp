#include "solver/build/build_beams.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gapcheck::solver {
namespace {

constexpr std::int64_t truss = 3;

/// ELFORM 1, 4 and 5 integrate over the cross-section, 13 is the resultant beam with transverse shear.
bool is_calculated(const model::Section& section) {
  const bool known = (section.elform >= 1 && section.elform <= 5) || section.elform == 13;
  return known && section.beam.has_value();
}

}  // namespace

SolverResult<BeamProperties> beam_properties(const model::Section& section, const Material& material) {
  BeamProperties properties{material, section.beam.value_or(model::BeamSection{}), section.elform == truss};
  const model::BeamSection& values = properties.section;
  if (material.kind == MaterialKind::anisotropic || (material.kind == MaterialKind::plastic && !properties.truss))
    return Failure{Failure::Kind::bad_material,
                   fmt::format("section {}: beams that bend are calculated with material 001 only; make them trusses "
                               "(ELFORM 3) or change their material for this run",
                               section.id),
                   section.place};
  bool finite = true;
  for (const double value : {values.area, values.iss, values.itt, values.torsion, values.shear_area, values.line_mass})
    if (!(value >= 0) || !std::isfinite(value)) finite = false;
  if (!finite || !(values.area > 0))
    return Failure{
        Failure::Kind::bad_element,
        fmt::format("section {} has a beam area of {:g} or constants out of range; mend it", section.id, values.area),
        section.place};
  return properties;
}

bool BeamLimits::leaves_out(PartIndex part) {
  const auto& position = model_.part(part).section;
  if (!position) return false;
  const model::Section& section = model_.sections[*position];
  if (section.kind != model::SectionKind::beam) return false;
  const bool out = !is_calculated(section), other = section.elform != 2 && section.elform != truss;
  if ((out || other) && named_.insert(*position).second)
    diagnostics_.warning(model_.file(section.place), section.place.line,
                         fmt::format("section {}: beams of ELFORM {} {}", section.id, section.elform,
                                     out ? "take no part in the calculation" : "are calculated as the resultant beam"));
  return out;
}

Vector BeamLimits::third_point(std::uint32_t beam, const State& state) {
  const model::Elements<2>& beams = model_.mesh.beams;
  const auto& all = model_.mesh.beam_values;
  const model::BeamValues values = beam < all.size() ? all[beam] : model::BeamValues{};
  if (values.released) ++released_;
  if (values.shifted) ++shifted_;
  const Vector& first = state.x[beams.nodes[beam][0].value];
  const Vector way = state.x[beams.nodes[beam][1].value] - first;
  Vector third = values.orientation;
  if (values.third.value < state.x.size()) third = state.x[values.third.value] - first;
  const bool across = way.cross(third).norm() > 1e-9 * way.norm() * third.norm();
  const auto& section = model_.sections[*model_.part(beams.part[beam]).section].beam;
  if (!across && section && section->iss != section->itt) ++without_axes_;
  return across ? third : Vector(Vector::Zero());
}

void BeamLimits::tell() {
  const auto name = [&](std::size_t count, std::string_view what) {
    if (count > 0) diagnostics_.warning("", 0, fmt::format("{} beams {}", count, what));
  };
  name(released_, "have pin releases (RT1, RR1, RT2, RR2), which are not calculated");
  name(shifted_, "are offset from their nodes, which is not calculated");
  name(without_axes_, "have no third node across; their axes s and t are chosen freely");
}

}  // namespace gapcheck::solver
