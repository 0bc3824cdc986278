// What is installed shows only itself and the standard library; the manual's page shows an example as it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <gapcheck/gapcheck.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "api/new_folder.hpp"

namespace gapcheck::api_test::public_headers_test {
namespace {

namespace fs = std::filesystem;

const fs::path headers = fs::path(GAPCHECK_ROOT) / "lib/api/gapcheck";

std::vector<fs::path> public_headers() {
  std::vector<fs::path> list;
  for (const auto& entry : fs::recursive_directory_iterator(headers))
    if (entry.is_regular_file()) list.push_back(entry.path());
  std::sort(list.begin(), list.end());
  return list;
}

/// The names in <> or "" of all #include lines.
std::set<std::string> includes_of(const fs::path& path) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"][^>"]+[>"]).*)");
  std::set<std::string> names;
  std::istringstream text(content(path));
  std::smatch match;
  for (std::string line; std::getline(text, line);)
    if (std::regex_match(line, match, pattern)) names.insert(match[1]);
  return names;
}

TEST(PublicHeaders, IncludeOnlyThemselvesAndTheStandard) {
  // Names of the standard library have no dot and no slash.
  const std::regex standard("<[a-z_]+>"), own("<gapcheck/([a-z_]+\\.hpp)>");
  EXPECT_GT(public_headers().size(), 8u);
  for (const fs::path& path : public_headers())
    for (const std::string& name : includes_of(path)) {
      std::smatch match;
      if (std::regex_match(name, match, own))
        EXPECT_TRUE(fs::exists(headers / match[1].str())) << path << ": " << name;
      else
        EXPECT_TRUE(std::regex_match(name, standard)) << path << ": " << name;
    }
}

TEST(PublicHeaders, NameNoOtherLibrary) {
  for (const fs::path& path : public_headers()) {
    const std::string text = content(path);
    EXPECT_EQ(path.extension(), ".hpp");
    for (const char* word : {"Eigen::", "tbb::", "fmt::", "CGAL::", "nlohmann::", "GAPCHECK_"})
      EXPECT_EQ(text.find(word), std::string::npos) << path << ": " << word;
  }
}

TEST(PublicHeaders, TheOneForAllIncludesAll) {
  const std::set<std::string> all = includes_of(headers / "gapcheck.hpp");
  for (const fs::path& path : public_headers())
    if (path.filename() != "gapcheck.hpp") {
      EXPECT_TRUE(all.contains("<gapcheck/" + path.filename().string() + ">")) << path;
    }
}

TEST(PublicHeaders, ThePageShowsTheExampleAsItIs) {
  const std::string page = content(fs::path(GAPCHECK_ROOT) / "docs/api.md");
  EXPECT_NE(page.find("```cpp\n" + content(fs::path(GAPCHECK_ROOT) / "examples/audit_deck.cpp") + "```\n"),
            std::string::npos);
  for (const fs::path& path : public_headers())
    EXPECT_NE(page.find("`gapcheck/" + path.filename().string() + "`"), std::string::npos) << path;
}

}  // namespace
}  // namespace gapcheck::api_test::public_headers_test
