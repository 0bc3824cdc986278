#pragma once
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "common/deck_files.hpp"

namespace gapcheck::app {

/// The decks of one call.
struct DeckList {
  std::vector<std::string> decks;            ///< paths, each file once
  std::vector<std::string> parts_of_others;  ///< found by a pattern but left out: another of the decks includes them
  std::vector<std::string> incomplete;       ///< left out by changed_decks(): no run can begin with them
};

/// Decks from the command line: literal paths, and patterns (`*`, `?`, `**` for any folders) that are not the name of a
/// file. Matches of patterns are sorted, without hidden folders and folders behind links. A file found only by a
/// pattern and included by one of the listed decks is not a deck of its own; of files that include one another in a
/// circle one is. Errors go to `diagnostics`: patterns that find nothing, folders that cannot be read, more files than
/// a call should take.
[[nodiscard]] DeckList list_decks(const std::vector<std::string>& arguments, DeckFiles& files,
                                  Diagnostics& diagnostics);

/// Files that have changed.
struct ChangedFiles {
  std::vector<std::string> changed;  ///< one that is not there is an error, unless a deck includes it
  std::vector<std::string> deleted;  ///< may be there or not
};

/// Of the decks that list_decks() finds those that one of the files belongs to, or that still include one that is gone.
/// A named file, too, is not a deck if another one includes it. A file that nobody includes is one only if it can run
/// (DeckFiles::can_run): the include that no deck has must not fail a commit.
[[nodiscard]] DeckList changed_decks(const std::vector<std::string>& arguments, const ChangedFiles& changed,
                                     DeckFiles& files, Diagnostics& diagnostics);

/// `name` with {deck} replaced by the deck's path: without its extension, and never leading out of the folder in
/// `name`. "reports/{deck}.html" and "models/side/a.k" give "reports/models/side/a.html".
[[nodiscard]] std::string name_for(std::string_view name, std::string_view deck);

}  // namespace gapcheck::app
