#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "model/entity/sets.hpp"
#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// The volume inside a surface of triangles and bilinear quads whose normals, by the right-hand rule, point outward.
class ControlVolume {
 public:
  explicit ControlVolume(std::vector<model::SegmentNodes> segments);

  [[nodiscard]] std::size_t size() const { return segments_.size(); }
  /// The nodes of the surface, each once, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& nodes() const { return nodes_; }

  /// Edges that do not lie between two segments with the same side out, and the nodes of the first of them.
  struct OpenEdges {
    std::size_t count = 0;
    std::array<std::uint32_t, 2> first{};
  };
  [[nodiscard]] OpenEdges open_edges() const;

  /// By the divergence theorem; exact for the bilinear patches of a closed surface.
  [[nodiscard]] double volume(std::span<const Vector> x) const;
  /// Half the length of the cross product of the diagonals, summed.
  [[nodiscard]] double area(std::span<const Vector> x) const;
  /// The forces of a unit pressure on the nodes of nodes(), which do the work of the pressure on the volume: ∫ N n dA
  /// over each patch.
  [[nodiscard]] std::vector<Vector> forces(std::span<const Vector> x) const;

 private:
  std::vector<model::SegmentNodes> segments_;
  std::vector<std::uint32_t> nodes_;
  std::vector<std::array<std::uint32_t, 4>> places_;  ///< of the segments' corners in nodes_
};

}  // namespace gapcheck::solver
