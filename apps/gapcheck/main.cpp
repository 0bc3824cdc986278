#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "command_line.hpp"
#include "output.hpp"

namespace gapcheck::app {
namespace {

int run(int argc, char** argv) {
  CLI::App app;
  Action action;
  add_commands(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
      return app.exit(error) == 0 ? clean : failed;
    print(plain_error(std::string(error.what()) + "; see gapcheck --help"));
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
