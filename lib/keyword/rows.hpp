#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "keyword/card.hpp"
#include "keyword/text/kept_rows.hpp"

namespace gapcheck::keyword {

/// Called with the number of rows before any is read.
using MakeRoom = std::function<void(std::size_t count)>;
/// Called with some rows, starting at row `first` of the block. The arrays may be longer than `count`.
using TakeRows = std::function<void(std::size_t first, const Rows& rows)>;

/// Reads all rows of a block without holding them all at once: `make_room` is called once, then `take` for every piece,
/// in any order and from several threads at a time. Otherwise like read_rows().
void read_rows_in_pieces(const Deck& deck, const Block& block, const CardLayout& layout, Diagnostics& diagnostics,
                         const MakeRoom& make_room, const TakeRows& take);

/// Reads all rows of a block in parallel: its integer fields in layout order, then its real fields; text fields are not
/// allowed. Handles all formats, comments, parameters and id offsets; blank lines are skipped. The result does not
/// depend on the number of threads.
Rows read_rows(const Deck& deck, const Block& block, const CardLayout& layout, Diagnostics& diagnostics);

}  // namespace gapcheck::keyword
