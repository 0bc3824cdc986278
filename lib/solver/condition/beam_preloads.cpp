#include <fmt/format.h>

#include <algorithm>

#include "solver/condition/preload_curve.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::string_view preload_keyword = "INITIAL_AXIAL_FORCE_BEAM";

/// The force up to where the curve ends or first falls.
std::optional<AxialPreload> preload_of(ConditionBuilder& builder, const model::BeamPreload& preload) {
  constexpr PreloadWords words{preload_keyword, " (times SCALE)", "force", "forces", "beams"};
  auto curve = preload_curve(builder, preload.curve, preload.scale, words, preload.place);
  if (!curve) return std::nullopt;
  return AxialPreload{std::move(curve->curve), curve->end, preload.kbend == 1, curve->phases};
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
    if (beams.on_arms(position))
      return fail(
          Failure::Kind::not_calculated,
          fmt::format("beam {} is offset from its nodes; preloads are calculated for beams on their nodes", id));
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
