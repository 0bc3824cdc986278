#include "solver/output/text_files.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "results/curves/binout_write_histories.hpp"
#include "results/curves/contact_forces.hpp"
#include "results/curves/glstat.hpp"
#include "results/curves/matsum.hpp"
#include "results/curves/nodout.hpp"
#include "results/text/file_header.hpp"
#include "solver/output/connection_states.hpp"
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

std::vector<results::LegendEntry> airbag_titles(const model::Model& model) {
  std::vector<results::LegendEntry> list;
  for (const model::Airbag& airbag : model.airbags)
    if (!airbag.title.empty()) list.push_back({airbag.id, airbag.title});
  return list;
}

/// By StressKind.
std::array<std::vector<results::LegendEntry>, 3> element_titles(const model::Model& model) {
  std::array<std::vector<results::LegendEntry>, 3> list;
  const auto add = [&](results::StressKind kind, const std::vector<model::HistoryElement>& entries,
                       const std::vector<std::int64_t>& ids) {
    for (const model::HistoryElement& entry : entries)
      if (!entry.title.empty()) list[static_cast<std::size_t>(kind)].push_back({ids[entry.element], entry.title});
  };
  add(results::StressKind::solid, model.output.history_solids, model.mesh.solids.id);
  add(results::StressKind::beam, model.output.history_beams, model.mesh.beams.id);
  add(results::StressKind::shell, model.output.history_shells, model.mesh.shells.id);
  return list;
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

bool write_ncforc(const Run& run, const TextWriter& write, const NodeAreas& areas) {
  const double time = run.stepper().state().time;
  std::string text;
  for (const ContactIndex contact : positions<ContactIndex>(run.model().contacts.size())) {
    if (const auto nodes = node_forces(run, contact, areas))
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

namespace {

using results::BinoutWriter;

/// The list of files of a run.
class TextFileList {
 public:
  TextFileList(const Run& run, const std::string& program, const RunRecord& record)
      : model_(run.model()),
        output_(output_intervals(run.model(), run.end_time())),
        header_{run.model().title, program},
        record_(record) {
    add_energies();
    add_contacts();
    add_forces(run);
    add_bodies(run);
    add_elements();
  }

  [[nodiscard]] std::vector<TextFile> take() { return std::move(files_); }

 private:
  /// `rows`: what the file has of a run; `print` and `add` write it as text and into a binout.
  template <class Rows, class Print, class Add>
  void add(std::string name, double interval, std::string header, Rows rows, Print print, Add add) {
    files_.push_back(
        {std::move(name), interval, std::move(header),
         [rows, print](const Run& run, const TextWriter& write) {
           return write(print(run.stepper().state(), rows(run)));
         },
         [rows, add](const Run& run, BinoutWriter& binout) { add(binout, run.stepper().state(), rows(run)); }});
  }

  void add_energies() {
    files_.push_back({"glstat", output_.glstat, results::glstat_header(header_), write_glstat,
                      [](const Run& run, BinoutWriter& binout) { results::add_glstat(binout, global_state(run)); }});
    add(
        "matsum", output_.matsum, results::matsum_header(header_, part_titles(model_)),
        [&r = record_](const Run& run) { return part_states(run, r.masses); },
        [](const State& at, const auto& rows) { return results::matsum_text(at.time, rows); },
        [titles = part_titles(model_)](BinoutWriter& binout, const State& at, const auto& rows) {
          results::add_matsum(binout, at.time, titles, rows);
        });
    add(
        "nodout", output_.nodout, results::nodout_header(header_, node_titles(model_)),
        [&r = record_](const Run& run) { return node_states(run, &r.turns); },
        [](const State& at, const auto& rows) { return results::nodout_text(at.cycle + 1, at.time, rows); },
        [titles = node_titles(model_)](BinoutWriter& binout, const State& at, const auto& rows) {
          results::add_nodout(binout, titles, {at.cycle + 1, at.time, rows});
        });
  }

  void add_contacts() {
    const std::vector<results::LegendEntry> titles = contact_titles(model_);
    const std::string header = results::contact_header(header_, titles);
    const auto now = [](const Run& run, bool transducers) {
      const State& at = run.stepper().state();
      return results::InterfaceStates{at.time, at.cycle + 1, interface_states(run, transducers)};
    };
    files_.push_back({"rcforc", output_.rcforc, header, write_rcforc, [=](const Run& run, BinoutWriter& binout) {
                        results::add_rcforc(binout, titles, now(run, true));
                      }});
    files_.push_back({"sleout", output_.sleout, header, write_sleout, [=](const Run& run, BinoutWriter& binout) {
                        results::add_sleout(binout, titles, now(run, false));
                      }});
    files_.push_back(
        {"ncforc", output_.ncforc, header,
         [&r = record_](const Run& run, const TextWriter& write) { return write_ncforc(run, write, r.areas); },
         nullptr});
  }

  void add_forces(const Run& run) {
    add(
        "secforc", output_.secforc, results::secforc_header(header_, section_titles(record_, model_)),
        [&r = record_](const Run& now) { return section_states(now, r.places, r.sections); },
        [](const State& at, const auto& rows) { return results::secforc_text(at.time, rows); },
        [titles = section_titles(record_, model_)](BinoutWriter& binout, const State& at, const auto& rows) {
          results::add_secforc(binout, titles, at.time, rows);
        });
    add(
        "spcforc", output_.spcforc, results::spcforc_header(header_),
        [&r = record_](const Run& now) { return support_states(now, r.held); },
        [](const State& at, const auto& rows) { return results::spcforc_text(at.time, rows); },
        [](BinoutWriter& binout, const State& at, const auto& rows) { results::add_spcforc(binout, at.time, rows); });
    add(
        "bndout", output_.bndout, results::bndout_header(header_),
        [&r = record_](const Run&) { return r.boundary.states(); },
        [](const State& at, const auto& rows) { return results::bndout_text(at.time, rows); },
        [](BinoutWriter& binout, const State& at, const auto& rows) { results::add_bndout(binout, at.time, rows); });
    add(
        "rwforc", output_.rwforc, results::rwforc_header(header_, wall_titles(model_)), wall_states,
        [](const State& at, const auto& rows) { return results::rwforc_text(at.time, rows); },
        [titles = wall_titles(model_)](BinoutWriter& binout, const State& at, const auto& rows) {
          results::add_rwforc(binout, titles, at.time, rows);
        });
    add(
        "abstat", airbag_states(run).empty() ? 0 : output_.abstat,
        results::abstat_header(header_, airbag_titles(model_)), airbag_states,
        [](const State& at, const auto& rows) { return results::abstat_text(at.time, rows); },
        [titles = airbag_titles(model_)](BinoutWriter& binout, const State& at, const auto& rows) {
          results::add_abstat(binout, titles, at.time, rows);
        });
    add(
        "deforc", spring_states(run).empty() ? 0 : output_.deforc, results::deforc_header(header_), spring_states,
        [](const State& at, const auto& rows) { return results::deforc_text(at.time, rows); },
        [](BinoutWriter& binout, const State& at, const auto& rows) { results::add_deforc(binout, at.time, rows); });
  }

  void add_bodies(const Run& run) {
    add(
        "rbdout", listed_bodies(run).empty() ? 0 : output_.rbdout, results::rbdout_header(header_),
        [&r = record_](const Run& now) { return r.bodies.states(now); },
        [](const State& at, const auto& rows) { return results::rbdout_text(at.cycle + 1, at.time, rows); },
        [](BinoutWriter& binout, const State& at, const auto& rows) {
          results::add_rbdout(binout, at.cycle + 1, at.time, rows);
        });
    add(
        "jntforc", model_.joints.empty() ? 0 : output_.jntforc, results::jntforc_header(header_), joint_states,
        [](const State& at, const auto& rows) { return results::jntforc_text(at.time, rows); },
        [](BinoutWriter& binout, const State& at, const auto& rows) { results::add_jntforc(binout, at.time, rows); });
    add(
        "swforc", record_.welds.empty() ? 0 : output_.swforc, results::swforc_header(header_),
        [&r = record_](const Run& now) { return r.welds.states(now); },
        [](const State& at, const auto& rows) { return results::swforc_text(at.time, rows); },
        [](BinoutWriter& binout, const State& at, const auto& rows) { results::add_swforc(binout, at.time, rows); });
  }

  void add_elements() {
    const auto titles = element_titles(model_);
    std::vector<results::LegendEntry> all;
    for (const auto& of_kind : titles) all.insert(all.end(), of_kind.begin(), of_kind.end());
    const bool local = model_.output.local_shells;
    add(
        "elout", output_.elout, results::elout_header(header_, all),
        [&r = record_](const Run& now) { return element_stresses(now, r.places); },
        [local](const State& at, const auto& rows) { return results::elout_text(at.cycle + 1, at.time, local, rows); },
        [titles, local](BinoutWriter& binout, const State& at, const auto& rows) {
          results::add_elout(binout, titles, at.cycle + 1, at.time, local, rows);
        });
  }

  const model::Model& model_;
  const model::Output output_;
  const results::FileHeader header_;
  const RunRecord& record_;
  std::vector<TextFile> files_;
};

}  // namespace

std::vector<TextFile> text_files(const Run& run, const std::string& program, const RunRecord& record) {
  return TextFileList(run, program, record).take();
}

}  // namespace gapcheck::solver
