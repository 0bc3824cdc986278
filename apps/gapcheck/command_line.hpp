#pragma once
#include <CLI/App.hpp>

#include "commands.hpp"

namespace gapcheck::app {

/// Adds all commands with their options to `app`; the chosen one sets `action`. Both must outlive the parsing.
void add_commands(CLI::App& app, Action& action);

}  // namespace gapcheck::app
