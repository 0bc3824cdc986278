#include "solver/element/warped_frequency.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "solver/element/full/shell_full_strains.hpp"
#include "solver/element/plate_roots.hpp"

namespace gapcheck::solver {
namespace {

/// What the shape may change by, in heights of the quad at its narrowest point, and by how much the squared frequency
/// then grows at most.
constexpr double kept_change = 0.01, kept_growth = 1.05;

/// Motions: nine coefficients of v that strain, and two rates of the normal at each corner. Strains: eight at each
/// point.
constexpr int motion_count = 17, strain_count = 32;
using ModeStrains = Eigen::Matrix<double, strain_count, motion_count>;
using ModeEnergies = Eigen::Matrix<double, motion_count, motion_count>;

/// Factors on the strains whose squares add up to twice the energy per mass.
struct Moduli {
  PlateRoots plate;
  double bending, shear, shift;

  Moduli(const ShellProperties& properties, double thickness)
      : plate(properties),
        bending(thickness / std::sqrt(12)),
        shear(std::sqrt(properties.stiffest * properties.shear_factor * properties.material.shear() /
                        properties.material.density)),
        shift(thickness / 2 * properties.reference) {}
};

/// One column: what a motion strains, in roots of energy.
void set_column(const FullFrame& frame, const Moduli& moduli, const FullStrains& rates, double scale, ModeStrains& all,
                int column) {
  const Four weight = scale * (frame.determinant / frame.area).sqrt();
  const auto put = [&](int row, const Four& value) { all.col(column).segment<4>(4 * row) = (weight * value).matrix(); };
  const PlaneTensor &e = rates.membrane, &k = rates.bending;
  const double shift = moduli.shift;
  put(0, moduli.plate.sum * (e.xx + e.yy - shift * (k.xx + k.yy)));
  put(1, moduli.plate.difference * (e.xx - e.yy - shift * (k.xx - k.yy)));
  put(2, moduli.plate.difference * (e.xy - shift * k.xy));
  put(3, moduli.bending * moduli.plate.sum * (k.xx + k.yy));
  put(4, moduli.bending * moduli.plate.difference * (k.xx - k.yy));
  put(5, moduli.bending * moduli.plate.difference * k.xy);
  put(6, moduli.shear * rates.zx);
  put(7, moduli.shear * rates.yz);
}

/// Strains of all motions of which each has the kinetic energy of a quarter of the mass.
ModeStrains strains_of_motions(const ShellProperties& properties, const FullFrame& frame, double thickness) {
  const Moduli moduli(properties, thickness);
  const MembraneModes modes(frame, properties.material.poisson);
  const Bilinear rest{Vector::Zero(), Vector::Zero(), Vector::Zero(), Vector::Zero()};
  ModeStrains all;
  int column = 0;
  for (Vector Bilinear::*coefficient : {&Bilinear::xi, &Bilinear::eta, &Bilinear::both})
    for (int axis = 0; axis < 3; ++axis) {
      Bilinear v = rest;
      (v.*coefficient)[axis] = 1;
      // Σ v² of the corners is 4.
      set_column(frame, moduli, full_rates(frame, modes, v, rest), 0.5, all, column++);
    }
  const double scale = 1 / std::sqrt(properties.inertia(frame.area, thickness));
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const Vector first = frame.normal[corner].unitOrthogonal(), second = frame.normal[corner].cross(first);
    for (const Vector& turn : {first, second}) {
      std::array<Vector, 4> m;
      m.fill(Vector::Zero());
      m[corner] = turn;
      set_column(frame, moduli, full_rates(frame, modes, rest, bilinear(m)), scale, all, column++);
    }
  }
  return all;
}

double largest_bound(const ModeStrains& of_motions) {
  ModeEnergies power = of_motions.transpose() * of_motions;
  const double trace = power.trace();
  if (!(trace > 0)) return trace;
  power /= trace;
  for (int squaring = 0; squaring < 3; ++squaring) power = ModeEnergies(power * power);
  return trace * std::pow(power.squaredNorm(), 1.0 / 16);
}

}  // namespace

double WarpedFrequency::squared(const ShellProperties& properties, const FullFrame& frame, double thickness) {
  const Bilinear& x = frame.x;
  const std::array<double, 8> shape{x.xi.x(),   x.xi.y(),   x.eta.x(),  x.eta.y(),
                                    x.both.x(), x.both.y(), x.both.z(), thickness};
  if (squared_ > 0) {
    const double longest = std::sqrt(std::max((frame.x_xi * frame.x_xi + frame.y_xi * frame.y_xi).maxCoeff(),
                                              (frame.x_eta * frame.x_eta + frame.y_eta * frame.y_eta).maxCoeff()));
    const double change = kept_change * frame.determinant.minCoeff() / longest;
    bool same = std::abs(thickness - static_cast<double>(shape_[7])) <= kept_change * thickness;
    for (std::size_t i = 0; i < 7; ++i) same = same && std::abs(shape[i] - static_cast<double>(shape_[i])) <= change;
    if (same) return squared_;
  }
  for (std::size_t i = 0; i < 8; ++i) shape_[i] = static_cast<float>(shape[i]);
  return squared_ = kept_growth * 4 * largest_bound(strains_of_motions(properties, frame, thickness));
}

}  // namespace gapcheck::solver
