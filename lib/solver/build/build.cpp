#include "solver/build/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "solver/build/build_beams.hpp"
#include "solver/build/build_discrete_beams.hpp"
#include "solver/build/build_folded_shells.hpp"
#include "solver/build/build_full_shells.hpp"
#include "solver/build/build_hourglass.hpp"
#include "solver/build/build_rigid.hpp"
#include "solver/build/build_shells.hpp"
#include "solver/build/build_solid_rules.hpp"
#include "solver/build/build_spotwelds.hpp"
#include "solver/build/build_thick_shells.hpp"
#include "solver/build/build_welds.hpp"
#include "solver/build/material/build_equation_of_state.hpp"
#include "solver/build/material/build_foam_rubber.hpp"
#include "solver/build/material/build_johnson_cook.hpp"
#include "solver/build/material/build_orthotropic.hpp"
#include "solver/element/nodal_mass.hpp"
#include "solver/quadrature/gauss.hpp"

namespace gapcheck::solver {
namespace {

using model::SectionKind;

/// Half thicknesses between the nodes of a shell and its mid-surface.
constexpr double largest_reference = 1000;
template <std::size_t N>
model::Place place_of(const model::Elements<N>& elements, std::size_t i) {
  return {elements.origins.file(static_cast<std::uint32_t>(i)), elements.line[i]};
}

/// *ELEMENT_MASS.
SolverStatus add_masses(const model::Mesh& mesh, State& state) {
  for (std::size_t i = 0; i < mesh.masses.size(); ++i) {
    const double mass = mesh.mass_values[i];
    if (const NodeIndex node = mesh.masses.nodes[i][0]; node.value < mesh.nodes.size() && mass > 0)
      state.mass[node.value] += mass;
    if (mass < 0)
      return Failure{Failure::Kind::contradiction,
                     fmt::format("mass {} is {:g}; set a number that is not below zero", mesh.masses.id[i], mass),
                     place_of(mesh.masses, i)};
  }
  return {};
}

/// Sections and materials of the parts of elements.
class PartProperties {
 public:
  PartProperties(const model::Model& model, Diagnostics& diagnostics) : model_(model), diagnostics_(diagnostics) {}

  /// The part's section and material if both exist and are of the right kind.
  struct Properties {
    const model::Section* section = nullptr;
    Material material;
  };
  SolverResult<Properties> operator()(std::string_view what, std::int64_t id, PartIndex index, SectionKind kind,
                                      model::Place place) {
    const model::Part* part = index == none<PartIndex> ? nullptr : &model_.part(index);
    if (part == nullptr || !part->section || !part->material)
      return Failure{Failure::Kind::missing_material,
                     fmt::format("{} {} has no part, section or material; define them or leave it out", what, id),
                     place};
    const model::Section& section = model_.sections[*part->section];
    if (section.kind != kind)
      return Failure{Failure::Kind::missing_material,
                     fmt::format("{} {} is in part {}, whose section {} is for other elements", what, id,
                                 part->id.value, section.id),
                     place};
    auto material = build_material(model_, model_.materials[*part->material]);
    if (!material) return material.error();
    if (kind != SectionKind::shell && material.value().shells_only())
      return Failure{Failure::Kind::bad_material,
                     fmt::format("material {} is for shells only, but {} {} is of it",
                                 model_.materials[*part->material].id, what, id),
                     place};
    const bool solids_only = material.value().solids_only();
    if (kind != SectionKind::solid && solids_only)
      return Failure{Failure::Kind::bad_material,
                     fmt::format("material {} is calculated in solids only, but {} {} is of it",
                                 model_.materials[*part->material].id, what, id),
                     place};
    if (kind == SectionKind::beam && !material.value().in_beams())
      return Failure{Failure::Kind::bad_material,
                     fmt::format("material {} is calculated in shells and solids only, but {} {} is of it",
                                 model_.materials[*part->material].id, what, id),
                     place};
    if (kind == SectionKind::shell && material.value().johnson_cook)
      if (SolverStatus good = check_johnson_cook_shell(model_.materials[*part->material]); !good.ok())
        return good.error();
    if (kind == SectionKind::solid)
      if (SolverStatus added = add_equation_of_state(model_, *part, material.value()); !added.ok())
        return added.error();
    if (named_.insert(*part->material).second)
      name_what_is_not_calculated(model_, model_.materials[*part->material], diagnostics_);
    if (kind == SectionKind::shell && model_.materials[*part->material].weld)
      return Failure{
          Failure::Kind::bad_material,
          fmt::format("material {} is calculated in spotweld beams (ELFORM 9) and solids, but {} {} is of it",
                      model_.materials[*part->material].id, what, id),
          place};
    if (kind == SectionKind::beam && !section.integrated() && material.value().failure_strain > 0)
      diagnostics_.warning("", 0,
                           fmt::format("{} {} and others of material {} do not fail (FS, FAIL)", what, id,
                                       model_.materials[*part->material].id));
    if (kind == SectionKind::beam && material.value().erosion)
      diagnostics_.warning("", 0,
                           fmt::format("{} {} and others of material {} do not fail (*MAT_ADD_EROSION)", what, id,
                                       model_.materials[*part->material].id));
    if (kind == SectionKind::solid && !SolidFormulations::is_calculated(section))
      diagnostics_.warning(
          "", 0,
          fmt::format("section {}: ELFORM {} is calculated as {}", section.id, section.elform,
                      kind == SectionKind::shell ? "the one-point shell" : SolidFormulations::stand_in(section)));
    return Properties{&section, std::move(material).value()};
  }

 private:
  const model::Model& model_;
  Diagnostics& diagnostics_;
  std::set<std::uint32_t> named_;  ///< materials whose limits were reported
};

/// Builds, part by part, what elements need.
class Builder {
 public:
  Builder(const model::Model& model, const BuildSettings& settings, Diagnostics& diagnostics)
      : model_(model),
        settings_(settings),
        diagnostics_(diagnostics),
        properties_(model, diagnostics),
        scaling_(model.controls),
        positions_(model.parts.size()),
        rigid_(model.parts.size()) {}

  SolverResult<Structure> build() {
    State& state = structure_.state;
    const model::Mesh& mesh = model_.mesh;
    const std::size_t nodes = mesh.nodes.size();
    state.x = settings_.x != nullptr ? *settings_.x : mesh.nodes.x;
    state.v.assign(nodes, Vector::Zero());
    state.w.assign(nodes, Vector::Zero());
    state.mass.assign(nodes, 0);
    state.inertia.assign(nodes, 0);
    structure_.constraints.resize(nodes);
    structure_.node_id = mesh.nodes.id;
    structure_.shell_id = mesh.shells.id;
    structure_.solid_id = mesh.solids.id;
    structure_.beam_id = mesh.beams.id;
    name_element_controls(model_, diagnostics_);
    structure_.thick_shell_id = mesh.thick_shells.id;
    SolverStatus added = add_shells();
    if (added.ok()) added = add_solids();
    if (added.ok()) added = add_thick_shells(model_, scaling_, rigid_, structure_, diagnostics_);
    if (added.ok()) added = add_beams();
    if (added.ok()) added = add_masses(mesh, state);
    if (added.ok()) build_rigid_bodies(model_, std::move(rigid_), structure_);
    if (added.ok()) build_welds(model_, structure_, diagnostics_);
    name_what_is_left_out();
    if (!added.ok()) return added.error();
    return std::move(structure_);
  }

 private:
  /// The position of a shell's properties, which all shells of its part share, or those with the same plies of their
  /// own.
  SolverResult<std::uint32_t> shell_position(std::uint32_t i) {
    const model::Shells& shells = model_.mesh.shells;
    const PartIndex part = shells.part[i];
    const auto layup = shells.own_layup.empty() ? std::nullopt : shells.layup_of(i);
    if (part != none<PartIndex> && !layup && positions_[part.value]) return *positions_[part.value];
    const std::pair key{part.value, layup.value_or(0)};
    if (const auto known = layered_.find(key); layup && known != layered_.end()) return known->second;
    const auto found = properties_("shell", shells.id[i], part, SectionKind::shell, place_of(shells, i));
    if (!found) return found.error();
    auto all = shell_properties(model_, part, *found.value().section, found.value().material, settings_.shell_hourglass,
                                diagnostics_, layup ? &shells.layups[*layup] : nullptr);
    if (!all) return all.error();
    const auto folded = folded_shells(model_, part, *found.value().section, diagnostics_);
    if (!folded) return folded.error();
    all.value().folded = folded.value();
    const std::uint32_t position = structure_.shells.add_properties(std::move(all).value());
    if (layup)
      layered_.emplace(key, position);
    else
      positions_[part.value] = position;
    return position;
  }

  SolverStatus add_shells() {
    const model::Shells& shells = model_.mesh.shells;
    auto own = shells.own_thickness.begin();
    auto offset = shells.own_offset.begin();
    for (std::uint32_t i = 0; i < shells.size(); ++i) {
      const PartIndex part = shells.part[i];
      if (SolverStatus known = complete("shell", shells, i); !known.ok()) return known;
      if (SolverStatus full = check_full_shell(model_, shells, i, places(shells.nodes[i])); !full.ok()) return full;
      const auto position = shell_position(i);
      if (!position) return position.error();
      const model::Section& section = model_.sections[*model_.part(part).section];
      while (own != shells.own_thickness.end() && own->shell < i) ++own;
      const bool has_own = own != shells.own_thickness.end() && own->shell == i;
      const double thickness = mean_thickness(section, has_own ? &own->thickness : nullptr);
      if (!(thickness > 0) || !std::isfinite(thickness))
        return Failure{Failure::Kind::bad_element,
                       fmt::format("shell {} has the thickness {:g}; give its section one", shells.id[i], thickness),
                       place_of(shells, i)};
      if (model_.rigid(part)) {
        const double density = model_.materials[*model_.part(part).material].density;
        add_rigid(part, shells.nodes[i], shell_mass_points(places(shells.nodes[i]), thickness, density));
      } else {
        while (offset != shells.own_offset.end() && offset->shell < i) ++offset;
        const bool has_offset = offset != shells.own_offset.end() && offset->shell == i;
        const double reference = shell_reference(section, has_offset ? &offset->offset : nullptr, thickness);
        if (!std::isfinite(reference) || std::abs(reference) > largest_reference)
          return Failure{Failure::Kind::bad_element,
                         fmt::format("the mid-surface of shell {} is {:g} half thicknesses off its nodes; mend NLOC or "
                                     "OFFSET",
                                     shells.id[i], -reference),
                         place_of(shells, i)};
        structure_.added_mass +=
            structure_.shells.add(shells.nodes[i], structure_.shells.with_reference(position.value(), reference),
                                  thickness, i, structure_.state, scaling_);
        if (SolverStatus turned = turn_last_shell(part); !turned.ok()) return turned;
      }
    }
    return {};
  }

  SolverStatus turn_last_shell(PartIndex part) {
    const model::Material& material = model_.materials[*model_.part(part).material];
    if (!material.orthotropic) return {};
    double angle = 0;
    SolverStatus turned =
        turn_material(material, structure_.shells.axes(structure_.shells.size() - 1, structure_.state.x), angle);
    structure_.shells.set_axis(angle);
    return turned;
  }

  SolverStatus add_solids() {
    const model::Elements<8>& solids = model_.mesh.solids;
    positions_.assign(model_.parts.size(), std::nullopt);  // a part of shells cannot contain solids
    SolidFormulations formulations(model_, diagnostics_);
    for (std::uint32_t i = 0; i < solids.size(); ++i) {
      const PartIndex part = solids.part[i];
      if (SolverStatus known = complete("solid", solids, i); !known.ok()) return known;
      if (part == none<PartIndex> || !positions_[part.value]) {
        auto found = properties_("solid", solids.id[i], part, SectionKind::solid, place_of(solids, i));
        if (!found) return found.error();
        const auto rules = formulations.rules(part, *found.value().section, found.value().material);
        if (!rules) return rules.error();
        Diagnostics of_no_effect;  // bricks with eight points have no hourglass modes
        const ElementControl control =
            element_control(model_, model_.part(part), ElementFamily::solids, settings_.solid_hourglass,
                            has_eight_points(rules.value().brick) ? of_no_effect : diagnostics_);
        const model::Material& written = model_.materials[*model_.part(part).material];
        auto weld = weld_limits(written);
        if (!weld) return weld.error();
        if (!has_eight_points(rules.value().brick))
          name_free_bending(model_, written, weld.value(), control.hourglass, diagnostics_);
        const bool viscous = has_bulk_viscosity(found.value().material);
        positions_[part.value] = structure_.solids.add_properties(
            {std::move(found.value().material), control.hourglass, viscous ? control.quadratic_viscosity : 0,
             viscous ? control.linear_viscosity : 0, rules.value(), std::move(weld).value(),
             formulations.inverted_fail(part)});
      }
      if (SolverStatus weld = check_weld_brick(model_, i); !weld.ok()) return weld;
      if (!model_.rigid(part))
        if (SolverStatus known = formulations.look_at(i); !known.ok()) return known;
      double volume = 0;  // for rigid ones the mass, which has the same sign
      if (model_.rigid(part)) {
        const std::vector<PointMass> points =
            solid_mass_points(places(solids.nodes[i]), model_.materials[*model_.part(part).material].density);
        for (const PointMass& point : points) volume += point.mass;
        add_rigid(part, solids.nodes[i], points);
      } else {
        volume = structure_.solids.add(solids.nodes[i], *positions_[part.value], i, structure_.state, scaling_,
                                       &structure_.added_mass);
      }
      if (!(volume > 0))
        return Failure{Failure::Kind::bad_element,
                       fmt::format("solid {} has the volume {:g}{}; mend the order of its nodes", solids.id[i], volume,
                                   formulations.volume_note(i)),
                       place_of(solids, i)};
    }
    formulations.tell();
    return {};
  }

  SolverStatus add_beams() {
    const model::Elements<2>& beams = model_.mesh.beams;
    positions_.assign(model_.parts.size(), std::nullopt);
    BeamLimits limits(model_, diagnostics_);
    DiscreteBeams discrete(model_, diagnostics_);
    for (std::uint32_t i = 0; i < beams.size(); ++i) {
      const PartIndex part = beams.part[i];
      if (SolverStatus known = complete("beam", beams, i); !known.ok()) return known;
      if (DiscreteBeams::has(model_, part)) {
        const Vector third = limits.third_point(i, structure_.state);
        if (SolverStatus added = discrete.add(i, third, scaling_, structure_); !added.ok()) return added;
        continue;
      }
      if (part != none<PartIndex> && limits.leaves_out(part)) continue;
      if (part == none<PartIndex> || !positions_[part.value]) {
        const auto found = properties_("beam", beams.id[i], part, SectionKind::beam, place_of(beams, i));
        if (!found) return found.error();
        auto built = beam_properties(*found.value().section, found.value().material,
                                     model_.materials[*model_.part(part).material]);
        if (!built) return built.error();
        positions_[part.value] = structure_.beams.add_properties(std::move(built).value());
      }
      double length = 0;
      if (model_.rigid(part)) {
        const model::Section& section = model_.sections[*model_.part(part).section];
        const double density = model_.materials[*model_.part(part).material].density;
        const auto points = beam_mass_points(places(beams.nodes[i]), section.beam_area, density);
        for (const PointMass& point : points) length += point.mass;
        add_rigid(part, beams.nodes[i], points);
      } else {
        const Vector third = limits.third_point(i, structure_.state);
        const auto joint = limits.joint(i);
        if (!joint) return joint.error();
        length = structure_.beams.add(beams.nodes[i], *positions_[part.value], third, i, structure_.state, scaling_,
                                      &structure_.added_mass, joint.value());
      }
      if (!(length > 0)) {
        limits.tell();
        return Failure{Failure::Kind::bad_element, fmt::format("beam {} has no length or mass; mend it", beams.id[i]),
                       place_of(beams, i)};
      }
    }
    limits.tell();
    return {};
  }

  template <std::size_t N>
  SolverStatus complete(std::string_view what, const model::Elements<N>& elements, std::uint32_t i) {
    const auto& nodes = elements.nodes[i];
    const bool all =
        std::all_of(nodes.begin(), nodes.end(), [&](NodeIndex node) { return node.value < model_.mesh.nodes.size(); });
    if (!all)
      return Failure{Failure::Kind::bad_element,
                     fmt::format("{} {} has a node that is not there", what, elements.id[i]), place_of(elements, i)};
    return {};
  }

  template <std::size_t N>
  [[nodiscard]] std::array<Vector, N> places(const std::array<NodeIndex, N>& nodes) const {
    std::array<Vector, N> x;
    for (std::size_t k = 0; k < N; ++k) x[k] = structure_.state.x[nodes[k].value];
    return x;
  }

  template <std::size_t N>
  void add_rigid(PartIndex part, const std::array<NodeIndex, N>& nodes, const std::vector<PointMass>& points) {
    RigidPart& rigid = rigid_[part.value];
    rigid.nodes.insert(rigid.nodes.end(), nodes.begin(), nodes.end());
    rigid.points.insert(rigid.points.end(), points.begin(), points.end());
  }

  void name_what_is_left_out() {
    const model::Mesh& mesh = model_.mesh;
    const auto name = [&](std::string_view what, std::size_t count) {
      if (count > 0) diagnostics_.warning("", 0, fmt::format("{} {} take no part in the calculation", count, what));
    };
    name("particles", mesh.particles.size());
  }

  const model::Model& model_;
  const BuildSettings& settings_;
  Diagnostics& diagnostics_;
  PartProperties properties_;
  MassScaling scaling_;
  std::vector<std::optional<std::uint32_t>> positions_;  ///< by part: its position among the properties
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> layered_;  ///< of shells, by part and own plies
  std::vector<RigidPart> rigid_;                                              ///< by part
  Structure structure_;
};

}  // namespace

SolverResult<Structure> build_structure(const model::Model& model, const BuildSettings& settings,
                                        Diagnostics& diagnostics) {
  return Builder(model, settings, diagnostics).build();
}

}  // namespace gapcheck::solver
