// Types of the library and of the tests' headers: a name is defined once. Test programs link both, and of two classes
// with one name the linker keeps the destructor and inline functions of either.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "source_text.hpp"

namespace gapcheck::architecture_test {
namespace {

namespace fs = std::filesystem;

/// Full names of the types that a file defines outside functions, classes and unnamed namespaces. Relies on the house's
/// format, where these and only these begin a line.
std::vector<std::string> defined_types(const std::string& text) {
  static const std::regex opening(R"(^(inline )?namespace ([\w:]*) ?\{)"), closing(R"(^\}.*// namespace)"),
      type(R"(^(struct|class|enum class) (?:alignas\(\d+\) )?(\w+)( final)?( *: [^;]*)?( *\{.*)?$)");
  std::vector<std::string> names, spaces;
  for (const std::string& line : split_lines(text)) {
    if (line.empty() || line[0] == ' ' || line[0] == '#') continue;  // most lines, and the expressions are slow
    std::smatch match;
    if (std::regex_search(line, match, opening)) {
      spaces.push_back(match[2]);
    } else if (std::regex_search(line, closing) && !spaces.empty()) {
      spaces.pop_back();
    } else if (line.find('{') != std::string::npos && std::regex_search(line, match, type)) {
      std::string full;
      bool unnamed = false;
      for (const std::string& space : spaces) full += space + "::", unnamed |= space.empty();
      if (!unnamed) names.push_back(full + match[2].str());
    }
  }
  return names;
}

TEST(OneDefinition, TypesOfAText) {
  const std::string text =
      "namespace a::b {\n"
      "namespace {\nstruct Hidden {\n};\n}  // namespace\n"
      "struct Declared;\n"
      "class Seen : public Base {\n  struct Inner {};\n};\n"
      "enum class Kind : int { one };\n"
      "}  // namespace a::b\n";
  EXPECT_EQ(defined_types(text), (std::vector<std::string>{"a::b::Seen", "a::b::Kind"}));
}

TEST(OneDefinition, OfEveryType) {
  std::map<std::string, std::set<std::string>> places;
  std::size_t found = 0;
  for (const char* const top : {"lib", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(GAPCHECK_ROOT) / top)) {
      // What differs between operating systems is compiled for one of them.
      const std::string path = entry.path().generic_string();
      if (!is_code(entry.path()) || path.find("/base/system/windows/") != std::string::npos) continue;
      // Test programs are many; what two of them define in their own files never meets.
      if (std::string(top) == "tests" && entry.path().extension() != ".hpp") continue;
      for (const std::string& name : defined_types(read(entry.path()))) places[name].insert(path), ++found;
    }
  EXPECT_GT(found, 1000U);
  for (const auto& [name, files] : places)
    EXPECT_EQ(files.size(), 1U) << name << " is defined in " << *files.begin() << " and " << *files.rbegin();
}

}  // namespace
}  // namespace gapcheck::architecture_test
