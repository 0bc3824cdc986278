#pragma once
#include <optional>
#include <span>

namespace gapcheck::solver {

/// A node at a segment when the two meet.
struct PressedNode {
  double stiffness = 0;
  double release = 0;  ///< depth at which it is released
};

/// The greatest depth at the times of a run's steps lies between these.
struct DepthRange {
  double least = 0, most = 0;
};

/// The depth of springs of this sum of stiffness that stop one mass, 1 / `mobility`, of this speed: v sqrt(m / k). In
/// steps dt of central differences, with W = dt sqrt(k / m), the largest of all steps lies between the factors
/// sqrt(1 - W² / 4) and its inverse: the invariant of the difference equation gives an amplitude between v sqrt(m / k)
/// and that over sqrt(1 - W² / 4), depending on how deep the first step leads, and some step meets it up to the cosine
/// of W / 2. Nothing: not stable.
[[nodiscard]] std::optional<DepthRange> depth_of_one_mass(double speed, double mobility, double stiffness, double step);

/// The greatest depth of a spring that takes all of an energy: ½ k p² never exceeds it in the middle of a step of
/// central differences, and `share`, (dt times the frequency of the spring)², takes it from there to the ends. Nothing:
/// not stable.
[[nodiscard]] std::optional<double> depth_of_energy(double energy, double stiffness, double share);

/// The greatest speed with which a body may hit something fixed so that none of its nodes is released, whatever it is
/// made of as long as it stores or dissipates what is done to it: with more the contact is lost. `first`: the nodes
/// that meet at one time, of this mass; `all`: all that meet. In the frame of the body the fixed surface does work on
/// it, at most v Σ k d per time; the first nodes must have moved by v t − d then, and have at least the kinetic energy
/// of that. The best t, three times d / v, gives v² <= 27/4 Σ(k d) d / m.
[[nodiscard]] double speed_of_release(std::span<const PressedNode> first, std::span<const PressedNode> all,
                                      double mass);
/// How much farther than the release depth the body of speed_of_release() flies until then.
inline constexpr double flight_of_release = 3;

/// The same for a body of which all mass is in the nodes that meet at one time: its centre of mass is decelerated by
/// Σ k d / m at most, and its way is the mean of theirs: v² / 2 <= d Σ(k d) / m, for steps dt in between.
[[nodiscard]] double speed_of_release_of_sheet(std::span<const PressedNode> nodes, double mass, double step);

}  // namespace gapcheck::solver
