#pragma once
#include <array>
#include <vector>

#include "model/model.hpp"

namespace gapcheck::solver {

/// The points of a curve as material models see it: LS-DYNA replaces them by LCINT ones with equal distances over the
/// same range, at least 100, from LCINT of the curve or of *CONTROL_SOLUTION (Keyword User's Manual, Vol. I,
/// *CONTROL_SOLUTION and *DEFINE_CURVE). A curve of two points, or whose abscissas do not rise, stays as it is, and so
/// do curves over time.
[[nodiscard]] std::vector<std::array<double, 2>> material_points(const model::Model& model, const model::Curve& curve);

}  // namespace gapcheck::solver
