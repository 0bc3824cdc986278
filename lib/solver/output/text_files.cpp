#include "solver/output/text_files.hpp"

#include <algorithm>
#include <span>

#include "results/curves/contact_forces.hpp"
#include "results/curves/glstat.hpp"
#include "results/curves/matsum.hpp"
#include "results/curves/nodout.hpp"
#include "results/text/file_header.hpp"
#include "solver/output/plot.hpp"
#include "solver/output/run_states.hpp"
#include "solver/output/section_states.hpp"

namespace gapcheck::solver {
namespace {

std::vector<results::LegendEntry> section_titles(const RunRecord& record, const model::Model& model) {
  std::vector<results::LegendEntry> list;
  for (const CutSection& cut : record.sections)
    if (const model::CrossSection& section = model.cross_sections[cut.section]; cut.fault.empty())
      list.push_back({section.id, section.title});
  return list;
}

std::vector<results::LegendEntry> wall_titles(const model::Model& model) {
  std::vector<results::LegendEntry> list;
  for (const model::RigidWall& wall : model.rigid_walls) list.push_back({wall.id, wall.title});
  return list;
}

std::vector<results::LegendEntry> element_titles(const model::Model& model) {
  std::vector<results::LegendEntry> list;
  const auto add = [&](const std::vector<model::HistoryElement>& entries, const std::vector<std::int64_t>& ids) {
    for (const model::HistoryElement& entry : entries)
      if (!entry.title.empty()) list.push_back({ids[entry.element], entry.title});
  };
  add(model.output.history_solids, model.mesh.solids.id);
  add(model.output.history_beams, model.mesh.beams.id);
  add(model.output.history_shells, model.mesh.shells.id);
  return list;
}

// The present state of each file as text.
std::string matsum_state(const Run& run, const State& at, const RunRecord& record) {
  return results::matsum_text(at.time, part_states(run, record.masses));
}
std::string nodout_state(const Run& run, const State& at, const RunRecord& record) {
  return results::nodout_text(at.cycle + 1, at.time, node_states(run, &record.turns));
}
std::string secforc_state(const Run& run, const State& at, const RunRecord& record) {
  return results::secforc_text(at.time, section_states(run, record.places, record.sections));
}
std::string spcforc_state(const Run& run, const State& at, const RunRecord& record) {
  return results::spcforc_text(at.time, support_states(run, record.held));
}
std::string bndout_state(const Run&, const State& at, const RunRecord& record) {
  return results::bndout_text(at.time, record.boundary.states());
}
std::string rwforc_state(const Run& run, const State& at, const RunRecord&) {
  return results::rwforc_text(at.time, wall_states(run));
}
std::string rbdout_state(const Run& run, const State& at, const RunRecord& record) {
  return results::rbdout_text(at.cycle + 1, at.time, record.bodies.states(run));
}
std::string swforc_state(const Run& run, const State& at, const RunRecord& record) {
  return results::swforc_text(at.time, record.welds.states(run));
}
std::string elout_state(const Run& run, const State& at, const RunRecord& record) {
  return results::elout_text(at.cycle + 1, at.time, run.model().output.local_shells,
                             element_stresses(run, record.places));
}

bool write_glstat(const Run& run, const TextWriter& write) { return write(results::glstat_text(global_state(run))); }

/// The rows of thousands of contacts are never all in memory.
bool write_rcforc(const Run& run, const TextWriter& write) {
  constexpr std::size_t at_once = 1024;
  const double time = run.stepper().state().time;
  const std::vector<results::InterfaceState> states = interface_states(run, true);
  for (std::size_t i = 0; i < states.size(); i += at_once)
    if (!write(results::rcforc_text(time, std::span(states).subspan(i, std::min(at_once, states.size() - i)))))
      return false;
  return true;
}

bool write_sleout(const Run& run, const TextWriter& write) {
  const State& at = run.stepper().state();
  return results::write_sleout(at.time, at.cycle + 1, interface_states(run, false), write);
}

bool write_ncforc(const Run& run, const TextWriter& write) {
  const double time = run.stepper().state().time;
  std::string text;
  for (const ContactIndex contact : positions<ContactIndex>(run.model().contacts.size())) {
    if (const auto nodes = node_forces(run, contact))
      text += results::ncforc_text(time, run.model().contact(contact).id.value, *nodes);
  }
  return write(text);
}

}  // namespace

model::Output output_intervals(const model::Model& model, double end_time) {
  model::Output output = model.output;
  for (double* interval : {&output.glstat, &output.sleout, &output.rcforc})
    if (*interval == 0) *interval = end_time / 1000;
  if (output.d3plot == 0) output.d3plot = end_time / 20;
  if (model.contacts.empty()) output.sleout = output.rcforc = output.ncforc = 0;
  if (output.history_nodes.empty()) output.nodout = 0;
  const bool loaded = !model.loads.concentrated.empty() || !model.loads.pressures.empty();
  const bool elements =
      !output.history_shells.empty() || !output.history_solids.empty() || !output.history_beams.empty();
  const auto only_if = [](bool there, double& interval) { interval = there ? interval : 0; };
  only_if(!model.cross_sections.empty(), output.secforc);
  only_if(!model.spcs.empty(), output.spcforc);
  only_if(loaded || !model.prescribed_motions.empty(), output.bndout);
  only_if(!model.rigid_walls.empty(), output.rwforc);
  only_if(elements, output.elout);
  return output;
}

std::vector<TextFile> text_files(const Run& run, const std::string& program, const RunRecord& record) {
  const model::Model& model = run.model();
  const model::Output output = output_intervals(model, run.end_time());
  const results::FileHeader header{model.title, program};
  const bool any_body = !listed_bodies(run).empty();
  const std::string contacts = results::contact_header(header, contact_titles(model));
  const auto text = [&record](auto make) {
    return [make, &record](const Run& now, const TextWriter& write) {
      return write(make(now, now.stepper().state(), record));
    };
  };
  return {
      {"glstat", output.glstat, results::glstat_header(header), write_glstat},
      {"matsum", output.matsum, results::matsum_header(header, part_titles(model)), text(matsum_state)},
      {"nodout", output.nodout, results::nodout_header(header, node_titles(model)), text(nodout_state)},
      {"rcforc", output.rcforc, contacts, write_rcforc},
      {"sleout", output.sleout, contacts, write_sleout},
      {"ncforc", output.ncforc, contacts, write_ncforc},
      {"secforc", output.secforc, results::secforc_header(header, section_titles(record, model)), text(secforc_state)},
      {"spcforc", output.spcforc, results::spcforc_header(header), text(spcforc_state)},
      {"bndout", output.bndout, results::bndout_header(header), text(bndout_state)},
      {"rwforc", output.rwforc, results::rwforc_header(header, wall_titles(model)), text(rwforc_state)},
      {"rbdout", any_body ? output.rbdout : 0, results::rbdout_header(header), text(rbdout_state)},
      {"swforc", record.welds.empty() ? 0 : output.swforc, results::swforc_header(header), text(swforc_state)},
      {"elout", output.elout, results::elout_header(header, element_titles(model)), text(elout_state)},
  };
}

}  // namespace gapcheck::solver
