#include "command_line.hpp"

#include <CLI/Option.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/nearest_name.hpp"
#include "common/version.hpp"

namespace gapcheck::app {
namespace {

std::string_view nearest_command(const CLI::App& app, std::string_view written) {
  std::vector<std::string_view> names;
  for (const CLI::App* command : app.get_subcommands({})) names.emplace_back(command->get_name());
  return nearest_name(written, names);
}

/// With the two hyphens.
std::string nearest_option(const CLI::App& command, std::string_view written) {
  std::vector<std::string_view> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.emplace_back(name);
  const std::string_view nearest = nearest_name(written.substr(0, written.find('=')), names);
  return nearest.empty() ? "" : "--" + std::string(nearest);
}

}  // namespace

std::string what_is_wrong(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> unknown = app.remaining(true);
  const std::vector<CLI::App*> called = app.get_subcommands();
  std::string text = error.what(), meant;
  if (called.empty() && !unknown.empty() && !unknown.front().starts_with('-')) {
    text = "there is no command '" + unknown.front() + "'";
    meant = nearest_command(app, unknown.front());
  }
  for (const std::string& word : unknown)
    if (meant.empty() && word.starts_with("--"))
      meant = nearest_option(called.empty() ? app : *called.front(), std::string_view(word).substr(2));
  return text + did_you_mean(meant) + (meant.empty() ? "; see gapcheck" : " See gapcheck") +
         (called.empty() ? "" : " " + called.front()->get_name()) + " --help";
}

void add_commands(CLI::App& app, Action& action) {
  app.name("gapcheck");
  app.description(
      "Finds the contact problems of LS-DYNA keyword decks, before the first run and in its message files.");
  app.set_version_flag("--version", version_line("gapcheck"));
  app.require_subcommand(1);
  add_audit(app, action);
  add_merge(app, action);
  add_messag(app, action);
  add_compare(app, action);
  add_run(app, action);
  add_start(app, action);
  add_fix(app, action);
  add_lsp(app, action);
  add_rules(app, action);
  add_explain(app, action);
  app.footer(
      "Exit codes: 0 nothing at or above --fail-on, 1 findings or differences, 2 the tool could not do its job.");
}

}  // namespace gapcheck::app
