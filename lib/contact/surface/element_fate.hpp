#pragma once
#include <array>
#include <vector>

#include "base/ids.hpp"
#include "base/vector.hpp"

namespace gapcheck::contact {

/// A scaled Jacobian or a share of the former area below this is as good as none: the element cannot be calculated.
inline constexpr double flattened_element = 0.01;

/// What becomes of an element whose nodes are moved.
struct ElementFate {
  double before = 0, after = 0;  ///< area of shells, volume of solids; negative: turned against the element before
  bool inverted = false, flat = false;  ///< by the move; elements that were so before are neither
  [[nodiscard]] bool bad() const { return inverted || flat; }
};

/// The fate of a shell; a triangle repeats its last node.
[[nodiscard]] ElementFate element_fate(const std::array<NodeIndex, 4>& nodes, const std::vector<Vector>& before,
                                       const std::vector<Vector>& after);
/// The fate of an eight-node element or a collapsed form of it.
[[nodiscard]] ElementFate element_fate(const std::array<NodeIndex, 8>& nodes, const std::vector<Vector>& before,
                                       const std::vector<Vector>& after);

}  // namespace gapcheck::contact
