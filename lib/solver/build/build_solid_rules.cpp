#include "solver/build/build_solid_rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gapcheck::solver {
namespace {

constexpr std::int64_t wedges_only = 15, tetrahedra_only = 10, nodal_pressure = 13;

bool is_for_tetrahedra(std::int64_t elform) {
  return elform == tetrahedra_only || elform == nodal_pressure || stands_in_nodal_pressure(elform);
}

/// One-point wedges become ELFORM 115.
bool sorts_one_point_wedges(std::int64_t esort) { return esort % 10 == 2 || esort % 10 == 4; }

/// Materials 001, 003 and 024, or no stress at all.
bool averages(const Material& material) {
  return !material.johnson_cook && material.kind != MaterialKind::rubber && material.kind != MaterialKind::hydro;
}

bool is_one_point(const model::Section& section) { return section.elform == 0 || section.elform == 1; }

}  // namespace

bool SolidFormulations::inverted_fail(PartIndex part) const {
  const auto set = model_.sets.parts.find(model_.controls.psfail);
  if (model_.controls.psfail == 0 || set == model_.sets.parts.end()) return false;
  return std::find(set->second.members.begin(), set->second.members.end(), part) != set->second.members.end();
}

SolverResult<SolidRules> SolidFormulations::rules(PartIndex part, const model::Section& section,
                                                  const Material& material) {
  const std::int64_t esort = model_.controls.solid_esort;
  if (esort < 0 || esort > 14 || (esort > 4 && esort < 11))
    return Failure{Failure::Kind::contradiction,
                   fmt::format("ESORT of *CONTROL_SOLID is {}; set 0 to 4 or 11 to 14", esort),
                   model_.controls.solid_place};
  if (const std::int64_t psfail = model_.controls.psfail; psfail != 0 && model_.sets.parts.count(psfail) == 0)
    return Failure{
        Failure::Kind::contradiction,
        fmt::format("PSFAIL of *CONTROL_SOLID names part set {}, which is not defined; define it or set 0", psfail),
        model_.controls.solid_place};
  SolidRules rules = solid_rules(section.elform, esort);
  if (rules.tetrahedron == SolidRule::nodal_pressure && !averages(material)) {
    rules.tetrahedron = SolidRule::one_point;
    without_average_.insert(part.value);
  }
  if (rules.brick == SolidRule::accurate && material.kind == MaterialKind::rubber)
    return Failure{
        Failure::Kind::not_calculated,
        fmt::format(
            "section {}: ELFORM -2 is not calculated with rubber or foam (027 and others); set ELFORM to -1 or 2",
            section.id),
        section.place};
  return rules;
}

bool SolidFormulations::is_calculated(const model::Section& section) {
  switch (section.elform) {
    case -2:
    case -1:
    case 0:
    case 1:
    case 2:
    case tetrahedra_only:
    case nodal_pressure:
    case wedges_only:
      return true;
    default:
      return false;
  }
}

std::string_view SolidFormulations::stand_in(const model::Section& section) {
  if (stands_in_nodal_pressure(section.elform)) return "ELFORM 13 (tetrahedra with four nodes)";
  return stands_in_eight_points(section.elform) ? "ELFORM 2" : "the one-point solid";
}

SolverStatus SolidFormulations::look_at(std::uint32_t solid) {
  const model::Elements<8>& solids = model_.mesh.solids;
  const auto found = model_.part(solids.part[solid]).section;
  if (!found) return {};
  const model::Section& section = model_.sections[*found];
  const SolidShape shape = solid_shape(solids.nodes[solid]);
  if (shape == SolidShape::brick && !is_for_tetrahedra(section.elform) && section.elform != wedges_only) return {};
  Counts& counts = counts_[*found];
  ++(shape == SolidShape::tetrahedron ? counts.tetrahedra : shape == SolidShape::wedge ? counts.wedges : counts.others);
  if (shape == SolidShape::tetrahedron && without_average_.count(solids.part[solid].value) > 0)
    ++counts.without_average;
  if (section.elform == wedges_only && shape != SolidShape::wedge && shape != SolidShape::tetrahedron)
    return Failure{
        Failure::Kind::bad_element,
        fmt::format("solid {} is not a wedge, but ELFORM 15 of its section {} is for wedges; set ELFORM to 2 "
                    "or mend its nodes (n1 n2 n3 n4 n5 n5 n6 n6)",
                    solids.id[solid], section.id),
        {solids.origins.file(solid), solids.line[solid]}};
  return {};
}

std::string_view SolidFormulations::volume_note(std::uint32_t solid) const {
  const model::Elements<8>& solids = model_.mesh.solids;
  const SolidShape shape = solid_shape(solids.nodes[solid]);
  const auto section = model_.part(solids.part[solid]).section;
  if (!section || model_.rigid(solids.part[solid]) || shape == SolidShape::tetrahedron) return "";
  const SolidRules rules = solid_rules(model_.sections[*section].elform, model_.controls.solid_esort);
  return has_eight_points(rules.of(shape)) ? " by the least of its eight points" : "";
}

void SolidFormulations::tell() {
  const std::int64_t esort = model_.controls.solid_esort;
  for (const auto& [position, counts] : counts_) {
    const model::Section& section = model_.sections[position];
    const auto warn = [&](std::size_t count, const std::string& what) {
      if (count > 0)
        diagnostics_.warning(model_.file(section.place), section.place.line,
                             fmt::format("section {}, ELFORM {}: {} {}", section.id, section.elform, count, what));
    };
    warn(counts.without_average,
         fmt::format("tetrahedra are calculated as ELFORM 10, not as ELFORM 13{}; nodal pressures are calculated with "
                     "materials 001, 003 and 024",
                     section.elform == nodal_pressure ? "" : " that ESORT asks for"));
    if (is_for_tetrahedra(section.elform)) {
      warn(counts.wedges + counts.others, "solids are no tetrahedra; they are calculated as one-point bricks");
    } else if (esort == 0 && !is_one_point(section) && is_calculated(section)) {
      warn(counts.tetrahedra,
           "tetrahedra are calculated as ELFORM 10, as with ESORT = 1 of *CONTROL_SOLID, not as collapsed bricks");
    }
    if (is_one_point(section) && sorts_one_point_wedges(esort))
      warn(counts.wedges, "wedges are calculated as one-point bricks, not as ELFORM 115 that ESORT asks for");
  }
}

}  // namespace gapcheck::solver
