#include "model/entity/mesh.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace gapcheck::model {

FileIndex Origins::file(std::uint32_t index) const {
  const auto after = std::upper_bound(ranges_.begin(), ranges_.end(), index,
                                      [](std::uint32_t i, const auto& range) { return i < range.first; });
  return after == ranges_.begin() ? none<FileIndex> : std::prev(after)->second;
}

std::vector<std::uint32_t> IdLookup::build(const std::vector<std::int64_t>& ids) {
  lowest_ = 0;
  table_.clear();
  sorted_.clear();
  if (ids.empty()) return {};
  const auto [lowest, highest] = std::minmax_element(ids.begin(), ids.end());
  lowest_ = *lowest;
  // Unsigned, because the difference of two ids may not fit into a signed number.
  const std::uint64_t span = static_cast<std::uint64_t>(*highest) - static_cast<std::uint64_t>(lowest_);
  std::vector<std::uint32_t> duplicates;
  if (span < 4 * static_cast<std::uint64_t>(ids.size()) + 1024) {
    table_.assign(static_cast<std::size_t>(span) + 1, no_position);
    for (std::uint32_t i = 0; i < ids.size(); ++i) {
      std::uint32_t& entry = table_[static_cast<std::size_t>(ids[i] - lowest_)];
      if (entry == no_position)
        entry = i;
      else
        duplicates.push_back(i);
    }
    return duplicates;
  }
  sorted_.reserve(ids.size());
  for (std::uint32_t i = 0; i < ids.size(); ++i) sorted_.emplace_back(ids[i], i);
  if (!std::is_sorted(sorted_.begin(), sorted_.end())) std::sort(sorted_.begin(), sorted_.end());
  const auto kept = std::unique(sorted_.begin(), sorted_.end(), [&](const auto& a, const auto& b) {
    if (a.first != b.first) return false;
    duplicates.push_back(b.second);
    return true;
  });
  sorted_.erase(kept, sorted_.end());
  std::sort(duplicates.begin(), duplicates.end());
  return duplicates;
}

}  // namespace gapcheck::model
