#include "solver/quadrature/brick_map.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapcheck::solver {
namespace {

/// ξ, η, ζ, ηζ, ζξ, ξη, ξηζ at the corners.
constexpr double mode_signs[8][7] = {{-1, -1, -1, 1, 1, 1, -1}, {1, -1, -1, 1, -1, -1, 1}, {1, 1, -1, -1, -1, 1, -1},
                                     {-1, 1, -1, -1, 1, -1, 1}, {-1, -1, 1, -1, -1, 1, 1}, {1, -1, 1, -1, 1, -1, -1},
                                     {1, 1, 1, 1, 1, 1, 1},     {-1, 1, 1, 1, -1, -1, -1}};

/// ξ of a Gauss point, by the corner it is next to.
double gauss_place(std::size_t point, int axis) { return std::numbers::inv_sqrt3 * mode_signs[point][axis]; }

/// The factors of a column of the Jacobian at a point: of the pair modes `l` and `k` and of ξηζ.
struct ColumnFactors {
  int k, l;
  double at_k, at_l, product;
  ColumnFactors(int j, std::size_t point, const Matrix& scale) : k((j + 1) % 3), l((j + 2) % 3) {
    at_k = gauss_place(point, k) * scale(j, k);
    at_l = gauss_place(point, l) * scale(j, l);
    product = at_k * at_l;
  }
};

/// ∂/∂ξ of a field with these modes.
Matrix derivatives(const BrickModes& x, std::size_t point, const Matrix& scale) {
  Matrix columns;
  for (int j = 0; j < 3; ++j) {
    const ColumnFactors f(j, point, scale);
    columns.col(j) = x.linear.col(j) + f.at_k * x.pairs.col(f.l) + f.at_l * x.pairs.col(f.k) + f.product * x.all;
  }
  return columns;
}

/// The transpose of derivatives(): adds the forces of `columns`.
void add_forces(const Matrix& columns, std::size_t point, const Matrix& scale, BrickModes& forces) {
  forces.linear += columns;
  for (int j = 0; j < 3; ++j) {
    const ColumnFactors f(j, point, scale);
    forces.pairs.col(f.l) += f.at_k * columns.col(j);
    forces.pairs.col(f.k) += f.at_l * columns.col(j);
    forces.all += f.product * columns.col(j);
  }
}

/// det J J⁻ᵀ
Matrix cofactor(const Matrix& m) {
  Matrix result;
  for (int j = 0; j < 3; ++j) result.col(j) = m.col((j + 1) % 3).cross(m.col((j + 2) % 3));
  return result;
}

/// The inverse; `good` becomes false where the determinant is not above zero.
Matrix inverse_of(const Matrix& m, bool& good) {
  const Matrix c = cofactor(m);
  const double determinant = c.col(0).dot(m.col(0));
  if (!(determinant > 0)) good = false;
  return c.transpose() / determinant;
}

/// ELFORM -2: κ for the gradient of the i-th component.
Matrix component_scale(const Matrix& scale, int i) {
  Matrix own = scale;
  own.row(i).setOnes();
  return own;
}

/// ELFORM -2: derivatives() by component, of a field in the axes.
Matrix derivatives_by_component(const BrickModes& v, std::size_t point, const Matrix& scale) {
  Matrix columns = derivatives(v, point, scale);
  columns.diagonal() = derivatives(v, point, Matrix::Ones()).diagonal();
  return columns;
}

/// Row by row the product with the component's own matrix.
Matrix times_inverse(const Matrix& rows, const std::array<Matrix, 3>& inverse) {
  Matrix product;
  for (int i = 0; i < 3; ++i) product.row(i) = rows.row(i) * inverse[static_cast<std::size_t>(i)];
  return product;
}

/// The transpose of that.
Matrix times_transposed(const Matrix& rows, const std::array<Matrix, 3>& inverse) {
  Matrix product;
  for (int i = 0; i < 3; ++i) product.row(i) = rows.row(i) * inverse[static_cast<std::size_t>(i)].transpose();
  return product;
}

/// The axes made orthogonal to each other, the longest first, so that the plane of a flat brick and the direction of a
/// long one are kept.
Matrix orthogonal_axes(const Matrix& sides) {
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return sides.col(a).squaredNorm() > sides.col(b).squaredNorm(); });
  Matrix axes;
  axes.col(order[0]) = sides.col(order[0]).normalized();
  const Vector second = sides.col(order[1]) - sides.col(order[1]).dot(axes.col(order[0])) * axes.col(order[0]);
  axes.col(order[1]) = second.normalized();
  axes.col(order[2]) = axes.col(order[0]).cross(axes.col(order[1]));
  return axes;
}

BrickModes turned(const Matrix& by, const BrickModes& x) { return {by * x.linear, by * x.pairs, by * x.all}; }

Matrix side_ratios(const Matrix& axes) {
  Matrix scale = Matrix::Ones();
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k)
      if (j != k) scale(j, k) = std::min(1.0, axes.col(j).norm() / axes.col(k).norm());
  return scale;
}

bool is_scaled(SolidRule rule) { return rule == SolidRule::efficient || rule == SolidRule::accurate; }

using ProductModes = Eigen::Matrix<double, 3, 4>;

/// Columns: the gradients of the four modes with products at a point.
ProductModes product_gradients(const Matrix& inverse, std::size_t point, const Matrix& scale) {
  ProductModes columns = ProductModes::Zero();
  for (int j = 0; j < 3; ++j) {
    const ColumnFactors f(j, point, scale);
    columns(j, f.l) = f.at_k;
    columns(j, f.k) = f.at_l;
    columns(j, 3) = f.product;
  }
  return inverse.transpose() * columns;
}

/// Σ V g gᵀ of the gradients' differences from their mean, by modes; of one component of ELFORM -2.
Eigen::Matrix4d squared_differences(const BrickMap& map, int component) {
  const bool accurate = map.rule == SolidRule::accurate;
  const Matrix scale = accurate ? component_scale(map.scale, component) : map.scale;
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  ProductModes mean = ProductModes::Zero();
  for (std::size_t p = 0; p < 8; ++p) {
    const Matrix& inverse = accurate ? map.component_inverse[p][static_cast<std::size_t>(component)] : map.inverse[p];
    const ProductModes columns = product_gradients(inverse, p, scale);
    sum += map.volume[p] * columns.transpose() * columns;
    mean += map.volume[p] * columns;
  }
  return sum - mean.transpose() * mean / map.total;
}

template <class M>
double largest_row_sum(const M& m) {
  return m.cwiseAbs().rowwise().sum().maxCoeff();
}

}  // namespace

BrickModes brick_modes(const std::array<Vector, 8>& corners) {
  BrickModes modes;
  for (std::size_t a = 0; a < 8; ++a) {
    for (int j = 0; j < 3; ++j) {
      modes.linear.col(j) += mode_signs[a][j] * corners[a];
      modes.pairs.col(j) += mode_signs[a][3 + j] * corners[a];
    }
    modes.all += mode_signs[a][6] * corners[a];
  }
  return {modes.linear / 8, modes.pairs / 8, modes.all / 8};
}

std::array<Vector, 8> corner_forces(const BrickModes& forces) {
  std::array<Vector, 8> corners;
  for (std::size_t a = 0; a < 8; ++a) {
    corners[a] = mode_signs[a][6] * forces.all;
    for (int j = 0; j < 3; ++j)
      corners[a] += mode_signs[a][j] * forces.linear.col(j) + mode_signs[a][3 + j] * forces.pairs.col(j);
    corners[a] /= 8;
  }
  return corners;
}

BrickMap brick_map(SolidRule rule, const BrickModes& x) {
  BrickMap map;
  map.rule = rule;
  map.good = true;
  if (is_scaled(rule)) map.scale = side_ratios(x.linear);
  if (rule == SolidRule::accurate) map.axes = orthogonal_axes(x.linear);
  map.least = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < 8; ++p) {
    const Matrix jacobian = derivatives(x, p, Matrix::Ones()), slopes = cofactor(jacobian);
    map.volume[p] = slopes.col(0).dot(jacobian.col(0));
    map.total += map.volume[p];
    map.least = std::min(map.least, 8 * map.volume[p]);
    add_forces(slopes, p, Matrix::Ones(), map.slope);
    if (rule == SolidRule::accurate) {
      const Matrix scaled = derivatives(x, p, map.scale);
      for (int i = 0; i < 3; ++i) {
        Matrix own = scaled;
        own.col(i) = jacobian.col(i);
        map.component_inverse[p][static_cast<std::size_t>(i)] = inverse_of(own, map.good);
      }
    } else {
      map.inverse[p] = rule == SolidRule::efficient ? inverse_of(derivatives(x, p, map.scale), map.good)
                                                    : Matrix(slopes.transpose() / map.volume[p]);
    }
  }
  map.good = map.good && map.least > 0 && std::isfinite(map.total);
  return map;
}

Matrix mean_gradient(const BrickMap& map, const BrickModes& v) {
  return (v.linear * map.slope.linear.transpose() + v.pairs * map.slope.pairs.transpose() +
          v.all * map.slope.all.transpose()) /
         map.total;
}

std::array<Matrix, 8> brick_gradients(const BrickMap& map, const BrickModes& v) {
  std::array<Matrix, 8> gradients;
  const bool accurate = map.rule == SolidRule::accurate;
  const BrickModes local = accurate ? turned(map.axes.transpose(), v) : v;
  Matrix mean = Matrix::Zero();
  for (std::size_t p = 0; p < 8; ++p) {
    if (accurate)
      gradients[p] = map.axes * times_inverse(derivatives_by_component(local, p, map.scale), map.component_inverse[p]);
    else
      gradients[p] = derivatives(v, p, map.scale) * map.inverse[p];
    mean += map.volume[p] * gradients[p];
  }
  if (!is_scaled(map.rule)) return gradients;  // the mean is exact
  const Matrix correction = mean_gradient(map, v) - mean / map.total;
  for (Matrix& gradient : gradients) gradient += correction;
  return gradients;
}

BrickModes brick_stress_forces(const BrickMap& map, const std::array<Matrix, 8>& stress) {
  Matrix mean = Matrix::Zero();
  for (std::size_t p = 0; p < 8; ++p) mean += map.volume[p] / map.total * stress[p];
  BrickModes forces{mean * map.slope.linear, mean * map.slope.pairs, mean * map.slope.all};
  const bool accurate = map.rule == SolidRule::accurate;
  BrickModes local;
  for (std::size_t p = 0; p < 8; ++p) {
    const Matrix rest = map.volume[p] * (stress[p] - mean);
    if (!accurate) {
      add_forces(rest * map.inverse[p].transpose(), p, map.scale, forces);
      continue;
    }
    Matrix columns = times_transposed(map.axes.transpose() * rest, map.component_inverse[p]);
    add_forces(columns.diagonal().asDiagonal(), p, Matrix::Ones(), local);
    columns.diagonal().setZero();
    add_forces(columns, p, map.scale, local);
  }
  if (accurate) {
    const BrickModes back = turned(map.axes, local);
    forces.linear += back.linear;
    forces.pairs += back.pairs;
    forces.all += back.all;
  }
  return forces;
}

double gradient_bound(const BrickMap& map, const BrickModes& x, double mean, double rest) {
  // The differences depend on the four modes with products alone, once the linear field through the centre is taken
  // off.
  double differences = 0;
  for (int i = 0; i < (map.rule == SolidRule::accurate ? 3 : 1); ++i)
    differences = std::max(differences, largest_row_sum(squared_differences(map, i)));
  const double squared_rest = rest * differences;
  ProductModes products, slopes;
  products << x.pairs, x.all;
  slopes << map.slope.pairs, map.slope.all;
  const ProductModes skew = x.linear.inverse() * products;
  const ProductModes overlap = slopes - map.slope.linear * skew;
  const Matrix squared_slope = map.slope.linear * map.slope.linear.transpose() + slopes * slopes.transpose();
  const double first = mean * largest_row_sum(squared_slope) / (8 * map.total);
  const double second = squared_rest * (1 + largest_row_sum(Matrix(skew * skew.transpose()))) / 8;
  const double coupling = mean / map.total * squared_rest * overlap.squaredNorm() / 64;
  return (first + second) / 2 + std::sqrt((first - second) * (first - second) / 4 + coupling);
}

}  // namespace gapcheck::solver
