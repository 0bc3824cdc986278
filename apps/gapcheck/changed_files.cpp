#include "changed_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "audit/repair/deck_edits.hpp"
#include "base/file_writer.hpp"

namespace gapcheck::app {

namespace fs = std::filesystem;

Status choose_places(const keyword::Deck& deck, const std::string& main, const ChangedDirectory& directory,
                     std::vector<FixedFile>& all_changed) {
  std::error_code error;
  const fs::path home = fs::weakly_canonical(fs::path(main), error).parent_path();
  std::set<fs::path> sources, taken;
  for (const keyword::SourceFile& file : deck.files()) sources.insert(fs::weakly_canonical(file.path, error));
  // Another name of the same file counts, too.
  const auto is_source = [&](const fs::path& target) {
    return sources.contains(fs::weakly_canonical(target, error)) ||
           std::any_of(sources.begin(), sources.end(),
                       [&](const fs::path& s) { return fs::equivalent(s, target, error); });
  };
  for (FixedFile& changed : all_changed) {
    fs::path below = fs::weakly_canonical(changed.path, error).lexically_relative(home);
    if (below.empty() || *below.begin() == "..") below = fs::path(changed.path).filename();
    const fs::path target = fs::path(directory.path) / below;
    const fs::path canonical = fs::weakly_canonical(target, error);
    if (is_source(target))
      return plain_error(fmt::format("{} is a file of the deck itself; give another directory with {}", target.string(),
                                     directory.option));
    if (!taken.insert(canonical).second)
      return plain_error(fmt::format(
          "two files of the deck would become {}; put them below the folder of the main file", target.string()));
    changed.written = target.string();
  }
  return {};
}

Status write_texts(const keyword::Deck& deck, const std::map<std::string, std::string>& texts,
                   std::span<const FixedFile> places) {
  if (Status same = deck.unchanged(); !same.ok()) return same;
  std::vector<FileWriter> writers;
  for (const FixedFile& place : places) {
    std::error_code error;
    fs::create_directories(fs::path(place.written).parent_path(), error);
    auto writer = FileWriter::create(place.written);
    if (!writer) return writer.error();
    writer.value().write(texts.at(place.path));
    if (Status written = writer.value().finish(); !written.ok()) return written;
    writers.push_back(std::move(writer).value());
  }
  if (Status same = deck.unchanged(); !same.ok()) return same;
  for (FileWriter& writer : writers)
    if (Status written = writer.commit(); !written.ok()) return written;
  return {};
}

Status write_files(const keyword::Deck& deck, std::span<const audit::ChangedLines> files,
                   std::span<const FixedFile> places) {
  if (Status same = deck.unchanged(); !same.ok()) return same;
  return write_texts(deck, audit::changed_texts(deck, files), places);
}

}  // namespace gapcheck::app
