// The house rules that a machine can check: who may include whom, where CGAL and the operating system may be seen, that
// the library never prints or exits, how files are named and how long they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "class_lines.hpp"
#include "source_text.hpp"

namespace gapcheck::architecture_test {
namespace {

namespace fs = std::filesystem;

/// Rooms, or floors of a room, each with those directly below it. It may include these and whatever is below them.
using Order = std::map<std::string, std::vector<std::string>>;

const Order rooms{{"base", {}},
                  {"records", {"base"}},
                  {"keyword", {"records"}},
                  {"model", {"keyword"}},
                  {"geometry", {"model"}},
                  {"contact", {"geometry"}},
                  {"results", {"contact"}},
                  {"audit", {"results"}},
                  {"solver", {"results"}},
                  {"report", {"audit", "solver"}},
                  {"api", {"report"}}};

/// The floors of a room, as in docs/architecture.md; "top" are the files of the room itself.
const std::map<std::string, Order> floors{
    {"base",
     {{"system", {}},
      {"system/posix", {"system"}},
      {"system/windows", {"system"}},
      {"top", {"system/posix", "system/windows"}}}},
    {"keyword", {{"text", {}}, {"top", {"text"}}}},
    {"model",
     {{"entity", {}}, {"contact", {"entity"}}, {"top", {"contact"}}, {"read", {"top"}}, {"material", {"read"}}}},
    {"geometry", {{"top", {}}, {"batch", {"top"}}}},
    {"contact",
     {{"definition", {}},
      {"mesh", {"definition"}},
      {"search", {"mesh"}},
      {"surface", {"search"}},
      {"pair", {"surface"}},
      {"tie", {"pair"}},
      {"edge", {"tie"}},
      {"crossing", {"edge"}},
      {"stiffness", {"surface"}},
      {"top", {"crossing", "stiffness"}}}},
    {"results",
     {{"text", {}}, {"log", {"text"}}, {"d3plot", {"text"}}, {"history", {"text"}}, {"curves", {"d3plot", "history"}}}},
    {"audit",
     {{"mesh", {}},
      {"portability", {}},
      {"top", {"mesh", "portability"}},
      {"shared", {"top"}},
      {"untangle", {"shared"}},
      {"fix", {"untangle"}},
      {"repair", {"fix"}},
      {"rules/penetration", {"shared"}},
      {"rules/tie", {"shared"}},
      {"rules/thickness", {"shared"}},
      {"rules/definition", {"shared"}},
      {"rules/surface", {"shared"}},
      {"rules/mesh", {"shared"}},
      {"rules/ignore", {"shared"}},
      {"rules/run", {"shared"}}}},
    {"solver",
     {{"state", {}},
      {"material", {"state"}},
      {"quadrature", {"state"}},
      {"discrete", {"material"}},
      {"element/full", {"state"}},
      {"element", {"discrete", "quadrature", "element/full"}},
      {"thick", {"element"}},
      {"rigid", {"material"}},
      {"structure", {"thick", "rigid"}},

      {"airbag", {"state"}},
      {"condition", {"structure", "airbag"}},
      {"build/material", {"condition"}},
      {"build", {"build/material"}},
      {"interface", {"state"}},
      {"mortar", {"interface"}},
      {"contact", {"mortar"}},
      {"constraint", {"contact", "structure"}},
      {"tie", {"contact", "structure"}},
      {"interpolation", {"tie"}},
      {"top", {"build", "constraint", "interpolation"}},
      {"output", {"top"}},
      {"loss", {"top"}},
      {"start", {"loss"}},
      {"trial", {"output", "start"}}}},
    {"report",
     {{"archive", {}},
      {"write", {}},
      {"item", {"write"}},
      {"baseline", {"item"}},
      {"text", {"baseline"}},
      {"compare", {"text"}},
      {"format", {"text"}},
      {"export", {"item"}},
      {"html", {"baseline", "export"}}}},
};

/// Whether `upper` may include `lower`: it is the same or below.
bool may_include(const Order& order, const std::string& upper, const std::string& lower) {
  if (upper == lower) return true;
  const auto at = order.find(upper);
  return at != order.end() && std::any_of(at->second.begin(), at->second.end(),
                                          [&](const std::string& below) { return may_include(order, below, lower); });
}

/// Room and floor of what an #include line of `from` includes; no room if it is none of ours. The public headers stand
/// in lib/api/gapcheck and are included as <gapcheck/…>.
Source target(const std::string& line) {
  const Include include = included(line);
  if (include.name.starts_with("gapcheck/")) return placed(fs::path("api") / include.name);
  return include.quoted ? placed(include.name) : Source{};
}

bool is_public(const Source& source) { return source.path.starts_with("api/gapcheck/"); }

std::string without_ending(const fs::path& path, const std::string& ending) {
  std::string name = path.generic_string();
  name.resize(name.size() - ending.size());
  return name;
}

/// Paths of all files below a folder of the project, relative to it and sorted.
std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  const fs::path root = fs::path(GAPCHECK_ROOT) / folder;
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), root));
  std::sort(files.begin(), files.end());
  return files;
}

/// Whether a CMakeLists.txt names the entry as a word of its own.
bool lists(const std::string& list, const std::string& entry) {
  const auto ends_word = [](char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0 || c == '(' || c == ')';
  };
  for (std::size_t at = list.find(entry); at != std::string::npos; at = list.find(entry, at + 1)) {
    const std::size_t end = at + entry.size();
    if ((at == 0 || ends_word(list[at - 1])) && (end == list.size() || ends_word(list[end]))) return true;
  }
  return false;
}

TEST(Architecture, CodeOnlyDropsCommentsAndTexts) {
  EXPECT_EQ(code_only("a // exit(\nb /* exit(\n */ c"), "a         \nb         \n    c");
  EXPECT_EQ(code_only(R"(f("exit(\"", 'x', 1'000);)"), R"(f("       ", ' ', 1'000);)");
  EXPECT_EQ(code_only("f(R\"-(a\"{\n)-\", b)"), "f(R\"     \n  \", b)");
}

TEST(Architecture, ThereIsALibrary) { EXPECT_GT(library_sources().size(), 20u); }

TEST(Architecture, RoomsIncludeOnlyRoomsToTheirLeft) {
  for (const Source& source : library_sources()) {
    ASSERT_TRUE(rooms.contains(source.room)) << "unknown room " << source.room;
    for (const std::string& line : source.lines)
      if (const std::string room = target(line).room; rooms.contains(room)) {
        EXPECT_TRUE(may_include(rooms, source.room, room)) << source.path << ": " << line;
      }
  }
}

TEST(Architecture, FloorsIncludeOnlyFloorsBelow) {
  for (const Source& source : library_sources()) {
    const auto room = floors.find(source.room);
    if (room == floors.end()) {
      EXPECT_TRUE(source.floor == "top" || is_public(source)) << "a room without floors: " << source.path;
      continue;
    }
    ASSERT_TRUE(room->second.contains(source.floor)) << "unknown floor: " << source.path;
    for (const std::string& line : source.lines)
      if (const Source to = target(line); to.room == source.room) {
        EXPECT_TRUE(may_include(room->second, source.floor, to.floor)) << source.path << ": " << line;
      }
  }
}

TEST(Architecture, OrderIsTransitive) {
  EXPECT_TRUE(may_include(rooms, "report", "base"));
  EXPECT_TRUE(may_include(rooms, "audit", "audit"));
  EXPECT_FALSE(may_include(rooms, "audit", "solver"));
  EXPECT_FALSE(may_include(rooms, "contact", "audit"));
  EXPECT_FALSE(may_include(floors.at("contact"), "stiffness", "pair"));
  EXPECT_FALSE(may_include(floors.at("solver"), "contact", "structure"));
}

TEST(Architecture, EveryFloorHasFiles) {
  const std::vector<Source> sources = library_sources();
  for (const auto& [room, order] : floors)
    for (const auto& [floor, below] : order) {
      EXPECT_TRUE(std::any_of(sources.begin(), sources.end(),
                              [&room = room, &floor = floor](const Source& source) {
                                return source.room == room && source.floor == floor;
                              }))
          << room << "/" << floor;
      for (const std::string& each : below) EXPECT_TRUE(order.contains(each)) << room << "/" << each;
    }
}

TEST(Architecture, OwnHeadersAreNamedWithTheirRoom) {
  for (const Source& source : library_sources())
    for (const std::string& line : source.lines)
      if (included(line).quoted) {
        EXPECT_TRUE(rooms.contains(target(line).room)) << source.path << ": " << line;
      }
}

TEST(Architecture, PublicHeadersShowNothingElse) {
  for (const Source& source : library_sources()) {
    if (!is_public(source)) continue;
    EXPECT_TRUE(source.path.ends_with(".hpp")) << source.path;
    for (const std::string& line : source.lines) {
      const Include include = included(line);
      EXPECT_FALSE(include.quoted) << source.path << ": " << line;
      EXPECT_TRUE(include.name.find('/') == std::string::npos || include.name.starts_with("gapcheck/"))
          << source.path << ": " << line;
    }
  }
}

TEST(Architecture, OnlyGeometrySeesCgal) {
  for (const Source& source : library_sources())
    for (const std::string& line : source.lines)
      if (included(line).name.starts_with("CGAL/")) {
        EXPECT_EQ(source.room, "geometry") << source.path << ": " << line;
        EXPECT_TRUE(source.path.ends_with(".cpp")) << "CGAL in a header reaches other rooms: " << source.path;
      }
}

/// A quick look before a regular expression, which takes a hundred times as long.
bool has_any(const std::string& line, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return line.find(word) != std::string::npos; });
}

/// Headers of operating systems. <csignal> too, since signals differ most.
bool is_of_the_system(const std::string& header) {
  static const std::set<std::string> names{"csignal",  "dirent.h", "dlfcn.h",   "fcntl.h",  "io.h",
                                           "malloc.h", "poll.h",   "pthread.h", "pwd.h",    "sched.h",
                                           "signal.h", "spawn.h",  "termios.h", "unistd.h", "windows.h"};
  return names.contains(header) || header.starts_with("sys/");
}

TEST(Architecture, OnlyBaseSeesTheOperatingSystem) {
  const std::string own = "base/system/";
  const std::regex macro(R"(^\s*#.*\b(_WIN32|__MINGW32__|__linux__|__unix__|__APPLE__|__GLIBC__)\b)");
  const auto refers = [&](const std::string& line) {
    return has_any(line, {"_WIN32", "__MINGW", "__linux", "__unix", "__APPLE", "__GLIBC"}) &&
           std::regex_search(line, macro);
  };
  std::size_t own_includes = 0;
  for (const char* const top : {"lib", "apps"})
    for (const fs::path& path : files_below(top)) {
      if (!is_code(path)) continue;
      const bool is_own = path.generic_string().starts_with(own);
      for (const std::string& line : split_lines(read(fs::path(GAPCHECK_ROOT) / top / path))) {
        const bool includes = is_of_the_system(included(line).name);
        own_includes += is_own && includes ? 1 : 0;
        EXPECT_TRUE(is_own || (!includes && !refers(line))) << top << "/" << path << ": " << line;
      }
    }
  EXPECT_GT(own_includes, 10U);
}

TEST(Architecture, TheLibraryNeverPrintsAndNeverExits) {
  const std::regex forbidden(
      R"(std::(cout|cerr|clog)\b|\b(printf|fprintf|puts|fputs|putchar|exit|_exit|quick_exit)\s*\(|fmt::print\b)");
  for (const Source& source : library_sources()) {
    const auto lines = split_lines(code_only(source));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      EXPECT_FALSE(has_any(lines[i], {"cout", "cerr", "clog", "print", "put", "exit"}) &&
                   std::regex_search(lines[i], forbidden))
          << source.path << ":" << i + 1 << ": " << lines[i];
    }
  }
}

TEST(Architecture, NoThrowInTheLibrary) {
  const std::regex forbidden(R"(\bthrow\b)");
  for (const Source& source : library_sources())
    for (const std::string& line : split_lines(code_only(source)))
      EXPECT_FALSE(has_any(line, {"throw"}) && std::regex_search(line, forbidden)) << source.path << ": " << line;
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

TEST(Architecture, FloorsStaySmall) {
  constexpr std::size_t limit = 40;
  for (const char* const top : {"lib", "tests", "apps", "python"}) {
    std::map<std::string, std::size_t> files;
    for (const fs::path& path : files_below(top)) {
      const bool source = is_code(path) || path.extension() == ".py" || path.extension() == ".sh";
      if (source || path.filename() == "CMakeLists.txt") ++files[path.parent_path().generic_string()];
    }
    for (const auto& [folder, count] : files) EXPECT_LE(count, limit) << top << "/" << folder;
  }
}

TEST(Architecture, ClassesStayShort) {
  constexpr std::size_t limit = 300;
  for (const ClassLength& each : class_lengths(library_sources()))
    EXPECT_LE(each.lines, limit) << each.path << ": " << each.name;
}

TEST(Architecture, EverySourceFileIsBuilt) {
  for (const Source& source : library_sources()) {
    if (!source.path.ends_with(".cpp")) continue;
    const std::string list = read(fs::path(GAPCHECK_ROOT) / "lib" / source.room / "CMakeLists.txt");
    // Rules are listed by their name: GROUP/NAME.
    const bool rule = source.floor.starts_with("rules/");
    const fs::path below = fs::path(source.path).lexically_relative(source.room);
    const std::string entry = rule ? without_ending(below.lexically_relative("rules"), ".cpp") : below.generic_string();
    EXPECT_TRUE(lists(list, entry)) << source.path << " is in no CMakeLists.txt";
  }
}

TEST(Architecture, EveryRuleTestHasItsRule) {
  const std::string ending = "_test.cpp";
  std::size_t tests = 0;
  for (const fs::path& path : files_below("tests/audit/rules")) {
    if (!path.generic_string().ends_with(ending)) continue;
    ++tests;
    const std::string rule = without_ending(path, ending) + ".cpp";
    EXPECT_TRUE(fs::exists(fs::path(GAPCHECK_ROOT) / "lib" / "audit" / "rules" / rule)) << rule;
  }
  EXPECT_GT(tests, 0U);
}

/// The CMakeLists.txt nearest to the test, in its folder or above, is the one that builds it.
TEST(Architecture, EveryTestIsBuilt) {
  const fs::path tests = fs::path(GAPCHECK_ROOT) / "tests";
  for (const fs::path& path : files_below("tests")) {
    if (!path.generic_string().ends_with("_test.cpp")) continue;
    if (path.generic_string().starts_with("audit/rules/")) continue;  // built from the list of rules, see above
    fs::path folder = path.parent_path();
    while (!folder.empty() && !fs::exists(tests / folder / "CMakeLists.txt")) folder = folder.parent_path();
    ASSERT_FALSE(folder.empty()) << path << ": no CMakeLists.txt";
    const std::string entry = path.lexically_relative(folder).generic_string();
    EXPECT_TRUE(lists(read(tests / folder / "CMakeLists.txt"), entry)) << path << " is not built";
  }
}

/// The test of a unit is at the same path below tests as the unit is below lib.
TEST(Architecture, TestsAreWhereTheirUnitsAre) {
  const std::string ending = "_test.cpp";
  const std::vector<Source> sources = library_sources();
  std::size_t matched = 0;
  for (const fs::path& path : files_below("tests")) {
    if (!path.generic_string().ends_with(ending)) continue;
    const fs::path unit = without_ending(path, ending);
    bool same_name = false, same_place = false;
    for (const Source& source : sources) {
      if (source.room != path.begin()->string() || fs::path(source.path).stem() != unit.filename()) continue;
      same_name = true;
      same_place |= fs::path(source.path).replace_extension() == unit;
    }
    EXPECT_EQ(same_name, same_place) << path;
    matched += same_place ? 1 : 0;
  }
  EXPECT_GT(matched, 100U);
}

}  // namespace
}  // namespace gapcheck::architecture_test
