#include "solver/build/build_beams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/build/build_spotwelds.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::int64_t truss = 3, spotweld = 9;

/// ELFORM 4 and 5 integrate over the cross-section, 13 is the resultant beam with transverse shear.
bool is_calculated(const model::Section& section) {
  const bool known = (section.elform >= 1 && section.elform <= 5) || section.elform == 13;
  return section.integrated() || (known && section.beam.has_value());
}

Failure bad_section(const model::Section& section, std::string_view why) {
  return {Failure::Kind::bad_element, fmt::format("section {} {}", section.id, why), section.place};
}

/// The beam bends and its material is not made for that, or it is of spotwelds and is none.
std::optional<Failure> unsuitable(const model::Section& section, const Material& material,
                                  const model::Material& written) {
  const auto bad = [&](std::string_view why) {
    return Failure{Failure::Kind::bad_material, fmt::format("section {}: {}", section.id, why), section.place};
  };
  if (written.weld && section.elform != spotweld)
    return bad(fmt::format("material {} (*MAT_SPOTWELD) is for spotweld beams; set ELFORM to 9", written.id));
  const bool plastic = material.kind == MaterialKind::plastic && section.elform != truss && !section.integrated();
  if (material.kind != MaterialKind::anisotropic && !plastic) return std::nullopt;
  return bad(
      "resultant beams are calculated with material 001 only; make them trusses or integrated beams (ELFORM 3, 1) or "
      "change their material for this run");
}

/// Points and constants of the cross-section of an integrated beam.
SolverStatus set_fibers(const model::Section& section, BeamProperties& properties) {
  const model::BeamProfile& profile = *section.profile;
  const auto& [s, t] = std::pair(profile.s, profile.t);
  for (std::size_t end = 0; end < 2; ++end)
    if (!(s[end] > 0) || !(profile.tube ? t[end] >= 0 && t[end] < s[end] : t[end] > 0) ||
        !std::isfinite(s[end] * t[end]))
      return bad_section(
          section, fmt::format("has the sides or diameters {:g} and {:g} at an end; mend TS1 to TT2", s[end], t[end]));
  if (!(profile.shear_factor > 0) || !std::isfinite(profile.shear_factor))
    return bad_section(section, fmt::format("has the shear factor SHRF {:g}; set it above zero", profile.shear_factor));
  properties.fibers = section_fibers(profile);
  if (properties.fibers.empty())
    return bad_section(
        section, fmt::format("has QR/IRID {} and {}; rules 1 to 5 of rectangles and tubes are calculated", profile.rule,
                             profile.arbitrary ? "an arbitrary shape (CST)" : "CST 0 or 1"));
  properties.section = section_constants(profile, properties.fibers);
  properties.shear_factor = profile.shear_factor;
  properties.torsion_free = profile.torsion_free;
  return {};
}

}  // namespace

SolverResult<BeamProperties> beam_properties(const model::Section& section, const Material& material,
                                             const model::Material& written) {
  BeamProperties properties;
  properties.material = material;
  properties.section = section.beam.value_or(model::BeamSection{});
  properties.truss = section.elform == truss;
  if (!section.beam) properties.section.area = section.beam_area;
  if (auto why = unsuitable(section, material, written)) return std::move(*why);
  if (section.integrated() && material.has_stress())
    if (const SolverStatus set = set_fibers(section, properties); !set.ok()) return set.error();
  auto limits = weld_limits(written);
  if (!limits) return limits.error();
  properties.weld = std::move(limits).value();
  const model::BeamSection& values = properties.section;
  bool finite = true;
  for (const double value : {values.area, values.iss, values.itt, values.torsion, values.shear_area, values.line_mass})
    if (!(value >= 0) || !std::isfinite(value)) finite = false;
  if (!finite || !(values.area > 0))
    return bad_section(section, fmt::format("has a beam area of {:g} or constants out of range; mend it", values.area));
  return properties;
}

bool BeamLimits::leaves_out(PartIndex part) {
  const auto& position = model_.part(part).section;
  if (!position) return false;
  const model::Section& section = model_.sections[*position];
  if (section.kind != model::SectionKind::beam) return false;
  const auto& material = model_.part(part).material;
  if (material && model_.materials[*material].null_material && section.beam_area > 0) return false;
  const bool out = !is_calculated(section);
  const bool other = section.elform != 2 && section.elform != truss && !section.integrated();
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
  const Vector& first = state.x[beams.nodes[beam][0].value];
  const Vector way = state.x[beams.nodes[beam][1].value] - first;
  Vector third = values.orientation;
  if (values.third.value < state.x.size()) third = state.x[values.third.value] - first;
  const bool across = way.cross(third).norm() > 1e-9 * way.norm() * third.norm();
  const auto& section = model_.sections[*model_.part(beams.part[beam]).section].beam;
  if (!across && section && section->iss != section->itt) ++without_axes_;
  return across ? third : Vector(Vector::Zero());
}

SolverResult<BeamJoint> BeamLimits::joint(std::uint32_t beam) {
  const model::Elements<2>& beams = model_.mesh.beams;
  const auto& all = model_.mesh.beam_values;
  const model::BeamValues values = beam < all.size() ? all[beam] : model::BeamValues{};
  const model::Section& section = model_.sections[*model_.part(beams.part[beam]).section];
  const model::Place place{beams.origins.file(beam), beams.line[beam]};
  const auto fail = [&](std::string_view why) {
    return Failure{Failure::Kind::not_calculated, fmt::format("beam {} {}", beams.id[beam], why), place};
  };
  BeamJoint joint;
  const bool bends = section.elform != truss;
  if (values.shifted() && !bends) ++shifted_;
  if (values.shifted() && bends) joint.offset = values.offsets;
  if (section.integrated()) {
    const model::BeamProfile& profile = *section.profile;
    const bool shifted = profile.location != std::array<double, 2>{};
    if (shifted && (profile.s[0] != profile.s[1] || profile.t[0] != profile.t[1]))
      return fail(
          fmt::format("has a reference surface (NSLOC, NTLOC of section {}) and different ends, which is not "
                      "calculated; give both ends the same sides",
                      section.id));
    joint.shift = {-profile.location[0] * profile.s[0] / 2,
                   -profile.location[1] * (profile.tube ? profile.s[0] : profile.t[0]) / 2};
  }
  if (values.released() && (section.integrated() || !bends)) ++released_;
  if (!values.released() || section.integrated() || !bends) return joint;
  if (values.global_releases)
    return fail("has pin releases about global axes (LOCAL = 1), which are not calculated; release about its own axes");
  constexpr unsigned along = 1, about_s = 2, about_t = 4;
  for (std::size_t end = 0; end < 2; ++end) {
    const unsigned moves = values.releases[2 * end], turns = values.releases[2 * end + 1];
    if ((moves & (about_s | about_t)) != 0)
      return fail("has ends that slide across it (RT1, RT2), which is not calculated; release the axis r or rotations");
    joint.released.axial = joint.released.axial || (moves & along) != 0;
    joint.released.twist = joint.released.twist || (turns & along) != 0;
    joint.released.turn_s[end] = (turns & about_s) != 0;
    joint.released.turn_t[end] = (turns & about_t) != 0;
  }
  return joint;
}

void BeamLimits::tell() {
  const auto name = [&](std::size_t count, std::string_view what) {
    if (count > 0) diagnostics_.warning("", 0, fmt::format("{} beams {}", count, what));
  };
  name(released_, "have pin releases (RT1, RR1, RT2, RR2), which are calculated in resultant beams only");
  name(shifted_, "are trusses that are offset from their nodes, which is not calculated");
  name(without_axes_, "have no third node across; their axes s and t are chosen freely");
}

}  // namespace gapcheck::solver
