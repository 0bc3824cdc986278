#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/state/failure.hpp"
#include "solver/state/force.hpp"
#include "solver/state/motion.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

struct StepSettings {
  double time_step_factor = 0.9;           ///< TSSFAC, on the manual's element steps
  double greatest_step = 0;                ///< 0 = no limit
  double first_step = 0;                   ///< DTINIT: limit of the first step; 0 = none
  MassScaling scaling;                     ///< during the run; step 0: none
  std::shared_ptr<const TimeCurve> limit;  ///< greatest step over time (LCTM); nullptr: none
  /// Also stay below the bound of every element's highest frequency. The manual's lengths alone are not safe for single
  /// bricks and tetrahedra.
  bool bounded_step = true;
  double least_step = 0;  ///< a step at or below it ends the run
  /// How far the energies may be out of balance, relative to the largest sum of energies so far. 0 = not checked.
  double energy_tolerance = 0.1;
};

/// What sets the time step.
struct StepControl {
  /// other: a force or the step limit
  enum class Kind : std::uint8_t { shell, solid, beam, thick_shell, other } kind = Kind::other;
  std::uint32_t element = 0;  ///< position in the model
};

/// An element that has failed.
struct ElementFailure {
  StepControl::Kind kind = StepControl::Kind::shell;
  std::uint32_t element = 0;  ///< position in the model
  double time = 0;
};

/// Velocities of nodes and, by body, those of the centres and the spins.
struct InitialMotion {
  std::vector<Vector> v, w;
  std::vector<std::array<Vector, 2>> bodies;
};

/// Explicit time integration by central differences (Belytschko, Liu, Moran, 6.2): forces at tₙ, accelerations,
/// velocities at tₙ + ½, positions at tₙ₊₁. Rotations are advanced by angular velocities; the elements need nothing
/// else from them. The result is the same, bit for bit, for any number of threads.
class Stepper {
 public:
  Stepper(Structure structure, StepSettings settings);
  /// Forces act in the order in which they are added.
  void add(std::unique_ptr<Force> force) { others_.push_back(std::move(force)); }

  /// One step; after a failure the positions are those at which it occurred, and no further step should be made.
  [[nodiscard]] SolverStatus step();
  /// A step in two halves. begin_step() computes forces, energies and the velocities in the middle of the next step; in
  /// between everything else belongs to state().time. end_step() advances.
  [[nodiscard]] SolverStatus begin_step();
  void end_step() { move(next_); }
  /// Ends a dynamic relaxation between the halves of a step. What moves loses its kinetic energy; the rest goes on.
  void begin_run(const InitialMotion& motion, double time_step_factor);
  /// Between the halves: the next step, and what sets it.
  [[nodiscard]] double next_step() const { return next_; }
  [[nodiscard]] const StepControl& control() const { return control_; }

  [[nodiscard]] const State& state() const { return structure_.state; }
  [[nodiscard]] const Structure& structure() const { return structure_; }
  /// All that have failed so far, in that order; within one cycle shells, solids, beams, each by position.
  [[nodiscard]] const std::vector<ElementFailure>& failures() const { return failures_; }
  /// At the time of the last force evaluation: that at which the last step began.
  [[nodiscard]] const Energies& energies() const { return energies_; }
  /// The energies of the other forces at that time, by their state.
  [[nodiscard]] Absorbed held() const;
  /// The largest sum of energies so far.
  [[nodiscard]] double largest_energy() const { return largest_energy_; }
  /// Sum of internal and other forces at that time, and the forces added by constraints.
  [[nodiscard]] const Forces& net() const { return net_; }
  [[nodiscard]] const Forces& external() const { return external_; }
  /// What supports and prescribed motions do to a node at that time, force and moment; part of both of these.
  [[nodiscard]] std::array<Vector, 2> reaction(std::size_t node) const;

 private:
  [[nodiscard]] SolverStatus evaluate(double& next);
  /// What one pass over the elements of each kind has found.
  struct Summaries {
    Summary shells, solids, beams, thick_shells;
  };
  [[nodiscard]] double element_step(const Summaries& all);
  [[nodiscard]] SolverStatus accelerate(double next);
  [[nodiscard]] SolverStatus check_energy();
  void note_failures();
  [[nodiscard]] double scale_masses(double next);
  void move(double next);

  Structure structure_;
  StepSettings settings_;
  std::vector<std::unique_ptr<Force>> others_;
  Forces external_, before_, net_;  ///< before_: external forces at the start of the step that led here
  Energies energies_;
  std::vector<std::uint32_t> constrained_;        ///< nodes with constraints, ascending
  std::vector<std::uint32_t> reaction_of_;        ///< by node: position in it; empty: there are none
  std::vector<std::array<Vector, 2>> reactions_;  ///< by position in it
  double next_ = 0;
  StepControl control_;
  std::vector<ElementFailure> failures_;
  double work_ = 0;  ///< of all forces other than the elements'
  double largest_energy_ = 0;
};

}  // namespace gapcheck::solver
