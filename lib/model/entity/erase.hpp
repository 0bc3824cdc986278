#pragma once
#include <cstdint>
#include <vector>

#include "model/entity/mesh.hpp"

namespace gapcheck::model {

/// Removes the entries at the given positions (ascending) from a column; the others keep their order.
template <class Value>
void erase_column(const std::vector<std::uint32_t>& positions, std::vector<Value>& column) {
  std::size_t next = 0, kept = 0;
  for (std::size_t i = 0; i < column.size(); ++i) {
    if (next < positions.size() && positions[next] == i) {
      ++next;
      continue;
    }
    if (kept != i) column[kept] = std::move(column[i]);
    ++kept;
  }
  column.resize(kept);
}

/// The same for all columns of a table together with the files of its entries.
template <class Ids, class... Columns>
void erase_positions(const std::vector<std::uint32_t>& positions, Origins& origins, Ids& ids, Columns&... columns) {
  if (positions.empty()) return;
  Origins kept;
  FileIndex last = none<FileIndex>;
  std::uint32_t place = 0;
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < ids.size(); ++i) {
    if (next < positions.size() && positions[next] == i) {
      ++next;
      continue;
    }
    const FileIndex file = origins.file(i);
    if (file != last || place == 0) kept.add(place, last = file);
    ++place;
  }
  origins = std::move(kept);
  erase_column(positions, ids);
  (erase_column(positions, columns), ...);
}

/// The new position of the entry at `position` after the given positions (ascending) were removed.
[[nodiscard]] inline std::uint32_t position_after(const std::vector<std::uint32_t>& erased, std::uint32_t position) {
  const auto before = std::lower_bound(erased.begin(), erased.end(), position) - erased.begin();
  return position - static_cast<std::uint32_t>(before);
}

}  // namespace gapcheck::model
