#include "solver/build/build_full_shells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "solver/element/full/shell_full_frame.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::int64_t full_form = 16, one_point_membrane = 5, full_membrane = 9, full_projection = 8, sort_to_dkt = 2;
/// Other forms with four points in the plane: Hughes and Liu with selective integration, linear shells with drilling
/// stiffness or hybrid membrane, shells with thickness stretch.
constexpr std::array<std::int64_t, 7> other_forms{-full_form, 6, 7, 18, 20, 21, 26};

/// Type 8 always is on: it has no coefficient that would count, and shells with four points have nothing else to
/// control.
void name_hourglass_control(const model::Model& model, const model::Part& part, Diagnostics& diagnostics) {
  std::int64_t type = model.controls.ihq;
  model::Place place = model.controls.hourglass_place;
  if (part.hourglass_id != 0) {
    const auto own = model.hourglass.find(part.hourglass_id);
    place = own == model.hourglass.end() ? part.place : own->second.place;
    if (own == model.hourglass.end())
      diagnostics.warning(model.file(place), place.line,
                          fmt::format("part {} names hourglass control {}, which is not defined; type 8 is taken",
                                      part.id.value, part.hourglass_id));
    else if (own->second.ihq != 0)
      type = own->second.ihq;
  }
  if (type != 0 && type != full_projection)
    diagnostics.warning(
        model.file(place), place.line,
        fmt::format("part {}: hourglass control IHQ {} is calculated as type 8 (full projection), as fully "
                    "integrated shells have no hourglass modes",
                    part.id.value, type));
}

}  // namespace

bool membrane(const model::Section& section) {
  return section.kind == model::SectionKind::shell &&
         (section.elform == one_point_membrane || section.elform == full_membrane);
}

bool full_shell(const model::Section& section) {
  return section.kind == model::SectionKind::shell &&
         (section.elform == full_form || section.elform == full_membrane ||
          std::find(other_forms.begin(), other_forms.end(), section.elform) != other_forms.end());
}

void make_full(const model::Model& model, PartIndex index, const model::Section& section, ShellProperties& properties,
               Diagnostics& diagnostics) {
  properties.form = ShellForm::full;
  properties.sorts = model.controls.shell_esort != 0;
  properties.discrete_kirchhoff = model.controls.shell_esort == sort_to_dkt;
  properties.hourglass.kind = HourglassKind::none;
  if (section.elform != full_form)
    diagnostics.warning("", 0,
                        fmt::format("section {}: ELFORM {} is calculated as ELFORM 16", section.id, section.elform));
  if (model.rigid(index)) return;
  const model::Part& part = model.part(index);
  name_hourglass_control(model, part, diagnostics);
}

SolverStatus check_full_shell(const model::Model& model, const model::Shells& shells, std::uint32_t i,
                              const std::array<Vector, 4>& x) {
  const PartIndex part = shells.part[i];
  if (part == none<PartIndex> || model.rigid(part)) return {};
  const model::Part& own = model.part(part);
  if (!own.section || !full_shell(model.sections[*own.section])) return {};
  const std::int64_t esort = model.controls.shell_esort;
  const bool triangle = shells.nodes[i][2] == shells.nodes[i][3];
  if (triangle && (esort < 0 || esort > sort_to_dkt))
    return Failure{
        Failure::Kind::contradiction,
        fmt::format("*CONTROL_SHELL: ESORT is {}, with which triangle {} cannot be calculated; set 0 (quad with "
                    "two equal corners), 1 (C0 triangle) or 2 (DKT triangle)",
                    esort, shells.id[i]),
        model.controls.shell_place};
  if (!triangle && !(make_full_frame(x).determinant > 0).all())
    return Failure{
        Failure::Kind::bad_element,
        fmt::format("shell {} has no area at one of its four integration points; move its nodes until all its "
                    "corners are below 180 degrees, or give it ELFORM 2",
                    shells.id[i]),
        {shells.origins.file(i), shells.line[i]}};
  return {};
}

}  // namespace gapcheck::solver
