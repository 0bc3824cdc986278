#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gapcheck::solver {

/// Yield stress after Johnson and Cook (7th International Symposium on Ballistics, 1983), materials 015 and 098:
/// σ = min[min(A + B ε̄ⁿ, SIGMAX) (1 + C ln ε̇*), SIGSAT] (1 − T*ᵐ), ε̇* = ε̇ / EPSO, T* = (T − TR) / (TM − TR); and their
/// strain at failure (Engng Fract. Mech. 21, 1985). Rates below EPSO count as EPSO. Plastic work heats without loss.
struct JohnsonCook {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double a = 0, b = 0, n = 1, c = 0, rate = 1;  ///< rate: EPSO
  double most_stress = none, saturation = none;
  double m = 1, warming = none;  ///< TM − TR
  double heat = 0;               ///< ρ CP; 0: the temperature stays
  std::array<double, 5> d{};     ///< D1 … D5
  double least_failure = 0;      ///< EFMIN
  bool fails = false;            ///< by D1 … D5

  /// 1 + C ln ε̇*.
  [[nodiscard]] double rate_factor(double of) const { return 1 + c * std::log(std::max(of / rate, 1.0)); }
  /// T* after plastic work (per volume) since the start, at most 1.
  [[nodiscard]] double warmth(double plastic_work) const {
    return heat > 0 ? std::clamp(plastic_work / heat / warming, 0.0, 1.0) : 0;
  }
  /// 1 − T*ᵐ.
  [[nodiscard]] double softening(double warmth_now) const { return warmth_now > 0 ? 1 - std::pow(warmth_now, m) : 1; }
  /// Without softening.
  [[nodiscard]] double stress(double plastic_strain, double of_rate) const {
    const double still = std::min(a + (b != 0 ? b * std::pow(plastic_strain, n) : 0), most_stress);
    return std::min(still * rate_factor(of_rate), saturation);
  }
  /// [D1 + D2 exp(D3 σ*)] [1 + D4 ln ε̇*] [1 + D5 T*], not below EFMIN; σ*: mean stress, tension positive, over von
  /// Mises.
  [[nodiscard]] double failure_strain(double ratio, double of_rate, double warmth_now) const {
    const double strain = (d[0] + d[1] * std::exp(d[2] * ratio)) *
                          (1 + d[3] * std::log(std::max(of_rate / rate, 1.0))) * (1 + d[4] * warmth_now);
    return std::max(strain, least_failure);
  }
};

}  // namespace gapcheck::solver
