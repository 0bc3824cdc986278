#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "folder_test.hpp"
#include "program_names.hpp"

namespace gapcheck {

struct Ended {
  int code = -1;
  std::string out, err;
};

inline std::string content(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// The folder of each test is also the working directory of the programs.
class Program : public FolderTest {
 protected:
  static inline const std::filesystem::path project = GAPCHECK_ROOT;
  static inline const std::filesystem::path fixtures = project / "tests/apps/fixtures";

  /// `command` as a shell takes it.
  [[nodiscard]] Ended shell(const std::string& command) const {
    const std::string whole = "cd '" + folder_.string() + "' && " + command + " 2>.stderr";
    Ended run;
    std::FILE* pipe = ::popen(whole.c_str(), "r");
    if (pipe == nullptr) return run;
    std::array<char, 4096> buffer{};
    for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
      run.out.append(buffer.data(), n);
    const int status = ::pclose(pipe);
    run.code = WIFEXITED(status) ? WEXITSTATUS(status) : -2;
    run.err = content(folder_ / ".stderr");
    return run;
  }
  [[nodiscard]] Ended gapcheck(const std::string& arguments) const { return shell(GAPCHECK_PROGRAM " " + arguments); }
  [[nodiscard]] Ended check_c(const std::string& arguments) const { return shell(CHECK_C_PROGRAM " " + arguments); }

  /// Expects that a page of docs/ shows, between marks of a name, calls and what they print. How many there are.
  [[nodiscard]] int examples_hold(const std::string& page_name, const std::string& name) const {
    const std::string page = content(project / "docs" / page_name),
                      begin = "<!-- " + name + ": begin -->\n```\n$ gapcheck ";
    int examples = 0;
    for (std::size_t from = page.find(begin); from != std::string::npos;
         from = page.find(begin, from + 1), ++examples) {
      const std::size_t line = page.find('\n', from + begin.size());
      const std::size_t end = page.find("```\n<!-- " + name + ": end -->", line);
      if (end == std::string::npos) return -1;
      const std::string call = page.substr(from + begin.size(), line - from - begin.size());
      EXPECT_EQ(gapcheck(call).out, page.substr(line + 1, end - line - 1)) << call;
    }
    return examples;
  }

  /// Copies the files of a fixture into the folder.
  void use(const std::string& fixture) const {
    std::filesystem::copy(fixtures / fixture, folder_, std::filesystem::copy_options::recursive);
  }
  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return name;
  }
};

/// Holds a text against tests/apps/golden/NAME.txt. With GAPCHECK_UPDATE_GOLDEN in the environment it is written there.
inline void expect_golden(const std::string& name, const std::string& text) {
  const std::filesystem::path path = std::filesystem::path(GAPCHECK_ROOT) / "tests/apps/golden" / (name + ".txt");
  if (std::getenv("GAPCHECK_UPDATE_GOLDEN") != nullptr) std::ofstream(path, std::ios::binary) << text;
  ASSERT_TRUE(std::filesystem::exists(path)) << path << " is missing";
  EXPECT_EQ(text, content(path)) << name;
}

}  // namespace gapcheck
