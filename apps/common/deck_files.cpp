#include "common/deck_files.hpp"

namespace gapcheck::app {

const DeckFiles::Known& DeckFiles::known(const std::string& deck) {
  const auto [entry, is_new] = known_.try_emplace(deck);
  Known& known = entry->second;
  if (!is_new) return known;
  Diagnostics unheard;
  if (const auto read = keyword::read_deck(deck, options_, unheard); read) {
    for (const keyword::SourceFile& file : read.value().files().subspan(1)) known.includes.push_back(file.path);
    known.directives = !read.value().directives().empty();
  }
  return known;
}

}  // namespace gapcheck::app
