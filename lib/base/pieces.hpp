#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace gapcheck {

/// Cuts [0, count) into pieces of about `grain` items, for parallel loops over a list whose runs of equal items must
/// stay together: joined(i) tells that item i belongs to the same run as item i - 1. Returns where the pieces begin,
/// and `count` at the end.
template <class Joined>
[[nodiscard]] std::vector<std::size_t> pieces_of_runs(std::size_t count, std::size_t grain, const Joined& joined) {
  std::vector<std::size_t> starts{0};
  while (starts.back() < count) {
    std::size_t next = std::min(count, starts.back() + grain);
    while (next < count && joined(next)) ++next;
    starts.push_back(next);
  }
  return starts;
}

}  // namespace gapcheck
