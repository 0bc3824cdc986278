#pragma once
#include <array>
#include <variant>
#include <vector>

namespace gapcheck::solver {

/// Pressure p = A + B E at a relative volume V, with the slopes of A and B over μ = 1/V − 1. E: internal energy per
/// reference volume. All equations of state here are linear in E.
struct PressureLine {
  double cold = 0, thermal = 0;              ///< A, B
  double cold_slope = 0, thermal_slope = 0;  ///< over μ
  double steepest = 0;  ///< slope of A that a step from here may meet: that of the next piece of a table
  [[nodiscard]] double pressure(double energy) const { return cold + thermal * energy; }
};

/// 001: p = C0 + C1 μ + C2 μ² + C3 μ³ + (C4 + C5 μ + C6 μ²) E; C2 and C6 count in compression only.
struct LinearPolynomial {
  std::array<double, 7> c{};
  [[nodiscard]] PressureLine at(double volume) const;
};

/// 004, Mie and Grüneisen with a cubic shock velocity (theory manual, equations of state): in compression
/// p = ρ₀ C² μ [1 + (1 − γ₀/2) μ − a/2 μ²] / [1 − (S1 − 1) μ − S2 μ²/(μ + 1) − S3 μ³/(μ + 1)²]² + (γ₀ + a μ) E,
/// otherwise ρ₀ C² μ + (γ₀ + a μ) E.
struct Gruneisen {
  double stiffness = 0;  ///< ρ₀ C²
  double s1 = 0, s2 = 0, s3 = 0, gamma = 0, a = 0;
  /// Beyond the pole of the shock velocity there is no pressure: infinity.
  [[nodiscard]] PressureLine at(double volume) const;
};

/// 009: p = C(ln V) + γ T(ln V) E, linear between the points and beyond them.
struct PressureTable {
  struct Row {
    double strain, cold, thermal;  ///< ln V, C, T
  };
  std::vector<Row> rows;  ///< strains rise; two or more
  double gamma = 0;
  [[nodiscard]] PressureLine at(double volume) const;
};

struct EquationOfState {
  std::variant<LinearPolynomial, Gruneisen, PressureTable> law;
  double initial_energy = 0;  ///< E0

  [[nodiscard]] PressureLine at(double volume) const;
  /// (1 + μ) dp/dμ along an isentrope, dE = −p dV: (1 + μ) (∂p/∂μ + p V² ∂p/∂E).
  [[nodiscard]] double bulk(double volume, double energy) const;
  /// The same with the steepest slope nearby, for bounds.
  [[nodiscard]] double bulk_bound(double volume, double energy) const;
};

}  // namespace gapcheck::solver
