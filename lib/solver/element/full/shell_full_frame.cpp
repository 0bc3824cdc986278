#include "solver/element/full/shell_full_frame.hpp"

#include <algorithm>

namespace gapcheck::solver {
namespace {

/// Normals at the corners of a frame with axes and x.
void set_normals(FullFrame& frame) {
  const Vector &xi = frame.x.xi, &eta = frame.x.eta, &both = frame.x.both;
  constexpr std::array<std::array<double, 2>, 4> corner{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    Vector normal = Vector(xi + corner[i][1] * both).cross(eta + corner[i][0] * both);
    // Where two sides are in line, or two corners the same, they have no normal: stay near that of the element.
    normal.z() = std::max(normal.z(), frame.area / 40);
    frame.normal[i] = normal.normalized();
  }
  frame.n = bilinear(frame.normal);
}

}  // namespace

FullFrame make_full_frame(const std::array<Vector, 4>& corners, ShellAxes axes) {
  FullFrame frame;
  const Bilinear x = bilinear(corners);
  const Vector normal = x.xi.cross(x.eta);
  const double length = normal.norm();
  frame.area = 4 * length;
  frame.e3 = normal / length;
  const Vector side = corners[1] - corners[0];
  Vector along = side - side.dot(frame.e3) * frame.e3;
  // Coincident corners 1 and 2 give no direction: the diagonal does.
  if (!(along.squaredNorm() > 0)) along = x.xi + x.eta;
  if (axes == ShellAxes::invariant) along = invariant_direction(x.xi, x.eta);
  frame.e1 = along.normalized();
  frame.e2 = frame.e3.cross(frame.e1);
  frame.x = frame.local(x);
  set_normals(frame);
  frame.x_xi = frame.x.xi.x() + point_eta * frame.x.both.x();
  frame.y_xi = frame.x.xi.y() + point_eta * frame.x.both.y();
  frame.x_eta = frame.x.eta.x() + point_xi * frame.x.both.x();
  frame.y_eta = frame.x.eta.y() + point_xi * frame.x.both.y();
  frame.determinant = frame.x_xi * frame.y_eta - frame.y_xi * frame.x_eta;
  const Four inverse = 1 / frame.determinant;
  frame.xi_x = inverse * frame.y_eta;
  frame.xi_y = -inverse * frame.x_eta;
  frame.eta_x = -inverse * frame.y_xi;
  frame.eta_y = inverse * frame.x_xi;
  return frame;
}

PlaneTensor in_plane(const FullFrame& frame, const Products& products) {
  const Four xi = products.xi + products.both / 3 + point_eta * products.skew_xi,
             eta = products.eta + products.both / 3 + point_xi * products.skew_eta,
             shear = products.shear + point_xi * products.skew_xi + point_eta * products.skew_eta +
                     2 * products.both * point_xi * point_eta;
  return {frame.xi_x * frame.xi_x * xi + frame.eta_x * frame.eta_x * eta + frame.xi_x * frame.eta_x * shear,
          frame.xi_y * frame.xi_y * xi + frame.eta_y * frame.eta_y * eta + frame.xi_y * frame.eta_y * shear,
          2 * frame.xi_x * frame.xi_y * xi + 2 * frame.eta_x * frame.eta_y * eta +
              (frame.xi_x * frame.eta_y + frame.xi_y * frame.eta_x) * shear};
}

Products along_lines(const FullFrame& frame, const PlaneTensor& n) {
  const Four xi = frame.determinant * (frame.xi_x * frame.xi_x * n.xx + frame.xi_y * frame.xi_y * n.yy +
                                       2 * frame.xi_x * frame.xi_y * n.xy),
             eta = frame.determinant * (frame.eta_x * frame.eta_x * n.xx + frame.eta_y * frame.eta_y * n.yy +
                                        2 * frame.eta_x * frame.eta_y * n.xy),
             shear = frame.determinant * (frame.xi_x * frame.eta_x * n.xx + frame.xi_y * frame.eta_y * n.yy +
                                          (frame.xi_x * frame.eta_y + frame.xi_y * frame.eta_x) * n.xy);
  Products products;
  products.xi = xi.sum();
  products.eta = eta.sum();
  products.shear = shear.sum();
  products.skew_xi = (point_eta * xi + point_xi * shear).sum();
  products.skew_eta = (point_xi * eta + point_eta * shear).sum();
  products.both = (products.xi + products.eta) / 3 + 2 * (point_xi * point_eta * shear).sum();
  return products;
}

}  // namespace gapcheck::solver
