#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/model.hpp"
#include "solver/state/failure.hpp"
#include "solver/state/force.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

// Explicit dynamic relaxation: a phase with its own time before the run, in which the velocities are scaled in each
// cycle. Source: LS-DYNA Keyword User's Manual, Vol. I, *CONTROL_DYNAMIC_RELAXATION, *DEFINE_CURVE (SIDR).

/// Whether the run begins with one: IDRFLG = 1, or 0 and a curve with SIDR = 1 or 2.
[[nodiscard]] bool relaxes(const model::Model& model);

struct RelaxationSettings {
  std::uint64_t check_every = 250;                       ///< NRCYCK, in cycles
  double tolerance = 0.001;                              ///< DRTOL, on the ratio of energies
  double factor = 0.995;                                 ///< DRFCTR, on the velocities
  double end = std::numeric_limits<double>::infinity();  ///< DRTERM
  double time_step_factor = 0.9;                         ///< TSSFDR
};

/// The settings of a model that relaxes. A failure names a value without meaning, or what together with a relaxation is
/// not calculated.
[[nodiscard]] SolverResult<RelaxationSettings> relaxation_settings(const model::Model& model);

/// A curve for the relaxation alone (SIDR = 1) that still changes after this time; 0: none.
[[nodiscard]] std::int64_t unfinished_curve(const model::Model& model, double time);

/// Kinetic energy of the nodes outside rigid bodies, less that of the motion of their common centre of mass.
[[nodiscard]] double distortional_energy(const Structure& structure);

/// Decides when a relaxation ends.
class RelaxationCheck {
 public:
  explicit RelaxationCheck(const RelaxationSettings& settings) : settings_(settings) {}
  /// Once per cycle, when the velocities of the next step are known; true: the relaxation ends here.
  [[nodiscard]] bool ends(const Structure& structure);
  /// The energy of the last cycle over the greatest; 0 if there was none.
  [[nodiscard]] double ratio() const { return peak_ > 0 ? energy_ / peak_ : 0; }
  [[nodiscard]] bool converged() const { return converged_; }
  [[nodiscard]] const RelaxationSettings& settings() const { return settings_; }

 private:
  RelaxationSettings settings_;
  double energy_ = 0, peak_ = 0;
  bool converged_ = false;
};

/// The force that scales the velocities of free degrees of freedom while the state is relaxing: −(1 − f) m v⁺ / dt,
/// with the velocity v⁺ that all other forces give. Reactions that follow act as if that were another force, so ties,
/// walls and prescribed motions stay met.
class RelaxationDamping : public Force {
 public:
  /// `structure` must outlive it.
  RelaxationDamping(const Structure& structure, double factor) : structure_(structure), factor_(factor) {}
  void add(State& /*state*/, Forces& /*forces*/) override {}
  [[nodiscard]] bool reacts() const override { return true; }
  void react(const State& state, double mean, double next, Forces& net, Forces& external) override;
  void absorbed(Absorbed& work) const override { work.damping += work_; }
  /// What is still moving at the end of the relaxation loses this kinetic energy.
  void stop(double kinetic) { work_ += kinetic; }

 private:
  void damp_bodies(const State& state, double mean, double next, Forces& net, Forces& external);
  const Structure& structure_;
  double factor_;
  double work_ = 0;
  Forces last_;  ///< at the start of the step that led here
};

}  // namespace gapcheck::solver
