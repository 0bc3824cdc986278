#include "solver/tie/tie_system.hpp"

#include <cmath>

namespace gapcheck::solver {
namespace {

/// A row whose pivot is below this share of its diagonal follows from others.
constexpr double least_pivot = 1e-9;
/// Share of the diagonal that keeps a search for such rows from dividing by zero.
constexpr double support = 1e-12;

}  // namespace

TieSystem::TieSystem(std::span<const Tie> ties, std::size_t nodes) : nodes_(nodes) {
  place_.assign(nodes, no_position);
  const auto use = [&](NodeIndex node) {
    if (place_[node.value] != no_position) return;
    place_[node.value] = static_cast<std::uint32_t>(used_.size());
    used_.push_back(node);
  };
  for (const Tie& tie : ties) {
    first_row_.push_back(rows_);
    rows_ += tie.rotations ? 6 : 3;
    use(tie.node);
    for (const NodeIndex corner : tie.point.nodes) use(corner);
  }
}

void TieSystem::fill(std::span<const TieEquation> equations) {
  std::vector<Eigen::Triplet<double, int>> entries;
  // Zero entries stay, so that the pattern does not change.
  const auto block = [&](std::size_t row, NodeIndex node, bool rotation, const Matrix& m, bool active) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        entries.emplace_back(static_cast<int>(row) + i,
                             static_cast<int>(6 * place_[node.value]) + (rotation ? 3 : 0) + j, active ? m(i, j) : 0);
  };
  const auto scaled = [&](std::size_t row, NodeIndex node, bool rotation, double factor, bool active) {
    for (int i = 0; i < 3; ++i)
      entries.emplace_back(static_cast<int>(row) + i, static_cast<int>(6 * place_[node.value]) + (rotation ? 3 : 0) + i,
                           active ? factor : 0);
  };
  for (std::size_t t = 0; t < equations.size(); ++t) {
    const TieEquation& equation = equations[t];
    const Tie& tie = *equation.tie;
    const std::size_t row = first_row_[t];
    const Matrix arm = cross_matrix(equation.arm);
    const bool active = equation.active;
    scaled(row, tie.node, false, 1, active);
    if (tie.rotations) scaled(row + 3, tie.node, true, 1, active);
    for (std::size_t i = 0; i < 4; ++i) {
      const NodeIndex corner = tie.point.nodes[i];
      const double weight = tie.point.weights[i];
      scaled(row, corner, false, -weight, active);
      if (tie.carries && tie.offset == Turning::axes) block(row, corner, false, arm * equation.axes->turn[i], active);
      if (tie.carries && tie.offset == Turning::nodes) block(row, corner, true, weight * arm, active);
      if (!tie.rotations) continue;
      if (tie.rotation == Turning::axes) block(row + 3, corner, false, -equation.axes->turn[i], active);
      if (tie.rotation == Turning::nodes) scaled(row + 3, corner, true, -weight, active);
      if (tie.rotation != Turning::drill) continue;
      const Matrix drill = equation.axes->drill();
      block(row + 3, corner, false, -drill * equation.axes->turn[i], active);
      block(row + 3, corner, true, weight * (drill - Matrix::Identity()), active);
    }
  }
  g_.resize(static_cast<Eigen::Index>(rows_), static_cast<Eigen::Index>(6 * used_.size()));
  g_.setFromTriplets(entries.begin(), entries.end());
}

void TieSystem::multiply(const Mobility& mobility) {
  // Rows that are left out move nothing; the diagonal then is 1.
  for (Eigen::Index column = 0; column < g_.outerSize(); ++column)
    for (Sparse::InnerIterator entry(g_, column); entry; ++entry)
      if (const auto row = static_cast<std::size_t>(entry.row()); idle_[row] || dependent_[row]) entry.valueRef() = 0;
  Sparse weighted = g_;
  for (Eigen::Index column = 0; column < weighted.outerSize(); ++column) {
    const auto c = static_cast<std::size_t>(column);
    const double factor = mobility[std::size_t{6} * used_[c / 6].value + c % 6];
    for (Sparse::InnerIterator entry(weighted, column); entry; ++entry) entry.valueRef() *= factor;
  }
  const Sparse transposed = g_.transpose();
  a_ = weighted * transposed;
  diagonal_ = a_.diagonal();
  for (std::size_t row = 0; row < rows_; ++row) {
    const auto r = static_cast<Eigen::Index>(row);
    if (diagonal_[r] > 0 && std::isfinite(diagonal_[r])) continue;
    if (!dependent_[row]) idle_[row] = true;
    a_.coeffRef(r, r) = diagonal_[r] = 1;
  }
}

bool TieSystem::factorise(double share) {
  if (share > 0) {
    Sparse supported = a_;
    for (Eigen::Index i = 0; i < diagonal_.size(); ++i) supported.coeffRef(i, i) += share * diagonal_[i];
    factor_.compute(supported);
    analysed_ = -1;
  } else if (a_.nonZeros() != analysed_) {
    factor_.compute(a_);
    analysed_ = a_.nonZeros();
  } else {
    factor_.factorize(a_);
  }
  return factor_.info() == Eigen::Success;
}

bool TieSystem::leave_out_dependent() {
  // Only NaN coefficients make this fail: then no row is usable.
  const bool sound = factorise(support);
  bool any = false;
  for (Eigen::Index row = 0; row < diagonal_.size(); ++row) {
    const auto r = static_cast<std::size_t>(row);
    if (dependent_[r]) continue;
    if (sound && factor_.vectorD()[factor_.permutationP().indices()[row]] > least_pivot * diagonal_[row]) continue;
    dependent_[r] = any = true;
  }
  return any;
}

void TieSystem::set(std::span<const TieEquation> equations, const Mobility& mobility, bool fresh) {
  if (rows_ == 0) return;
  if (fresh) idle_.assign(rows_, false), dependent_.assign(rows_, false);
  fill(equations);
  multiply(mobility);
  if (!fresh && factorise(0) && (factor_.vectorD().array() > 0).all()) return;
  while (leave_out_dependent()) multiply(mobility);
  factorise(0);
}

Eigen::VectorXd TieSystem::solve(Eigen::VectorXd right) const {
  if (rows_ == 0) return right;
  for (std::size_t row = 0; row < rows_; ++row)
    if (idle_[row] || dependent_[row]) right[static_cast<Eigen::Index>(row)] = 0;
  Eigen::VectorXd lambda = factor_.solve(right);
  lambda += factor_.solve(right - a_ * lambda);
  return lambda;
}

}  // namespace gapcheck::solver
