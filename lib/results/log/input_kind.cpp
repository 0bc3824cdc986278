#include "results/log/input_kind.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "base/file_bytes.hpp"
#include "results/text/lines.hpp"

namespace gapcheck::results {
namespace {

namespace fs = std::filesystem;

bool deck_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".k" || extension == ".key" || extension == ".dyn";
}

/// mes0000, mes0001, …
bool rank_file(const std::string& name) {
  return name.size() >= 7 && name.starts_with("mes") &&
         std::all_of(name.begin() + 3, name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

Result<InputKind> files_of(const std::string& directory) {
  InputKind kind;
  kind.directory = true;
  std::error_code error;
  for (fs::directory_iterator entry(directory, error), end; !error && entry != end; entry.increment(error))
    if (rank_file(entry->path().filename().string())) kind.files.push_back(entry->path().string());
  std::sort(kind.files.begin(), kind.files.end());
  const auto exists = [&](const char* name) { return fs::is_regular_file(fs::path(directory) / name, error); };
  if (exists("messag"))
    kind.files = {(fs::path(directory) / "messag").string()};
  else if (kind.files.empty() && exists("d3hsp"))
    kind.files = {(fs::path(directory) / "d3hsp").string()};
  if (kind.files.empty())
    return Diagnostic{Severity::error, directory, 0, "the directory has no messag, mes0000 or d3hsp; name the file"};
  return kind;
}

}  // namespace

bool begins_as_deck(FileBytes& file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  for (Lines lines(file); !lines.done(); lines.advance()) {
    std::string_view line = lines.line();
    if (lines.number() == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
    if (line.find_first_not_of(" \t") == std::string_view::npos || line.front() == '$') continue;
    // Solver files indent lines that begin with a star.
    return line.size() > 1 && line[0] == '*' && std::isalpha(static_cast<unsigned char>(line[1])) != 0;
  }
  return false;
}

Result<InputKind> recognise(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return files_of(path);
  auto file = FileBytes::begin(path);
  if (!file) return file.error();
  InputKind kind;
  kind.deck = deck_extension(path) || begins_as_deck(file.value());
  if (!kind.deck) kind.files = {path};
  return kind;
}

Result<std::vector<std::string>> log_files(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code failed;
    if (!fs::is_directory(path, failed)) {
      files.push_back(path);
      continue;
    }
    const auto input = files_of(path);
    if (!input) return input.error();
    files.insert(files.end(), input.value().files.begin(), input.value().files.end());
  }
  return files;
}

}  // namespace gapcheck::results
