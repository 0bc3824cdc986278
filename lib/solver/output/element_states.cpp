#include "solver/output/element_states.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

using results::ElementStress;
using results::WeldForce;

results::StressRow stress_row(const PointState& point, const Symmetric& stress) {
  const Symmetric s = deviator(stress);
  return {stress, point.plastic_strain, std::sqrt(1.5 * contract(s, s)), point.plastic_strain > 0};
}

ElementStress shell_stress(const Run& run, std::uint32_t shell) {
  const Structure& structure = run.stepper().structure();
  const bool local = run.model().output.local_shells;
  const Matrix axes = structure.shells.axes(shell, structure.state.x);
  ElementStress element;
  element.layers = std::max<std::size_t>(structure.shells.properties(shell).layers.size(), 1);
  for (const PointState& point : structure.shells.points(shell))
    element.points.push_back(stress_row(point, local ? point.stress : rotated(point.stress, axes)));
  return element;
}

/// Moments in the middle of the beam.
ElementStress beam_stress(const Run& run, std::uint32_t beam) {
  const BeamElements& beams = run.stepper().structure().beams;
  const std::vector<Vector>& x = run.stepper().state().x;
  ElementStress element;
  element.kind = results::StressKind::beam;
  element.resultants[0] = beams.axial(beam);
  if (!beams.properties(beam).truss) {
    const Vector r = (x[beams.nodes(beam)[1].value] - x[beams.nodes(beam)[0].value]).normalized();
    const Vector &s = beams.state(beam).axis, t = r.cross(s), force = beams.end_force(beam);
    const Vector moment = (beams.moment_at_end(beam, 1) - beams.moment_at_end(beam, 0)) / 2;
    element.resultants = {beams.axial(beam), force.dot(s), force.dot(t), moment.dot(s), moment.dot(t), moment.dot(r)};
  }
  for (const BeamPoint& point : beams.points(beam)) {
    results::StressRow row;
    row.stress = {point.stress[0], 0, 0, point.stress[1], 0, point.stress[2]};
    row.plastic_strain = point.plastic_strain;
    element.points.push_back(row);
  }
  return element;
}

ElementStress solid_stress(const Run& run, std::uint32_t solid) {
  const PointState mean = run.stepper().structure().solids.point(solid);
  ElementStress element;
  element.kind = results::StressKind::solid;
  element.points.push_back(stress_row(mean, mean.stress));
  return element;
}

template <class Elements>
bool is_weld(const model::Model& model, const Elements& elements, std::uint32_t element) {
  const auto& material = model.part(elements.part[element]).material;
  return material && model.materials[*material].weld.has_value();
}

/// When an element failed; 0: it has not.
double failure_time(const Run& run, StepControl::Kind kind, std::uint32_t origin) {
  for (const ElementFailure& failure : run.stepper().failures())
    if (failure.kind == kind && failure.element == origin) return failure.time;
  return 0;
}

WeldForce beam_weld(const Run& run, std::uint32_t beam) {
  const BeamElements& beams = run.stepper().structure().beams;
  const std::vector<Vector>& x = run.stepper().state().x;
  const Vector way = x[beams.nodes(beam)[1].value] - x[beams.nodes(beam)[0].value];
  const std::array<double, 6> resultants = beam_stress(run, beam).resultants;
  WeldForce weld;
  weld.kind = WeldForce::Kind::beam;
  weld.id = run.model().mesh.beams.id[beams.origin(beam)];
  weld.length = way.norm();
  weld.failed = beams.failed(beam);
  if (weld.failed) weld.failure_time = failure_time(run, StepControl::Kind::beam, beams.origin(beam));
  if (weld.failed) return weld;
  weld.axial = resultants[0];
  weld.shear = std::hypot(resultants[1], resultants[2]);
  weld.moment = std::hypot(resultants[3], resultants[4]);
  weld.torsion = resultants[5];
  return weld;
}

WeldForce solid_weld(const Run& run, std::uint32_t solid) {
  const SolidElements& solids = run.stepper().structure().solids;
  std::array<Vector, 8> x, force;
  for (std::size_t k = 0; k < 8; ++k) {
    x[k] = run.stepper().state().x[solids.nodes(solid)[k].value];
    force[k] = solids.corner_force(solid, k);
  }
  WeldForce weld;
  weld.kind = WeldForce::Kind::solid;
  weld.id = run.model().mesh.solids.id[solids.origin(solid)];
  weld.length = (x[4] + x[5] + x[6] + x[7] - x[0] - x[1] - x[2] - x[3]).norm() / 4;
  weld.failed = solids.failed(solid);
  if (weld.failed) weld.failure_time = failure_time(run, StepControl::Kind::solid, solids.origin(solid));
  if (weld.failed) return weld;
  const WeldResultants resultants = brick_resultants(x, force);
  weld.axial = resultants[0];
  weld.shear = std::hypot(resultants[1], resultants[2]);
  weld.torsion = resultants[3];
  weld.moment = std::hypot(resultants[4], resultants[5]);
  return weld;
}

}  // namespace

std::vector<ElementStress> element_stresses(const Run& run, const ElementPlaces& places) {
  const model::Output& output = run.model().output;
  const Structure& structure = run.stepper().structure();
  std::vector<ElementStress> list;
  const auto add = [&](const std::vector<model::HistoryElement>& entries, const std::vector<std::uint32_t>& place,
                       const auto& mesh, const auto& elements, const auto& make) {
    for (const model::HistoryElement& entry : entries) {
      const std::uint32_t position = place[entry.element];
      if (position == no_position || elements.failed(position)) continue;
      list.push_back(make(run, position));
      list.back().id = mesh.id[entry.element];
      list.back().part = run.model().part(mesh.part[entry.element]).id.value;
    }
  };
  const model::Mesh& mesh = run.model().mesh;
  add(output.history_solids, places.solids, mesh.solids, structure.solids, solid_stress);
  add(output.history_beams, places.beams, mesh.beams, structure.beams, beam_stress);
  add(output.history_shells, places.shells, mesh.shells, structure.shells, shell_stress);
  return list;
}

WeldForces::WeldForces(const Run& run) {
  const model::Model& model = run.model();
  const Structure& structure = run.stepper().structure();
  for (std::uint32_t i = 0; i < model.welds.size(); ++i) {
    const std::vector<NodeIndex>& nodes = model.welds[i].nodes;
    if (nodes.empty() || nodes[0].value >= structure.state.x.size()) continue;
    const auto body = structure.rigid.body_of(nodes[0].value);
    // A weld that takes no part has its nodes in another body.
    if (body && structure.rigid.nodes(*body) == nodes) links_.push_back({*body, i, false, 0});
  }
  for (std::uint32_t i = 0; i < structure.beams.size(); ++i)
    if (is_weld(model, model.mesh.beams, structure.beams.origin(i))) beams_.push_back(i);
  for (std::uint32_t i = 0; i < structure.solids.size(); ++i)
    if (is_weld(model, model.mesh.solids, structure.solids.origin(i))) solids_.push_back(i);
}

void WeldForces::advance(const Run& run) {
  for (Link& link : links_) {
    if (link.failed || !run.stepper().structure().rigid.failed(link.body)) continue;
    link.failed = true;
    // It was released at the end of the step that led here.
    link.failure_time = run.stepper().state().time - run.stepper().state().dt;
  }
}

WeldForce WeldForces::link_force(const Run& run, const Link& link) const {
  const model::Weld& weld = run.model().welds[link.weld];
  WeldForce force;
  force.kind = weld.generalized ? WeldForce::Kind::generalized : WeldForce::Kind::link;
  force.id = weld.id;
  force.failed = link.failed;
  force.failure_time = link.failure_time;
  if (link.failed || weld.nodes.size() != 2) return force;
  const std::vector<Vector>& x = run.stepper().state().x;
  const Vector& pull = run.stepper().structure().rigid.response(link.body).link;
  const Vector way = x[weld.nodes[1].value] - x[weld.nodes[0].value];
  const double length = way.norm();
  force.axial = length > 0 ? pull.dot(way) / length : 0;
  force.shear = length > 0 ? (pull - force.axial / length * way).norm() : pull.norm();
  return force;
}

std::vector<WeldForce> WeldForces::states(const Run& run) const {
  std::vector<WeldForce> list;
  for (const Link& link : links_) list.push_back(link_force(run, link));
  for (const std::uint32_t beam : beams_) list.push_back(beam_weld(run, beam));
  for (const std::uint32_t solid : solids_) list.push_back(solid_weld(run, solid));
  return list;
}

}  // namespace gapcheck::solver
