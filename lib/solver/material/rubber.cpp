#include "solver/material/rubber.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

/// b = F Fᵀ, its first invariant and J = det F.
struct Stretch {
  Matrix b;
  double first, volume;
  explicit Stretch(const Matrix& f) : b(f * f.transpose()), first(b.trace()), volume(f.determinant()) {}
};

/// Largest eigenvalue of a symmetric matrix, from above.
double row_bound(const Matrix& m) { return m.cwiseAbs().rowwise().sum().maxCoeff(); }

}  // namespace

Rubber mooney_rivlin(double a, double b, double poisson) {
  return {a, b, a / 2 + b, (a * (5 * poisson - 2) + b * (11 * poisson - 5)) / (2 * (1 - 2 * poisson))};
}

Symmetric rubber_stress(const Rubber& rubber, const Matrix& f) {
  const Stretch s(f);
  const double third = s.volume * s.volume;
  const double pressure = -4 * rubber.c / (third * third) + 4 * rubber.d * (third - 1) * third;
  const Matrix stress = 2 * rubber.a * s.b + 2 * rubber.b * (s.first * s.b - s.b * s.b) + pressure * Matrix::Identity();
  return to_symmetric(stress / s.volume);
}

double rubber_energy(const Rubber& rubber, const Matrix& f) {
  const Stretch s(f);
  const double second = (s.first * s.first - s.b.squaredNorm()) / 2, third = s.volume * s.volume;
  return rubber.a * (s.first - 3) + rubber.b * (second - 3) + rubber.c * (1 / (third * third) - 1) +
         rubber.d * (third - 1) * (third - 1);
}

double rubber_stiffness_bound(const Rubber& rubber, const Matrix& f) {
  const Stretch s(f);
  const double second = (s.first * s.first - s.b.squaredNorm()) / 2, third = s.volume * s.volume;
  const Matrix cofactor = s.b * s.b - s.first * s.b + second * Matrix::Identity();
  // I₁ and I₂ are squared norms of F and of its cofactor, which change by g F, and by (tr g − gᵀ) cof F and cof g cof
  // F: |tr g − gᵀ| <= 2 |g|, and the sum of the singular values of cof g is at most |g|².
  const double shape = 2 * std::abs(rubber.a) * row_bound(s.b) + 12 * std::abs(rubber.b) * row_bound(cofactor);
  // The part U of J: J² U″ (tr g)² + J U′ ((tr g)² − tr g²), where (tr g)² <= 3 |g|².
  const double slope = -4 * rubber.c / (third * third) + 4 * rubber.d * third * (third - 1);
  const double curvature = 20 * rubber.c / (third * third) + rubber.d * third * (12 * third - 4);
  return shape + 3 * std::max(curvature, 0.0) + 2 * std::abs(slope);
}

}  // namespace gapcheck::solver
