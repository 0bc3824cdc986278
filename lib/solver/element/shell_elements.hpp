#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "base/ids.hpp"
#include "solver/element/shell.hpp"
#include "solver/state/assembly.hpp"
#include "solver/state/mass_scaling.hpp"
#include "solver/state/summary.hpp"

namespace gapcheck::solver {

/// All shells of a structure; arrays by shell.
class ShellElements {
 public:
  /// Adds a part's properties; returns their position.
  std::uint32_t add_properties(ShellProperties properties);
  /// The position of properties that differ in `reference` alone; adds them where there are none.
  std::uint32_t with_reference(std::uint32_t properties, double reference);
  /// Adds a shell (a triangle repeats its third corner) at positions `x` of all nodes and its share of mass and
  /// rotational inertia to the nodes. `origin`: its position in the model, for messages.
  /// Returns the mass added by `scaling`.
  double add(const std::array<NodeIndex, 4>& nodes, std::uint32_t properties, double thickness, std::uint32_t origin,
             State& state, const MassScaling& scaling = {});
  /// Of the shell that was added last: the angle from its x axis to the material's axis a.
  void set_axis(double angle) { state_.back().axis = angle; }
  /// The axes of a shell with all nodes at `x`, as columns: those of its points' stresses.
  [[nodiscard]] Matrix axes(std::size_t shell, const std::vector<Vector>& x) const;
  /// 1; 4 of shells with four points in the plane, 3 of triangles after Batoz.
  [[nodiscard]] std::size_t points_in_plane(std::size_t shell) const {
    return full(shell) ? 4 : kirchhoff(shell) ? 3 : 1;
  }
  /// What a shell begins with instead of nothing: all its points, with all nodes at `x`. Between the last add() and
  /// finish().
  void begin_with(std::size_t shell, std::span<const PointState> points, const std::vector<Vector>& x);
  /// Call it once all shells are added.
  void finish(std::size_t nodes);

  /// Forces at state.time, stresses updated over the last step (dt = 0: the forces of the present stresses).
  Summary update(const State& state);
  /// Watches the steps of all elements; call it once all are added. keep_steps() then adds mass where the last update()
  /// found one that is too small.
  void watch_steps(const MassScaling& scaling, const State& state);
  [[nodiscard]] AddedMass keep_steps(State& state);
  /// Subtracts the shells' pull on a node from its force and moment.
  void gather(std::size_t node, Vector& force, Vector& moment) const {
    for (const std::uint32_t place : table_.of(node)) {
      force -= force_[place];
      moment -= moment_[place];
    }
  }

  /// Internal force and moment on a corner at the last evaluation; the shell pulls its node with the opposite.
  [[nodiscard]] const Vector& corner_force(std::size_t shell, std::size_t k) const { return force_[4 * shell + k]; }
  /// 3 of triangles without four points in the plane, otherwise 4, of which two may be one node.
  [[nodiscard]] std::size_t corners(std::size_t shell) const { return triangle(shell) && !full(shell) ? 3 : 4; }
  [[nodiscard]] const Vector& corner_moment(std::size_t shell, std::size_t k) const { return moment_[4 * shell + k]; }

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] std::uint32_t origin(std::size_t shell) const { return origin_[shell]; }
  [[nodiscard]] const std::array<NodeIndex, 4>& nodes(std::size_t shell) const { return nodes_[shell]; }
  [[nodiscard]] const ShellProperties& properties(std::size_t shell) const { return properties_[which_[shell]]; }
  /// False: none ever fails.
  [[nodiscard]] bool can_fail() const {
    return std::any_of(properties_.begin(), properties_.end(), [](const ShellProperties& p) {
      return p.material.can_fail() || p.folded == FoldedShell::fails;
    });
  }
  /// All its layers, or enough of them, have failed: it has no stress, no force and no time step any more.
  [[nodiscard]] bool failed(std::size_t shell) const { return failed_[shell]; }
  [[nodiscard]] const ElementEnergy& energy(std::size_t shell) const { return energy_[shell]; }
  /// The energy that its stresses store, with all nodes at `x`.
  [[nodiscard]] double stored(std::size_t shell, const std::vector<Vector>& x) const;
  [[nodiscard]] const ShellState& state(std::size_t shell) const { return state_[shell]; }
  /// Layers of the first point in the plane, then those of the next.
  [[nodiscard]] std::span<const PointState> points(std::size_t shell) const {
    return {points_.data() + first_point_[shell], points_.data() + first_point_[shell + 1]};
  }

 private:
  [[nodiscard]] ShellForces at_rest(std::size_t shell, const std::vector<Vector>& x) const;
  [[nodiscard]] bool triangle(std::size_t shell) const { return nodes_[shell][2] == nodes_[shell][3]; }
  /// It has four points in the plane.
  [[nodiscard]] bool full(std::size_t shell) const {
    const ShellProperties& own = properties(shell);
    return own.form == ShellForm::full && !(own.sorts && triangle(shell));
  }
  [[nodiscard]] bool kirchhoff(std::size_t shell) const {
    return triangle(shell) && !full(shell) && properties(shell).discrete_kirchhoff;
  }
  [[nodiscard]] ShellForces forces(std::size_t shell, const ShellCorners& corners, double dt, ShellState& state,
                                   std::span<PointState> points) const;
  [[nodiscard]] Summary update_one(const State& state, std::size_t shell);
  /// The end of the shells from `first` on, before `last`, that one batch takes; `first` where it takes none.
  [[nodiscard]] std::size_t end_of_batch(std::size_t first, std::size_t last) const;
  /// update_one() for shells of a batch, one after the other.
  void update_batch(const State& state, std::size_t first, std::size_t last, Summary& sum);
  /// Whether a shell fails now: then `forces` are none. A fold that ends the run makes them bad.
  bool fails_now(const State& state, std::size_t shell, ShellForces& forces, Summary& summary);
  /// The summary of a shell, of which failure and work are known.
  [[nodiscard]] Summary conclude(std::size_t shell, const ShellForces& forces, Summary summary);

  std::vector<ShellProperties> properties_;
  std::vector<char> batched_;                                             ///< by properties: batches take such quads
  std::map<std::pair<std::uint32_t, double>, std::uint32_t> referenced_;  ///< positions by with_reference()
  std::vector<std::array<NodeIndex, 4>> nodes_;
  std::vector<std::uint32_t> which_, origin_;  ///< position in properties_, in the model
  std::vector<ShellState> state_;
  std::vector<double> step_factor_;  ///< root of the factor on the mass; empty: no shell is scaled
  std::vector<std::uint64_t> first_point_{0};
  std::vector<PointState> points_;
  std::vector<Vector> force_, moment_;  ///< four entries per shell
  std::vector<ElementEnergy> energy_;
  std::vector<char> failed_;  ///< not bits: written by several threads
  WatchedSteps watched_;
  CornerTable table_;
};

}  // namespace gapcheck::solver
