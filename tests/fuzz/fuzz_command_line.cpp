// The lines of an input as arguments of gapcheck: they are accepted, or refused with a message.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "fuzz.hpp"

namespace gapcheck::fuzz::command_line_target {

GAPCHECK_FUZZ_TARGET(command_line) {
  std::vector<std::string> words;
  while (!input.empty() && words.size() < 30) {
    const Headed next = headed(input);
    words.insert(words.begin(), std::string(next.head));
    input = next.rest;
  }
  CLI::App app;
  app::Action action;
  app::add_commands(app, action);
  try {
    app.parse(std::move(words));
    require(action != nullptr);
  } catch (const CLI::ParseError& error) {
    require(error.get_exit_code() == 0 || std::string_view(error.what()).size() > 1);
  }
}

}  // namespace gapcheck::fuzz::command_line_target
