#pragma once
#include <CLI/App.hpp>
#include <CLI/Error.hpp>
#include <string>

#include "commands.hpp"

namespace gapcheck::app {

/// Adds all commands with their options to `app`; the chosen one sets `action`. Both must outlive the parsing.
void add_commands(CLI::App& app, Action& action);

/// What is wrong with a command line, and which command or option was probably meant.
[[nodiscard]] std::string what_is_wrong(const CLI::App& app, const CLI::ParseError& error);

}  // namespace gapcheck::app
