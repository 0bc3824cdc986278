#include <cmath>

#include "solver/material/material.hpp"

namespace gapcheck::solver {
namespace {

/// The trial stress taken apart; each part shrinks with its own stiffness: value / (1 + stiffness t), t = Δε̄ / q.
struct Parts {
  double pressure, squared_shear, squared_transverse;  ///< (σxx + σyy) / 2; ((σxx − σyy) / 2)² + σxy²; σyz² + σzx²
  double pressure_weight, shear_weight;                ///< q² = weight pressure² + weight shear² + 3 transverse²
  double pressure_stiffness, shear_stiffness, transverse_stiffness;

  [[nodiscard]] double size(double t) const {
    const double p = pressure / (1 + pressure_stiffness * t);
    const double s = 1 + shear_stiffness * t, r = 1 + transverse_stiffness * t;
    return std::sqrt(pressure_weight * p * p + shear_weight * squared_shear / (s * s) +
                     3 * squared_transverse / (r * r));
  }
};

Parts take_apart(const Material& material, const Symmetric& trial) {
  const double ratio = material.anisotropy, half = (trial[xx] - trial[yy]) / 2;
  Parts parts{};
  parts.pressure = (trial[xx] + trial[yy]) / 2;
  parts.squared_shear = half * half + trial[xy] * trial[xy];
  parts.squared_transverse = trial[yz] * trial[yz] + trial[zx] * trial[zx];
  parts.pressure_weight = 2 / (1 + ratio);
  parts.shear_weight = 2 * (1 + 2 * ratio) / (1 + ratio);
  parts.pressure_stiffness = material.young / (2 * (1 - material.poisson)) * parts.pressure_weight;
  parts.shear_stiffness = material.shear() * parts.shear_weight;
  parts.transverse_stiffness = 3 * material.shear();
  return parts;
}

/// t with q(t) = σ(ε̄ + t q(t)). q falls with t and t q rises, so there is one crossing where the curve does not fall.
double solve_return(const Parts& parts, const YieldCurve& yield, double plastic_strain) {
  const auto excess = [&](double t) {
    const double size = parts.size(t);
    return size - yield.stress(plastic_strain + t * size);
  };
  constexpr int most_doublings = 200, most_halvings = 200;
  double low = 0, high = 1e-3 / parts.shear_stiffness;
  for (int i = 0; i < most_doublings && excess(high) > 0; ++i) {
    low = high;
    high *= 2;
  }
  // Secant steps, halved where they leave the bracket or shorten it too little (Illinois).
  double f_low = excess(low), f_high = excess(high);
  const double tolerance = 1e-15 * parts.size(0);
  for (int i = 0; i < most_halvings && high - low > 1e-16 * high; ++i) {
    const double secant = low + (high - low) * f_low / (f_low - f_high);
    const double t = i % 3 != 2 && secant > low && secant < high ? secant : (low + high) / 2;
    const double f = excess(t);
    if (std::abs(f) <= tolerance) return t;
    (f > 0 ? low : high) = t;
    (f > 0 ? f_low : f_high) = f;
  }
  return (low + high) / 2;
}

}  // namespace

double update_anisotropic_plane_stress(const Material& material, const Symmetric& increment, PointState& point) {
  const double plate = material.plate_modulus(), nu = material.poisson, two_shear = 2 * material.shear();
  const Symmetric start = point.stress;
  Symmetric& stress = point.stress;
  stress[xx] += plate * (increment[xx] + nu * increment[yy]);
  stress[yy] += plate * (increment[yy] + nu * increment[xx]);
  stress[zz] = 0;
  for (const std::size_t i : {xy, yz, zx}) stress[i] += two_shear * increment[i];
  const Parts parts = take_apart(material, stress);
  double plastic = 0;  // εxx + εyy
  if (parts.size(0) > material.yield.stress(point.plastic_strain)) {
    const double t = solve_return(parts, material.yield, point.plastic_strain);
    const double pressure = parts.pressure / (1 + parts.pressure_stiffness * t);
    const double shear = 1 / (1 + parts.shear_stiffness * t), half = (stress[xx] - stress[yy]) / 2 * shear;
    stress[xx] = pressure + half;
    stress[yy] = pressure - half;
    stress[xy] *= shear;
    for (const std::size_t i : {yz, zx}) stress[i] /= 1 + parts.transverse_stiffness * t;
    point.plastic_strain += t * parts.size(t);
    plastic = t * parts.pressure_weight * pressure;
    // t ∂(q²/2)/∂σ is the plastic strain; as in the isotropic law the mean stress of the step works on it.
    const double mean = (start[xx] + start[yy]) / 4 + pressure / 2, mean_half = (start[xx] - start[yy]) / 4 + half / 2;
    point.plastic_work += t * (parts.pressure_weight * mean * pressure +
                               parts.shear_weight * (mean_half * half + (start[xy] + stress[xy]) / 2 * stress[xy]) +
                               1.5 * ((start[yz] + stress[yz]) * stress[yz] + (start[zx] + stress[zx]) * stress[zx]));
  }
  return -nu / material.young * (stress[xx] + stress[yy] - start[xx] - start[yy]) - plastic;
}

}  // namespace gapcheck::solver
