#include "keyword/text/kept_rows.hpp"

#include <utility>

namespace gapcheck::keyword {

const RowTable* KeptRows::find(const Key& key) {
  const auto found = tables_.find(key);
  if (found == tables_.end()) return nullptr;
  ++used_;
  return &found->second;
}

void KeptRows::keep(Key key, RowTable table) {
  if (!keeps()) return;
  std::uint64_t bytes = 0;
  for (const RowTable::Piece& piece : table.pieces) {
    const Rows& rows = *piece.rows;
    bytes += rows.integers.size() * sizeof rows.integers[0] + rows.reals.size() * sizeof rows.reals[0] +
             rows.lines.size() * sizeof rows.lines[0];
  }
  if (bytes > *left_) return;
  *left_ -= bytes;
  tables_.insert_or_assign(std::move(key), std::move(table));
}

}  // namespace gapcheck::keyword
