// Writes the manual pages and the completions of both programs into a folder: gapcheck_manual FOLDER.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>

#include "base/file_writer.hpp"
#include "common/failures.hpp"
#include "common/version.hpp"
#include "completion.hpp"
#include "man_page.hpp"

namespace gapcheck::manual {
namespace {

void complain(const Diagnostic& error) {
  std::fprintf(stderr, "gapcheck_manual: %s: %s\n", error.file.c_str(), error.message.c_str());
}

int run(const std::string& folder) {
  app::Failures failures(complain);
  const auto write = [&](const std::string& path, const std::string& text) { failures.add(write_file(path, text)); };
  for (const ProgramText& program : {gapcheck_text(), check_c_text()}) {
    write(fmt::format("{}/{}.1", folder, program.name), man_page(program, app::version()));
    write(fmt::format("{}/{}.bash", folder, program.name), bash_completion(program));
    write(fmt::format("{}/_{}", folder, program.name), zsh_completion(program));
  }
  return failures.any() ? 2 : 0;
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
