#include "solver/quadrature/nodal_average.hpp"

#include <algorithm>
#include <tuple>

#include "base/parallel.hpp"

namespace gapcheck::solver {

void NodalAverage::add(const std::array<NodeIndex, 4>& nodes, std::uint32_t part, std::uint32_t owner) {
  const auto tetrahedron = static_cast<std::uint32_t>(owner_.size());
  for (std::uint32_t k = 0; k < 4; ++k) corners_.push_back({part, nodes[k].value, tetrahedron, k});
  owner_.push_back(owner);
}

void NodalAverage::finish(std::size_t owners) {
  if (empty()) return;
  place_.assign(owners, no_position);
  for (std::uint32_t i = 0; i < owner_.size(); ++i) place_[owner_[i]] = i;
  std::sort(corners_.begin(), corners_.end(), [](const Corner& a, const Corner& b) {
    return std::tie(a.part, a.node, a.tetrahedron, a.corner) < std::tie(b.part, b.node, b.tetrahedron, b.corner);
  });
  node_.resize(owner_.size());
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    const Corner& corner = corners_[i];
    const bool is_new = i == 0 || corner.part != corners_[i - 1].part || corner.node != corners_[i - 1].node;
    if (is_new && i > 0) first_.push_back(i);
    node_[corner.tetrahedron][corner.corner] = static_cast<std::uint32_t>(first_.size() - 1);
  }
  first_.push_back(static_cast<std::uint32_t>(corners_.size()));
  strain_.assign(first_.size() - 1, 0);
}

void NodalAverage::average(const std::vector<Share>& shares) {
  parallel_for(strain_.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
      double volume = 0, growth = 0;
      for (std::uint32_t i = first_[node]; i < first_[node + 1]; ++i) {
        volume += shares[corners_[i].tetrahedron].volume;
        growth += shares[corners_[i].tetrahedron].growth;
      }
      strain_[node] = volume > 0 ? growth / volume : 0;
    }
  });
}

std::array<double, 4> NodalAverage::strains(std::uint32_t owner) const {
  const std::array<std::uint32_t, 4>& nodes = node_[place_[owner]];
  return {strain_[nodes[0]], strain_[nodes[1]], strain_[nodes[2]], strain_[nodes[3]]};
}

}  // namespace gapcheck::solver
