#include "solver/material/principal_law.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

constexpr double one_third = 1.0 / 3.0;

/// I − 1 1ᵀ / 3: takes the mean out.
Matrix shape_projection() { return Matrix::Identity() - Matrix::Constant(one_third); }

/// Larger eigenvalue of (a c; c b).
double larger_eigenvalue(double a, double b, double c) { return (a + b) / 2 + std::hypot((a - b) / 2, c); }

}  // namespace

PrincipalResponse PrincipalLaw::volume(const Vector&) const { return {}; }

bool PrincipalLaw::tears(const Vector&) const { return false; }

StretchFunction StretchFunction::terms(std::vector<std::array<double, 2>> mu_alpha) {
  StretchFunction f;
  f.terms_ = std::move(mu_alpha);
  return f;
}

StretchFunction StretchFunction::table(double reach, std::vector<double> values) {
  StretchFunction f;
  f.values_ = std::move(values);
  const std::size_t count = f.values_.size(), middle = count / 2;
  f.start_ = -reach;
  f.spacing_ = 2 * reach / static_cast<double>(count - 1);
  f.integrals_.assign(count, 0);
  for (std::size_t i = middle + 1; i < count; ++i)
    f.integrals_[i] = f.integrals_[i - 1] + f.spacing_ / 2 * (f.values_[i - 1] + f.values_[i]);
  for (std::size_t i = middle; i > 0; --i)
    f.integrals_[i - 1] = f.integrals_[i] - f.spacing_ / 2 * (f.values_[i - 1] + f.values_[i]);
  return f;
}

double StretchFunction::value(double x) const {
  double sum = 0;
  for (const auto& [mu, alpha] : terms_) sum += mu * std::exp(alpha * x);
  if (values_.empty()) return sum;
  const double place = std::clamp((x - start_) / spacing_, 0.0, static_cast<double>(values_.size()) - 1.5);
  const auto i = static_cast<std::size_t>(place);
  const double along = (x - start_) / spacing_ - static_cast<double>(i);
  return values_[i] + along * (values_[i + 1] - values_[i]);
}

double StretchFunction::integral(double x) const {
  double sum = 0;
  for (const auto& [mu, alpha] : terms_) sum += alpha == 0 ? mu * x : mu / alpha * std::expm1(alpha * x);
  if (values_.empty()) return sum;
  const double place = std::clamp((x - start_) / spacing_, 0.0, static_cast<double>(values_.size()) - 1.5);
  const auto i = static_cast<std::size_t>(place);
  const double along = (x - start_) - static_cast<double>(i) * spacing_;
  return integrals_[i] + along / 2 * (values_[i] + value(x));
}

double StretchFunction::slope(double x) const {
  double sum = 0;
  for (const auto& [mu, alpha] : terms_) sum += mu * alpha * std::exp(alpha * x);
  if (values_.empty()) return sum;
  // A step may cross kinks of the curve that the table came from.
  constexpr std::size_t nearby = 16;
  const double place = std::clamp((x - start_) / spacing_, 0.0, static_cast<double>(values_.size()) - 1.5);
  const auto at = static_cast<std::size_t>(place);
  const std::size_t first = at > nearby ? at - nearby : 0, last = std::min(at + nearby, values_.size() - 2);
  double steepest = (values_[first + 1] - values_[first]) / spacing_;
  for (std::size_t i = first + 1; i <= last; ++i)
    steepest = std::max(steepest, (values_[i + 1] - values_[i]) / spacing_);
  return steepest;
}

PrincipalResponse OgdenLaw::shape(const Vector& x, bool) const {
  PrincipalResponse result;
  Vector slopes;
  for (int i = 0; i < 3; ++i) {
    const double at = x[i] - x.sum() * one_third;
    result.force[i] = f_.value(at);
    slopes[i] = f_.slope(at);
    result.energy += f_.integral(at);
  }
  result.force.array() -= result.force.mean();
  result.slope = shape_projection() * slopes.asDiagonal() * shape_projection();
  return result;
}

PrincipalResponse OgdenLaw::volume(const Vector& x) const {
  const double growth = std::expm1(x.sum());
  return {Vector::Constant(bulk_ * growth), Matrix::Constant(bulk_ * (1 + growth)), bulk_ * (growth - x.sum())};
}

PrincipalResponse HillLaw::shape(const Vector& x, bool) const {
  PrincipalResponse result;
  const double lateral = -n_ * x.sum();
  const double pressure = f_.value(lateral);
  result.energy = f_.integral(lateral) / n_;
  result.slope.setConstant(n_ * f_.slope(lateral));
  for (int i = 0; i < 3; ++i) {
    result.force[i] = f_.value(x[i]) - pressure;
    result.slope(i, i) += f_.slope(x[i]);
    result.energy += f_.integral(x[i]);
  }
  return result;
}

PrincipalResponse InvariantLaw::shape(const Vector& x, bool) const {
  const Vector at = x.array() - x.sum() * one_third;
  const Vector squares = (2 * at).array().exp(), inverses = (-2 * at).array().exp();
  const double i = squares.sum() - 3, j = inverses.sum() - 3;
  const auto& [c10, c01, c11, c20, c02, c30] = c_;
  const double wi = c10 + c11 * j + 2 * c20 * i + 3 * c30 * i * i, wj = c01 + c11 * i + 2 * c02 * j;
  const double wii = 2 * c20 + 6 * c30 * i, wij = c11, wjj = 2 * c02;
  PrincipalResponse result;
  result.energy = c10 * i + c01 * j + c11 * i * j + c20 * i * i + c02 * j * j + c30 * i * i * i;
  const Matrix projection = shape_projection();
  const Vector a = projection * (2 * squares), b = projection * (-2 * inverses);
  result.force = wi * a + wj * b;
  const Vector second = 4 * (wi * squares + wj * inverses);
  result.slope = projection * second.asDiagonal() * projection + wii * a * a.transpose() + wjj * b * b.transpose() +
                 wij * (a * b.transpose() + b * a.transpose());
  return result;
}

PrincipalResponse InvariantLaw::volume(const Vector& x) const {
  const double ratio = std::exp(x.sum()), growth = std::expm1(x.sum());
  return {Vector::Constant(bulk_ * ratio * growth), Matrix::Constant(bulk_ * ratio * (2 * ratio - 1)),
          bulk_ / 2 * growth * growth};
}

LowDensityFoamLaw::LowDensityFoamLaw(std::vector<std::array<double, 2>> points, double young, double cutoff, bool tears)
    : young_(young), cutoff_(cutoff), tears_(tears) {
  points_.push_back({0, 0});
  for (const auto& point : points)
    if (point[0] > 0) points_.push_back(point);
  energies_.assign(1, 0);
  for (std::size_t i = 1; i < points_.size(); ++i)
    energies_.push_back(energies_.back() +
                        (points_[i][0] - points_[i - 1][0]) * (points_[i][1] + points_[i - 1][1]) / 2);
}

std::size_t LowDensityFoamLaw::piece(double compression) const {
  const auto above = std::upper_bound(points_.begin() + 1, points_.end() - 1, compression,
                                      [](double e, const std::array<double, 2>& point) { return e < point[0]; });
  return static_cast<std::size_t>(above - points_.begin());
}

double LowDensityFoamLaw::slope_of(std::size_t piece) const {
  return (points_[piece][1] - points_[piece - 1][1]) / (points_[piece][0] - points_[piece - 1][0]);
}

double LowDensityFoamLaw::stress(double compression) const {
  const std::size_t at = piece(compression);
  return points_[at - 1][1] + slope_of(at) * (compression - points_[at - 1][0]);
}

double LowDensityFoamLaw::energy(double compression) const {
  const std::size_t at = piece(compression);
  return energies_[at - 1] + (compression - points_[at - 1][0]) * (points_[at - 1][1] + stress(compression)) / 2;
}

double LowDensityFoamLaw::steepest(double compression) const {
  constexpr double reach = 0.03;
  double slope = compression < reach ? young_ : 0;
  const std::size_t last = piece(std::max(compression + reach, 0.0));
  for (std::size_t at = piece(std::max(compression - reach, 0.0)); at <= last; ++at)
    slope = std::max(slope, slope_of(at));
  return slope;
}

PrincipalResponse LowDensityFoamLaw::shape(const Vector& x, bool torn) const {
  PrincipalResponse result;
  for (int i = 0; i < 3; ++i) {
    const double strain = std::expm1(x[i]), stretch = 1 + strain;
    double nominal = 0, slope = steepest(-strain);
    if (strain <= 0) {
      nominal = -stress(-strain);
      result.energy += energy(-strain);
    } else if (!torn) {
      const double yields = cutoff_ / young_;
      nominal = young_ * std::min(strain, yields);
      const double elastic = std::min(strain, yields);
      result.energy += young_ * elastic * elastic / 2 + cutoff_ * std::max(strain - yields, 0.0);
    }
    result.force[i] = stretch * nominal;
    result.slope(i, i) = stretch * nominal + stretch * stretch * slope;
  }
  return result;
}

bool LowDensityFoamLaw::tears(const Vector& x) const { return tears_ && young_ * std::expm1(x.maxCoeff()) > cutoff_; }

double principal_stiffness_bound(const Vector& x, const PrincipalResponse& response) {
  // Stretches along the axes: ∂²W/∂x² − diag ∂W/∂x.
  const Vector& force = response.force;
  const Matrix& slope = response.slope;
  Matrix stretching = slope;
  stretching.diagonal() -= force;
  double bound = stretching.cwiseAbs().rowwise().sum().maxCoeff();
  // Shears and turns in each plane of two axes (Ogden, Non-linear elastic deformations, 1984, section 6.1.4).
  constexpr double equal = 1e-5;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double a = std::exp(2 * x[i]), b = std::exp(2 * x[j]);
    const double quotient = std::abs(x[i] - x[j]) > equal
                                ? (force[i] - force[j]) / (a - b)
                                : (slope(i, i) + slope(j, j) - 2 * slope(i, j)) / (2 * (a + b));
    bound = std::max(bound, larger_eigenvalue(quotient * a, quotient * b, quotient * a - force[i]));
  }
  return bound;
}

}  // namespace gapcheck::solver
