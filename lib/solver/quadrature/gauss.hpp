#pragma once
#include <vector>

namespace gapcheck::solver {

/// A point of a rule on [−1, 1].
struct GaussPoint {
  double place, weight;
};

/// Gauss–Legendre rule with 1 … 10 points (other counts are moved into that range), places ascending; exact for
/// polynomials of degree 2 n − 1.
[[nodiscard]] std::vector<GaussPoint> gauss_rule(int points);

/// Gauss–Lobatto rule with 3 … 10 points, both ends among them; exact for polynomials of degree 2 n − 3. With one or
/// two points Gauss's rule.
[[nodiscard]] std::vector<GaussPoint> lobatto_rule(int points);

}  // namespace gapcheck::solver
