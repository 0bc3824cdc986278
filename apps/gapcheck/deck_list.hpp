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

/// Of the decks that list_decks() finds those that one of the files `changed` belongs to. A named file, too, is not a
/// deck if another one includes it. A file that nobody includes is one only if it can run (DeckFiles::can_run).
[[nodiscard]] DeckList changed_decks(const std::vector<std::string>& arguments, const std::vector<std::string>& changed,
                                     DeckFiles& files, Diagnostics& diagnostics);

/// `name` with {deck} replaced by the deck's path: without its extension, and never leading out of the folder in
/// `name`. "reports/{deck}.html" and "models/side/a.k" give "reports/models/side/a.html".
[[nodiscard]] std::string name_for(std::string_view name, std::string_view deck);

}  // namespace gapcheck::app
