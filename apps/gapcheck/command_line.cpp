#include "command_line.hpp"

#include "common/version.hpp"

namespace gapcheck::app {

void add_commands(CLI::App& app, Action& action) {
  app.name("gapcheck");
  app.description(
      "Finds the contact problems of LS-DYNA keyword decks, before the first run and in its message files.");
  app.set_version_flag("--version", version_line("gapcheck"));
  app.require_subcommand(1);
  add_audit(app, action);
  add_messag(app, action);
  add_compare(app, action);
  add_run(app, action);
  add_fix(app, action);
  add_rules(app, action);
  add_explain(app, action);
  app.footer(
      "Exit codes: 0 nothing at or above --fail-on, 1 findings or differences, 2 the tool could not do its job.");
}

}  // namespace gapcheck::app
