#include "solver/build/build_discrete_beams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace gapcheck::solver {
namespace {

using DiscreteKind = model::DiscreteBeamMaterial::Kind;

constexpr std::array<std::string_view, 6> degrees{"r", "s", "t", "rotation r", "rotation s", "rotation t"};

/// Builds the laws of one part; remembers the first thing that is wrong.
class DiscreteBuilder {
 public:
  DiscreteBuilder(const model::Model& model, const model::Section& section, const model::Material& material)
      : model_(model), section_(section), material_(material), data_(*material.discrete_beam) {}

  SolverResult<DiscreteBeam> build() {
    take_section();
    if (data_.kind == DiscreteKind::cable)
      take_cable();
    else
      take_laws();
    check_mass();
    if (!status_.ok()) return status_.error();
    return std::move(beam_);
  }

 private:
  void refuse(Failure::Kind kind, const std::string& why) {
    if (status_.ok())
      status_ =
          Failure{kind, fmt::format("material {} (*{}): {}", material_.id, material_.keyword, why), material_.place};
  }
  void refuse_section(const std::string& why) {
    if (status_.ok())
      status_ = Failure{Failure::Kind::bad_element, fmt::format("section {} (ELFORM 6): {}", section_.id, why),
                        section_.place};
  }
  /// Not below zero.
  double constant(std::string_view what, double value) {
    if (!(value >= 0) || !std::isfinite(value))
      refuse(Failure::Kind::bad_material, fmt::format("{} is {:g}; set a number not below zero", what, value));
    return value;
  }
  double finite(std::string_view what, double value) {
    if (!std::isfinite(value))
      refuse(Failure::Kind::bad_material, fmt::format("{} is {:g}; set a number", what, value));
    return value;
  }

  std::vector<ForceCurve::Point> points(std::string_view what, std::int64_t id) {
    if (id == 0) return {};
    const auto found = model_.curves.find(id);
    if (found == model_.curves.end() || found->second.points.size() < 2) {
      refuse(Failure::Kind::bad_material, fmt::format("curve {} of {} is not there or has no two points", id, what));
      return {};
    }
    std::vector<ForceCurve::Point> list;
    for (const auto& point : found->second.points) list.push_back({point[0], point[1]});
    return list;
  }

  void take_section() {
    const model::DiscreteBeamSection& data = *section_.spring;
    beam_.scoor = data.scoor;
    beam_.fixed = data.fixed;
    beam_.inertia = data.inertia;
    beam_.density = material_.density;
    beam_.mass = material_.density * data.volume;
    if (!(std::abs(data.scoor) <= 3) || data.scoor != std::round(data.scoor))
      refuse_section(fmt::format("SCOOR is {:g}; set -3 to 3", data.scoor));
    for (const auto& [name, value] : {std::pair("VOL", data.volume), {"INER", data.inertia}, {"CA", data.cable_area}})
      if (!(value >= 0) || !std::isfinite(value))
        refuse_section(fmt::format("{} is {:g}; set a number not below zero", name, value));
  }

  void check_mass() {
    if (!(beam_.density > 0) || !std::isfinite(beam_.density))
      refuse(Failure::Kind::bad_material, fmt::format("RO is {:g}; set it above zero", beam_.density));
    const bool has_mass = beam_.mass > 0 || (beam_.cable && beam_.cable->area > 0);
    if (!has_mass) refuse_section("VOL is zero, so its beams have no mass; set it above zero");
    const auto& laws = beam_.laws;
    const bool translates =
        std::any_of(laws.begin(), laws.begin() + 3, [](const DiscreteLaw& law) { return law.largest_stiffness() > 0; });
    if (beam_.rotates() && beam_.inertia == 0 && !translates)
      refuse_section("INER is zero, but its beams resist rotation; set it above zero");
  }

  void take_laws() {
    for (std::size_t i = 0; i < 6; ++i) {
      DiscreteLaw& law = beam_.laws[i];
      const std::string of(degrees[i]);
      law.stiffness = constant("the stiffness of " + of, data_.stiffness[i]);
      law.damping = constant("the damping of " + of, data_.damping[i]);
      law.preload = finite("the preload of " + of, data_.preload[i]);
      const auto points = this->points(of, data_.curve[i]);
      if (data_.kind == DiscreteKind::nonlinear) law.force = ForceCurve(points);
      law.viscous = ForceCurve(this->points("the damping of " + of, data_.damping_curve[i]));
      if (data_.kind == DiscreteKind::plastic && !points.empty()) take_yield(of, points, law);
      beam_.failure_force[i] = constant("the failure force of " + of, data_.failure_force[i]);
      beam_.failure_way[i] = constant("the failure displacement of " + of, data_.failure_motion[i]);
    }
  }

  void take_yield(const std::string& of, const std::vector<ForceCurve::Point>& points, DiscreteLaw& law) {
    if (!(law.stiffness > 0))
      refuse(Failure::Kind::bad_material, fmt::format("{} has a curve of yield forces, but no stiffness", of));
    std::vector<YieldCurve::Point> forces;
    for (const auto& [way, force] : points) {
      if (way < 0) continue;
      if (!(force > 0))
        refuse(Failure::Kind::bad_material, fmt::format("the yield force of {} is {:g}; set it above zero", of, force));
      forces.push_back({way, force});
    }
    if (forces.empty())
      refuse(Failure::Kind::bad_material, fmt::format("the curve of {} has no points from zero on", of));
    if (status_.ok()) law.yield = YieldCurve(forces);
  }

  void take_cable() {
    const model::DiscreteBeamMaterial::Cable& data = data_.cable;
    Cable cable;
    cable.area = section_.spring->cable_area;
    cable.offset = finite("OFFSET", section_.spring->cable_offset);
    if (finite("E", data.young) < 0)
      cable.stiffness = -data.young;
    else
      cable.young = data.young;
    cable.stress = ForceCurve(points("LCID", data.curve));
    if (!cable.stress.empty()) cable.stiffness = cable.young = 0;
    cable.force = constant("F0", data.force);
    cable.start = constant("TSTART", data.start);
    cable.ramp = constant("TRAMP", data.ramp);
    cable.end = constant("TMAXF0", data.end);
    // The ramp is carried out even if TMAXF0 ends before it.
    if (cable.start > 0 || cable.ramp > 0) cable.end = std::max(cable.end, cable.start + cable.ramp);
    if (data.shortening != 0)
      refuse(Failure::Kind::not_calculated, "FRACL0, which shortens the cable, is not calculated; set 0 and use F0");
    for (const auto& [name, value] : {std::pair("MXEPS", data.failure_strain), {"MXFRC", data.failure_force}})
      if (value < 0)
        refuse(Failure::Kind::not_calculated, fmt::format("{} below zero (a curve) is not calculated", name));
    cable.failure_strain = data.failure_strain;
    cable.failure_force = data.failure_force;
    if (!(cable.area > 0) && (cable.young > 0 || !cable.stress.empty()))
      refuse_section("CA is zero, so its cables have no stiffness; set it above zero");
    beam_.cable = std::move(cable);
  }

  const model::Model& model_;
  const model::Section& section_;
  const model::Material& material_;
  const model::DiscreteBeamMaterial& data_;
  DiscreteBeam beam_;
  SolverStatus status_;
};

}  // namespace

bool DiscreteBeams::has(const model::Model& model, PartIndex part) {
  if (part == none<PartIndex>) return false;
  const model::Part& own = model.part(part);
  return own.section && own.material && model.sections[*own.section].spring &&
         model.materials[*own.material].discrete_beam;
}

SolverResult<DiscreteBeams::Built> DiscreteBeams::build(const model::Part& part, Structure& structure) {
  const model::Section& section = model_.sections[*part.section];
  const model::Material& material = model_.materials[*part.material];
  auto beam = DiscreteBuilder(model_, section, material).build();
  if (!beam) return beam.error();
  Built built;
  if (const std::int64_t id = section.spring->system; id != 0 && !beam.value().cable) {
    const auto found = model_.systems.find(id);
    const std::string fault = found == model_.systems.end() ? "it is not defined" : found->second.fault;
    if (!fault.empty())
      return Failure{
          Failure::Kind::bad_element,
          fmt::format("section {}: the coordinate system {} (CID) cannot be used: {}", section.id, id, fault),
          section.place};
    built.axes = found->second.axes;
  }
  if (!beam.value().cable && beam.value().inertia == 0 && (beam.value().rotates() || beam.value().couples()))
    diagnostics_.warning(model_.file(section.place), section.place.line,
                         fmt::format("section {}: INER is zero; its beams get an inertia with which rotations do not "
                                     "limit the time step",
                                     section.id));
  BeamProperties properties;
  properties.material.density = material.density;
  properties.section.area = section.spring->cable_area;
  properties.discrete = std::make_shared<const DiscreteBeam>(std::move(beam).value());
  built.properties = structure.beams.add_properties(std::move(properties));
  return built;
}

SolverStatus DiscreteBeams::add(std::uint32_t beam, const Vector& third, const MassScaling& scaling,
                                Structure& structure) {
  const model::Elements<2>& beams = model_.mesh.beams;
  const PartIndex part = beams.part[beam];
  auto found = built_.find(part.value);
  if (found == built_.end()) {
    auto built = build(model_.part(part), structure);
    if (!built) return built.error();
    found = built_.emplace(part.value, std::move(built).value()).first;
  }
  const Built& built = found->second;
  const double mass =
      structure.beams.add_discrete(beams.nodes[beam], built.properties, built.axes ? &*built.axes : nullptr, third,
                                   beam, structure.state, scaling, &structure.added_mass);
  const model::Place place{beams.origins.file(beam), beams.line[beam]};
  if (!(mass > 0))
    return Failure{Failure::Kind::bad_element, fmt::format("beam {} has no length or mass; mend it", beams.id[beam]),
                   place};
  const std::size_t last = structure.beams.size() - 1;
  const DiscreteState& state = *structure.beams.discrete(last);
  if (structure.beams.properties(last).discrete->cable && !(state.unstressed > 0))
    return Failure{
        Failure::Kind::bad_element,
        fmt::format("beam {}: the cable's OFFSET leaves an unstressed length of {:g}; set it below its length",
                    beams.id[beam], state.unstressed),
        place};
  return {};
}

}  // namespace gapcheck::solver
