#include "solver/quadrature/brick_map.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gapcheck::solver {
namespace {

/// ξ, η, ζ, ηζ, ζξ, ξη, ξηζ at the corners.
constexpr double mode_signs[8][7] = {{-1, -1, -1, 1, 1, 1, -1}, {1, -1, -1, 1, -1, -1, 1}, {1, 1, -1, -1, -1, 1, -1},
                                     {-1, 1, -1, -1, 1, -1, 1}, {-1, -1, 1, -1, -1, 1, 1}, {1, -1, 1, -1, 1, -1, -1},
                                     {1, 1, 1, 1, 1, 1, 1},     {-1, 1, 1, 1, -1, -1, -1}};

/// ξ, η and ζ of the Gauss points.
std::array<Eight, 3> gauss_places() {
  std::array<Eight, 3> places;
  for (int p = 0; p < 8; ++p)
    for (int axis = 0; axis < 3; ++axis)
      places[static_cast<std::size_t>(axis)][p] = std::numbers::inv_sqrt3 * mode_signs[p][axis];
  return places;
}
const std::array<Eight, 3> gauss_place = gauss_places();

/// The factors of a column of the Jacobian at the points: of the pair modes `l` and `k` and of ξηζ.
struct ColumnFactors {
  int k, l;
  Eight at_k, at_l, product;
  ColumnFactors(int j, const Matrix& scale) : k((j + 1) % 3), l((j + 2) % 3) {
    at_k = gauss_place[static_cast<std::size_t>(k)] * scale(j, k);
    at_l = gauss_place[static_cast<std::size_t>(l)] * scale(j, l);
    product = at_k * at_l;
  }
};

using Factors = std::array<ColumnFactors, 3>;

Factors factors(const Matrix& scale) {
  return {ColumnFactors(0, scale), ColumnFactors(1, scale), ColumnFactors(2, scale)};
}

const Factors unscaled = factors(Matrix::Ones());

/// ∂/∂ξ of a field with these modes.
EightMatrices derivatives(const BrickModes& x, const Factors& all) {
  EightMatrices columns;
  for (int j = 0; j < 3; ++j) {
    const ColumnFactors& f = all[static_cast<std::size_t>(j)];
    for (int i = 0; i < 3; ++i)
      columns(i, j) = x.linear(i, j) + f.at_k * x.pairs(i, f.l) + f.at_l * x.pairs(i, f.k) + f.product * x.all[i];
  }
  return columns;
}

/// The transpose of derivatives(): adds the forces of `columns`.
void add_forces(const EightMatrices& columns, const Factors& all, BrickModes& forces) {
  for (int j = 0; j < 3; ++j) {
    const ColumnFactors& f = all[static_cast<std::size_t>(j)];
    for (int i = 0; i < 3; ++i) {
      const Eight& column = columns(i, j);
      forces.linear(i, j) += column.sum();
      forces.pairs(i, f.l) += (f.at_k * column).sum();
      forces.pairs(i, f.k) += (f.at_l * column).sum();
      forces.all[i] += (f.product * column).sum();
    }
  }
}

/// The inverses; `good` becomes false where a determinant is not above zero.
EightMatrices inverse_of(const EightMatrices& m, bool& good) {
  const EightMatrices cofactors = cofactor(m);
  const Eight determinants = determinant(m, cofactors);
  if (!(determinants > 0).all()) good = false;
  return inverse(cofactors, determinants);
}

/// ELFORM -2: κ for the gradient of the i-th component.
Matrix component_scale(const Matrix& scale, int i) {
  Matrix own = scale;
  own.row(i).setOnes();
  return own;
}

/// ELFORM -2: derivatives() by component, of a field in the axes.
EightMatrices derivatives_by_component(const BrickModes& v, const Factors& scaled) {
  EightMatrices columns = derivatives(v, scaled);
  const EightMatrices own = derivatives(v, unscaled);
  for (int i = 0; i < 3; ++i) columns(i, i) = own(i, i);
  return columns;
}

/// Row by row the product with the component's own matrix.
EightMatrices times_inverse(const EightMatrices& rows, const std::array<EightMatrices, 3>& inverse) {
  EightMatrices product;
  for (int i = 0; i < 3; ++i) {
    const EightMatrices& own = inverse[static_cast<std::size_t>(i)];
    for (int j = 0; j < 3; ++j)
      product(i, j) = rows(i, 0) * own(0, j) + rows(i, 1) * own(1, j) + rows(i, 2) * own(2, j);
  }
  return product;
}

/// The transpose of that.
EightMatrices times_transposed_inverse(const EightMatrices& rows, const std::array<EightMatrices, 3>& inverse) {
  EightMatrices product;
  for (int i = 0; i < 3; ++i) {
    const EightMatrices& own = inverse[static_cast<std::size_t>(i)];
    for (int j = 0; j < 3; ++j)
      product(i, j) = rows(i, 0) * own(j, 0) + rows(i, 1) * own(j, 1) + rows(i, 2) * own(j, 2);
  }
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

/// The gradients of the four modes with products at the points: component i of mode m.
using ProductGradients = std::array<std::array<Eight, 4>, 3>;

ProductGradients product_gradients(const EightMatrices& inverse, const Factors& all) {
  ProductGradients gradients;
  for (std::size_t i = 0; i < 3; ++i) {
    for (Eight& mode : gradients[i]) mode.setZero();
    for (std::size_t j = 0; j < 3; ++j) {
      const ColumnFactors& f = all[j];
      const Eight& row = inverse(static_cast<int>(j), static_cast<int>(i));
      gradients[i][static_cast<std::size_t>(f.l)] += row * f.at_k;
      gradients[i][static_cast<std::size_t>(f.k)] += row * f.at_l;
      gradients[i][3] += row * f.product;
    }
  }
  return gradients;
}

/// Σ V g gᵀ of the gradients' differences from their mean, by modes; of one component of ELFORM -2.
Eigen::Matrix4d squared_differences(const BrickMap& map, int component) {
  const bool accurate = map.rule == SolidRule::accurate;
  const Matrix scale = accurate ? component_scale(map.scale, component) : map.scale;
  const ProductGradients g = product_gradients(
      accurate ? map.component_inverse[static_cast<std::size_t>(component)] : map.inverse, factors(scale));
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  ProductModes mean;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t m = 0; m < 4; ++m) {
      const Eight weighted = map.volume * g[i][m];
      mean(static_cast<int>(i), static_cast<int>(m)) = weighted.sum();
      for (std::size_t n = 0; n <= m; ++n) sum(static_cast<int>(m), static_cast<int>(n)) += (weighted * g[i][n]).sum();
    }
  sum.triangularView<Eigen::StrictlyUpper>() = sum.transpose();
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
  const EightMatrices jacobian = derivatives(x, unscaled), slopes = cofactor(jacobian);
  map.volume = determinant(jacobian, slopes);
  map.total = map.volume.sum();
  map.least = 8 * map.volume.minCoeff();
  add_forces(slopes, unscaled, map.slope);
  if (rule == SolidRule::accurate) {
    const EightMatrices scaled = derivatives(x, factors(map.scale));
    for (int i = 0; i < 3; ++i) {
      EightMatrices own = scaled;
      for (int row = 0; row < 3; ++row) own(row, i) = jacobian(row, i);
      map.component_inverse[static_cast<std::size_t>(i)] = inverse_of(own, map.good);
    }
  } else if (rule == SolidRule::efficient) {
    map.inverse = inverse_of(derivatives(x, factors(map.scale)), map.good);
  } else {
    map.inverse = inverse(slopes, map.volume);
  }
  map.good = map.good && map.least > 0 && std::isfinite(map.total);
  return map;
}

Matrix mean_gradient(const BrickMap& map, const BrickModes& v) {
  return (v.linear * map.slope.linear.transpose() + v.pairs * map.slope.pairs.transpose() +
          v.all * map.slope.all.transpose()) /
         map.total;
}

EightMatrices brick_gradients(const BrickMap& map, const BrickModes& v) {
  const bool accurate = map.rule == SolidRule::accurate;
  EightMatrices gradients;
  if (accurate)
    gradients = map.axes * times_inverse(derivatives_by_component(turned(map.axes.transpose(), v), factors(map.scale)),
                                         map.component_inverse);
  else
    gradients = derivatives(v, is_scaled(map.rule) ? factors(map.scale) : unscaled) * map.inverse;
  if (!is_scaled(map.rule)) return gradients;  // the mean is exact
  const Matrix exact = mean_gradient(map, v);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) gradients(i, j) += exact(i, j) - (map.volume * gradients(i, j)).sum() / map.total;
  return gradients;
}

BrickModes brick_stress_forces(const BrickMap& map, const EightMatrices& stress) {
  Matrix mean;
  EightMatrices rest;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      mean(i, j) = (map.volume * stress(i, j)).sum() / map.total;
      rest(i, j) = map.volume * (stress(i, j) - mean(i, j));
    }
  BrickModes forces{mean * map.slope.linear, mean * map.slope.pairs, mean * map.slope.all};
  if (map.rule != SolidRule::accurate) {
    add_forces(times_transposed(rest, map.inverse), is_scaled(map.rule) ? factors(map.scale) : unscaled, forces);
    return forces;
  }
  EightMatrices columns = times_transposed_inverse(map.axes.transpose() * rest, map.component_inverse), own;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      own(i, j).setZero();
      if (i == j) own(i, j).swap(columns(i, j));
    }
  BrickModes local;
  add_forces(own, unscaled, local);
  add_forces(columns, factors(map.scale), local);
  const BrickModes back = turned(map.axes, local);
  forces.linear += back.linear;
  forces.pairs += back.pairs;
  forces.all += back.all;
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
