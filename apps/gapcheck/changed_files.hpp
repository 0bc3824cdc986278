#pragma once
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audit/fix/node_lines.hpp"
#include "base/result.hpp"
#include "keyword/deck.hpp"
#include "records/fix.hpp"

namespace gapcheck::app {

/// The option that names the directory for changed files of a deck, and what it says.
struct ChangedDirectory {
  std::string_view option;
  std::string path;
};

/// Where each changed file goes (FixedFile::written): at its path relative to the main file `main`, or only by name if
/// it is elsewhere. An error if this would overwrite a file of the deck, or two files would go to the same place.
[[nodiscard]] Status choose_places(const keyword::Deck& deck, const std::string& main,
                                   const ChangedDirectory& directory, std::vector<FixedFile>& changed);

/// Writes the changed files, whose texts are given by path as read, to their places: all of them or none, unless a name
/// cannot be taken over at the end.
[[nodiscard]] Status write_texts(const keyword::Deck& deck, const std::map<std::string, std::string>& texts,
                                 std::span<const FixedFile> places);

/// The same from the lines that change. Every byte outside of them is that of the deck.
[[nodiscard]] Status write_files(const keyword::Deck& deck, std::span<const audit::ChangedLines> files,
                                 std::span<const FixedFile> places);

}  // namespace gapcheck::app
