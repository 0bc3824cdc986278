#include "solver/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "results/matsum.hpp"
#include "results/nodout.hpp"
#include "solver/plot.hpp"
#include "solver/run_states.hpp"

namespace gapcheck::solver {
namespace {

Failure not_written(const std::string& path, const std::string& why) {
  return {Failure::Kind::output, fmt::format("{}: cannot be written: {}", path, why)};
}
Failure not_written(const std::string& path) {
  return not_written(path, std::strerror(errno != 0 ? errno : EIO));
}

std::vector<results::LegendEntry> contact_titles(const model::Model& model) {
  std::vector<results::LegendEntry> list;
  for (const model::Contact& contact : model.contacts) list.push_back({contact.id.value, contact.title});
  return list;
}

std::vector<results::LegendEntry> node_titles(const model::Model& model) {
  std::vector<results::LegendEntry> list;
  for (const model::HistoryNode& entry : model.output.history_nodes)
    list.push_back({model.mesh.nodes.id[entry.node.value], entry.title});
  return list;
}

}  // namespace

void Interval::written(double time) {
  next_ += length_ * std::max(1.0, std::floor((time - next_) / length_) + 1);
}

model::Output output_intervals(const model::Model& model, double end_time) {
  model::Output output = model.output;
  for (double* interval : {&output.glstat, &output.sleout, &output.rcforc})
    if (*interval == 0) *interval = end_time / 1000;
  if (output.d3plot == 0) output.d3plot = end_time / 20;
  if (model.contacts.empty()) output.sleout = output.rcforc = output.ncforc = 0;
  if (output.history_nodes.empty()) output.nodout = 0;
  return output;
}

std::optional<Failure> RunFiles::open(Text& text, const std::string& header) {
  text.path = (std::filesystem::path(settings_.directory) / text.name).string();
  std::error_code ignored;
  std::filesystem::remove(text.path, ignored);
  if (!text.interval.wanted()) return std::nullopt;
  errno = 0;
  text.file.reset(std::fopen(text.path.c_str(), "wb"));
  if (!text.file || std::fputs(header.c_str(), text.file.get()) < 0 || std::fflush(text.file.get()) != 0)
    return not_written(text.path);
  return std::nullopt;
}

std::variant<RunFiles, Failure> RunFiles::create(const Run& run, RunFilesSettings settings) {
  RunFiles files;
  files.settings_ = std::move(settings);
  const std::string& directory = files.settings_.directory;
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) return Failure{Failure::Kind::output, fmt::format("{}: cannot be created: {}", directory, error.message())};
  const model::Model& model = run.model();
  const model::Output output = output_intervals(model, run.end_time());
  const results::FileHeader header{model.title, files.settings_.program};
  const auto add = [&](const char* name, double interval, const std::string& text) {
    files.texts_.push_back({name, {}, Interval(interval), nullptr});
    return files.open(files.texts_.back(), text);
  };
  const auto contacts = contact_titles(model);
  auto problem = add("glstat", output.glstat, results::glstat_header(header));
  if (!problem) problem = add("matsum", output.matsum, results::matsum_header(header, part_titles(model)));
  if (!problem) problem = add("nodout", output.nodout, results::nodout_header(header, node_titles(model)));
  for (const auto& [name, interval] :
       {std::pair("rcforc", output.rcforc), std::pair("sleout", output.sleout), std::pair("ncforc", output.ncforc)})
    if (!problem) problem = add(name, interval, results::contact_header(header, contacts));
  if (problem) return std::move(*problem);
  files.sizes_ = contact::element_sizes(model);
  files.masses_ = std::make_unique<PartMasses>(model, files.sizes_);
  files.plot_interval_ = Interval(output.d3plot);
  if (!files.plot_interval_.wanted()) return files;
  results::D3plotWriteSettings form;
  form.word_bytes = files.settings_.double_words ? 8 : 4;
  auto plot = results::D3plotWriter::create((std::filesystem::path(directory) / "d3plot").string(),
                                            plot_mesh(model, run.initial().x), part_titles(model), form);
  if (!plot) return Failure{Failure::Kind::output, plot.error().file + ": " + plot.error().message};
  files.plot_ = std::make_unique<results::D3plotWriter>(std::move(plot).value());
  return files;
}

std::string RunFiles::state_text(std::size_t which, const Run& run) const {
  const State& state = run.stepper().state();
  switch (which) {
    case glstat:
      return results::glstat_text(global_state(run));
    case matsum:
      return results::matsum_text(state.time, part_states(run, *masses_));
    case nodout:
      return results::nodout_text(state.cycle + 1, state.time, node_states(run));
    case rcforc:
      return results::rcforc_text(state.time, interface_states(run));
    case sleout:
      return results::sleout_text(state.time, state.cycle + 1, interface_states(run));
    default:
      break;
  }
  std::string text;
  const auto contacts = run.contacts() != nullptr ? run.contacts()->states() : std::span<const ContactState>{};
  for (std::size_t i = 0; i < contacts.size(); ++i)
    text += results::ncforc_text(state.time, run.model().contacts[contacts[i].contact].id.value, 'A',
                                 node_forces(run, i));
  return text;
}

std::optional<Failure> RunFiles::plot(const Run& run) {
  const Stepper& stepper = run.stepper();
  results::D3plotState state =
      plot_state(run.model(), stepper.structure(), sizes_, masses_->motion(stepper.state()));
  state.kinetic = stepper.energies().kinetic;
  state.internal = stepper.energies().internal;
  state.total = stepper.energies().total();
  if (auto problem = plot_->append(state)) return Failure{Failure::Kind::output, problem->file + ": " + problem->message};
  ++plotted_;
  if (settings_.on_plot) return settings_.on_plot(state, run, plotted_);
  return std::nullopt;
}

std::optional<Failure> RunFiles::observe(const Run& run, bool last) {
  const double time = run.stepper().state().time;
  for (std::size_t i = 0; i < texts_.size(); ++i) {
    Text& text = texts_[i];
    if (!text.file || !(text.interval.due(time) || last)) continue;
    errno = 0;
    if (std::fputs(state_text(i, run).c_str(), text.file.get()) < 0 || std::fflush(text.file.get()) != 0)
      return not_written(text.path);
    text.interval.written(time);
  }
  if (plot_ && (plot_interval_.due(time) || last)) {
    plot_interval_.written(time);
    return plot(run);
  }
  return std::nullopt;
}

std::vector<std::string> RunFiles::names() const {
  std::vector<std::string> list;
  for (const Text& text : texts_)
    if (text.file) list.push_back(text.name);
  if (plot_) list.push_back("d3plot");
  return list;
}

}  // namespace gapcheck::solver
