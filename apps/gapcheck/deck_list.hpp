#pragma once
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "keyword/deck.hpp"

namespace gapcheck::app {

/// The decks that one call works on.
struct DeckList {
  std::vector<std::string> decks;   ///< paths, each file once
  std::vector<std::string> parts_of_others;  ///< found by a pattern and left out: another of the decks includes them
};

/// Decks from the command line: paths as they are, and patterns (`*`, `?`, `**` for any folders) that no file is named
/// like. What patterns find is sorted, without hidden folders and folders behind links. A file that is only found by a
/// pattern and that one of the listed decks includes is no deck of its own; of files that include one another in a
/// circle one is. Errors go to `diagnostics`: patterns that find nothing, folders that cannot be read, more files than
/// a call should take.
[[nodiscard]] DeckList list_decks(const std::vector<std::string>& arguments, const keyword::ReadOptions& options,
                                  Diagnostics& diagnostics);

/// `name` with the deck's path in place of {deck}: without its extension, and nothing of it leads out of the folder that
/// `name` gives. "reports/{deck}.html" and "models/side/a.k" give "reports/models/side/a.html".
[[nodiscard]] std::string name_for(std::string_view name, std::string_view deck);

}  // namespace gapcheck::app
