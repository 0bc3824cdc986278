#include "solver/run.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <gapcheck/run.hpp>
#include <gapcheck/version.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "api/convert.hpp"
#include "api/option_check.hpp"
#include "results/d3plot/run_folder.hpp"
#include "solver/output/run_files.hpp"
#include "solver/output/state_balance.hpp"
#include "solver/supported.hpp"

namespace gapcheck::api {
namespace {

RunState state_of(const solver::Run& run) {
  const solver::Stepper& stepper = run.stepper();
  const solver::Energies& energies = stepper.energies();
  RunState state;
  state.time = stepper.state().time;
  state.end_time = run.end_time();
  state.step = stepper.next_step();
  state.cycle = stepper.state().cycle;
  state.kinetic = energies.printed_kinetic;
  state.internal = energies.printed_internal();
  state.hourglass = energies.hourglass;
  state.sliding = energies.absorbed.sliding();
  state.external = energies.external;
  state.total = energies.printed_total();
  state.energy_ratio = energies.printed_ratio();
  state.seconds = run.seconds();
  for (const solver::ContactView& view : run.contacts()) {
    const solver::ContactState& from = view.state();
    RunContact contact;
    contact.id = run.model().contact(from.contact).id.value;
    contact.touching = from.touching;
    contact.released = from.released;
    contact.moved = from.moved;
    copy(from.force_a, contact.force_a);
    copy(from.force_b, contact.force_b);
    contact.energy_a = from.energy_a;
    contact.energy_b = from.energy_b;
    contact.friction = from.friction;
    state.contacts.push_back(contact);
  }
  return state;
}

/// Files, and the caller who watches.
class Watch : public solver::Run::Observer {
 public:
  Watch(solver::RunFiles& files, const RunOptions& options, bool& stop)
      : files_(files), options_(options), stop_(stop) {}
  solver::SolverStatus observe(const solver::Run& run, std::optional<solver::RunEnd> end) override {
    if (options_.watch && !options_.watch(state_of(run))) stop_ = true;
    return files_.observe(run, end);
  }

 private:
  solver::RunFiles& files_;
  const RunOptions& options_;
  bool& stop_;
};

RunEnd end_of(solver::RunEnd end) {
  switch (end) {
    case solver::RunEnd::time:
      return RunEnd::time;
    case solver::RunEnd::cycles:
      return RunEnd::cycles;
    case solver::RunEnd::energy:
      return RunEnd::energy;
    case solver::RunEnd::step:
      return RunEnd::step;
    case solver::RunEnd::stopped:
    case solver::RunEnd::signal:
      return RunEnd::stopped;
    case solver::RunEnd::failed:
      break;
  }
  return RunEnd::failed;
}

/// Says what of the deck is not calculated.
void add_unsupported(const std::vector<solver::Unsupported>& list, bool leave_out, gapcheck::Diagnostics& diagnostics) {
  for (const solver::Unsupported& one : list)
    diagnostics.add({leave_out ? gapcheck::Severity::warning : gapcheck::Severity::error, one.file, one.line,
                     fmt::format("*{} {}: {}", one.keyword, leave_out ? "is left out" : "is not supported", one.why)});
}

void add_output_notes(const keyword::Deck& deck, const model::Model& model, gapcheck::Diagnostics& diagnostics) {
  for (const model::Output::Note& note : solver::output_notes(model))
    diagnostics.warning(deck.files()[note.place.file.value].path, note.place.line, note.text);
}

Error error_from(const solver::Failure& failure, const model::Model& model, const gapcheck::Diagnostics& diagnostics) {
  return {model.file(failure.place), failure.place.line, failure.message, listed(diagnostics)};
}

/// Steps to the end. `stop`: what the run asks before every step.
Result<RunSummary> calculated(solver::Run& run, contact::SurfaceStore& surfaces, const std::string& directory,
                              const RunOptions& options, bool& stop, const gapcheck::Diagnostics& diagnostics) {
  solver::RunFilesSettings settings;
  settings.directory = directory;
  settings.program = fmt::format("gapcheck {}", version());
  settings.binout = options.binout;
  auto files = solver::RunFiles::create(run, surfaces, std::move(settings));
  if (!files) return error_from(files.error(), run.model(), diagnostics);
  run.drop_contact_summaries();
  solver::RunFiles& written = files.value();
  Watch watch(written, options, stop);
  RunSummary summary;
  summary.end = end_of(run.go(watch));
  if (const solver::SolverStatus& status = run.status(); !status.ok()) {
    if (status.error().kind == solver::Failure::Kind::output)
      return error_from(status.error(), run.model(), diagnostics);
    summary.failure = status.error().message;
  }
  summary.state = state_of(run);
  const solver::StateBalance balance = state_balance(run);
  summary.state_energy_ratio = balance.ratio;
  for (const solver::HeldEnergy& held : balance.held)
    summary.energies.push_back({name(held), held.work, held.state, held.covered});
  summary.files = written.names();
  summary.plotted_states = written.plotted_states();
  summary.diagnostics = listed(diagnostics);
  return summary;
}

std::string run_fault(const RunOptions& options) {
  OptionCheck check;
  check.amount("until", options.until);
  return check.message();
}

/// Files in the directory that must not be replaced.
std::string directory_fault(const std::string& directory, const keyword::Deck& deck, const RunOptions& options) {
  for (const std::string& file : results::result_files(directory))
    for (const keyword::SourceFile& source : deck.files())
      if (std::error_code failed; std::filesystem::equivalent(file, source.path, failed))
        return file + " is a file of the deck; give another directory";
  const auto foreign = results::foreign_results(directory);
  if (options.replace_foreign || foreign.empty()) return "";
  return foreign.front() + " is not a result of gapcheck; give another directory, or replace_foreign";
}

}  // namespace

Result<RunSummary> run_deck(const std::string& deck, const std::string& directory, const RunOptions& options) {
  if (std::string fault = run_fault(options); !fault.empty()) return plain_error(std::move(fault));
  const Jobs jobs(options.jobs);
  gapcheck::Diagnostics diagnostics;
  auto read = keyword::read_deck(deck, read_options(options.includes), diagnostics);
  if (!read) return error_of(read.error(), diagnostics);
  if (std::string fault = directory_fault(directory, read.value(), options); !fault.empty())
    return plain_error(std::move(fault));
  const auto model = model::read_model(read.value(), diagnostics);
  if (!model) return error_of(model.error(), diagnostics);
  keyword::note_missing_end(read.value(), diagnostics);
  read.value().drop_text([](std::string_view) { return true; });
  add_output_notes(read.value(), model.value(), diagnostics);
  add_unsupported(solver::unsupported(read.value(), model.value()), options.ignore_unsupported, diagnostics);
  if (diagnostics.has_errors()) return first_error(diagnostics);
  bool stop = false;
  solver::RunSettings settings;
  if (options.printed_stiffness) settings.springs = solver::SpringFormula::printed;
  settings.until = options.until;
  settings.cycles = options.cycles;
  settings.stop = [&stop] { return stop; };
  contact::SurfaceStore surfaces(model.value());
  auto run = solver::Run::prepare(model.value(), surfaces, settings, diagnostics);
  if (!run) return error_from(run.error(), model.value(), diagnostics);
  return calculated(run.value(), surfaces, directory, options, stop, diagnostics);
}

}  // namespace gapcheck::api
