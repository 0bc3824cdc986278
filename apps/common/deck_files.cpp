#include "common/deck_files.hpp"

#include <algorithm>
#include <string_view>

namespace gapcheck::app {
namespace {

bool has_keyword(const keyword::Deck& deck, std::string_view beginning) {
  return std::ranges::any_of(deck.blocks(), [&](const auto& block) { return block.name.starts_with(beginning); });
}

}  // namespace

const DeckFiles::Known& DeckFiles::known(const std::string& deck) {
  const auto [entry, is_new] = known_.try_emplace(deck);
  Known& known = entry->second;
  if (!is_new) return known;
  Diagnostics unheard;
  if (const auto read = keyword::read_deck(deck, options_, unheard); read) {
    for (const keyword::SourceFile& file : read.value().files().subspan(1)) known.includes.push_back(file.path);
    for (const keyword::MissingInclude& include : read.value().missing_includes())
      known.missing.push_back(include.name);
    known.directives = !read.value().directives().empty();
    known.can_run = has_keyword(read.value(), "CONTROL_TERMINATION") &&
                    (has_keyword(read.value(), "NODE") || !read.value().missing_includes().empty());
  }
  return known;
}

}  // namespace gapcheck::app
