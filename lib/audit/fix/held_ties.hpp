#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "audit/fix/least_movement.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "contact/tie/ties.hpp"
#include "model/read/links.hpp"

namespace gapcheck::audit {

/// A tied node and the segment that it is tied to: both move together.
struct HeldTie {
  NodeIndex node;
  model::SegmentNodes corners{};
  std::array<double, 4> share{};  ///< how the corners move the tied point
};

/// The ties that the contacts make; `judged` and `surfaces`: of the same model on the coordinates `x`.
[[nodiscard]] std::vector<HeldTie> held_ties(std::span<const contact::JudgedNode> judged,
                                             contact::SurfaceStore& surfaces, const std::vector<Vector>& x);

/// The same for a node at the middle of an edge.
[[nodiscard]] HeldTie held_tie(const model::HangingNode& hanging);

/// Ties that have one of the nodes, or a node of such a tie, and so on. `moving`: by node, 1 for the nodes that may
/// move; the nodes of the ties are added.
[[nodiscard]] std::vector<HeldTie> ties_of(std::vector<HeldTie> ties, std::vector<std::uint8_t>& moving);

}  // namespace gapcheck::audit
