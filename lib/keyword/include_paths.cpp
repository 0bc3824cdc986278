#include "keyword/include_paths.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/number.hpp"
#include "keyword/upper_case.hpp"

namespace gapcheck::keyword {
namespace {

bool is_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

bool has_drive(std::string_view name) {
  const char letter = name.empty() ? '\0' : static_cast<char>(name.front() | 0x20);
  return name.size() > 1 && name[1] == ':' && letter >= 'a' && letter <= 'z';
}

/// How many parts of a name of another machine may be folders of this one.
constexpr std::size_t most_parts = 3;

/// The last parts of a name, last first; at most `most_parts`.
std::vector<std::string> last_parts(std::string_view name) {
  if (has_drive(name)) name.remove_prefix(2);
  std::vector<std::string> parts;
  while (!name.empty() && parts.size() < most_parts) {
    const std::size_t slash = name.find_last_of("/\\");
    const std::string_view part = slash == std::string_view::npos ? name : name.substr(slash + 1);
    if (part == "..") break;
    if (!part.empty() && part != ".") parts.emplace_back(part);
    name = slash == std::string_view::npos ? std::string_view{} : name.substr(0, slash);
  }
  return parts;
}

/// One spelling of all names that mean the same file on a machine that does not tell letters by case.
std::string one_spelling(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '\\', '/');
  return upper_case(text);
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

bool may_be_of_another_machine(const std::string& name) {
  return name.starts_with('/') || name.find('\\') != std::string::npos || has_drive(name);
}

std::optional<FoundInclude> IncludePaths::find(const std::string& name, const std::string& main_file,
                                               const std::string& including_file,
                                               const std::function<bool(const std::string&)>& open) {
  std::string slashes = name;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  for (const std::string& written : std::set<std::string>{name, slashes}) {
    const std::filesystem::path file(written);
    if (file.is_absolute()) {
      if (is_file(file)) return FoundInclude{file.string(), false, {}};
      continue;
    }
    std::vector<std::filesystem::path> directories{
        {}, std::filesystem::path(main_file).parent_path(), std::filesystem::path(including_file).parent_path()};
    directories.insert(directories.end(), paths_.begin(), paths_.end());
    directories.insert(directories.end(), further_.begin(), further_.end());
    for (const auto& directory : directories)
      if (const auto candidate = directory / file; is_file(candidate))
        return FoundInclude{candidate.string(), false, {}};
  }
  if (!may_be_of_another_machine(name)) return std::nullopt;
  auto found = find_by_end(name, main_file, including_file, open);
  std::error_code error;
  if (found) taken_.emplace(std::filesystem::canonical(found->path, error).string(), one_spelling(name));
  return found;
}

std::optional<FoundInclude> IncludePaths::find_by_end(const std::string& name, const std::string& main_file,
                                                      const std::string& including_file,
                                                      const std::function<bool(const std::string&)>& open) const {
  std::vector<std::filesystem::path> directories{std::filesystem::path(including_file).parent_path(),
                                                 std::filesystem::path(main_file).parent_path()};
  directories.insert(directories.end(), paths_.begin(), paths_.end());
  directories.insert(directories.end(), further_.begin(), further_.end());
  const std::vector<std::string> parts = last_parts(name);
  const std::string spelling = one_spelling(name);
  std::optional<FoundInclude> found;
  std::string first;
  for (std::size_t count = parts.size(); count > 0; --count) {
    std::filesystem::path end;
    for (std::size_t i = count; i > 0; --i) end /= parts[i - 1];
    for (const auto& directory : directories) {
      const auto candidate = directory / end;
      if (!is_file(candidate)) continue;
      std::error_code error;
      const std::string canonical = std::filesystem::canonical(candidate, error).string();
      if (const auto taken = taken_.find(canonical); taken != taken_.end() && taken->second != spelling) continue;
      if (open(canonical)) continue;
      if (!found) {
        found = FoundInclude{candidate.string(), true, {}};
        first = canonical;
      } else if (canonical != first) {
        found->other = candidate.string();
        break;
      }
    }
    if (found) break;  // what fits a longer end is the better answer
  }
  return found;
}

}  // namespace gapcheck::keyword
