#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "solver/discrete/beam_arms.hpp"
#include "solver/element/beam.hpp"
#include "solver/state/assembly.hpp"
#include "solver/state/mass_scaling.hpp"
#include "solver/state/motion.hpp"
#include "solver/state/state.hpp"
#include "solver/state/summary.hpp"

namespace gapcheck::solver {

/// *INITIAL_AXIAL_FORCE_BEAM: the axial force follows a curve, whatever the beam's length does.
struct AxialPreload {
  TimeCurve force;
  double end = 0;        ///< of the curve, or where it first falls
  bool bending = false;  ///< KBEND = 1
  Phases phases{};
  [[nodiscard]] bool active(const State& state) const {
    return phases.now(state.relaxing) && state.time >= force.start() && state.time <= end;
  }
};

/// How a beam is joined to its nodes.
struct BeamJoint {
  std::array<Vector, 2> offset{Vector::Zero(), Vector::Zero()};  ///< of its ends from the nodes, at the start
  std::array<double, 2> shift{};  ///< of the axis from these places, along s and t, at the start
  BeamReleases released;
};

/// All beams and trusses of a structure; arrays by beam.
class BeamElements {
 public:
  /// Adds a part's properties; returns their position.
  std::uint32_t add_properties(BeamProperties properties);
  /// Adds a beam and its share of mass and rotational inertia to the nodes. `third`: a point in the plane of the axes r
  /// and s, from the first node; any length; only its direction across counts. `origin`: position in the model, for
  /// messages. Returns its length; if not above zero, the beam was not added. Adds the mass by DT of material 100 and
  /// by `scaling` to `added_mass`, if that is given. Ends off their nodes move with them as rigid arms.
  double add(const std::array<NodeIndex, 2>& nodes, std::uint32_t properties, const Vector& third, std::uint32_t origin,
             State& state, const MassScaling& scaling = {}, double* added_mass = nullptr, const BeamJoint& joint = {});
  /// The same for discrete beams, which may have no length. `axes`: of a local system, or nullptr. Returns their mass.
  double add_discrete(const std::array<NodeIndex, 2>& nodes, std::uint32_t properties, const Matrix* axes,
                      const Vector& third, std::uint32_t origin, State& state, const MassScaling& scaling = {},
                      double* added_mass = nullptr);
  /// Adds a preload; returns its position.
  std::uint32_t add_preload(AxialPreload preload);
  /// Gives it to an integrated beam.
  void preload(std::size_t beam, std::uint32_t preload) { preload_of_[beam] = preload; }
  [[nodiscard]] bool preloaded(std::size_t beam) const { return preload_of_[beam] != no_position; }
  /// Call it once all beams are added.
  void finish(std::size_t nodes);

  /// Forces at state.time (dt = 0: those of the present state).
  Summary update(const State& state);
  /// Watches the steps of all elements; call it once all are added. keep_steps() then adds mass where the last update()
  /// found one that is too small.
  void watch_steps(const MassScaling& scaling, const State& state);
  [[nodiscard]] AddedMass keep_steps(State& state);
  /// Subtracts the beams' pull on a node from its force and moment.
  void gather(std::size_t node, Vector& force, Vector& moment) const {
    for (const std::uint32_t place : table_.of(node)) {
      force -= force_[place];
      moment -= moment_[place];
    }
  }

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] std::uint32_t origin(std::size_t beam) const { return origin_[beam]; }
  [[nodiscard]] const std::array<NodeIndex, 2>& nodes(std::size_t beam) const { return nodes_[beam]; }
  [[nodiscard]] const BeamProperties& properties(std::size_t beam) const { return properties_[which_[beam]]; }
  [[nodiscard]] const ElementEnergy& energy(std::size_t beam) const { return energy_[beam]; }
  /// The energy that it stores, with all nodes at `x`.
  [[nodiscard]] double stored(std::size_t beam, const std::vector<Vector>& x) const;
  [[nodiscard]] const BeamState& state(std::size_t beam) const { return state_[beam]; }
  /// The axes r, s and t as columns, with all nodes at `x`.
  [[nodiscard]] Matrix axes(std::size_t beam, const std::vector<Vector>& x) const;
  /// Of a discrete beam; nullptr: it is none.
  [[nodiscard]] const DiscreteState* discrete(std::size_t beam) const {
    return discrete_of_[beam] == no_position ? nullptr : &discrete_[discrete_of_[beam]];
  }
  /// The integration points of an integrated beam.
  [[nodiscard]] std::span<const BeamPoint> points(std::size_t beam) const {
    return {points_.data() + first_point_[beam], points_.data() + first_point_[beam + 1]};
  }
  [[nodiscard]] bool failed(std::size_t beam) const { return failed_[beam] != 0; }
  /// True if one of them has a stress, and with it a time step.
  [[nodiscard]] bool limit_step() const;
  /// True if one of them may fail.
  [[nodiscard]] bool can_fail() const;
  /// Tension at the last evaluation.
  [[nodiscard]] double axial(std::size_t beam) const { return axial_[beam]; }
  /// Its ends are not at its nodes.
  [[nodiscard]] bool on_arms(std::size_t beam) const { return arms_.has(beam); }
  /// Force and moment on the second node, or node `k`, at the last evaluation; the beam pulls with the opposite.
  [[nodiscard]] const Vector& end_force(std::size_t beam, std::size_t k = 1) const { return force_[2 * beam + k]; }
  [[nodiscard]] const Vector& end_moment(std::size_t beam, std::size_t k = 1) const { return moment_[2 * beam + k]; }
  /// The moment on an end of the beam, which may be off its node.
  [[nodiscard]] Vector moment_at_end(std::size_t beam, std::size_t k) const {
    return arms_.at_end(beam, k, end_force(beam, k), end_moment(beam, k));
  }

 private:
  [[nodiscard]] Vector way(std::size_t beam, const std::vector<Vector>& x) const;
  [[nodiscard]] Summary update_one(const State& state, std::size_t beam);
  [[nodiscard]] BeamForces forces(const State& state, std::size_t beam, const BeamEnds& ends, double& supplied);
  [[nodiscard]] BeamForces discrete_forces_of(const State& state, std::size_t beam, const BeamEnds& ends,
                                              double& supplied);
  void append(const std::array<NodeIndex, 2>& nodes, std::uint32_t properties, std::uint32_t origin, BeamState beam);
  [[nodiscard]] BeamForces integrated_forces(const State& state, std::size_t beam, const BeamEnds& ends,
                                             double& supplied);
  [[nodiscard]] bool fails(const State& state, std::size_t beam, const BeamForces& forces);
  [[nodiscard]] double mass_factor(const State& state, const MassScaling& scaling);

  std::vector<BeamProperties> properties_;
  std::vector<std::array<NodeIndex, 2>> nodes_;
  std::vector<std::uint32_t> which_, origin_;  ///< position in properties_, in the model
  std::vector<BeamState> state_;
  std::vector<std::size_t> first_point_{0};  ///< of each beam among points_; one more than beams
  std::vector<BeamPoint> points_;
  std::vector<DiscreteState> discrete_;
  std::vector<std::uint32_t> discrete_of_;  ///< by beam; no_position: it is none
  std::vector<AxialPreload> preloads_;
  std::vector<std::uint32_t> preload_of_;  ///< by beam; no_position: none
  BeamArms arms_;
  std::vector<double> step_factor_;  ///< by beam: √ of the factor on its mass
  std::vector<std::uint8_t> failed_;
  std::vector<double> axial_;
  std::vector<ElementEnergy> energy_;
  std::vector<Vector> force_, moment_;  ///< two entries per beam
  WatchedSteps watched_;
  CornerTable table_;
};

}  // namespace gapcheck::solver
