#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "keyword/layout.hpp"
#include "lsp/outline.hpp"

namespace gapcheck::app::lsp {

/// Which card each data line of a keyword is: first those of `head`, then those of `cycle` again and again. Where
/// neither says it, the card is not known.
struct CardOrder {
  std::vector<const keyword::CardLayout*> head, cycle;
  bool checked = false;  ///< sure enough to call a field wrong
  bool operator==(const CardOrder&) const = default;
  /// The card of the data line with this number from 0; nullptr: not known.
  [[nodiscard]] const keyword::CardLayout* at(std::size_t row) const;
  /// The least number that means the same as this one.
  [[nodiscard]] std::size_t least(std::size_t row) const;
};

/// How many data lines decide about the order.
inline constexpr std::size_t deciding_rows = 24;

/// The order of the cards of a keyword. Its name decides, in a few cases its first data lines too: `rows`, as many as
/// there are up to deciding_rows.
[[nodiscard]] CardOrder card_order(std::string_view name, keyword::Format format,
                                   std::span<const std::string_view> rows);

/// The same for a keyword of a text.
[[nodiscard]] CardOrder card_order(const Text& text, const Keyword& keyword);
/// The same for a keyword whose first line of data, if it has any, starts there.
[[nodiscard]] CardOrder card_order(std::string_view name, keyword::Format format, const Text& text, Text::Spot data);

/// The known keyword whose cards a name has; nullptr: none.
[[nodiscard]] const keyword::KeywordLayout* layout_of(std::string_view name);

/// What a card is called: "card 2", "card A", "card ID".
[[nodiscard]] std::string called(const keyword::CardLayout& layout);

}  // namespace gapcheck::app::lsp
