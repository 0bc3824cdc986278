#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "solver/state/assembly.hpp"
#include "solver/state/mass_scaling.hpp"
#include "solver/state/summary.hpp"
#include "solver/thick/thick_shell.hpp"

namespace gapcheck::solver {

/// All thick shells of a structure; arrays by shell.
class ThickShellElements {
 public:
  /// Adds a part's properties; returns their position.
  std::uint32_t add_properties(ShellProperties properties);
  /// Adds a thick shell at positions `x` of all nodes and its share of mass to the nodes. `origin`: its position in the
  /// model. Returns its volume; if not above zero, it was not added. `added`: receives the mass that `scaling` adds.
  double add(const std::array<NodeIndex, 8>& nodes, std::uint32_t properties, std::uint32_t origin, State& state,
             const MassScaling& scaling = {}, double* added = nullptr);
  /// Call it once all are added.
  void finish(std::size_t nodes);

  /// Forces at state.time, stresses updated over the last step (dt = 0: the forces of the present stresses).
  Summary update(const State& state);
  /// Subtracts the shells' pull on a node from its force.
  void gather(std::size_t node, Vector& force) const {
    for (const std::uint32_t place : table_.of(node)) force -= force_[place];
  }

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] std::uint32_t origin(std::size_t shell) const { return origin_[shell]; }
  [[nodiscard]] const std::array<NodeIndex, 8>& nodes(std::size_t shell) const { return nodes_[shell]; }
  [[nodiscard]] const ShellProperties& properties(std::size_t shell) const { return properties_[which_[shell]]; }
  [[nodiscard]] const ThickShellState& state(std::size_t shell) const { return state_[shell]; }
  [[nodiscard]] const ElementEnergy& energy(std::size_t shell) const { return energy_[shell]; }
  /// Thick shells do not fail as elements; a layer that has failed has no stress.
  [[nodiscard]] static bool failed(std::size_t) { return false; }
  /// The energy that its stresses store, with all nodes at `x`.
  [[nodiscard]] double stored(std::size_t shell, const std::vector<Vector>& x) const;
  /// The axes of its layers' stresses with all nodes at `x`, as columns.
  [[nodiscard]] Matrix axes(std::size_t shell, const std::vector<Vector>& x) const;
  /// Layers from the lower to the upper side.
  [[nodiscard]] std::span<const PointState> points(std::size_t shell) const {
    return {points_.data() + first_point_[shell], points_.data() + first_point_[shell + 1]};
  }

 private:
  [[nodiscard]] Summary update_one(const State& state, std::size_t shell);
  [[nodiscard]] std::array<Vector, 8> places(std::size_t shell, const std::vector<Vector>& x) const;

  std::vector<ShellProperties> properties_;
  std::vector<std::array<NodeIndex, 8>> nodes_;
  std::vector<std::uint32_t> which_, origin_;  ///< position in properties_, in the model
  std::vector<ThickShellState> state_;
  std::vector<std::uint64_t> first_point_{0};
  std::vector<PointState> points_;
  std::vector<Vector> force_;  ///< eight entries per shell
  std::vector<ElementEnergy> energy_;
  CornerTable table_;
};

}  // namespace gapcheck::solver
