#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "solver/airbag/airbags.hpp"
#include "solver/condition/condition_builder.hpp"

namespace gapcheck::solver {
namespace {

/// Builds one airbag; the first failure goes to the builder.
class AirbagBuilder {
 public:
  AirbagBuilder(ConditionBuilder& builder, const model::Airbag& card) : builder_(builder), card_(card) {}

  /// Nothing after a failure, and for a surface without segments, which is told.
  std::optional<AirbagInput> build(std::uint32_t position) {
    check_settings();
    std::vector<model::SegmentNodes> segments = segments_of();
    if (builder_.failed()) return std::nullopt;
    if (segments.empty()) {
      builder_.warn(card_.keyword, card_.place,
                    fmt::format("airbag {} has no segments; it does nothing ({} {})", card_.id,
                                card_.parts ? "no shell is in part set" : "segment set", card_.set));
      return std::nullopt;
    }
    AirbagInput input{position,
                      ControlVolume(std::move(segments)),
                      card_.volume_scale,
                      card_.pressure_scale,
                      card_.excluded,
                      std::nullopt,
                      {}};
    check_surface(input);
    if (card_.kind == model::Airbag::Kind::simple)
      input.gas = gas();
    else
      input.law = law();
    if (builder_.failed()) return std::nullopt;
    return input;
  }

 private:
  void fail(Failure::Kind kind, const std::string& text) {
    builder_.fail(kind, card_.keyword, card_.place, fmt::format("airbag {}: {}", card_.id, text));
  }
  void not_calculated(const std::string& text) { fail(Failure::Kind::not_calculated, text); }
  void contradiction(const std::string& text) { fail(Failure::Kind::contradiction, text); }
  void above_zero(std::string_view name, double value) {
    if (!(value > 0)) contradiction(fmt::format("{} is {:g}; set a number above zero", name, value));
  }
  void not_below_zero(std::string_view name, double value) {
    if (!(value >= 0)) contradiction(fmt::format("{} is {:g}; set a number not below zero", name, value));
  }

  void check_settings() {
    if (builder_.relaxing) not_calculated("airbags are not calculated together with a dynamic relaxation");
    if (card_.sensor != 0)
      not_calculated(
          fmt::format("RBID = {}: sensors do not switch airbags on; set it to 0 to begin at the start", card_.sensor));
    if (card_.damping != 0) not_calculated("the damping MWD of its nodes is not calculated; set it to 0");
    if (card_.stagnation != 0) not_calculated("the stagnation pressure (SPSF) is not calculated; set it to 0");
    above_zero("VSCA", card_.volume_scale);
    above_zero("PSCA", card_.pressure_scale);
  }

  std::vector<model::SegmentNodes> segments_of() {
    const model::Model& model = builder_.model;
    std::vector<model::SegmentNodes> segments;
    if (!card_.parts) {
      const auto set = model.sets.segments.find(card_.set);
      if (set == model.sets.segments.end()) {
        fail(Failure::Kind::unknown_reference,
             fmt::format("segment set {} is not defined; define it, or set SIDTYP to 1 for a part set", card_.set));
        return {};
      }
      segments = set->second.members;
    } else {
      std::vector<bool> wanted(model.parts.size());
      for (const PartIndex part : builder_.part_set(card_.set, card_.keyword, card_.place))
        if (part.value < wanted.size()) wanted[part.value] = true;
      const auto& shells = model.mesh.shells;
      for (std::size_t i = 0; i < shells.size(); ++i)
        if (shells.part[i].value < wanted.size() && wanted[shells.part[i].value]) segments.push_back(shells.nodes[i]);
    }
    for (const model::SegmentNodes& segment : segments)
      for (const NodeIndex node : segment)
        if (node.value >= builder_.structure.state.x.size() && !builder_.failed())
          fail(Failure::Kind::unknown_reference, "a segment has no node");
    return segments;
  }

  /// Closed, with the normals outward.
  void check_surface(const AirbagInput& input) {
    const std::vector<Vector>& x = builder_.structure.state.x;
    const std::vector<std::int64_t>& ids = builder_.structure.node_id;
    if (const ControlVolume::OpenEdges open = input.surface.open_edges(); open.count > 0)
      return contradiction(fmt::format(
          "{} edges of its surface, the first between the nodes {} and {}, do not lie between two segments with the "
          "same side out; the surface must be closed, without inner walls, and all normals outward",
          open.count, ids[open.first[0]], ids[open.first[1]]));
    const double volume = input.surface.volume(x);
    if (volume < 0)
      return contradiction(
          fmt::format("its volume is {:g}: the normals of its segments point inward; the control volume needs them "
                      "outward: reverse the order of the nodes of all segments",
                      volume));
    const double left = input.volume_scale * volume - input.excluded;
    if (!(left > 0))
      contradiction(fmt::format("its volume at the start, {:g} times VSCA less VINI, is {:g}; it must be above zero",
                                volume, left));
  }

  /// The points of a curve whose abscissas rise and whose values are not below zero.
  model::Curve curve(std::int64_t id, std::string_view field) {
    const auto found = builder_.model.curves.find(id);
    if (found == builder_.model.curves.end() || found->second.points.empty()) {
      fail(Failure::Kind::unknown_reference,
           fmt::format("curve {} ({}) is not defined by a *DEFINE_CURVE, or has no points", id, field));
      return {};
    }
    const auto& points = found->second.points;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!(points[i][1] >= 0) || (i > 0 && !(points[i][0] > points[i - 1][0]))) {
        contradiction(fmt::format("curve {} ({}) needs rising abscissas and no value below zero", id, field));
        break;
      }
    return found->second;
  }
  /// A curve over time without values below zero; nullptr after a failure.
  std::shared_ptr<const TimeCurve> time_curve(std::int64_t id, std::string_view field) {
    auto curve = builder_.curve(id, card_.keyword, card_.place);
    if (curve == nullptr) return nullptr;
    for (const TimeCurve::Point& point : curve->points())
      if (!(point[1] >= 0)) {
        contradiction(
            fmt::format("curve {} ({}) has the value {:g}; it must not fall below zero", id, field, point[1]));
        break;
      }
    return curve;
  }
  PressureValue over_pressure(double constant, std::int64_t id, std::string_view field, double unit) {
    PressureValue value{constant, {}, card_.pressure_unit, unit};
    if (id != 0)
      value.curve = curve(id, field);
    else
      not_below_zero(field, constant);
    return value;
  }

  PressureByVolume law() {
    PressureByVolume law;
    if (card_.curve != 0) {
      law.over_volume = {0, curve(card_.curve, "LCID"), 1, card_.pressure_unit};
      return law;
    }
    above_zero("BETA", card_.factor);
    if (card_.coefficient_curve != 0) {
      law.coefficients = time_curve(card_.coefficient_curve, "CN");
      law.coefficient = card_.factor * card_.pressure_unit;
    } else {
      above_zero("CN", card_.coefficient);
      law.coefficient = card_.factor * card_.coefficient;
    }
    return law;
  }

  AirbagGas gas() {
    AirbagGas gas;
    if (card_.heat_volume == 0)
      not_calculated("heat capacities by A, B, MW and GASC (CV = 0) are not calculated; give CV and CP");
    above_zero("CV", card_.heat_volume);
    if (!(card_.heat_pressure > card_.heat_volume))
      contradiction(fmt::format("CP is {:g}; set a number above CV = {:g}", card_.heat_pressure, card_.heat_volume));
    not_below_zero("PE", card_.pressure);
    not_below_zero("RO", card_.density);
    if (card_.pressure > 0 && card_.density == 0)
      contradiction("RO is 0, with which its first gas has the pressure PE but no mass; set the ambient density");
    gas.heat_volume = card_.heat_volume;
    gas.heat_pressure = card_.heat_pressure;
    gas.inflow_temperature = card_.temperature;
    gas.ambient_pressure = card_.pressure;
    gas.ambient_density = card_.density;
    if (card_.curve != 0) {
      above_zero("T", card_.temperature);
      gas.inflow = time_curve(card_.curve, "LCID");
      gas.inflow_scale = card_.flow_unit;
    } else {
      builder_.warn(card_.keyword, card_.place, fmt::format("airbag {}: LCID is 0: no gas flows in", card_.id));
    }
    const bool exit = (card_.shape != 0 || card_.shape_curve != 0) && (card_.area != 0 || card_.area_curve != 0);
    if (exit && card_.exit_curve != 0)
      contradiction("LOU and MU with AREA are given, of which only one may be; set LOU or both of the others to 0");
    gas.shape = over_pressure(card_.shape, card_.shape_curve, "MU", 1);
    gas.area = over_pressure(card_.area, card_.area_curve, "AREA", card_.area_unit);
    if (card_.exit_curve != 0)
      gas.exit_flow = {0, curve(card_.exit_curve, "LOU"), card_.pressure_unit, card_.flow_unit};
    return gas;
  }

  ConditionBuilder& builder_;
  const model::Airbag& card_;
};

}  // namespace

void apply_airbags(ConditionBuilder& builder) {
  std::vector<AirbagInput> inputs;
  const std::vector<model::Airbag>& airbags = builder.model.airbags;
  for (std::uint32_t i = 0; i < airbags.size(); ++i) {
    if (auto input = AirbagBuilder(builder, airbags[i]).build(i)) inputs.push_back(std::move(*input));
    if (builder.failed()) return;
  }
  if (!inputs.empty()) builder.forces.push_back(std::make_unique<Airbags>(std::move(inputs), builder.structure.state));
}

}  // namespace gapcheck::solver
