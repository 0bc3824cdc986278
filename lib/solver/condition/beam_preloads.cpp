#include <fmt/format.h>

#include <algorithm>

#include "solver/condition/condition_builder.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::string_view preload_keyword = "INITIAL_AXIAL_FORCE_BEAM";

/// The force up to where the curve ends or first falls.
std::optional<AxialPreload> preload_of(ConditionBuilder& builder, const model::BeamPreload& preload) {
  const auto written = builder.curve(preload.curve, preload_keyword, preload.place);
  if (written == nullptr) return std::nullopt;
  const model::Curve& curve = builder.model.curves.at(preload.curve);
  if (curve.relaxation == 1)
    builder.fail(
        Failure::Kind::not_calculated, preload_keyword, preload.place,
        fmt::format("curve {} is for dynamic relaxation only (SIDR = 1), which is not calculated; set SIDR to 0",
                    preload.curve));
  else if (curve.relaxation != 0)
    builder.warn(
        preload_keyword, preload.place,
        fmt::format("the dynamic relaxation of curve {} (SIDR = {}) is not calculated; the preload acts in the "
                    "run only",
                    preload.curve, curve.relaxation));
  std::vector<TimeCurve::Point> points = curve.points;
  for (TimeCurve::Point& point : points) point = {point[0] * curve.abscissa_time, point[1] * preload.scale};
  const auto falls =
      std::adjacent_find(points.begin(), points.end(), [](const auto& a, const auto& b) { return b[1] < a[1]; });
  const double end = points.empty() ? 0 : falls == points.end() ? points.back()[0] : (*falls)[0];
  if (points.empty() || !(end > points.front()[0])) {
    builder.fail(Failure::Kind::contradiction, preload_keyword, preload.place,
                 fmt::format("the preload ends where curve {} (times SCALE) first falls or has its last point, here at "
                             "its start; let it rise from 0 to the force",
                             preload.curve));
    return std::nullopt;
  }
  AxialPreload result{TimeCurve(std::move(points)), end, preload.kbend == 1};
  const std::array<double, 2> limits{result.force.at(result.force.start()), result.force.at(end)};
  if (limits[1] < 0 || !std::isfinite(limits[0]) || !std::isfinite(limits[1])) {
    builder.fail(Failure::Kind::contradiction, preload_keyword, preload.place,
                 fmt::format("the force ends at {:g}; beams are pulled together by forces above zero", limits[1]));
    return std::nullopt;
  }
  return result;
}

/// Positions of the model's beams among those of the structure.
std::vector<std::uint32_t> positions_of_beams(const ConditionBuilder& builder) {
  std::vector<std::uint32_t> positions(builder.model.mesh.beams.size(), no_position);
  const BeamElements& beams = builder.structure.beams;
  for (std::uint32_t i = 0; i < beams.size(); ++i) positions[beams.origin(i)] = i;
  return positions;
}

/// Beams that yield under the force alone would flow as soon as it is no longer imposed.
void warn_if_it_yields(ConditionBuilder& builder, const model::BeamPreload& preload, const BeamProperties& properties,
                       double force) {
  const Material& material = properties.material;
  const double stress = force / properties.section.area;
  if (material.kind != MaterialKind::plastic || !(stress > material.yield_at(0).stress(0))) return;
  builder.warn(preload_keyword, preload.place,
               fmt::format("the stress {:g} of the preload is above the yield stress {:g}; the beams will yield once "
                           "the curve has ended",
                           stress, material.yield_at(0).stress(0)));
}

void apply_preload(ConditionBuilder& builder, const model::BeamPreload& preload,
                   const std::vector<std::uint32_t>& positions) {
  const auto fail = [&](Failure::Kind kind, std::string_view why) {
    builder.fail(kind, preload_keyword, preload.place, why);
  };
  if (preload.kbend != 0 && preload.kbend != 1)
    fail(Failure::Kind::not_calculated, fmt::format("KBEND = {} is not calculated; 0 and 1 are", preload.kbend));
  const auto set = builder.model.sets.beams.find(preload.set);
  if (set == builder.model.sets.beams.end())
    return fail(Failure::Kind::unknown_reference,
                fmt::format("set {} is not defined by a *SET_BEAM; define it", preload.set));
  const auto curve = preload_of(builder, preload);
  if (builder.failed() || !curve) return;
  BeamElements& beams = builder.structure.beams;
  const double force = curve->force.at(curve->end);
  const std::uint32_t number = beams.add_preload(*curve);
  bool warned = false;
  for (const std::uint32_t member : set->second.members) {
    const std::int64_t id = builder.model.mesh.beams.id[member];
    const std::uint32_t position = positions[member];
    if (position == no_position || !beams.properties(position).integrated())
      return fail(
          Failure::Kind::not_calculated,
          fmt::format("beam {} is not integrated over its cross-section; preloads are calculated for deformable "
                      "beams of ELFORM 1 and 9 with stress",
                      id));
    if (beams.preloaded(position))
      return fail(Failure::Kind::contradiction, fmt::format("beam {} has two preloads; give it one", id));
    if (!warned) warn_if_it_yields(builder, preload, beams.properties(position), force);
    warned = true;
    beams.preload(position, number);
  }
  if (set->second.members.empty())
    fail(Failure::Kind::unknown_reference, fmt::format("set {} has no beams; fill it", preload.set));
}

}  // namespace

void apply_beam_preloads(ConditionBuilder& builder) {
  if (builder.model.beam_preloads.empty()) return;
  const std::vector<std::uint32_t> positions = positions_of_beams(builder);
  for (const model::BeamPreload& preload : builder.model.beam_preloads)
    if (!builder.failed()) apply_preload(builder, preload, positions);
}

}  // namespace gapcheck::solver
