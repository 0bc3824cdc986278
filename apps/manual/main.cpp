// Writes the manual pages and the completions of both programs into a folder: gapcheck_manual FOLDER.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>

#include "common/files.hpp"
#include "common/version.hpp"
#include "completion.hpp"
#include "man_page.hpp"

namespace gapcheck::manual {
namespace {

bool write(const std::string& path, const std::string& text) {
  const auto error = app::write_file(path, text);
  if (error) std::fprintf(stderr, "gapcheck_manual: %s: %s\n", path.c_str(), error->message.c_str());
  return !error;
}

int run(const std::string& folder) {
  bool done = true;
  for (const ProgramText& program : {gapcheck_text(), check_c_text()}) {
    done = write(fmt::format("{}/{}.1", folder, program.name), man_page(program, app::version())) && done;
    done = write(fmt::format("{}/{}.bash", folder, program.name), bash_completion(program)) && done;
    done = write(fmt::format("{}/_{}", folder, program.name), zsh_completion(program)) && done;
  }
  return done ? 0 : 2;
}

}  // namespace
}  // namespace gapcheck::manual

int main(int argc, char** argv) {
  try {
    if (argc == 2) return gapcheck::manual::run(argv[1]);
    std::fputs("usage: gapcheck_manual FOLDER\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gapcheck_manual: %s\n", error.what());
  }
  return 2;
}
