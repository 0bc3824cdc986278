#pragma once
#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {

/// Sums the plies of one composite element: the lines up to the next element's line (split by `element`) or to the end.
/// A ply starts with a material id in ten columns, an element with five ids of eight columns each; a line is an element
/// if all five are positive whole numbers. Blank lines are skipped.
[[nodiscard]] double read_plies(CardReader& reader, const CardLayout& element, bool one_per_line);

}  // namespace gapcheck::model
