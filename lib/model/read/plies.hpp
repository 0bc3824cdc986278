#pragma once
#include <vector>

#include "model/entity/part.hpp"
#include "model/read/cards.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {

/// A line of two plies: material, thickness, angle and a field that is not used, then the same again.
[[nodiscard]] const CardLayout& ply_line();

/// The plies of one composite element, thicknesses as written, and their sum.
struct ElementPlies {
  std::vector<Ply> plies;
  double thickness = 0;
};

/// Reads the plies of one composite element: the lines up to the next element's line (split by `element`) or to the
/// end. A ply starts with a material id in ten columns, an element with five ids of eight columns each; a line is an
/// element if all five are positive whole numbers. Blank lines are skipped.
[[nodiscard]] ElementPlies read_plies(CardReader& reader, const CardLayout& element, bool one_per_line);

}  // namespace gapcheck::model
