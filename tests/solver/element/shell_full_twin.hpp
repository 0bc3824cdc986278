#pragma once
#include <Eigen/Dense>

#include "solver/element/shell_stiffness.hpp"

namespace gapcheck::solver {

/// The strains of one fully integrated shell once more, by shape functions and matrices instead of products of
/// coefficients: 8 rows for each point (εxx εyy 2εxy, κxx κyy 2κxy, 2εzx 2εyz) over 24 degrees of freedom.
class FullShellTwin {
 public:
  FullShellTwin(const std::array<Vector, 4>& x, double young, double poisson) : x_(x) {
    axes_.row(2) = (x[2] - x[0]).cross(x[3] - x[1]).normalized();
    const Vector side = x[1] - x[0], e3 = axes_.row(2);
    axes_.row(0) = (side - side.dot(e3) * e3).normalized();
    axes_.row(1) = e3.cross(Vector(axes_.row(0)));
    for (std::size_t i = 0; i < 4; ++i) x_[i] = axes_ * x[i];
    plane_ << 1, poisson, 0, poisson, 1, 0, 0, 0, (1 - poisson) / 2;
    plane_ *= young / (1 - poisson * poisson);
    shear_ = young / (2 * (1 + poisson));
    for (std::size_t g = 0; g < 4; ++g) add_point(g);
    assume_membrane();
  }

  [[nodiscard]] const Eigen::Matrix<double, 8, 24>& strains(std::size_t point) const { return strain_[point]; }
  [[nodiscard]] Eigen::MatrixXd stiffness(double thickness, double shear_factor) const {
    Eigen::Matrix<double, 8, 8> moduli = Eigen::Matrix<double, 8, 8>::Zero();
    moduli.topLeftCorner<3, 3>() = thickness * plane_;
    moduli.block<3, 3>(3, 3) = std::pow(thickness, 3) / 12 * plane_;
    moduli(6, 6) = moduli(7, 7) = shear_factor * shear_ * thickness;
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(24, 24);
    for (std::size_t g = 0; g < 4; ++g) sum += weight_[g] * strain_[g].transpose() * moduli * strain_[g];
    return sum;
  }

 private:
  using Row = Eigen::Matrix<double, 1, 24>;
  static double sign_xi(std::size_t i) { return i == 1 || i == 2 ? 1 : -1; }
  static double sign_eta(std::size_t i) { return i >= 2 ? 1 : -1; }
  static double shape_xi(std::size_t i, double eta) { return sign_xi(i) * (1 + sign_eta(i) * eta) / 4; }
  static double shape_eta(std::size_t i, double xi) { return sign_eta(i) * (1 + sign_xi(i) * xi) / 4; }

  /// Σ f(i) x(i), and the row of Σ a(i) v(i)·to + Σ b(i) (ω(i) × n(i))·to.
  template <class F>
  [[nodiscard]] Vector sum(const std::array<Vector, 4>& field, const F& f) const {
    Vector result = Vector::Zero();
    for (std::size_t i = 0; i < 4; ++i) result += f(i) * field[i];
    return result;
  }
  template <class F>
  [[nodiscard]] Row velocity(const F& f, const Vector& to) const {
    Row row = Row::Zero();
    for (std::size_t i = 0; i < 4; ++i) row.segment<3>(6 * static_cast<int>(i)) = f(i) * (axes_.transpose() * to);
    return row;
  }
  template <class F>
  [[nodiscard]] Row turning(const F& f, const Vector& to) const {
    Row row = Row::Zero();
    const std::array<Vector, 4> n = normals();
    // (ω × n)·to = ω·(n × to)
    for (std::size_t i = 0; i < 4; ++i)
      row.segment<3>(6 * static_cast<int>(i) + 3) = f(i) * (axes_.transpose() * n[i].cross(to));
    return row;
  }
  [[nodiscard]] std::array<Vector, 4> normals() const {
    std::array<Vector, 4> n;
    for (std::size_t i = 0; i < 4; ++i) {
      n[i] = (x_[(i + 1) % 4] - x_[i]).cross(x_[(i + 3) % 4] - x_[i]);
      n[i] = n[i].norm() > 0 ? n[i].normalized() : Vector(0, 0, 1);
    }
    return n;
  }

  /// In the middle of the side at η (along ξ) or at ξ (along η).
  [[nodiscard]] Row side_shear(bool along_xi, double at) const {
    const auto slope = [&](std::size_t i) { return along_xi ? shape_xi(i, at) : shape_eta(i, at); };
    const auto value = [&](std::size_t i) { return along_xi ? (1 + sign_eta(i) * at) / 4 : (1 + sign_xi(i) * at) / 4; };
    return turning(value, sum(x_, slope)) + velocity(slope, sum(normals(), value));
  }

  void add_point(std::size_t g) {
    const double xi = sign_xi(g) / std::sqrt(3.0), eta = sign_eta(g) / std::sqrt(3.0);
    const auto by_xi = [&](std::size_t i) { return shape_xi(i, eta); };
    const auto by_eta = [&](std::size_t i) { return shape_eta(i, xi); };
    const std::array<Vector, 2> tangent{sum(x_, by_xi), sum(x_, by_eta)};
    const std::array<Vector, 2> bent{sum(normals(), by_xi), sum(normals(), by_eta)};
    Eigen::Matrix2d jacobian;
    jacobian << tangent[0].x(), tangent[0].y(), tangent[1].x(), tangent[1].y();
    const Eigen::Matrix2d inverse = jacobian.inverse();
    weight_[g] = jacobian.determinant();
    place_[g] = {xi, eta};
    std::array<std::array<Row, 2>, 2> metric, curvature;
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t b = 0; b < 2; ++b) {
        const auto by = [&](std::size_t i) { return b == 0 ? by_xi(i) : by_eta(i); };
        metric[a][b] = velocity(by, tangent[a]);
        curvature[a][b] = turning(by, tangent[a]) + velocity(by, bent[a]);
      }
    Eigen::Matrix<double, 8, 24>& rows = strain_[g];
    rows.setZero();
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t b = 0; b < 2; ++b) {
        const int ia = static_cast<int>(a), ib = static_cast<int>(b);
        const std::array<double, 3> share{inverse(0, ia) * inverse(0, ib), inverse(1, ia) * inverse(1, ib),
                                          inverse(0, ia) * inverse(1, ib) + inverse(1, ia) * inverse(0, ib)};
        for (int k = 0; k < 3; ++k) {
          rows.row(k) += share[static_cast<std::size_t>(k)] * metric[a][b];
          rows.row(3 + k) += share[static_cast<std::size_t>(k)] * curvature[a][b];
        }
      }
    const Row along_xi = (1 - eta) / 2 * side_shear(true, -1) + (1 + eta) / 2 * side_shear(true, 1);
    const Row along_eta = (1 - xi) / 2 * side_shear(false, -1) + (1 + xi) / 2 * side_shear(false, 1);
    rows.row(6) = inverse(0, 0) * along_xi + inverse(0, 1) * along_eta;
    rows.row(7) = inverse(1, 0) * along_xi + inverse(1, 1) * along_eta;
  }

  /// The membrane strain is the closest one, by elastic energy, that belongs to a stress of Pian and Sumihara.
  void assume_membrane() {
    const double area = weight_[0] + weight_[1] + weight_[2] + weight_[3];
    double mean_xi = 0, mean_eta = 0;
    for (std::size_t g = 0; g < 4; ++g) {
      mean_xi += weight_[g] * place_[g][0] / area;
      mean_eta += weight_[g] * place_[g][1] / area;
    }
    const Vector xi = sum(x_, [](std::size_t i) { return shape_xi(i, 0); }),
                 eta = sum(x_, [](std::size_t i) { return shape_eta(i, 0); });
    std::array<Eigen::Matrix<double, 3, 5>, 4> mode;
    Eigen::Matrix<double, 5, 5> gram = Eigen::Matrix<double, 5, 5>::Zero();
    Eigen::Matrix<double, 5, 24> right = Eigen::Matrix<double, 5, 24>::Zero();
    for (std::size_t g = 0; g < 4; ++g) {
      Eigen::Matrix<double, 3, 5> stress = Eigen::Matrix<double, 3, 5>::Zero();
      stress.leftCols<3>().setIdentity();
      stress.col(3) = (place_[g][1] - mean_eta) * Vector(xi.x() * xi.x(), xi.y() * xi.y(), xi.x() * xi.y());
      stress.col(4) = (place_[g][0] - mean_xi) * Vector(eta.x() * eta.x(), eta.y() * eta.y(), eta.x() * eta.y());
      mode[g] = plane_.inverse() * stress;
      gram += weight_[g] * mode[g].transpose() * plane_ * mode[g];
      right += weight_[g] * mode[g].transpose() * plane_ * strain_[g].topRows<3>();
    }
    const Eigen::Matrix<double, 5, 24> share = gram.fullPivLu().solve(right);
    for (std::size_t g = 0; g < 4; ++g) strain_[g].topRows<3>() = mode[g] * share;
  }

  std::array<Vector, 4> x_;  ///< in the axes
  Matrix axes_;
  Eigen::Matrix3d plane_;
  double shear_ = 0;
  std::array<Eigen::Matrix<double, 8, 24>, 4> strain_;
  std::array<double, 4> weight_{};
  std::array<std::array<double, 2>, 4> place_{};
};

}  // namespace gapcheck::solver
