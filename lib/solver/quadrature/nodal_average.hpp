#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/ids.hpp"

namespace gapcheck::solver {

/// Volume strains of tetrahedra that are averaged at their nodes (Bonet and Burton, Commun. Numer. Meth. Engng 14,
/// 1998): a node has a quarter of the volume of each tetrahedron of its part there, and the volume strain Σ ΔV / Σ V. A
/// tetrahedron takes the mean of its four nodes. Sums have a fixed order, so they do not depend on threads.
class NodalAverage {
 public:
  /// Of one tetrahedron in a step: its volume and what that grows by. Zeros take no part.
  struct Share {
    double volume = 0, growth = 0;
  };

  /// Adds a tetrahedron of a part; only those of one part are averaged. `owner`: position in the caller's arrays.
  void add(const std::array<NodeIndex, 4>& nodes, std::uint32_t part, std::uint32_t owner);
  /// Call it once all are added; `owners`: number of the caller's positions.
  void finish(std::size_t owners);

  [[nodiscard]] bool empty() const { return owner_.empty(); }
  /// The positions in the caller's arrays, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& owners() const { return owner_; }
  [[nodiscard]] bool has(std::uint32_t owner) const { return owner < place_.size() && place_[owner] != no_position; }
  /// Takes the shares of all, in the order of owners().
  void average(const std::vector<Share>& shares);
  /// Volume strains at the four nodes.
  [[nodiscard]] std::array<double, 4> strains(std::uint32_t owner) const;

 private:
  struct Corner {
    std::uint32_t part = 0, node = 0, tetrahedron = 0, corner = 0;
  };
  std::vector<std::uint32_t> owner_, place_;        ///< by tetrahedron; tetrahedron by owner
  std::vector<Corner> corners_;                     ///< by part, node and tetrahedron
  std::vector<std::uint32_t> first_{0};             ///< of each node among corners_; one more than nodes
  std::vector<std::array<std::uint32_t, 4>> node_;  ///< of each tetrahedron among strain_
  std::vector<double> strain_;                      ///< by node and part
};

}  // namespace gapcheck::solver
