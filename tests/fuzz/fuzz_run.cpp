// Any bytes as a deck that the solver calculates for at most fifty cycles, with all files that a run writes.
#include <string>

#include "fuzz.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "solver/output/run_files.hpp"
#include "solver/output/state_balance.hpp"
#include "solver/run.hpp"
#include "solver/supported.hpp"

namespace gapcheck::fuzz::run_target {

GAPCHECK_FUZZ_TARGET(run) {
  static const Folder folder;
  Diagnostics diagnostics;
  keyword::ReadOptions options;
  options.max_include_depth = 0;
  const auto deck = keyword::read_deck_text(std::string(input), "fuzz.k", options, diagnostics);
  if (!deck) return;
  const auto model = model::read_model(deck.value(), diagnostics);
  // As `gapcheck run` does with --ignore-unsupported.
  if (!model || diagnostics.has_errors()) return;
  static_cast<void>(solver::unsupported(deck.value(), model.value()));
  solver::RunSettings settings;
  settings.cycles = 50;
  contact::SurfaceStore surfaces(model.value());
  auto run = solver::Run::prepare(model.value(), surfaces, settings, diagnostics);
  static_cast<void>(diagnostics.sorted());
  if (!run) {
    require(!run.error().message.empty());
    return;
  }
  solver::RunFilesSettings output;
  output.directory = folder.path();
  output.program = "fuzz";
  auto files = solver::RunFiles::create(run.value(), surfaces, output);
  if (!files) return;
  const solver::RunEnd end = run.value().go(files.value());
  require((end == solver::RunEnd::failed) == !run.value().status().ok());
  require(run.value().stepper().state().cycle <= settings.cycles);
  static_cast<void>(solver::state_balance(run.value()));
}

}  // namespace gapcheck::fuzz::run_target
