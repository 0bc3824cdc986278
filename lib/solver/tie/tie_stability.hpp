#pragma once
#include <cstdint>
#include <vector>

#include "solver/tie/tie.hpp"

namespace gapcheck::solver {

/// Keeps the springs of ties stable. All springs together have no frequency above that of the largest row sum of
/// K in coordinates divided by the roots of the masses (Gershgorin); springs that would bring a row over the limit are
/// softened.
class TieStability {
 public:
  explicit TieStability(const Structure& structure) : structure_(structure) {}
  /// A spring along the offset and one for rotations, at the present positions.
  void add(const Tie& tie, const SegmentAxes& axes, const Vector& arm, double stiffness, double rotational);
  /// By spring, in the order added (translation and rotation of a tie): the share of the stiffness that keeps all
  /// squared frequencies at or below `greatest`.
  [[nodiscard]] std::vector<double> shares(double greatest) const;
  /// Upper bound of the squared frequencies; `shares`: of the stiffness.
  [[nodiscard]] double squared_frequency(const std::vector<double>& shares) const;

 private:
  /// A spring's share in the motion of something with mass, divided by the root of the mass.
  struct Part {
    std::size_t mass = 0;
    double size = 0;
  };
  struct Spring {
    std::size_t first = 0, last = 0;  ///< of parts_
    double stiffness = 0, sum = 0;    ///< sum: of all parts
  };
  void move(NodeIndex node, double share);
  void turn(NodeIndex node, double share);
  void begin(double stiffness);
  void finish();
  [[nodiscard]] std::vector<double> rows(const std::vector<double>& shares) const;

  const Structure& structure_;
  std::vector<Spring> springs_;
  std::vector<Part> parts_;
};

}  // namespace gapcheck::solver
