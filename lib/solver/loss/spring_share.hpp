#pragma once
#include <span>

#include "solver/loss/judge_impacts.hpp"

namespace gapcheck::solver {

/// (Step times frequency)² of the springs of impacts along a normal, at most: the rows of M⁻¹ K. Each spring pushes a
/// node, and the corners as much together.
[[nodiscard]] double share_of_springs(const ImpactScene& scene, std::span<const Impact* const> impacts,
                                      const Vector& normal);

}  // namespace gapcheck::solver
