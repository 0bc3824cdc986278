#pragma once
#include <array>

#include "solver/element/full/shell_full_frame.hpp"

namespace gapcheck::solver {

/// The fields that the membrane stress may have besides a constant: one that is linear in η along xi, one that is
/// linear in ξ along eta (Pian and Sumihara 1984), and the strains that an elastic shell has under them.
class MembraneModes {
 public:
  MembraneModes(const FullFrame& frame, double poisson)
      : weight_(frame.determinant / frame.area),
        place_{point_eta - (weight_ * point_eta).sum(), point_xi - (weight_ * point_xi).sum()} {
    const std::array<Vector, 2> direction{frame.x.xi, frame.x.eta};
    for (std::size_t i = 0; i < 2; ++i) {
      const double x = direction[i].x(), y = direction[i].y();
      stress_[i] = {x * x, y * y, x * y};
      strain_[i] = {x * x - poisson * y * y, y * y - poisson * x * x, 2 * (1 + poisson) * x * y};
    }
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j)
        gram_[i][j] = (weight_ * place_[i] * place_[j]).sum() *
                      (stress_[i][0] * strain_[j][0] + stress_[i][1] * strain_[j][1] + stress_[i][2] * strain_[j][2]);
  }

  /// The mean strain, and the modes' share in the rest.
  [[nodiscard]] PlaneTensor assumed(const PlaneTensor& strain) const {
    const std::array<double, 2> share = solve(products(strain, stress_));
    PlaneTensor result = means(strain);
    add(result, strain_, share);
    return result;
  }
  /// The transpose, for stresses: the work that they do in assumed() is that of the result in the strain itself.
  [[nodiscard]] PlaneTensor transposed(const PlaneTensor& stress) const {
    const std::array<double, 2> share = solve(products(stress, strain_));
    PlaneTensor result = means(stress);
    add(result, stress_, share);
    return result;
  }

 private:
  using Components = std::array<double, 3>;

  [[nodiscard]] std::array<double, 2> products(const PlaneTensor& a, const std::array<Components, 2>& mode) const {
    std::array<double, 2> result;
    for (std::size_t i = 0; i < 2; ++i)
      result[i] = (weight_ * place_[i] * (mode[i][0] * a.xx + mode[i][1] * a.yy + mode[i][2] * a.xy)).sum();
    return result;
  }
  [[nodiscard]] std::array<double, 2> solve(const std::array<double, 2>& right) const {
    const double determinant = gram_[0][0] * gram_[1][1] - gram_[0][1] * gram_[1][0];
    return {(gram_[1][1] * right[0] - gram_[0][1] * right[1]) / determinant,
            (gram_[0][0] * right[1] - gram_[1][0] * right[0]) / determinant};
  }
  [[nodiscard]] PlaneTensor means(const PlaneTensor& a) const {
    const auto mean = [&](const Four& f) { return Four(Four::Constant((weight_ * f).sum())); };
    return {mean(a.xx), mean(a.yy), mean(a.xy)};
  }
  void add(PlaneTensor& sum, const std::array<Components, 2>& mode, const std::array<double, 2>& share) const {
    for (std::size_t i = 0; i < 2; ++i) {
      sum.xx += share[i] * mode[i][0] * place_[i];
      sum.yy += share[i] * mode[i][1] * place_[i];
      sum.xy += share[i] * mode[i][2] * place_[i];
    }
  }

  Four weight_;                ///< share of the area
  std::array<Four, 2> place_;  ///< η and ξ less their means
  std::array<Components, 2> stress_, strain_;
  std::array<std::array<double, 2>, 2> gram_;
};

}  // namespace gapcheck::solver
