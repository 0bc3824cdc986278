#pragma once
#include <map>
#include <string>

#include "audit/repair/repair_trial.hpp"
#include "keyword/deck.hpp"
#include "keyword/file_cache.hpp"

namespace gapcheck::app {

/// A deck whose repairs are tried: it is read again with other texts, its other files from memory.
class RepairedInput {
 public:
  /// Both must outlive it.
  RepairedInput(const std::string& deck, const keyword::ReadOptions& options) : deck_(deck), options_(options) {}

  /// `texts` must outlive the deck.
  [[nodiscard]] Result<keyword::Deck> read(const std::map<std::string, std::string>& texts, Diagnostics& diagnostics) {
    keyword::ReadOptions options = options_;
    options.cache = &cache_;
    options.replaced = &texts;
    return keyword::read_deck(deck_, options, diagnostics);
  }
  /// The same for those who try repairs; refers to this object.
  [[nodiscard]] audit::Reread reread() {
    return [this](const auto& texts, Diagnostics& diagnostics) { return read(texts, diagnostics); };
  }

 private:
  const std::string& deck_;
  const keyword::ReadOptions& options_;
  keyword::FileCache cache_;
};

}  // namespace gapcheck::app
