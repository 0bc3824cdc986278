#pragma once
#include <cstddef>
#include <cstdint>

#include "keyword/deck.hpp"

namespace gapcheck::keyword {

/// *NODE… and *ELEMENT_…: what *INCLUDE_AUTO_OFFSET shifts.
[[nodiscard]] bool is_node_or_element(std::string_view name);

/// The highest ids of the nodes and elements read so far, each block looked at once. Elements: shells, solids, thick
/// shells, beams, discrete elements, masses, inertias, seat belts and PLOTEL.
class HighestIds {
 public:
  /// Looks at the blocks that were added to the deck since the last call.
  void update(const Deck& deck);
  [[nodiscard]] std::int64_t node() const { return node_; }
  [[nodiscard]] std::int64_t element() const { return element_; }

 private:
  std::size_t next_ = 0;
  std::int64_t node_ = 0, element_ = 0;
};

}  // namespace gapcheck::keyword
