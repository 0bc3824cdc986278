#pragma once
#include <Eigen/Dense>
#include <cstdint>
#include <vector>

#include "solver/state/force.hpp"

namespace gapcheck::solver {

/// Degrees of freedom that move together or by linear equations (*CONSTRAINED_NODE_SET, *CONSTRAINED_LINEAR_GLOBAL and
/// _LOCAL).
/// Joined ones have the velocity of their common momentum; equations Σ c v = 0 get reactions −c λ, which do no work
/// together. Equations that share degrees of freedom are solved at once. In the first cycle the initial velocities are
/// replaced by the nearest ones, by the masses, that meet them.
class LinearConstraints : public Force {
 public:
  /// A translation (0 … 2) or rotation (3 … 5) of a node outside rigid bodies that nothing else holds or moves.
  struct Freedom {
    std::uint32_t node = 0;
    std::uint8_t freedom = 0;
    bool operator==(const Freedom&) const = default;
    auto operator<=>(const Freedom&) const = default;
  };
  struct Term {
    Freedom at;
    double factor = 0;
  };
  /// Until the time `end`; each degree of freedom at most once.
  void join(const std::vector<Freedom>& freedoms, double end);
  void add_equation(const std::vector<Term>& terms);
  /// Call it once all are added.
  void finish();
  /// Of the equations that are solved together, the most at once.
  [[nodiscard]] std::size_t largest_group() const;

  void add(State& state, Forces& forces) override;
  [[nodiscard]] bool reacts() const override { return true; }
  void react(const State& state, double mean, double next, Forces& net, Forces& external) override;

 private:
  struct Joined {
    std::vector<std::uint32_t> members;  ///< positions in freedoms_
    double end;
  };
  struct Entry {
    std::uint32_t freedom;  ///< position in freedoms_
    double factor;
  };
  /// Equations that share degrees of freedom; the solver of c M⁻¹ cᵀ for the masses of `masses`.
  struct Group {
    std::vector<std::vector<Entry>> rows;
    std::vector<double> masses;
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  };
  std::uint32_t position(const Freedom& freedom);
  /// Changes velocities_ to those that meet all at a time.
  void project(double time);
  void project(Group& group);
  void factorise(Group& group) const;

  std::vector<Freedom> freedoms_;  ///< as added
  std::vector<Joined> joined_;
  std::vector<Group> groups_;
  std::vector<double> mass_, velocity_;
  std::vector<std::uint32_t> joined_of_;  ///< by freedom: position in joined_; no_position: none
  std::vector<bool> acts_;                ///< by joined
};

}  // namespace gapcheck::solver
