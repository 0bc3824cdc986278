#pragma once
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/tie/tie.hpp"

namespace gapcheck::solver {

/// A tie as an equation: velocity of the node - velocity of the point - spin × arm, and the difference of angular
/// velocities, are given.
struct TieEquation {
  const Tie* tie = nullptr;
  const SegmentAxes* axes = nullptr;
  Vector arm = Vector::Zero();  ///< from the point to the node, if the tie carries its moment
  bool active = true;
};

/// The inverse mass of each degree of freedom: six per node, 0 if held.
using Mobility = std::vector<double>;

/// The equations (G M⁻¹ Gᵀ) λ = r of ties that share nodes. Three rows per tie, three more where rotations are tied.
/// Rows that follow from others or move nothing are left out: their λ is 0.
class TieSystem {
 public:
  /// `nodes`: how many the structure has.
  TieSystem(std::span<const Tie> ties, std::size_t nodes);
  [[nodiscard]] std::size_t size() const { return rows_; }
  /// First row of a tie.
  [[nodiscard]] std::size_t row(std::size_t tie) const { return first_row_[tie]; }
  /// Factorises. `fresh`: held degrees of freedom or active ties have changed, so other rows may be left out; false:
  /// only the arms have turned.
  void set(std::span<const TieEquation> equations, const Mobility& mobility, bool fresh);
  [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd right) const;
  /// By row: left out because it follows from others, although it could move something.
  [[nodiscard]] const std::vector<bool>& dependent() const { return dependent_; }

 private:
  using Sparse = Eigen::SparseMatrix<double>;
  void fill(std::span<const TieEquation> equations);
  void multiply(const Mobility& mobility);
  /// Cholesky with `share` of the diagonal added; false where it fails.
  bool factorise(double share);
  /// Marks rows whose pivot has vanished; true if there are new ones.
  bool leave_out_dependent();

  std::vector<std::size_t> first_row_;
  std::size_t rows_ = 0, nodes_ = 0;
  std::vector<std::uint32_t> place_;  ///< by node: its position among those with ties
  std::vector<NodeIndex> used_;
  std::vector<bool> idle_, dependent_;  ///< by row
  Sparse g_, a_;
  Eigen::VectorXd diagonal_;
  Eigen::SimplicialLDLT<Sparse> factor_;
  Eigen::Index analysed_ = -1;  ///< entries of the matrix whose pattern is known
};

}  // namespace gapcheck::solver
