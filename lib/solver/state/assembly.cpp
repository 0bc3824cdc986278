#include "solver/state/assembly.hpp"

namespace gapcheck::solver {

CornerTable::CornerTable(std::size_t nodes, std::span<const NodeIndex> corners) : first_(nodes + 1, 0) {
  for (const NodeIndex node : corners)
    if (node.value < nodes) ++first_[node.value + 1];
  for (std::size_t i = 0; i < nodes; ++i) first_[i + 1] += first_[i];
  places_.resize(first_[nodes]);
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t place = 0; place < corners.size(); ++place)
    if (corners[place].value < nodes) places_[next[corners[place].value]++] = place;
}

}  // namespace gapcheck::solver
