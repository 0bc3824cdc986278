#pragma once
#include <CLI/App.hpp>
#include <functional>

namespace gapcheck::app {

/// What every command returns.
enum Exit : int {
  clean = 0,     ///< nothing at or above --fail-on
  findings = 1,  ///< something was found
  failed = 2,    ///< the tool could not do its job
};

/// The action of the chosen command once all arguments are read; returns the exit code.
using Action = std::function<int()>;

// Each adds its subcommand, which sets `action` when chosen.
void add_audit(CLI::App& app, Action& action);
void add_merge(CLI::App& app, Action& action);
void add_messag(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_run(CLI::App& app, Action& action);
void add_start(CLI::App& app, Action& action);
void add_fix(CLI::App& app, Action& action);
void add_lsp(CLI::App& app, Action& action);
void add_rules(CLI::App& app, Action& action);
void add_explain(CLI::App& app, Action& action);

}  // namespace gapcheck::app
