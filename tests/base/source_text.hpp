#pragma once
#include <filesystem>
#include <string>
#include <vector>

// The source files of the project as text, for tests of the house rules.
namespace gapcheck::architecture_test {

/// A source file of lib/: its path below lib/, its room and floor, its lines.
struct Source {
  std::string path;
  std::string room;
  std::string floor;  ///< folders between the room and the file, as in "rules/tie"; "top" for files of the room itself
  std::vector<std::string> lines;
};

/// All sources of lib/, sorted by path.
[[nodiscard]] std::vector<Source> library_sources();
/// Room and floor of a path below lib/; the lines are left empty.
[[nodiscard]] Source placed(const std::filesystem::path& below_lib);

/// The text with comments and the inside of literals blanked; line breaks stay.
[[nodiscard]] std::string code_only(const std::string& text);
[[nodiscard]] std::string code_only(const Source& source);

[[nodiscard]] std::string read(const std::filesystem::path& path);
[[nodiscard]] std::vector<std::string> split_lines(const std::string& text);

/// Letters, digits and underscores.
[[nodiscard]] bool in_name(char c);

/// .hpp and .cpp.
[[nodiscard]] bool is_code(const std::filesystem::path& path);

/// What an #include line includes; an empty name for other lines.
struct Include {
  std::string name;
  bool quoted = false;  ///< "name" rather than <name>
};
[[nodiscard]] Include included(const std::string& line);

}  // namespace gapcheck::architecture_test
