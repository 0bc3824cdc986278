#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "audit/repair/deck_edits.hpp"
#include "base/result.hpp"
#include "keyword/card.hpp"
#include "keyword/deck.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::audit {

/// Other values in fields of a deck's cards. Deck and edits must outlive it.
class CardFields {
 public:
  CardFields(const keyword::Deck& deck, DeckEdits& edits) : deck_(deck), edits_(edits) {}

  /// The keyword at a place, or the last one before it in the same file; nullptr if there is none.
  [[nodiscard]] const keyword::Block* block(const model::Place& place) const;
  /// An error if the lines of a block cannot be changed: its file is included twice or transformed.
  [[nodiscard]] Status check(const keyword::Block& block) const;
  /// A field as written, changes so far included.
  [[nodiscard]] std::string written(const keyword::Block& block, std::uint32_t line, const keyword::CardLayout& layout,
                                    std::string_view field);
  /// Sets a field. Errors: check_replaceable().
  Status set(const keyword::Block& block, std::uint32_t line, const keyword::CardLayout& layout, std::string_view field,
             double value);
  /// `moves`: of two fields that change places, where a parameter goes along.
  Status set_text(const keyword::Block& block, std::uint32_t line, const keyword::CardLayout& layout,
                  std::string_view field, std::string_view text, bool moves = false);
  /// A new card of a block with numbers in some fields.
  [[nodiscard]] static std::string card(const keyword::Block& block, const keyword::CardLayout& layout,
                                        std::span<const std::pair<std::string_view, double>> values);
  [[nodiscard]] Diagnostic error(const model::Place& place, const std::string& what) const;
  [[nodiscard]] const keyword::Deck& deck() const { return deck_; }
  [[nodiscard]] DeckEdits& edits() { return edits_; }

 private:
  [[nodiscard]] keyword::Card card_at(const keyword::Block& block, std::uint32_t line,
                                      const keyword::CardLayout& layout);
  const keyword::Deck& deck_;
  DeckEdits& edits_;
  Diagnostics ignored_;  ///< already reported when the deck was read
};

}  // namespace gapcheck::audit
