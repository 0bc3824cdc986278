#include "api/report_store.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "api/convert.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::api {
namespace {

Contact contact_of(const ContactSummary& from) {
  Contact contact;
  contact.id = from.id;
  contact.order = from.order;
  contact.title = from.title;
  contact.keyword = from.keyword;
  contact.type = from.type;
  contact.tracked_nodes = from.tracked_nodes;
  contact.segments = from.segments;
  contact.penetrations = from.penetrations;
  contact.max_penetration = from.max_penetration;
  contact.released = from.released;
  contact.edge_zone = from.edge_zone;
  contact.segment_penetrations = from.segment_penetrations;
  contact.mortar_penetrations = from.mortar_penetrations;
  contact.edge_penetrations = from.edge_penetrations;
  contact.ties = from.ties;
  contact.untied = from.untied;
  contact.out_of_reach = from.out_of_reach;
  contact.reported_penetrations = from.reported_penetrations;
  contact.judged_nearest = from.judged_nearest;
  contact.not_checked = from.not_checked;
  contact.file = from.file;
  contact.line = from.line;
  return contact;
}

Finding finding_of(const gapcheck::Finding& from) {
  Finding finding;
  finding.id = from.id;
  finding.rule = from.rule;
  finding.severity = converted(from.severity);
  finding.message = from.message;
  finding.contact = from.contact;
  finding.node = from.node;
  finding.part = from.part;
  finding.element = from.element;
  finding.element_part = from.element_part;
  finding.penetration = from.penetration;
  finding.contact_distance = from.contact_distance;
  if (from.point) copy(*from.point, finding.point.emplace().data());
  finding.count = from.count;
  finding.file = from.file;
  finding.line = from.line;
  return finding;
}

ModelCounts counts_of(const gapcheck::ModelCounts& from) {
  ModelCounts counts;
  counts.nodes = from.nodes;
  counts.shells = from.shells;
  counts.solids = from.solids;
  counts.beams = from.beams;
  counts.thick_shells = from.thick_shells;
  counts.discrete = from.discrete;
  counts.masses = from.masses;
  counts.particles = from.particles;
  counts.parts = from.parts;
  counts.contacts = from.contacts;
  return counts;
}

Timesteps timesteps_of(const gapcheck::Timesteps& from) {
  Timesteps steps;
  steps.contact = from.contact_timestep;
  steps.element = from.element_timestep;
  for (const gapcheck::SurfaceTimestep& each : from.surface_timesteps)
    steps.surfaces.push_back({each.contact, each.side, each.type, each.timestep, each.node, each.part});
  return steps;
}

static_assert(static_cast<int>(ElementKind::shell) == static_cast<int>(MeshElement::shell) &&
              static_cast<int>(ElementKind::solid) == static_cast<int>(MeshElement::solid) &&
              static_cast<int>(ElementKind::thick_shell) == static_cast<int>(MeshElement::thick_shell) &&
              static_cast<int>(ElementKind::beam) == static_cast<int>(MeshElement::beam) &&
              static_cast<int>(ElementKind::particle) == static_cast<int>(MeshElement::particle) &&
              sizeof(Vector) == 3 * sizeof(double) && sizeof(ElementKind) == sizeof(MeshElement));

Mesh mesh_view(const ElementMesh& from) {
  Mesh mesh;
  mesh.node = from.node_ids;
  // Points are three numbers each, one behind the other.
  if (!from.x.empty()) mesh.points = {from.x.front().data(), 3 * from.x.size()};
  mesh.corners = from.corners;
  mesh.ends = from.ends;
  mesh.kind = {reinterpret_cast<const ElementKind*>(from.kinds.data()), from.kinds.size()};
  mesh.element = from.element_ids;
  mesh.part = from.part_ids;
  mesh.contact = from.contact_ids;
  mesh.thickness = from.thickness;
  mesh.left_out = from.left_out;
  return mesh;
}

SolverRun::Termination termination_of(gapcheck::SolverRun::Termination from) {
  switch (from) {
    case gapcheck::SolverRun::Termination::normal:
      return SolverRun::Termination::normal;
    case gapcheck::SolverRun::Termination::error:
      return SolverRun::Termination::error;
    case gapcheck::SolverRun::Termination::unknown:
      break;
  }
  return SolverRun::Termination::unknown;
}

SolverRun run_of(const gapcheck::SolverRun& from) {
  SolverRun run;
  run.version = from.version;
  run.revision = from.revision;
  run.precision = from.precision;
  run.platform = from.platform;
  run.title = from.title;
  run.mpp = from.mpp;
  run.ranks = from.ranks;
  run.termination = termination_of(from.termination);
  run.problem_time = from.problem_time;
  run.end_time = from.end_time;
  run.cycles = from.cycles;
  run.timesteps = timesteps_of(from);
  for (const gapcheck::RigidwallPenetration& wall : from.rigidwalls)
    run.rigidwalls.push_back({wall.node, wall.wall, wall.depth, wall.file, wall.line});
  for (const gapcheck::SolverMessage& each : from.messages)
    run.messages.push_back(
        {converted(each.severity), each.code, each.kind, each.text, each.count, each.file, each.line});
  run.counts_may_be_cut = from.counts_may_be_cut;
  return run;
}

}  // namespace

Report report_of(gapcheck::Report from, const gapcheck::Diagnostics& diagnostics) {
  const auto store = std::make_shared<const ReportStore>(std::move(from));
  const gapcheck::Report& internal = store->report;
  Report report;
  report.source = internal.source;
  report.input = internal.input;
  report.model = counts_of(internal.model);
  report.files = internal.files;
  for (const ContactSummary& contact : internal.contacts) report.contacts.push_back(contact_of(contact));
  report.penetrations = store->penetrations.view();
  report.ties = store->ties.view();
  for (const gapcheck::Finding& finding : internal.findings) report.findings.push_back(finding_of(finding));
  const report::Totals totals = report::totals(internal);
  report.totals = {totals.errors, totals.warnings, totals.notes};
  report.ignored = internal.ignored.size();
  if (internal.predicted) report.predicted = timesteps_of(*internal.predicted);
  if (internal.run) report.run = run_of(*internal.run);
  if (internal.mesh) report.mesh = mesh_view(*internal.mesh);
  report.complete = !diagnostics.has_errors();
  report.diagnostics = listed(diagnostics);
  report.diagnostics_left_out = diagnostics.dropped();
  report.store = store;
  return report;
}

}  // namespace gapcheck::api
