#include "output_guard.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>

namespace gapcheck::app {
namespace {

namespace fs = std::filesystem;

/// Identifies a file: device and inode number if it exists, otherwise its path. Nothing for anything other than a
/// regular file.
std::optional<std::string> identity(const std::string& path) {
  for (const std::string_view stream : {"/dev/std", "/dev/fd/", "/proc/"})
    if (path.starts_with(stream)) return std::nullopt;
  std::error_code failed;
  fs::path place = fs::weakly_canonical(fs::absolute(path, failed), failed);
  if (failed) place = fs::absolute(path, failed).lexically_normal();
  struct stat status {};
  if (::stat(place.c_str(), &status) != 0) return place.string();
  if (!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) return std::nullopt;
  return fmt::format("{} {}", status.st_dev, status.st_ino);
}

bool any_exists(const std::vector<PlannedOutput>& outputs) {
  std::error_code failed;
  return std::any_of(outputs.begin(), outputs.end(), [&failed](const PlannedOutput& output) {
    return !output.path.empty() && fs::exists(output.path, failed);
  });
}

/// What is wrong with two outputs in one file.
std::string shared_place(const PlannedOutput& first, const PlannedOutput& second) {
  if (!first.deck.empty() && !second.deck.empty() && first.deck != second.deck)
    return fmt::format(
        "{} would hold the results of {} and of {}; write {{deck}} into the name where their own are to "
        "stand, and give decks different names",
        second.path, first.deck, second.deck);
  return fmt::format("{} {} and {} {} are one file; give each its own", first.option, first.path, second.option,
                     second.path);
}

}  // namespace

std::vector<PlannedOutput> planned_outputs(const OutputOptions& output) {
  return {{"--output", output.output}, {"--html", output.html}};
}

std::vector<PlannedOutput> planned_outputs(const ExportOptions& exports) {
  return {{"--key", exports.key},       {"--ani", exports.ani}, {"--a4sel", exports.a4sel},
          {"--medina", exports.medina}, {"--vtu", exports.vtu}, {"--sets", exports.sets}};
}

std::vector<PlannedOutput> planned_run_outputs(const std::string& directory, bool vtu) {
  const auto numbered = [](std::string_view name, std::string_view begin, std::string_view end) {
    if (name.size() < begin.size() + end.size() + 1 || !name.starts_with(begin) || !name.ends_with(end)) return false;
    name = name.substr(begin.size(), name.size() - begin.size() - end.size());
    return name.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const auto replaced = [&](std::string_view name) {
    constexpr std::array always{"messag", "d3hsp",  "glstat", "matsum", "nodout",
                                "rcforc", "sleout", "ncforc", "d3plot"};
    return std::find(always.begin(), always.end(), name) != always.end() || numbered(name, "d3plot", "") ||
           (vtu && (name == "run.pvd" || numbered(name, "state_", ".vtu")));
  };
  std::vector<PlannedOutput> outputs;
  std::error_code failed;
  for (fs::directory_iterator entry(directory, failed), end; !failed && entry != end; entry.increment(failed))
    if (replaced(entry->path().filename().string()))
      outputs.push_back({"-o", entry->path().string(), "", "another directory"});
  std::sort(outputs.begin(), outputs.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return outputs;
}

void add_deck_files(const keyword::Deck& deck, std::vector<ReadInput>& read) {
  const auto files = deck.files();
  for (std::size_t i = 0; i < files.size(); ++i)
    read.push_back({files[i].path, i == 0 ? "the deck itself" : "a file that the deck includes"});
}

void add_deck_files(const std::string& deck, DeckFiles& files, const std::vector<PlannedOutput>& outputs,
                    std::vector<ReadInput>& read) {
  read.push_back({deck, "the deck itself"});
  if (!any_exists(outputs)) return;
  for (const std::string& file : files.includes(deck)) read.push_back({file, "a file that " + deck + " includes"});
}

void add_run_files(const std::string& directory, std::vector<ReadInput>& read) {
  for (const char* name : {"d3hsp", "d3plot", "glstat", "matsum", "nodout", "rcforc", "sleout"})
    if (std::error_code failed; fs::exists(fs::path(directory) / name, failed))
      read.push_back({(fs::path(directory) / name).string(), "a file of the run"});
}

Status check_outputs(const std::vector<ReadInput>& read, const std::vector<PlannedOutput>& outputs) {
  std::map<std::string, const ReadInput*> inputs;
  for (const ReadInput& input : read)
    if (!input.path.empty())
      if (const auto file = identity(input.path)) inputs.emplace(*file, &input);
  std::map<std::string, const PlannedOutput*> taken;
  for (const PlannedOutput& output : outputs) {
    const auto file = output.path.empty() ? std::nullopt : identity(output.path);
    if (!file) continue;
    if (const auto found = inputs.find(*file); found != inputs.end())
      return plain_error(fmt::format("{} {} is {}{}; give {}", output.option, output.path, found->second->what,
                                     output.path == found->second->path ? "" : ", " + found->second->path,
                                     output.instead));
    if (const auto [first, fresh] = taken.emplace(*file, &output); !fresh)
      return plain_error(shared_place(*first->second, output));
  }
  return {};
}

}  // namespace gapcheck::app
