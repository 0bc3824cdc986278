#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// For every node the element corners that lie on it, as positions in the elements' force arrays, ascending. Sums over
/// them are always taken in that order, so they do not depend on threads.
class CornerTable {
 public:
  CornerTable() = default;
  /// `corners[k]`: node of the k-th entry of the force array, or none if unused.
  CornerTable(std::size_t nodes, std::span<const NodeIndex> corners);

  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t node) const {
    return {places_.data() + first_[node], places_.data() + first_[node + 1]};
  }

 private:
  std::vector<std::uint32_t> first_{0}, places_;
};

}  // namespace gapcheck::solver
