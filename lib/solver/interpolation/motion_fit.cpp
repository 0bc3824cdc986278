#include "solver/interpolation/motion_fit.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace gapcheck::solver {
namespace {

/// Eigenvalues below this share of the greatest belong to motions that the nodes do not give.
constexpr double least_eigenvalue = 1e-10;
/// A component that such a motion changes by less than this is given all the same.
constexpr double least_change = 1e-6;

Eigen::Matrix<double, 3, 6> motion_at(const Vector& arm) {
  Eigen::Matrix<double, 3, 6> result;
  result << Matrix::Identity(), cross_matrix(-arm);  // u + θ × arm
  return result;
}

}  // namespace

MotionFit::MotionFit(std::span<const Matrix> weights, std::span<const Vector> places)
    : arms_(places.begin(), places.end()), weights_(weights.begin(), weights.end()) {
  const auto count = static_cast<double>(places.size());
  for (const Vector& place : places) center_ += place / count;
  double squared = 0;
  for (Vector& arm : arms_) arm -= center_, squared += arm.squaredNorm() / count;
  if (squared > 0) size_ = std::sqrt(squared);
  Six sum = Six::Zero();
  for (std::size_t i = 0; i < arms_.size(); ++i) {
    arms_[i] /= size_;
    const Eigen::Matrix<double, 3, 6> motion = motion_at(arms_[i]);
    sum += motion.transpose() * weights_[i] * motion;
  }
  const Eigen::SelfAdjointEigenSolver<Six> eigen(sum);
  const double greatest = eigen.eigenvalues()[5];
  for (int k = 0; k < 6; ++k) {
    const Twist mode = eigen.eigenvectors().col(k);
    const double value = eigen.eigenvalues()[k];
    if (value > least_eigenvalue * greatest)
      inverse_ += mode * mode.transpose() / value;
    else
      free_.col(k) = mode;
  }
}

MotionFit::Six MotionFit::at(const Vector& point) const {
  Six result = Six::Zero();
  result.topRows<3>() = motion_at((point - center_) / size_);
  result.bottomRightCorner<3, 3>() = Matrix::Identity() / size_;
  return result;
}

Eigen::Matrix<double, 6, 3> MotionFit::share(std::size_t node, const Vector& point) const {
  return at(point) * (inverse_ * (motion_at(arms_[node]).transpose() * weights_[node]));
}

bool MotionFit::determines(const Twist& component, const Vector& point) const {
  const Twist change = free_.transpose() * (at(point).transpose() * component);
  const double far = 1 + (point - center_).norm() / size_;
  const double unit = component.head<3>().norm() * far + component.tail<3>().norm() / size_;
  return change.lpNorm<Eigen::Infinity>() <= least_change * unit;
}

}  // namespace gapcheck::solver
