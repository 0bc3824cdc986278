#include "common/file_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>

#include "base/system/files.hpp"
#include "results/d3plot/run_folder.hpp"

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
  system::FileState state;
  if (!system::state_of(place.string(), state)) return place.string();
  if (state.kind == system::FileKind::other) return std::nullopt;
  return fmt::format("{} {}", state.device, state.inode);
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
  for (const std::string& file : results::result_files(directory)) read.push_back({file, "a file of the run"});
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
