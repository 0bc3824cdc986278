#include "common/deck_files.hpp"

namespace gapcheck::app {

const std::vector<std::string>& DeckFiles::includes(const std::string& deck) {
  const auto [entry, is_new] = includes_.try_emplace(deck);
  if (!is_new) return entry->second;
  Diagnostics unheard;
  if (const auto read = keyword::read_deck(deck, options_, unheard); read)
    for (const keyword::SourceFile& file : read.value().files().subspan(1)) entry->second.push_back(file.path);
  return entry->second;
}

}  // namespace gapcheck::app
