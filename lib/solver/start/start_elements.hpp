#pragma once
#include <map>
#include <span>
#include <vector>

#include "contact/mesh/mesh_index.hpp"
#include "contact/stiffness/element_timestep.hpp"
#include "model/model.hpp"
#include "records/start.hpp"

namespace gapcheck::solver {

/// Shapes of the elements at moved nodes, in the deck and at the start. All references must outlive it.
class StartElements {
 public:
  /// `start`: coordinates by node.
  StartElements(const model::Model& model, const std::vector<Vector>& start)
      : model_(model), start_(start), index_(model), step_(model) {}

  /// Measures the elements at these nodes, each once, and lists them: those that have changed visibly, collapsed ones
  /// first, then by loss of time step. `mover`: by node, id of the contact that moved it last.
  [[nodiscard]] std::vector<StartElement> list_changed(std::span<const NodeIndex> moved,
                                                       const std::map<NodeIndex, std::int64_t>& mover);
  /// Sums over the elements at some of these nodes; call list_changed() before.
  [[nodiscard]] StartShapes shapes_at(std::span<const NodeIndex> moved);
  /// Smallest step of all elements on these coordinates.
  [[nodiscard]] double smallest_step(const std::vector<Vector>& x) const { return step_.smallest(x); }

 private:
  using Key = std::pair<model::ElementKind, std::uint32_t>;
  [[nodiscard]] std::vector<Key> elements_at(std::span<const NodeIndex> moved);
  [[nodiscard]] StartElement measure(const Key& key) const;

  const model::Model& model_;
  const std::vector<Vector>& start_;
  contact::MeshIndex index_;
  contact::ElementSteps step_;
  std::map<Key, std::size_t> listed_;  ///< positions of those that have changed visibly
  std::vector<StartElement> list_;
};

}  // namespace gapcheck::solver
