#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "base/system/memory.hpp"
#include "command_line.hpp"
#include "common/signals.hpp"
#include "output.hpp"

namespace gapcheck::app {
namespace {

/// What --help and --version ask for.
int show_text_of(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream text;
  app.exit(error, text, text);
  Output output("");
  output.write(text.str());
  const Status shown = output.close();
  if (!shown.ok()) print(shown.error());
  return shown.ok() ? clean : failed;
}

/// The words of the command line, the last first. CLI11 takes "[a,b]" for a list; here it is the name of a file.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  std::reverse(words.begin(), words.end());
  for (std::string& word : words)
    if (word.starts_with('[') && word.ends_with(']')) word.insert(0, "./");
  return words;
}

int run(int argc, char** argv) {
  CLI::App app;
  Action action;
  add_commands(app, action);
  try {
    app.parse(words_of(argc, argv));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return show_text_of(app, error);
    print(plain_error(what_is_wrong(app, error)));
    return failed;
  }
  // The editor's server lives for hours and gives back what it does not need.
  if (!app.got_subcommand("lsp")) system::keep_freed_memory();
  return action ? action() : failed;
}

}  // namespace
}  // namespace gapcheck::app

int main(int argc, char** argv) {
  // Nothing here may allocate any more.
  try {
    gapcheck::app::prepare_process();
    return gapcheck::app::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("gapcheck: error: not enough memory\n", stderr);
  } catch (const std::exception& error) {
    const bool no_thread = std::strstr(error.what(), "pthread_create") != nullptr;
    std::fprintf(stderr, "gapcheck: error: %s%s\n", error.what(), no_thread ? "; with --jobs 1 none is needed" : "");
  }
  return gapcheck::app::failed;
}
