#pragma once
#include <Eigen/Dense>
#include <span>
#include <vector>

#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// Velocity, then angular velocity.
using Twist = Eigen::Matrix<double, 6, 1>;

/// The rigid motion next to the velocities of some nodes: u and θ of the least Σ (vᵢ − u − θ × rᵢ)ᵀ Wᵢ (vᵢ − u − θ ×
/// rᵢ). Rigid motions come out exactly.
class MotionFit {
 public:
  /// Symmetric weights without negative eigenvalues, and places, by node; there is at least one.
  MotionFit(std::span<const Matrix> weights, std::span<const Vector> places);

  /// The motion of a point of the body (velocity, angular velocity) by the velocity of a node.
  [[nodiscard]] Eigen::Matrix<double, 6, 3> share(std::size_t node, const Vector& point) const;
  /// Whether the nodes give this component of the point's motion: not the rotation about the line of nodes in line.
  [[nodiscard]] bool determines(const Twist& component, const Vector& point) const;

 private:
  using Six = Eigen::Matrix<double, 6, 6>;
  /// The motion of a point by the unknowns: the centre's velocity, and the angular velocity times the size.
  [[nodiscard]] Six at(const Vector& point) const;

  Vector center_ = Vector::Zero();
  double size_ = 1;           ///< root mean square distance of the nodes from their centre
  std::vector<Vector> arms_;  ///< from the centre, in sizes
  std::vector<Matrix> weights_;
  Six inverse_ = Six::Zero();  ///< of the normal equations; motions that are not given stay zero
  Six free_ = Six::Zero();     ///< columns: these motions
};

}  // namespace gapcheck::solver
