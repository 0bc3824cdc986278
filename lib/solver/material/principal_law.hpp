#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// What an isotropic hyperelastic law W(x) gives for the logarithms x of the principal stretches, per undeformed
/// volume.
struct PrincipalResponse {
  Vector force = Vector::Zero();  ///< ∂W/∂x: principal Kirchhoff stresses
  Matrix slope = Matrix::Zero();  ///< ∂²W/∂x²; of curves with the steepest piece nearby, so that it bounds a step
  double energy = 0;              ///< W
};

/// A law in principal stretches, split into a part that hysteresis weakens and one that it leaves alone.
class PrincipalLaw {
 public:
  PrincipalLaw() = default;
  PrincipalLaw(const PrincipalLaw&) = delete;
  PrincipalLaw& operator=(const PrincipalLaw&) = delete;
  virtual ~PrincipalLaw() = default;
  /// Of foams the whole law, of rubber the part at constant volume. `torn`: there is no tension any more.
  [[nodiscard]] virtual PrincipalResponse shape(const Vector& x, bool torn) const = 0;
  /// Of rubber the part of the volume alone.
  [[nodiscard]] virtual PrincipalResponse volume(const Vector& x) const;
  /// The tension has reached its limit, after which there is none.
  [[nodiscard]] virtual bool tears(const Vector& x) const;
};

/// A function of x = ln λ with its integral from 0 and its slope.
class StretchFunction {
 public:
  /// Σ μ λ^α.
  static StretchFunction terms(std::vector<std::array<double, 2>> mu_alpha);
  /// Values at evenly spaced x from −`reach` to `reach`, an odd number of them; linear in x between and beyond them.
  static StretchFunction table(double reach, std::vector<double> values);
  [[nodiscard]] double value(double x) const;
  [[nodiscard]] double integral(double x) const;
  [[nodiscard]] double slope(double x) const;

 private:
  std::vector<std::array<double, 2>> terms_;
  double start_ = 0, spacing_ = 1;
  std::vector<double> values_, integrals_;
};

/// Ogden's rubber (Proc. R. Soc. A 326, 1972): W = Σ ∫ f(x*) dx* + K (J − 1 − ln J), x* = x − ln J / 3.
class OgdenLaw : public PrincipalLaw {
 public:
  OgdenLaw(StretchFunction f, double bulk) : f_(std::move(f)), bulk_(bulk) {}
  [[nodiscard]] PrincipalResponse shape(const Vector& x, bool torn) const override;
  [[nodiscard]] PrincipalResponse volume(const Vector& x) const override;

 private:
  StretchFunction f_;
  double bulk_;
};

/// Hill's foam (Adv. Appl. Mech. 18, 1978) in the form of Storåkers (J. Mech. Phys. Solids 34, 1986):
/// W = Σ w(x) + w(−n ln J) / n, w = ∫ f dx, n = ν / (1 − 2ν). With f = G λ² it is the rubber of Blatz and Ko (Trans.
/// Soc. Rheol. 6, 1962).
class HillLaw : public PrincipalLaw {
 public:
  /// 0 < ν < ½.
  HillLaw(StretchFunction f, double poisson) : f_(std::move(f)), n_(poisson / (1 - 2 * poisson)) {}
  [[nodiscard]] PrincipalResponse shape(const Vector& x, bool torn) const override;

 private:
  StretchFunction f_;
  double n_;
};

/// Rubber by invariants of the shape (Rivlin): W = Σ C_pq (J₁ − 3)^p (J₂ − 3)^q + ½ K (J − 1)²,
/// J₁ = I₁ J^(−2/3), J₂ = I₂ J^(−4/3).
class InvariantLaw : public PrincipalLaw {
 public:
  /// C10, C01, C11, C20, C02, C30.
  InvariantLaw(const std::array<double, 6>& c, double bulk) : c_(c), bulk_(bulk) {}
  [[nodiscard]] PrincipalResponse shape(const Vector& x, bool torn) const override;
  [[nodiscard]] PrincipalResponse volume(const Vector& x) const override;

 private:
  std::array<double, 6> c_;
  double bulk_;
};

/// Foam without coupling of its principal directions, material 057: nominal stresses by a curve over 1 − λ in
/// compression, E (λ − 1) up to a cutoff in tension.
class LowDensityFoamLaw : public PrincipalLaw {
 public:
  /// `points`: strain and stress in compression, strains rise, two or more; the end slopes continue. They hold (0, 0).
  LowDensityFoamLaw(std::vector<std::array<double, 2>> points, double young, double cutoff, bool tears);
  [[nodiscard]] PrincipalResponse shape(const Vector& x, bool torn) const override;
  [[nodiscard]] bool tears(const Vector& x) const override;
  /// Nominal stress of a compression 1 − λ > 0.
  [[nodiscard]] double stress(double compression) const;

 private:
  /// The piece that a compression is in, from 1.
  [[nodiscard]] std::size_t piece(double compression) const;
  [[nodiscard]] double slope_of(std::size_t piece) const;
  [[nodiscard]] double energy(double compression) const;
  /// The steepest piece within a few percent of strain.
  [[nodiscard]] double steepest(double compression) const;
  std::vector<std::array<double, 2>> points_;  ///< from (0, 0)
  std::vector<double> energies_;               ///< at the points
  double young_, cutoff_;
  bool tears_;
};

/// f of a law whose uniaxial nominal stress is `nominal` (after Kolling, Du Bois, Benson and Feng, Comput. Mech. 40,
/// 2007): λ σ₀(λ) = f(λ) − f(λ^−ν), so f(λ) = Σ λₖ σ₀(λₖ), λₖ = λ^((−ν)^k); ν = ½ for rubber. `nominal`: of a strain λ
/// − 1.
template <class Nominal>
StretchFunction tabulated_stretch(const Nominal& nominal, double poisson);

/// The largest second derivative of W over ε where F grows to (1 + ε g) F per squared norm of g, from above: of a law's
/// response with principal stretches exp(x).
[[nodiscard]] double principal_stiffness_bound(const Vector& x, const PrincipalResponse& response);

template <class Nominal>
StretchFunction tabulated_stretch(const Nominal& nominal, double poisson) {
  constexpr double reach = 3;  // stretches from 1/20 to 20
  constexpr std::size_t count = 2401;
  constexpr double negligible = 1e-17;
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    double x = reach * (2 * static_cast<double>(i) / (count - 1) - 1);
    for (; std::abs(x) > negligible; x *= -poisson) values[i] += std::exp(x) * nominal(std::expm1(x));
  }
  return StretchFunction::table(reach, std::move(values));
}

}  // namespace gapcheck::solver
