#include "solver/structure/mass_points.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "base/quad.hpp"

namespace gapcheck::solver {
namespace {

constexpr double signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
constexpr double gauss = std::numbers::inv_sqrt3;

}  // namespace

std::vector<PointMass> solid_mass_points(const std::array<Vector, 8>& x, double density) {
  std::vector<PointMass> points;
  if (x[3] == x[4] && x[3] == x[7]) {
    const double volume = (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) / 6;
    const double near = (5 + 3 * std::sqrt(5.0)) / 20, far = (5 - std::sqrt(5.0)) / 20;
    const Vector sum = x[0] + x[1] + x[2] + x[3];
    for (std::size_t a = 0; a < 4 && volume > 0; ++a)
      points.push_back({far * sum + (near - far) * x[a], density * volume / 4});
    return points;
  }
  for (const auto& g : signs) {
    Matrix jacobian = Matrix::Zero();
    Vector place = Vector::Zero();
    for (std::size_t a = 0; a < 8; ++a) {
      std::array<double, 3> factor;
      for (std::size_t k = 0; k < 3; ++k) factor[k] = 1 + signs[a][k] * g[k] * gauss;
      place += factor[0] * factor[1] * factor[2] / 8 * x[a];
      for (std::size_t k = 0; k < 3; ++k)
        jacobian.col(static_cast<int>(k)) += signs[a][k] * factor[(k + 1) % 3] * factor[(k + 2) % 3] / 8 * x[a];
    }
    points.push_back({place, density * jacobian.determinant()});
  }
  return points;
}

std::vector<PointMass> shell_mass_points(const std::array<Vector, 4>& x, double thickness, double density) {
  std::vector<PointMass> points;
  for (std::size_t g = 0; g < 4; ++g) {
    const double s = signs[g][0] * gauss, t = signs[g][1] * gauss;
    const Vector along_s = ((1 - t) * (x[1] - x[0]) + (1 + t) * (x[2] - x[3])) / 4;
    const Vector along_t = ((1 - s) * (x[3] - x[0]) + (1 + s) * (x[2] - x[1])) / 4;
    const Vector place = quad_point(x, s, t);
    const Vector normal = along_s.cross(along_t);
    const double area = normal.norm();
    if (!(area > 0)) continue;
    const Vector lift = thickness / std::sqrt(12.0) / area * normal;
    for (const double side : {-1.0, 1.0}) points.push_back({place + side * lift, density * thickness * area / 2});
  }
  return points;
}

std::vector<PointMass> beam_mass_points(const std::array<Vector, 2>& x, double area, double density) {
  const double mass = density * area * (x[1] - x[0]).norm();
  if (!(mass > 0)) return {};
  const Vector middle = (x[0] + x[1]) / 2, arm = gauss / 2 * (x[1] - x[0]);
  return {{middle - arm, mass / 2}, {middle + arm, mass / 2}};
}

}  // namespace gapcheck::solver
