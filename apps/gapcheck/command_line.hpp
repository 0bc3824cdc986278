#pragma once
#include <CLI/App.hpp>

#include "commands.hpp"

namespace gapcheck::app {

/// Gives `app` all commands with their options; the one that is chosen sets `action`. Both must outlive the parsing.
void add_commands(CLI::App& app, Action& action);

}  // namespace gapcheck::app
