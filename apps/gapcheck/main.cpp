#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "commands.hpp"
#include "output.hpp"

namespace gapcheck::app {
namespace {

int run(int argc, char** argv) {
  CLI::App app("Finds the contact problems of LS-DYNA keyword decks, before the first run and in its message files.",
               "gapcheck");
  app.set_version_flag("--version", "gapcheck " GAPCHECK_VERSION);
  app.require_subcommand(1);
  Action action;
  add_audit(app, action);
  add_messag(app, action);
  add_compare(app, action);
  add_run(app, action);
  add_fix(app, action);
  add_rules(app, action);
  add_explain(app, action);
  app.footer(
      "Exit codes: 0 nothing at or above --fail-on, 1 findings or differences, 2 the tool could not do its job.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
      return app.exit(error) == 0 ? clean : failed;
    print_error(std::string(error.what()) + "; see gapcheck --help");
    return failed;
  }
  return action ? action() : failed;
}

}  // namespace
}  // namespace gapcheck::app

int main(int argc, char** argv) {
  // Nothing here may allocate any more.
  try {
    return gapcheck::app::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("gapcheck: error: not enough memory\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gapcheck: error: %s\n", error.what());
  }
  return gapcheck::app::failed;
}
