#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "keyword/card.hpp"
#include "keyword/deck.hpp"
#include "lsp/outline.hpp"
#include "lsp/text.hpp"

namespace gapcheck::app::lsp {

/// What a text takes from its deck: the values of parameters, and the offsets and the place of its include.
class Scope {
 public:
  /// A text whose deck is not known.
  Scope();
  /// The file of a deck that was read.
  Scope(std::shared_ptr<const keyword::Deck> deck, FileIndex file);
  /// Whether all parameters are known.
  [[nodiscard]] bool whole() const { return whole_; }
  [[nodiscard]] const keyword::Deck& deck() const { return *deck_; }
  /// A block of the deck in place of a keyword of the text, for cards; without a body. Its ids are those of the model.
  [[nodiscard]] keyword::Block block(const Keyword& keyword) const;
  /// What the include adds to ids, each number once; without 0.
  [[nodiscard]] std::set<std::int64_t> offsets() const;

 private:
  std::shared_ptr<const keyword::Deck> deck_;
  FileIndex file_;
  bool whole_ = false;
  std::vector<const keyword::Block*> blocks_;  ///< of the file, by line
};

/// A file of a deck.
struct FileView {
  std::string path;
  std::shared_ptr<const Text> text;
  std::shared_ptr<const std::vector<Keyword>> outline;
  Scope scope;
};

/// The files of a deck: first the one in question, then the others, which are read when they are needed.
struct DeckFiles {
  FileView own;
  std::vector<std::function<FileView()>> others{};
  /// Calls visit(file) for each until it returns false.
  template <class Visit>
  void for_each(const Visit& visit) const {
    if (!visit(own)) return;
    for (const auto& other : others)
      if (!visit(other())) return;
  }
};

}  // namespace gapcheck::app::lsp
