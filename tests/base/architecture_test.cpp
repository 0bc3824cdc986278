// The house rules that a machine can check: who may include whom, where CGAL may be seen, that the library never
// prints or exits, how files are named and how long they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace gapcheck::architecture_test {
namespace {

namespace fs = std::filesystem;

/// Rooms in the order of their dependencies; audit and solver stand side by side.
const std::map<std::string, int> rank{{"base", 0},    {"records", 1}, {"keyword", 2}, {"model", 3},  {"geometry", 4},
                                      {"contact", 5}, {"results", 6}, {"audit", 7},   {"solver", 7}, {"report", 8}};

/// A source file: its path below lib/, the room it is in, its lines without comments and texts.
struct Source {
  std::string path, room;
  std::vector<std::string> lines;
};

/// Blanks comments and the inside of string and character literals; line breaks stay. Raw strings are treated as
/// ordinary ones, which is good enough for the code at hand.
std::string code_only(const std::string& text) {
  enum class In { code, line_comment, block_comment, literal } state = In::code;
  std::string result = text;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : '\0';
    const bool digit_separator = c == '\'' && i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0;
    if (c == '\n') {
      if (state != In::block_comment) state = In::code;
      continue;
    }
    switch (state) {
      case In::code:
        if (c == '/' && next == '/') state = In::line_comment;
        if (c == '/' && next == '*') state = In::block_comment;
        if ((c == '"' || c == '\'') && !digit_separator) {
          state = In::literal;
          quote = c;
        }
        if (state == In::line_comment || state == In::block_comment) result[i] = ' ';
        break;
      case In::line_comment:
        result[i] = ' ';
        break;
      case In::block_comment:
        result[i] = ' ';
        if (c == '*' && next == '/') {
          result[++i] = ' ';
          state = In::code;
        }
        break;
      case In::literal:
        if (c == quote) {
          state = In::code;
        } else {
          result[i] = ' ';
          if (c == '\\' && next != '\n' && next != '\0') result[++i] = ' ';
        }
        break;
    }
  }
  return result;
}

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool is_code(const fs::path& path) { return path.extension() == ".hpp" || path.extension() == ".cpp"; }

std::vector<Source> library_sources() {
  std::vector<Source> sources;
  const fs::path lib = fs::path(GAPCHECK_ROOT) / "lib";
  for (const auto& entry : fs::recursive_directory_iterator(lib)) {
    if (!entry.is_regular_file() || !is_code(entry.path())) continue;
    const fs::path below = fs::relative(entry.path(), lib);
    sources.push_back({below.generic_string(), below.begin()->string(), split_lines(read(entry.path()))});
  }
  std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
  return sources;
}

std::vector<std::string> without_comments(const Source& source) {
  std::string text;
  for (const std::string& line : source.lines) text += line + '\n';
  return split_lines(code_only(text));
}

/// The name that an #include line includes; empty for other lines.
std::string included(const std::string& line) {
  static const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"].*)");
  std::smatch match;
  return std::regex_match(line, match, pattern) ? match[1].str() : "";
}

TEST(Architecture, CodeOnlyDropsCommentsAndTexts) {
  EXPECT_EQ(code_only("a // exit(\nb /* exit(\n */ c"), "a         \nb         \n    c");
  EXPECT_EQ(code_only(R"(f("exit(\"", 'x', 1'000);)"), R"(f("       ", ' ', 1'000);)");
}

TEST(Architecture, ThereIsALibrary) { EXPECT_GT(library_sources().size(), 20u); }

TEST(Architecture, RoomsIncludeOnlyRoomsToTheirLeft) {
  for (const Source& source : library_sources()) {
    ASSERT_TRUE(rank.contains(source.room)) << "unknown room " << source.room;
    for (const std::string& line : source.lines) {
      const std::string name = included(line);
      const std::string room = name.substr(0, name.find('/'));
      if (name.find('/') == std::string::npos || !rank.contains(room) || line.find('"') == std::string::npos) continue;
      EXPECT_TRUE(room == source.room || rank.at(room) < rank.at(source.room)) << source.path << ": " << line;
    }
  }
}

TEST(Architecture, OwnHeadersAreNamedWithTheirRoom) {
  for (const Source& source : library_sources())
    for (const std::string& line : source.lines)
      if (!included(line).empty() && line.find('"') != std::string::npos) {
        EXPECT_TRUE(rank.contains(included(line).substr(0, included(line).find('/')))) << source.path << ": " << line;
      }
}

TEST(Architecture, OnlyGeometrySeesCgal) {
  for (const Source& source : library_sources())
    for (const std::string& line : source.lines)
      if (included(line).starts_with("CGAL/")) {
        EXPECT_EQ(source.room, "geometry") << source.path << ": " << line;
        EXPECT_TRUE(source.path.ends_with(".cpp")) << "CGAL in a header reaches other rooms: " << source.path;
      }
}

TEST(Architecture, TheLibraryNeverPrintsAndNeverExits) {
  const std::regex forbidden(
      R"(std::(cout|cerr|clog)\b|\b(printf|fprintf|puts|fputs|putchar|exit|_exit|quick_exit)\s*\(|fmt::print\b)");
  for (const Source& source : library_sources()) {
    const auto lines = without_comments(source);
    for (std::size_t i = 0; i < lines.size(); ++i)
      EXPECT_FALSE(std::regex_search(lines[i], forbidden)) << source.path << ":" << i + 1 << ": " << lines[i];
  }
}

TEST(Architecture, NoThrowInTheLibrary) {
  const std::regex forbidden(R"(\bthrow\b)");
  for (const Source& source : library_sources())
    for (const std::string& line : without_comments(source))
      EXPECT_FALSE(std::regex_search(line, forbidden)) << source.path << ": " << line;
}

TEST(Architecture, FilesAreNamedInLowerCaseAndHeadersGuarded) {
  const std::regex name(R"([a-z][a-z0-9_]*\.(hpp|cpp))");
  for (const Source& source : library_sources()) {
    EXPECT_TRUE(std::regex_match(fs::path(source.path).filename().string(), name)) << source.path;
    if (source.path.ends_with(".hpp")) {
      EXPECT_TRUE(!source.lines.empty() && source.lines.front() == "#pragma once") << source.path;
    }
  }
}

TEST(Architecture, FilesStayShort) {
  constexpr std::size_t limit = 450;
  for (const Source& source : library_sources()) EXPECT_LE(source.lines.size(), limit) << source.path;
}

TEST(Architecture, EverySourceFileIsBuilt) {
  for (const Source& source : library_sources()) {
    if (!source.path.ends_with(".cpp")) continue;
    const fs::path path(source.path);
    const std::string list = read(fs::path(GAPCHECK_ROOT) / "lib" / source.room / "CMakeLists.txt");
    // Rules are listed without their ending.
    const bool rule = path.parent_path().filename() == "rules";
    const std::string entry = rule ? "\n  " + path.stem().string() : path.filename().string();
    EXPECT_NE(list.find(entry), std::string::npos) << source.path << " is in no CMakeLists.txt";
  }
}

TEST(Architecture, EveryRuleTestHasItsRule) {
  std::size_t tests = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(GAPCHECK_ROOT) / "tests" / "audit" / "rules")) {
    std::string name = entry.path().filename().string();
    if (!name.ends_with("_test.cpp")) continue;
    ++tests;
    name.resize(name.size() - std::string("_test.cpp").size());
    EXPECT_TRUE(fs::exists(fs::path(GAPCHECK_ROOT) / "lib" / "audit" / "rules" / (name + ".cpp"))) << name;
  }
  EXPECT_GT(tests, 0U);
}

TEST(Architecture, TestsAreNamedAfterWhatTheyTest) {
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(GAPCHECK_ROOT) / "tests")) {
    if (!entry.path().filename().string().ends_with("_test.cpp")) continue;
    if (entry.path().parent_path().filename() == "rules") continue;  // built from the list of rules, see below
    EXPECT_TRUE(fs::exists(entry.path().parent_path() / "CMakeLists.txt")) << entry.path();
    const std::string list = read(entry.path().parent_path() / "CMakeLists.txt");
    EXPECT_NE(list.find(entry.path().filename().string()), std::string::npos) << entry.path() << " is not built";
  }
}

}  // namespace
}  // namespace gapcheck::architecture_test
