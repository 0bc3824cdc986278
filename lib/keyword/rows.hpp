#pragma once
#include <cstdint>
#include <vector>

#include "keyword/card.hpp"

namespace gapcheck::keyword {

/// The rows of a block that holds one card again and again, as columns of numbers.
struct Rows {
  std::size_t count = 0;
  std::size_t integer_columns = 0, real_columns = 0;
  std::vector<std::int64_t> integers;  ///< count x integer_columns, row by row; blank = 0
  std::vector<double> reals;           ///< count x real_columns, row by row; blank = 0
  std::vector<std::uint32_t> lines;    ///< count
};

/// Reads all rows of a block in parallel: its integer fields in layout order, then its real fields; text fields are not
/// allowed. Handles all formats, comments, parameters and id offsets; blank lines are passed over. The result does not
/// depend on the number of threads.
Rows read_rows(const Deck& deck, const Block& block, const CardLayout& layout, Diagnostics& diagnostics);

}  // namespace gapcheck::keyword
