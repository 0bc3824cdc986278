#include "deck_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#include "base/path_pattern.hpp"
#include "keyword/include_paths.hpp"
#include "report/item/describe.hpp"

namespace gapcheck::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_decks = 10'000, max_entries = 10'000'000;

bool is_pattern(const std::string& path) { return path.find_first_of("*?") != std::string::npos; }

/// The folder before the first part with a wildcard: where the search begins.
fs::path fixed_part(const fs::path& pattern) {
  fs::path fixed;
  for (const fs::path& part : pattern.parent_path()) {
    if (is_pattern(part.string())) break;
    fixed /= part;
  }
  return fixed;
}

bool hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

/// Files that a pattern finds, sorted.
std::vector<std::string> find_files(const std::string& argument, Diagnostics& diagnostics) {
  const std::string pattern = fs::path(argument).lexically_normal().generic_string();
  const fs::path start = fixed_part(pattern);
  std::vector<std::string> found;
  std::error_code error;
  const auto options = fs::directory_options::skip_permission_denied;
  if (!start.empty() && !fs::is_directory(start, error)) return found;
  fs::recursive_directory_iterator at(start.empty() ? fs::path(".") : start, options, error);
  const fs::path whole(pattern);
  const std::ptrdiff_t parts = std::distance(whole.begin(), whole.end());
  const std::ptrdiff_t fixed = std::distance(start.begin(), start.end());
  const bool any_depth = pattern.find("**") != std::string::npos;
  for (std::size_t entries = 0; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    if (++entries > max_entries || found.size() > max_decks) {
      diagnostics.error(argument, 0, fmt::format("finds more than {} files; name the decks more closely", max_decks));
      return {};
    }
    std::error_code unknown;
    const fs::path path = start.empty() ? at->path().lexically_normal() : at->path();
    if (at->is_directory(unknown)) {
      if (hidden(path) || (!any_depth && fixed + at.depth() + 2 > parts)) at.disable_recursion_pending();
    } else if (at->is_regular_file(unknown) && matches(pattern, path.generic_string())) {
      found.push_back(path.string());
    }
  }
  if (error) diagnostics.error(start.string(), 0, fmt::format("cannot be searched for decks: {}", error.message()));
  std::sort(found.begin(), found.end());
  return found;
}

/// Also of a file that is gone.
std::string canonical(const std::string& path) {
  std::error_code error;
  const std::string name = fs::weakly_canonical(fs::absolute(path, error), error).string();
  return name.empty() ? path : name;
}

/// A candidate deck, and whether it was named.
struct Candidate {
  std::string path, canonical;
  bool named = false;
};

std::vector<Candidate> candidates(const std::vector<std::string>& arguments, Diagnostics& diagnostics) {
  std::vector<Candidate> list;
  std::set<std::string> known;
  const auto add = [&](const std::string& path, bool named) {
    Candidate candidate{path, canonical(path), named};
    if (known.insert(candidate.canonical).second) list.push_back(std::move(candidate));
  };
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (!is_pattern(argument) || fs::exists(argument, error)) {
      add(argument, true);
      continue;
    }
    const auto found = find_files(argument, diagnostics);
    if (found.empty() && !diagnostics.has_errors())
      diagnostics.error(argument, 0, "no file is named like this; correct the pattern");
    for (const std::string& path : found) add(path, false);
  }
  return list;
}

/// The other files that a deck includes, directly or indirectly, by canonical path.
std::set<std::string> includes_of(const Candidate& candidate, DeckFiles& files) {
  std::set<std::string> others;
  for (const std::string& file : files.includes(candidate.path)) others.insert(canonical(file));
  others.erase(candidate.canonical);
  return others;
}

/// Whether the name of an include that is missing may mean a path: which folder it was in is not known any more.
bool may_mean(std::string name, const std::string& path) {
  const bool other_machine = keyword::may_be_of_another_machine(name);
  std::replace(name.begin(), name.end(), '\\', '/');
  if (other_machine) name = fs::path(name).filename().string();
  fs::path end;
  for (const fs::path& part : fs::path(name).lexically_normal().relative_path())
    if (part != "..") end /= part;
  return !end.empty() && ("/" + path).ends_with("/" + end.string());
}

/// Chooses the decks so that each candidate is one or is included by one.
class Choice {
 public:
  Choice(const std::vector<Candidate>& all, DeckFiles& files) : all_(all) {
    for (const Candidate& candidate : all) {
      includes_.push_back(includes_of(candidate, files));
      missing_.push_back(files.missing(candidate.path));
    }
    for (std::size_t i = 0; i < all.size(); ++i)
      for (const std::string& file : includes_[i]) includers_[file].push_back(i);
  }

  /// Per candidate: it is a deck of its own.
  std::vector<bool> decks() {
    std::vector<bool> stays(all_.size(), false);
    const auto keep = [&](std::size_t i) {
      stays[i] = true;
      covered_.insert(includes_[i].begin(), includes_[i].end());
    };
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (all_[i].named) keep(i);
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (!stays[i] && !covered_.contains(all_[i].canonical) && leads(i)) keep(i);
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (!stays[i] && !covered_.contains(all_[i].canonical)) keep(i);
    return stays;
  }

  /// True if the file, given by its canonical path, is the candidate, or is included by it even if it is gone.
  [[nodiscard]] bool has(std::size_t i, const std::string& path) const {
    return path == all_[i].canonical || includes_[i].contains(path) ||
           std::ranges::any_of(missing_[i], [&](const std::string& name) { return may_mean(name, path); });
  }
  /// True if that holds for any candidate.
  [[nodiscard]] bool any_has(const std::string& path) const {
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (has(i, path)) return true;
    return false;
  }

 private:
  /// Only files that it includes itself include this file: of files that include one another in a circle the first is
  /// enough, and reading it reports the fault.
  [[nodiscard]] bool leads(std::size_t i) const {
    const auto found = includers_.find(all_[i].canonical);
    return found == includers_.end() || std::all_of(found->second.begin(), found->second.end(), [&](std::size_t other) {
             return includes_[i].contains(all_[other].canonical);
           });
  }

  const std::vector<Candidate>& all_;
  std::vector<std::set<std::string>> includes_;
  std::vector<std::vector<std::string>> missing_;  ///< names
  std::map<std::string, std::vector<std::size_t>> includers_;
  std::set<std::string> covered_;
};

}  // namespace

DeckList list_decks(const std::vector<std::string>& arguments, DeckFiles& files, Diagnostics& diagnostics) {
  DeckList list;
  const std::vector<Candidate> all = candidates(arguments, diagnostics);
  const bool named = std::all_of(all.begin(), all.end(), [](const Candidate& candidate) { return candidate.named; });
  const std::vector<bool> decks = named ? std::vector<bool>(all.size(), true) : Choice(all, files).decks();
  for (std::size_t i = 0; i < all.size(); ++i) (decks[i] ? list.decks : list.parts_of_others).push_back(all[i].path);
  return list;
}

DeckList changed_decks(const std::vector<std::string>& arguments, const ChangedFiles& changed, DeckFiles& files,
                       Diagnostics& diagnostics) {
  std::vector<Candidate> all = candidates(arguments, diagnostics);
  for (Candidate& candidate : all) candidate.named = false;
  Choice choice(all, files);
  std::set<std::string> paths;
  for (const std::string& file : changed.deleted) paths.insert(canonical(file));
  for (const std::string& file : changed.changed) {
    const std::string& path = *paths.insert(canonical(file)).first;
    std::error_code unknown;
    if (!fs::exists(file, unknown) && !choice.any_has(path))
      diagnostics.error(
          file, 0, "is not there, and no deck includes it; correct the name, or give a deleted file with --deleted");
  }
  const std::vector<bool> decks = choice.decks();
  DeckList list;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto belongs = [&](const std::string& path) { return choice.has(i, path); };
    if (decks[i] && std::ranges::any_of(paths, belongs))
      (files.can_run(all[i].path) ? list.decks : list.incomplete).push_back(all[i].path);
  }
  return list;
}

std::string name_for(std::string_view name, std::string_view deck) {
  constexpr std::string_view mark = "{deck}";
  fs::path inside;
  for (const fs::path& part : fs::path(deck).lexically_normal().relative_path())
    if (part != "..") inside /= part;
  inside.replace_extension();
  std::string result(name);
  for (std::size_t at = result.find(mark); at != std::string::npos; at = result.find(mark, at + inside.string().size()))
    result.replace(at, mark.size(), inside.string());
  return result;
}

}  // namespace gapcheck::app
