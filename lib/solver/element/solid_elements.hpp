#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "solver/element/solid.hpp"
#include "solver/quadrature/nodal_average.hpp"
#include "solver/state/assembly.hpp"
#include "solver/state/mass_scaling.hpp"
#include "solver/state/summary.hpp"

namespace gapcheck::solver {

/// When solids fail but by their material.
struct SolidEnds {
  bool inverted = false;         ///< when they lose their volume
  double share = 0, factor = 0;  ///< of let_small_steps_fail(); share 0: none fails by its step
  double least = 0;              ///< step, known from the first one on
  [[nodiscard]] bool exist() const { return inverted || share > 0; }
};

/// Solids with some of these properties may fail.
inline bool any_can_fail(std::span<const SolidProperties> all) {
  return std::any_of(all.begin(), all.end(), [](const SolidProperties& p) {
    return p.material.can_fail() || p.weld.exist() || p.inverted_fails;
  });
}

/// All solids of a structure; arrays by solid.
class SolidElements {
 public:
  /// Adds a part's properties; returns their position.
  std::uint32_t add_properties(SolidProperties properties);
  /// Adds a solid (a tetrahedron repeats its fourth corner) at positions `x` of all nodes and its share of mass to the
  /// nodes. `origin`: its position in the model, for messages. Returns its volume; if not above zero, the solid was not
  /// added; of eight points it may be eight times that of the least one. `added`: receives the mass that `scaling`
  /// adds.
  double add(const std::array<NodeIndex, 8>& nodes, std::uint32_t properties, std::uint32_t origin, State& state,
             const MassScaling& scaling = {}, double* added = nullptr);
  /// What a solid begins with instead of nothing: all its points, with all nodes at `x`. Between the last add() and
  /// finish().
  void begin_with(std::size_t solid, std::span<const PointState> points, const std::vector<Vector>& x);
  /// Solids whose normal stress is given for a while; each in one section at most. Returns its position.
  std::uint32_t add_section(SectionStress section);
  [[nodiscard]] const std::vector<SectionStress>& sections() const { return sections_; }
  /// The section that a solid is in; no_position: none.
  [[nodiscard]] std::uint32_t section_of(std::size_t solid) const {
    return section_of_.empty() ? no_position : section_of_[solid];
  }
  /// The force that the solids of a section carry along its normal, above zero in tension.
  [[nodiscard]] double section_force(std::size_t section) const;
  [[nodiscard]] SolidRule rule(std::size_t solid) const { return rule_[solid]; }
  /// Call it once all solids are added.
  void finish(std::size_t nodes);

  /// Forces at state.time, stresses updated over the last step (dt = 0: the forces of the present stresses).
  Summary update(const State& state);
  /// Watches the steps of all elements; call it once all are added. keep_steps() then adds mass where the last update()
  /// found one that is too small.
  void watch_steps(const MassScaling& scaling, const State& state);
  [[nodiscard]] AddedMass keep_steps(State& state);
  /// Subtracts the solids' pull on a node from its force.
  void gather(std::size_t node, Vector& force) const {
    for (const std::uint32_t place : table_.of(node)) force -= force_[place];
  }

  /// Internal force on a corner at the last evaluation; the solid pulls its node with the opposite. A tetrahedron has
  /// four corners.
  [[nodiscard]] const Vector& corner_force(std::size_t solid, std::size_t k) const { return force_[8 * solid + k]; }
  [[nodiscard]] std::size_t corners(std::size_t solid) const;
  [[nodiscard]] const std::array<NodeIndex, 8>& nodes(std::size_t solid) const { return nodes_[solid]; }

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] std::uint32_t origin(std::size_t solid) const { return origin_[solid]; }
  /// False: none ever fails.
  [[nodiscard]] bool can_fail() const { return ends_.exist() || any_can_fail(properties_); }
  /// Its point has failed, or it was a spotweld and is torn: it has no stress, no force and no time step any more.
  [[nodiscard]] bool failed(std::size_t solid) const { return failed_[solid]; }
  /// A solid that loses its volume also fails, instead of ending the run.
  void let_inverted_fail() { ends_.inverted = true; }
  /// A solid also fails when its time step falls below this share of the run's first one (DTMIN with ERODE = 1 of
  /// *CONTROL_TIMESTEP). `factor`: TSSFAC.
  void let_small_steps_fail(double share, double factor) { ends_ = {ends_.inverted, share, factor}; }
  [[nodiscard]] const SolidProperties& properties(std::size_t solid) const { return properties_[which_[solid]]; }
  [[nodiscard]] const ElementEnergy& energy(std::size_t solid) const { return energy_[solid]; }
  /// The energy that its stress stores, with all nodes at `x`.
  [[nodiscard]] double stored(std::size_t solid, const std::vector<Vector>& x) const;
  /// The mean over its points.
  [[nodiscard]] PointState point(std::size_t solid) const;
  /// One point, or the eight next to the corners.
  [[nodiscard]] std::span<const PointState> points(std::size_t solid) const {
    return {points_.data() + first_point_[solid], points_.data() + first_point_[solid + 1]};
  }

 private:
  [[nodiscard]] Summary update_one(const State& state, std::size_t solid);
  [[nodiscard]] SolidForces forces_of(std::size_t solid, const SolidCorners& corners, double dt);
  /// The end of the solids from `first` on that can be in one batch; `first`: it cannot be in any.
  [[nodiscard]] std::size_t end_of_batch(std::size_t first, std::size_t last) const;
  /// update_one() of the first solid, or of all that can be in one batch with it; returns the end of these.
  std::size_t update_some(const State& state, std::size_t first, std::size_t end, Summary& sum);
  /// Removes a solid that fails, otherwise notes its steps or that it is bad.
  void judge(std::size_t solid, bool fails_now, SolidForces& forces, Summary& summary);
  [[nodiscard]] Summary conclude(std::size_t solid, const SolidForces& forces, Summary summary);
  /// With the stress of its section. `supplied`: what that puts into the solid in the step.
  [[nodiscard]] SolidForces preloaded_forces(const State& state, std::size_t solid, const SolidCorners& corners,
                                             double& supplied);
  [[nodiscard]] double stored_at(std::size_t solid, const std::array<Vector, 8>& corners) const;

  std::vector<SolidProperties> properties_;
  std::vector<char> batched_;  ///< by properties: BrickBatch takes them
  std::vector<std::array<NodeIndex, 8>> nodes_;
  std::vector<std::uint32_t> which_, origin_;  ///< position in properties_, in the model
  std::vector<SolidRule> rule_;
  std::vector<SolidState> state_;
  std::vector<std::uint64_t> first_point_{0};
  std::vector<PointState> points_;
  std::vector<Vector> force_;  ///< eight entries per solid
  std::vector<ElementEnergy> energy_;
  std::vector<char> failed_;  ///< not bits: written by several threads
  std::vector<SectionStress> sections_;
  std::vector<std::uint32_t> section_of_;  ///< by solid; empty: no solid is in a section
  SolidEnds ends_;
  WatchedSteps watched_;
  NodalAverage average_;                     ///< of tetrahedra with nodal pressures
  std::vector<NodalAverage::Share> shares_;  ///< of each of them
  CornerTable table_;
};

}  // namespace gapcheck::solver
