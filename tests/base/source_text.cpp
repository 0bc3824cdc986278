#include "source_text.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <regex>
#include <sstream>

namespace gapcheck::architecture_test {

namespace fs = std::filesystem;

namespace {

/// Where a raw literal ends whose quotation mark is at `open`: behind its last quotation mark.
std::size_t raw_end(const std::string& text, std::size_t open) {
  const std::size_t bracket = text.find('(', open);
  if (bracket == std::string::npos) return text.size();
  const std::string close = ')' + text.substr(open + 1, bracket - open - 1) + '"';
  const std::size_t end = text.find(close, bracket);
  return end == std::string::npos ? text.size() : end + close.size();
}

void blank(std::string& text, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < std::min(end, text.size()); ++i)
    if (text[i] != '\n') text[i] = ' ';
}

}  // namespace

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string code_only(const std::string& text) {
  std::string result = text;
  const auto before = [&](std::size_t i) { return i > 0 ? text[i - 1] : '\0'; };
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    std::size_t end = i + 1;
    if (text.compare(i, 2, "//") == 0) {
      end = std::min(text.find('\n', i), text.size());
      blank(result, i, end);
    } else if (text.compare(i, 2, "/*") == 0) {
      const std::size_t close = text.find("*/", i + 2);
      end = close == std::string::npos ? text.size() : close + 2;
      blank(result, i, end);
    } else if (c == '"' && before(i) == 'R' && (i < 2 || !in_name(text[i - 2]))) {
      end = raw_end(text, i);
      blank(result, i + 1, end - 1);
    } else if (c == '"' || (c == '\'' && !in_name(before(i)))) {  // 1'000 is no character
      while (end < text.size() && text[end] != c && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
      blank(result, i + 1, end);
      ++end;
    }
    i = end;
  }
  return result;
}

std::string code_only(const Source& source) {
  std::string text;
  for (const std::string& line : source.lines) text += line + '\n';
  return code_only(text);
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

Source placed(const fs::path& below_lib) {
  const std::string folders = below_lib.parent_path().generic_string();
  const std::size_t slash = folders.find('/');
  return {below_lib.generic_string(),
          folders.substr(0, slash),
          slash == std::string::npos ? "top" : folders.substr(slash + 1),
          {}};
}

std::vector<Source> library_sources() {
  std::vector<Source> sources;
  const fs::path lib = fs::path(GAPCHECK_ROOT) / "lib";
  for (const auto& entry : fs::recursive_directory_iterator(lib)) {
    if (!entry.is_regular_file() || !is_code(entry.path())) continue;
    sources.push_back(placed(fs::relative(entry.path(), lib)));
    sources.back().lines = split_lines(read(entry.path()));
  }
  std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
  return sources;
}

Include included(const std::string& line) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::smatch match;
  if (!std::regex_match(line, match, pattern)) return {};
  return {match[2].str(), match[1].str() == "\""};
}

}  // namespace gapcheck::architecture_test
