#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "lsp/card_order.hpp"

namespace gapcheck::app::lsp {

/// How the elements of a keyword are spread over lines.
struct ElementLines {
  const keyword::CardLayout* first = nullptr;        ///< nullptr: card_order() says all, or nobody knows
  const keyword::CardLayout* nodes = nullptr;        ///< of solids whose first line names no nodes
  std::size_t node_lines = 0;                        ///< how many of these
  std::vector<const keyword::CardLayout*> behind{};  ///< further lines of each; nullptr: not known
  const keyword::CardLayout* middle = nullptr;       ///< behind the first of them, if the element has nodes N5 to N8
  const keyword::CardLayout* ply = nullptr;          ///< any number of lines, up to one that can only be an element
};

/// The card of each data line of a keyword, one line after the other. Of elements the lines themselves decide, as
/// lib/model/read reads them; of all other keywords card_order() does.
class LineCards {
 public:
  LineCards(const Text& text, const Keyword& keyword);
  /// The card of the next data line; nullptr: not known.
  [[nodiscard]] const keyword::CardLayout* next(std::string_view line);
  /// Passes the data lines of the text in front of this one.
  void skip_to(std::uint32_t line);
  /// Data lines so far; where one card repeats, not all of those that were passed count.
  [[nodiscard]] std::size_t row() const { return row_; }
  /// Whether every line is that card, and a line of an unknown one is known to be such a line.
  [[nodiscard]] bool sure() const { return elements_.first != nullptr || order_.checked; }

 private:
  void begin(std::string_view line);
  const Text& text_;
  const Keyword& keyword_;
  const CardOrder order_;
  const ElementLines elements_;
  std::vector<const keyword::CardLayout*> rest_;  ///< lines of the element that has begun
  std::size_t next_ = 0;                          ///< which of them comes next
  bool begun_ = false;
  std::size_t row_ = 0;
};

/// A line that is a card.
struct CardLine {
  const Keyword* keyword = nullptr;
  const keyword::CardLayout* layout = nullptr;  ///< nullptr: not a data line, or not known
  std::size_t row = 0;                          ///< how many data lines of the keyword come before it
};

[[nodiscard]] CardLine card_at(const Text& text, std::span<const Keyword> outline, std::uint32_t line);

}  // namespace gapcheck::app::lsp
