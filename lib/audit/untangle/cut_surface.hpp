#pragma once
#include <span>
#include <vector>

#include "audit/untangle/crossing_pairs.hpp"
#include "contact/surface/neighbours.hpp"

namespace gapcheck::audit {

/// One side of a contact as a surface that can be cut: edges between nodes, segments at nodes.
class CutSurface {
 public:
  /// All must outlive it. `x`: coordinates by node.
  CutSurface(const contact::ContactSide& side, const model::Mesh& mesh, const std::vector<Vector>& x)
      : side_(side), x_(x), neighbours_(side.selection.segments, mesh) {}
  [[nodiscard]] const contact::Segments& segments() const { return side_.selection.segments; }
  [[nodiscard]] const contact::ContactSide& side() const { return side_; }
  [[nodiscard]] const contact::Neighbours& neighbours() const { return neighbours_; }
  [[nodiscard]] const std::vector<Vector>& x() const { return x_; }
  /// The segments of elements (of this mesh), and those that share a node with them; ascending. Empty if an element has
  /// none.
  [[nodiscard]] std::vector<SegmentIndex> around(const model::Mesh& mesh,
                                                 std::span<const ElementOfKind> elements) const;

 private:
  const contact::ContactSide& side_;
  const std::vector<Vector>& x_;
  contact::Neighbours neighbours_;
};

}  // namespace gapcheck::audit
