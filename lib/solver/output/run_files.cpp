#include "solver/output/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string_view>
#include <system_error>

#include "base/file_writer.hpp"
#include "base/system/files.hpp"
#include "results/log/run_log.hpp"
#include "results/log/write_messag.hpp"
#include "solver/output/plot.hpp"
#include "solver/output/run_report.hpp"

namespace gapcheck::solver {
namespace {

/// A sum of steps may miss a multiple by this relative amount.
constexpr double rounding_of_time = 1e-12;

Failure not_written(const std::string& path, const std::string& why) {
  return {Failure::Kind::output, fmt::format("{}: cannot be written: {}", path, why)};
}
Failure not_written(const std::string& path) {
  return not_written(path, std::generic_category().message(errno != 0 ? errno : EIO));
}

/// All of the text, immediately visible to other programs.
bool write(std::FILE* file, std::string_view text) {
  errno = 0;
  return std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
}

/// Text that is written to some files in pieces.
class Pieces {
 public:
  struct File {
    std::FILE* file;
    const std::string& path;
  };
  explicit Pieces(std::vector<File> files) : files_(std::move(files)) {}
  void add(std::string_view piece) {
    constexpr std::size_t full = std::size_t{1} << 20;
    text_ += piece;
    if (text_.size() >= full) write_all();
  }
  [[nodiscard]] results::TextSink sink() {
    return [this](std::string_view piece) { add(piece); };
  }
  /// Writes what is left. The first failure counts.
  [[nodiscard]] SolverStatus end() {
    write_all();
    return status_;
  }

 private:
  void write_all() {
    for (const auto& [file, path] : files_)
      if (status_.ok() && !write(file, text_)) status_ = not_written(path);
    text_.clear();
  }

  std::vector<File> files_;
  std::string text_;
  SolverStatus status_;
};

const char* reason(RunEnd end) {
  switch (end) {
    case RunEnd::time:
      return "termination time reached";
    case RunEnd::cycles:
      return "termination cycle reached";
    case RunEnd::energy:
      return "the change of energy that ENDENG allows";
    case RunEnd::step:
      return "the smallest step that DTMIN allows";
    case RunEnd::stopped:
      return "termination on request";
    case RunEnd::signal:
      return "terminated by a signal";
    case RunEnd::failed:
      break;
  }
  return "termination due to an error";
}

}  // namespace

bool Interval::due(double time) const {
  return wanted() && (multiple_ == 0 || time >= multiple_ * length_ * (1 - rounding_of_time));
}

void Interval::written(double time) {
  multiple_ = std::max(multiple_, std::floor(time / length_ * (1 + rounding_of_time))) + 1;
}

SolverStatus RunFiles::open(Text& text, const std::string& header) {
  text.path = (std::filesystem::path(settings_.directory) / text.name).string();
  std::error_code ignored;
  std::filesystem::remove(text.path, ignored);
  if (!text.interval.wanted()) return {};
  errno = 0;
  text.file.reset(system::open_stream(text.path, "wb"));
  if (!text.file || !write(text.file.get(), header)) return not_written(text.path);
  return {};
}

SolverResult<RunFiles> RunFiles::create(const Run& run, contact::SurfaceStore& surfaces, RunFilesSettings settings) {
  RunFiles files;
  files.settings_ = std::move(settings);
  const std::string& directory = files.settings_.directory;
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    return Failure{Failure::Kind::output, fmt::format("{}: cannot be created: {}", directory, error.message())};
  files.sizes_ = contact::element_sizes(run.model());
  files.record_ = std::make_unique<RunRecord>(run, files.sizes_, surfaces);
  SolverStatus opened = files.open_logs(run, surfaces);
  if (opened.ok()) opened = files.open_texts(run);
  if (opened.ok()) opened = files.open_plot(run);
  if (opened.ok()) {
    auto intfor = RunIntfor::create(run, surfaces, directory, run.model().output.intfor, files.settings_.double_words);
    if (!intfor) return intfor.error();
    files.intfor_ = std::move(intfor).value();
  }
  if (!opened.ok()) return opened.error();
  return files;
}

SolverStatus RunFiles::open_texts(const Run& run) {
  const model::Output& output = run.model().output;
  const std::vector<TextFile> files = text_files(run, settings_.program, *record_);
  for (const TextFile& file : files) {
    const double interval = writes_text(output, file.name, settings_.binout) ? file.interval : 0;
    texts_.push_back({file.name, {}, Interval(interval), nullptr, file.state});
    if (SolverStatus opened = open(texts_.back(), file.header); !opened.ok()) return opened;
  }
  plot_interval_ = Interval(output_intervals(run.model(), run.end_time()).d3plot);
  auto binout =
      RunBinout::create(settings_.directory, {run.model().title, settings_.program}, files, output, settings_.binout);
  if (!binout) return binout.error();
  binout_ = std::move(binout).value();
  return {};
}

SolverStatus RunFiles::open_logs(const Run& run, contact::SurfaceStore& surfaces) {
  const model::Model& model = run.model();
  const results::FileHeader header{model.title, settings_.program};
  const Report report = run_report(run, surfaces);
  std::string switched;
  for (const model::Contact& contact : model.contacts)
    if (contact.soft == 2 && ContactForces::calculates(contact) && !contact::has_soft_2(contact::classify(contact)))
      switched += results::soft_switch_block(contact.id.value);
  for (const char* name : {"messag", "d3hsp"}) {
    logs_.push_back({name, {}, Interval(1), nullptr, nullptr});
    if (SolverStatus opened = open(logs_.back(), results::log_banner(header)); !opened.ok()) return opened;
  }
  const Text &messag = logs_[0], &d3hsp = logs_[1];
  Pieces definitions({{d3hsp.file.get(), d3hsp.path}});
  results::write_contact_definitions(contact_definitions(model, surfaces), definitions.sink());
  if (SolverStatus written = definitions.end(); !written.ok()) return written;
  Pieces found({{messag.file.get(), messag.path}, {d3hsp.file.get(), d3hsp.path}});
  found.add(switched + results::message_blocks(report));
  results::write_surface_timesteps(*report.predicted, report.contacts, found.sink());
  if (SolverStatus written = found.end(); !written.ok()) return written;
  Pieces last({{d3hsp.file.get(), d3hsp.path}});
  last.add(results::smallest_timesteps(element_steps(model, sizes_)));
  return last.end();
}

SolverStatus RunFiles::open_plot(const Run& run) {
  results::D3plotWriteSettings form;
  form.word_bytes = settings_.double_words ? 8 : 4;
  form.deletion = can_fail(run.stepper().structure());
  auto plot = results::D3plotWriter::create((std::filesystem::path(settings_.directory) / "d3plot").string(),
                                            plot_mesh(run.model(), run.initial().x), part_titles(run.model()), form);
  if (!plot) return Failure{Failure::Kind::output, plot.error().file + ": " + plot.error().message};
  plot_ = std::make_unique<results::D3plotWriter>(std::move(plot).value());
  return {};
}

SolverStatus RunFiles::log(const std::string& text) {
  for (const Text& file : logs_)
    if (!write(file.file.get(), text)) return not_written(file.path);
  return {};
}

SolverStatus RunFiles::log_plot(const Run& run, const std::string& what) {
  const State& state = run.stepper().state();
  return log(results::cycle_line(state.cycle + 1, state.time, run.stepper().next_step(), what));
}

SolverStatus RunFiles::log_failures(const Run& run) {
  const std::vector<ElementFailure>& failures = run.stepper().failures();
  const model::Mesh& mesh = run.model().mesh;
  std::string text;
  for (; logged_failures_ < failures.size(); ++logged_failures_) {
    const auto& [kind, element, time] = failures[logged_failures_];
    text += kind == StepControl::Kind::solid  ? results::failed_element("solid", mesh.solids.id[element], time)
            : kind == StepControl::Kind::beam ? results::failed_element("beam", mesh.beams.id[element], time)
                                              : results::failed_element("shell", mesh.shells.id[element], time);
  }
  return text.empty() ? SolverStatus() : log(text);
}

SolverStatus RunFiles::log_end(const Run& run, RunEnd end) {
  const State& state = run.stepper().state();
  std::string text;
  if (!run.status().ok()) text = results::error_block(run.status().error().message);
  return log(text + results::log_end(end != RunEnd::failed && end != RunEnd::signal, reason(end), state.time,
                                     state.cycle + 1));
}

SolverStatus RunFiles::plot(const Run& run) {
  const Stepper& stepper = run.stepper();
  results::D3plotState state =
      plot_state(run.model(), stepper.structure(), sizes_, record_->masses.motion(stepper.state()));
  state.kinetic = stepper.energies().printed_kinetic;
  state.internal = stepper.energies().printed_internal();
  state.total = stepper.energies().printed_total();
  if (const Status appended = plot_->append(state); !appended.ok())
    return Failure{Failure::Kind::output, appended.error().file + ": " + appended.error().message};
  ++plotted_;
  if (settings_.on_plot) return settings_.on_plot(state, run, plotted_);
  return {};
}

SolverStatus RunFiles::observe(const Run& run, std::optional<RunEnd> end) {
  const State& state = run.stepper().state();
  record_->advance(run);
  if (SolverStatus logged = log_failures(run); !logged.ok()) return logged;
  for (const ContactEvent& event : run.events())
    if (SolverStatus logged =
            log(results::contact_warning(run.model().contact(event.contact).id.value, event.time, event.text));
        !logged.ok())
      return logged;
  for (Text& text : texts_) {
    if (!text.file || !(text.interval.due(state.time) || end)) continue;
    if (!text.state(run, [&](std::string_view piece) { return write(text.file.get(), piece); }))
      return not_written(text.path);
    text.interval.written(state.time);
  }
  const bool plots = plot_interval_.due(state.time) || end;
  if (intfor_ && (intfor_->due(state.time) || end))
    if (SolverStatus logged = log_plot(run, "write intfor file"); !logged.ok()) return logged;
  for (Run::Observer* binary : {static_cast<Run::Observer*>(binout_.get()), static_cast<Run::Observer*>(intfor_.get())})
    if (binary != nullptr)
      if (SolverStatus added = binary->observe(run, end); !added.ok()) return added;
  if (plots) {
    plot_interval_.written(state.time);
    if (SolverStatus logged = log_plot(run, "write d3plot file"); !logged.ok()) return logged;
    if (SolverStatus plotted = plot(run); !plotted.ok()) return plotted;
  }
  if (!end) return {};
  if (SolverStatus logged = log_end(run, *end); !logged.ok()) return logged;
  return check_names();
}

SolverStatus RunFiles::check_names() const {
  if (binout_)
    if (SolverStatus names = binout_->check_names(); !names.ok()) return names;
  if (intfor_)
    if (SolverStatus names = intfor_->check_names(); !names.ok()) return names;
  Status there = plot_->check_names();
  for (const auto* texts : {&logs_, &texts_})
    for (const Text& text : *texts)
      if (text.file && there.ok()) there = check_name(text.path, id_of(text.file.get()), false);
  if (there.ok()) return {};
  return Failure{Failure::Kind::output, there.error().file + ": " + there.error().message};
}

std::vector<std::string> RunFiles::names() const {
  std::vector<std::string> list;
  for (const auto* texts : {&logs_, &texts_})
    for (const Text& text : *texts)
      if (text.file) list.push_back(text.name);
  if (binout_) list.push_back(RunBinout::name());
  if (intfor_) list.push_back(RunIntfor::name());
  list.emplace_back("d3plot");
  return list;
}

}  // namespace gapcheck::solver
