#pragma once
#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "solver/element/shell_stiffness.hpp"

namespace gapcheck::solver {

/// A clamped strip of shells whose static deflection follows from their stiffness.
struct Strip {
  double young = 1000, poisson = 0, thickness = 0.1;
  std::vector<Vector> x;  ///< by station along the strip, then across it; the first station is clamped
  std::size_t across = 2;
  std::vector<std::array<std::size_t, 4>> elements = {};
  ShellKernel kernel = full_forces;
  ShellProperties properties = {};  ///< but for the material

  /// n x (across − 1) quads.
  void join() {
    for (std::size_t a = 0; a + across < x.size(); a += across)
      for (std::size_t j = a; j + 1 < a + across; ++j) elements.push_back({j, j + across, j + across + 1, j + 1});
  }

  /// Displacement of the last station along `direction` under a unit force there.
  [[nodiscard]] double tip(const Vector& direction) const {
    const int clamped = 6 * static_cast<int>(across), size = 6 * static_cast<int>(x.size()) - clamped;
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size);
    for (const auto& element : elements) add(element, clamped, k);
    // Rotations about the normals have no stiffness: hold them by next to nothing.
    const double least = 1e-9 * young * std::pow(thickness, 3);
    for (int i = 0; i < size; ++i) k(i, i) += i % 6 < 3 ? 0 : least;
    Eigen::VectorXd load = Eigen::VectorXd::Zero(size);
    for (std::size_t j = 0; j < across; ++j) {
      const double share = (j == 0 || j + 1 == across ? 0.5 : 1) / static_cast<double>(across - 1);
      load.segment<3>(size - 6 * static_cast<int>(across - j)) = share * direction;
    }
    return load.dot(k.partialPivLu().solve(load));
  }

 private:
  void add(const std::array<std::size_t, 4>& element, int clamped, Eigen::MatrixXd& k) const {
    ShellProperties all = properties;
    all.material = elastic_material(young, poisson);
    all.shear_factor = 5.0 / 6;
    std::array<Vector, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = x[element[i]];
    const Eigen::MatrixXd own = shell_stiffness(OneShell(all, thickness, kernel), corners, 1e-14);
    const Eigen::MatrixXd even = (own + own.transpose()) / 2;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        const int row = 6 * static_cast<int>(element[i]) - clamped, column = 6 * static_cast<int>(element[j]) - clamped;
        if (row >= 0 && column >= 0)
          k.block<6, 6>(row, column) += even.block<6, 6>(6 * static_cast<int>(i), 6 * static_cast<int>(j));
      }
  }
};

inline Strip straight(int n, double length, double width, double thickness) {
  Strip strip;
  strip.thickness = thickness;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < 2; ++j) strip.x.emplace_back(length * i / n, width * j, 0);
  strip.join();
  return strip;
}

/// The twisted beam of MacNeal and Harder (1985): 90°, n x 2 quads.
inline Strip twisted(int n, double thickness) {
  constexpr double length = 12, width = 1.1;
  Strip strip{29e6, 0.22, thickness, {}, 3};
  for (int i = 0; i <= n; ++i)
    for (int j = -1; j <= 1; ++j) {
      const double angle = std::numbers::pi / 2 * i / n, y = width / 2 * j;
      strip.x.emplace_back(length * i / n, y * std::cos(angle), y * std::sin(angle));
    }
  strip.join();
  return strip;
}

}  // namespace gapcheck::solver
