#include "solver/output/run_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

/// The angle about each axis of a step with this angular velocity. That of a rigid body's nodes is the vector whose
/// spin_rotation() turns the body, 2 tan(angle / 2) / dt long.
Vector step_turn(const Vector& spin, double dt, bool rigid) {
  const double half = spin.norm() * dt / 2;
  return !rigid || !(half > 0) ? Vector(dt * spin) : Vector(std::atan(half) / half * dt * spin);
}

std::vector<CutSection> wanted_sections(const model::Model& model) {
  return model.output.secforc > 0 ? section_cuts(model) : std::vector<CutSection>();
}

/// Sections that are not calculated; of many the first ones.
void note_sections(const model::Model& model, std::vector<model::Output::Note>& notes) {
  constexpr std::size_t most = 20;
  std::size_t faults = 0;
  for (const CutSection& cut : wanted_sections(model)) {
    if (cut.fault.empty() || ++faults > most) continue;
    const model::CrossSection& section = model.cross_sections[cut.section];
    notes.push_back({section.place, fmt::format("cross-section {} is not in secforc: {}", section.id, cut.fault)});
  }
  if (faults > most)
    notes.push_back(
        {model.cross_sections[0].place, fmt::format("{} more cross-sections are not in secforc", faults - most)});
}

/// Files with an interval that have nothing to hold.
void note_empty_files(const model::Model& model, std::vector<model::Output::Note>& notes) {
  const model::Output& output = model.output;
  const bool loads = !model.loads.concentrated.empty() || !model.loads.pressures.empty();
  bool bodies = false, welds = !model.welds.empty();
  for (const PartIndex part : positions<PartIndex>(model.parts.size())) bodies = bodies || model.rigid(part);
  for (const model::RigidGroup& group : model.rigid_groups)
    bodies = bodies || group.kind == model::RigidGroup::Kind::nodal_rigid_body;
  for (const model::Material& material : model.materials) welds = welds || material.weld;
  const bool elements =
      !output.history_solids.empty() || !output.history_beams.empty() || !output.history_shells.empty();
  const bool springs = std::any_of(model.mesh.discrete_values.begin(), model.mesh.discrete_values.end(),
                                   [](const model::DiscreteValues& own) { return own.printed; });
  const auto note = [&](double interval, bool there, std::string_view name, std::string_view what) {
    if (interval > 0 && !there)
      notes.push_back(
          {{FileIndex{0}, 0}, fmt::format("the deck asks for {}, but has no {}: it is not written", name, what)});
  };
  note(output.secforc, !model.cross_sections.empty(), "secforc", "*DATABASE_CROSS_SECTION");
  note(output.spcforc, !model.spcs.empty(), "spcforc", "*BOUNDARY_SPC");
  note(output.bndout, loads || !model.prescribed_motions.empty(), "bndout", "loads and prescribed motions");
  note(output.rwforc, !model.rigid_walls.empty(), "rwforc", "rigid walls");
  note(output.rbdout, bodies, "rbdout", "rigid bodies");
  note(output.swforc, welds, "swforc", "welds");
  note(output.deforc, springs, "deforc", "discrete springs and dampers with PF = 0");
  note(output.abstat, !model.airbags.empty(), "abstat", "airbags");
  note(output.jntforc, !model.joints.empty(), "jntforc", "joints");
  note(output.elout, elements, "elout", "*DATABASE_HISTORY of solids, beams or shells");
}

}  // namespace

NodeTurns::NodeTurns(const Run& run)
    : rotation_(run.model().output.history_nodes.size(), Vector::Zero()), spin_(rotation_) {}

void NodeTurns::advance(const Run& run) {
  const State& state = run.stepper().state();
  const auto& entries = run.model().output.history_nodes;
  for (std::size_t i = 0; i < rotation_.size(); ++i) {
    const std::uint32_t node = entries[i].node.value;
    // Nodes of rigid bodies have the angular velocity of the step that ended here.
    const bool rigid = run.stepper().structure().rigid.holds(node);
    rotation_[i] += step_turn(rigid ? state.w[node] : spin_[i], state.dt, rigid);
    spin_[i] = state.w[node];
  }
}

RunRecord::RunRecord(const Run& run, const contact::ElementSizes& sizes, contact::SurfaceStore& surfaces)
    : masses(run.model(), sizes),
      turns(run),
      places(run.model(), run.stepper().structure()),
      held(run),
      sections(wanted_sections(run.model())) {
  const model::Output& output = run.model().output;
  if (output.ncforc > 0) areas = NodeAreas(run.model(), surfaces);
  if (output.bndout > 0) boundary = BoundaryWork(run, held);
  if (output.rbdout > 0) bodies = BodyTurns(run);
  if (output.swforc > 0) welds = WeldForces(run);
}

void RunRecord::advance(const Run& run) {
  turns.advance(run);
  boundary.advance(run);
  bodies.advance(run);
  welds.advance(run);
}

std::vector<model::Output::Note> output_notes(const model::Model& model) {
  std::vector<model::Output::Note> notes = model.output.all_notes();
  note_sections(model, notes);
  note_empty_files(model, notes);
  return notes;
}

}  // namespace gapcheck::solver
