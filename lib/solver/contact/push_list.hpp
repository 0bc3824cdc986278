#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/surface/surface.hpp"
#include "solver/interface/contact_state.hpp"
#include "solver/state/force.hpp"

namespace gapcheck::solver {

/// Force on one tracked node; the opposite acts on the segment's corners by their weights.
struct NodePush {
  Vector force;
  std::array<double, 4> weights;
  std::uint32_t node = 0, segment = 0;
};

/// Pushes in a fixed order, and between which nodes (as positions in the model) the corners of their segments lie.
struct PushList {
  std::vector<NodePush> pushes;
  std::uint32_t low = 0xffffffffu, high = 0;
  void clear();
  void add(const NodePush& push, const model::SegmentNodes& corners);
};

/// Adds the forces of all lists, each node tracked at most once: first on the tracked nodes, then on the corners in the
/// order of lists and pushes. The same bits for any number of threads.
void add_pushes(std::span<const PushList> lists, const contact::Segments& segments, Forces& forces);

/// Adds forces, and their moments about the origin, to the sums of both sides, list by list. `exchanged`: the tracked
/// nodes are on side B. The same bits for any number of threads.
void add_totals(std::span<const PushList> lists, const contact::Segments& segments, const std::vector<Vector>& x,
                bool exchanged, ContactState& result);

}  // namespace gapcheck::solver
