#include "keyword/include_paths.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/number.hpp"

namespace gapcheck::keyword {
namespace {

bool is_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

}  // namespace

std::optional<IncludeName> next_include_name(CardReader& reader, const Parameters& parameters) {
  while (!reader.at_end() && trimmed(reader.peek()).empty()) reader.skip();
  if (reader.at_end()) return std::nullopt;
  IncludeName include{{}, reader.peek_line()};
  for (bool continued = true; continued && !reader.at_end();) {
    auto part = trimmed(reader.peek());
    continued = part.ends_with(" +");
    if (continued) part = trimmed(part.substr(0, part.size() - 2));
    if (include.name.size() <= max_include_name) include.name += part.substr(0, max_include_name + 1);
    reader.skip();
  }
  if (include.name.starts_with('&')) {
    const Block& block = reader.block();
    const auto* value = parameters.find(include.name.substr(1), block.scope, block.order);
    if (const auto* text = value == nullptr ? nullptr : std::get_if<std::string>(value)) include.name = *text;
  }
  return include;
}

bool IncludePaths::add(const std::string& path) {
  if (std::find(paths_.begin(), paths_.end(), path) != paths_.end()) return true;
  if (paths_.size() == most) return false;
  paths_.push_back(path);
  return true;
}

std::optional<std::string> IncludePaths::find(const std::string& name, const std::string& main_file,
                                              const std::string& including_file) const {
  std::string slashes = name;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  for (const std::string& written : std::set<std::string>{name, slashes}) {
    const std::filesystem::path file(written);
    if (file.is_absolute()) {
      if (is_file(file)) return file.string();
      continue;
    }
    std::vector<std::filesystem::path> directories{
        {}, std::filesystem::path(main_file).parent_path(), std::filesystem::path(including_file).parent_path()};
    directories.insert(directories.end(), paths_.begin(), paths_.end());
    directories.insert(directories.end(), further_.begin(), further_.end());
    for (const auto& directory : directories)
      if (const auto candidate = directory / file; is_file(candidate)) return candidate.string();
  }
  return std::nullopt;
}

}  // namespace gapcheck::keyword
