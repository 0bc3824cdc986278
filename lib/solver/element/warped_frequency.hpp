#pragma once
#include <array>

namespace gapcheck::solver {

struct FullFrame;
struct ShellProperties;

/// A sharp upper bound of the highest frequency of one warped quad with four points: the sixteenth root of Σ λ¹⁶ over
/// the eigenvalues λ of its stiffness over its mass, so at most 18 % above the largest of the 14 that are not zero. As
/// that costs seven times what the forces do, it is kept while the shape changes by no more than its margin covers.
class WarpedFrequency {
 public:
  /// The square, 1/s² in consistent units. Of elastic stiffness; isotropic materials exactly, others by a bound of
  /// their moduli.
  [[nodiscard]] double squared(const ShellProperties& properties, const FullFrame& frame, double thickness);

 private:
  std::array<float, 8> shape_{};  ///< coefficients of the positions, thickness
  double squared_ = 0;            ///< 0: there is none yet
};

}  // namespace gapcheck::solver
