#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "audit/untangle/crossing_pairs.hpp"
#include "contact/mesh/mesh_index.hpp"
#include "contact/stiffness/element_timestep.hpp"
#include "model/model.hpp"

namespace gapcheck::audit {

/// How much a correction may change an element. Elements that are already worse in the deck may stay so.
struct ShapeLimits {
  double warp = 15;                     ///< of shells, degrees
  double slenderness = 0.1;             ///< of shells: altitude over longest edge
  double corner = 0.1;                  ///< of solids: smallest product of a corner's edges over their lengths
  double edge_from = 0.5, edge_to = 2;  ///< length of an edge over that in the deck
  double step = 0.8;                    ///< time step over the smallest one of all elements in the deck
};

/// The elements at moved nodes, and whether they keep their shape. The model must outlive it and keep its elements.
class ElementBounds {
 public:
  /// `x`: the deck's coordinates by node; must outlive it.
  ElementBounds(const model::Model& model, const std::vector<Vector>& x, const ShapeLimits& limits = {})
      : model_(model), deck_(x), limits_(limits), index_(model), steps_(model) {}

  /// Elements at moved nodes that are turned inside out, warped or stretched beyond the limits, or whose time step is
  /// too small.
  [[nodiscard]] std::vector<ElementOfKind> broken(const std::vector<Vector>& x, std::span<const NodeIndex> moved);
  /// Nodes that must be held at their place so that these elements keep their shape: of each element, those that moved
  /// at least half as far as its farthest one. Ascending, each once.
  [[nodiscard]] std::vector<NodeIndex> offenders(const std::vector<Vector>& x,
                                                 std::span<const ElementOfKind> elements) const;
  [[nodiscard]] std::vector<NodeIndex> offenders(const std::vector<Vector>& x, std::span<const NodeIndex> moved) {
    return offenders(x, broken(x, moved));
  }

  /// The limits, with edges of this element no shorter than its time step allows.
  [[nodiscard]] ShapeLimits limits_of(const ElementOfKind& element);

  struct Change {
    std::uint64_t touched = 0, worsened = 0;
  };
  /// Elements with a moved node, and how many of them have a visibly worse shape than in the deck: a degree of warp, or
  /// a hundredth of the other measures.
  [[nodiscard]] Change change(const std::vector<Vector>& x, std::span<const NodeIndex> moved);

  /// Elements by node.
  [[nodiscard]] contact::MeshIndex& index() { return index_; }

 private:
  template <class Visit>
  void for_each_element(std::span<const NodeIndex> moved, const Visit& visit);

  /// The time step that every element must keep that has it in the deck; 0: none.
  [[nodiscard]] double least_step();
  [[nodiscard]] bool keeps_step(const ElementOfKind& element, const std::vector<Vector>& x);

  const model::Model& model_;
  const std::vector<Vector>& deck_;
  ShapeLimits limits_;
  contact::MeshIndex index_;
  contact::ElementSteps steps_;
  std::optional<double> least_step_;  ///< once it was asked for
};

}  // namespace gapcheck::audit
