#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace gapcheck {

/// A lower bound of the letters that are inserted, removed or replaced to turn one text into the other: those that one
/// has too many of. Swapped letters count nothing. Far quicker than a distance.
[[nodiscard]] inline std::size_t least_changed(std::string_view a, std::string_view b) {
  std::array<int, 256> surplus{};
  for (const char c : a) ++surplus[static_cast<unsigned char>(c)];
  std::size_t missing = 0;
  for (const char c : b)
    if (--surplus[static_cast<unsigned char>(c)] < 0) ++missing;
  // What a has too many of is what b lacks, less the difference in length.
  return std::max(missing, missing + a.size() - b.size());
}

/// Least cost of turning one sequence into another by inserting, removing and replacing items (Levenshtein). Inserting
/// and removing cost 1, replacing costs replace(from, to), which is 0 for equal items. Time is size times size: bound
/// both.
template <class Sequence, class Replace>
[[nodiscard]] double edit_distance(const Sequence& from, const Sequence& to, const Replace& replace) {
  std::vector<double> costs(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j) costs[j] = static_cast<double>(j);
  for (std::size_t i = 0; i < from.size(); ++i) {
    double diagonal = costs[0];
    costs[0] += 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const double above = costs[j + 1];
      costs[j + 1] = std::min({above + 1, costs[j] + 1, diagonal + replace(from[i], to[j])});
      diagonal = above;
    }
  }
  return costs.back();
}

}  // namespace gapcheck
