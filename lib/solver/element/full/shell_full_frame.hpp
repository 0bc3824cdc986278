#pragma once
#include <array>
#include <cmath>

#include "base/vector.hpp"
#include "solver/element/full/shell_axes.hpp"

namespace gapcheck::solver {

/// A number for each of the four points in the plane, in the order of the corners.
using Four = Eigen::Array4d;

/// ξ and η of the points.
inline const double point_place = std::sqrt(1.0 / 3);
inline const Four point_xi(-point_place, point_place, point_place, -point_place);
inline const Four point_eta(-point_place, -point_place, point_place, point_place);

/// The field mean + ξ xi + η eta + ξη both through the values at the corners (−1, −1), (1, −1), (1, 1), (−1, 1).
struct Bilinear {
  Vector mean, xi, eta, both;
};

inline Bilinear bilinear(const std::array<Vector, 4>& f) {
  const Vector even = f[0] + f[2], odd = f[1] + f[3], up = f[2] - f[0], across = f[1] - f[3];
  return {(even + odd) / 4, (up + across) / 4, (up - across) / 4, (even - odd) / 4};
}

/// Axes of the element and its shape in them. e3 is normal to both diagonals, so xi and eta of the positions have no z:
/// the corners lie at ± both.z() from the mean plane.
struct FullFrame {
  Vector e1, e2, e3;
  double area;
  Bilinear x;                                  ///< positions in the axes
  std::array<Vector, 4> normal;                ///< of the mid-surface at the corners, in the axes
  Bilinear n;                                  ///< the same
  Four x_xi, y_xi, x_eta, y_eta;               ///< tangents at the points, in the plane
  Four determinant, xi_x, xi_y, eta_x, eta_y;  ///< ∂(x, y)/∂(ξ, η), ∂ξ/∂x …

  [[nodiscard]] Vector local(const Vector& a) const { return {a.dot(e1), a.dot(e2), a.dot(e3)}; }
  [[nodiscard]] Bilinear local(const Bilinear& f) const {
    return {local(f.mean), local(f.xi), local(f.eta), local(f.both)};
  }
  [[nodiscard]] Vector global(const Vector& a) const { return a.x() * e1 + a.y() * e2 + a.z() * e3; }
};

/// Components of a symmetric tensor in the plane at the points; xy of a strain is the whole shear angle here.
struct PlaneTensor {
  Four xx, yy, xy;
};

[[nodiscard]] FullFrame make_full_frame(const std::array<Vector, 4>& corners, ShellAxes axes = ShellAxes::side);

/// a,ξ·b,ξ, a,η·b,η and a,ξ·b,η + a,η·b,ξ of two fields a and b, by the powers of ξ and η in them:
/// xi + η skew_xi + both / 3, eta + ξ skew_eta + both / 3, shear + ξ skew_xi + η skew_eta + 2 ξη both at the points.
struct Products {
  double xi = 0, eta = 0, shear = 0, skew_xi = 0, skew_eta = 0, both = 0;

  void add(const Bilinear& a, const Bilinear& b) {
    xi += a.xi.dot(b.xi);
    eta += a.eta.dot(b.eta);
    shear += a.xi.dot(b.eta) + a.eta.dot(b.xi);
    skew_xi += a.xi.dot(b.both) + a.both.dot(b.xi);
    skew_eta += a.eta.dot(b.both) + a.both.dot(b.eta);
    both += a.both.dot(b.both);
  }
  /// The transpose: adds to `b` what works on it where *this works on the products.
  void spread(const Bilinear& a, Bilinear& b) const {
    b.xi += xi * a.xi + shear * a.eta + skew_xi * a.both;
    b.eta += eta * a.eta + shear * a.xi + skew_eta * a.both;
    b.both += skew_xi * a.xi + skew_eta * a.eta + both * a.both;
  }
};

/// Transverse shear: along ξ mean_xi + η slope_xi, along η mean_eta + ξ slope_eta, through the values a,ξ·b + … in the
/// middles of the sides.
struct SideShear {
  double mean_xi = 0, slope_xi = 0, mean_eta = 0, slope_eta = 0;

  void add(const Bilinear& tangent, const Bilinear& b) {
    mean_xi += tangent.xi.dot(b.mean) + tangent.both.dot(b.eta);
    slope_xi += tangent.xi.dot(b.eta) + tangent.both.dot(b.mean);
    mean_eta += tangent.eta.dot(b.mean) + tangent.both.dot(b.xi);
    slope_eta += tangent.eta.dot(b.xi) + tangent.both.dot(b.mean);
  }
  /// The transposes: what works on b, and on the field whose tangents count.
  void spread(const Bilinear& tangent, Bilinear& b) const {
    b.mean += mean_xi * tangent.xi + mean_eta * tangent.eta + (slope_xi + slope_eta) * tangent.both;
    b.eta += mean_xi * tangent.both + slope_xi * tangent.xi;
    b.xi += mean_eta * tangent.both + slope_eta * tangent.eta;
  }
  void spread_tangent(const Bilinear& b, Bilinear& tangent) const {
    tangent.xi += mean_xi * b.mean + slope_xi * b.eta;
    tangent.eta += mean_eta * b.mean + slope_eta * b.xi;
    tangent.both += mean_xi * b.eta + mean_eta * b.xi + (slope_xi + slope_eta) * b.mean;
  }
};

/// The strain at the points.
[[nodiscard]] PlaneTensor in_plane(const FullFrame& frame, const Products& products);

/// What resultants at the points work on the products; the transpose of in_plane times the area.
[[nodiscard]] Products along_lines(const FullFrame& frame, const PlaneTensor& n);

}  // namespace gapcheck::solver
