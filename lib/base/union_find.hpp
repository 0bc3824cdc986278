#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace gapcheck {

/// Sets of the numbers 0 … size - 1, initially separate. The smallest number of a set represents it, whatever the order
/// in which sets are united. Asking shortens paths: one thread at a time.
class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

  [[nodiscard]] std::size_t size() const { return parent_.size(); }
  /// The smallest number in the set of `n`.
  [[nodiscard]] std::uint32_t root(std::uint32_t n) {
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  /// Makes `n` a set of its own. To be called for all numbers of a set before any of them is asked again.
  void separate(std::uint32_t n) { parent_[n] = n; }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace gapcheck
