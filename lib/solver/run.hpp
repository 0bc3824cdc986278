#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "contact/initial.hpp"
#include "model/model.hpp"
#include "solver/airbag/airbags.hpp"
#include "solver/build/build.hpp"
#include "solver/condition/loads.hpp"
#include "solver/condition/relaxation.hpp"
#include "solver/condition/rigid_walls.hpp"
#include "solver/condition/springs.hpp"
#include "solver/contact/contact_forces.hpp"
#include "solver/contact/transducers.hpp"
#include "solver/step.hpp"

namespace gapcheck::solver {

enum class RunEnd : std::uint8_t {
  time,
  cycles,
  energy,   ///< ENDENG: the energy ratio has changed by this many percent
  step,     ///< DTMIN: the step has fallen to this fraction of the first one
  stopped,  ///< on request
  signal,   ///< on request of a signal that asks the process to end
  failed,
};

struct RunSettings {
  double until = 0;          ///< end time; 0: ENDTIM of *CONTROL_TERMINATION
  std::uint64_t cycles = 0;  ///< largest number of steps; 0: no limit
  BuildSettings build;
  StepSettings step;
  SpringFormula springs = SpringFormula::documented;  ///< of contacts with SOFT = 0 and 1
  std::vector<ShotNode>* shot = nullptr;  ///< gets the nodes that contacts move during the run; null: nobody asks
  bool relax = true;                      ///< false: without the dynamic relaxation that the deck asks for
  std::function<bool()> stop;             ///< called before every step; true ends the run
  RunEnd stop_means = RunEnd::stopped;    ///< what it is then, if not that
};

/// A calculation from a model to its end. The model must outlive it.
class Run {
 public:
  /// Initialises the contacts, whose moved nodes start from there, and builds the structure with everything that acts
  /// on it. `surfaces`: of this model. Deviations from the deck go to `diagnostics`.
  static SolverResult<Run> prepare(const model::Model& model, contact::SurfaceStore& surfaces,
                                   const RunSettings& settings, Diagnostics& diagnostics);

  /// The interface for result files: called at every step, before the positions change.
  class Observer {
   public:
    virtual ~Observer() = default;
    /// `end`: no further step follows, and why. A failure ends the run.
    [[nodiscard]] virtual SolverStatus observe(const Run& run, std::optional<RunEnd> end) = 0;
  };

  /// Steps until the end, after the deck's dynamic relaxation, which nobody observes; the state is then that of the
  /// last observation. An observer's failure takes precedence over the run's.
  RunEnd go(Observer& observer);

  [[nodiscard]] const model::Model& model() const { return *model_; }
  [[nodiscard]] const contact::InitialState& initial() const { return *initial_; }
  /// Frees InitialState::contacts, some 400 bytes for each contact: only the reports at the start need them.
  void drop_contact_summaries() { std::vector<ContactSummary>().swap(initial_->contacts); }
  [[nodiscard]] const Stepper& stepper() const { return *stepper_; }
  /// The contacts that are calculated, in deck order.
  [[nodiscard]] std::vector<ContactView> contacts() const;
  /// What the force transducers measure, in deck order.
  [[nodiscard]] std::vector<ContactState> transducers() const {
    return transducers_->measure(contacts(), stepper_->state());
  }
  /// Single events of contacts in the last force evaluation.
  [[nodiscard]] const std::vector<ContactEvent>& events() const { return events_; }
  [[nodiscard]] const ContactCounters& contact_counters() const { return contacts_->counters(); }
  /// The penalty contacts; owned by the stepper.
  [[nodiscard]] ContactForces& contact_forces() { return *contacts_; }
  /// What acts on nodes beside elements and contacts; nullptr: nothing of the kind.
  struct Conditions {
    const RigidWalls* walls = nullptr;
    const ConcentratedLoads* loads = nullptr;
    const Pressures* pressures = nullptr;
    const Springs* springs = nullptr;
    const Airbags* airbags = nullptr;
  };
  [[nodiscard]] const Conditions& conditions() const { return conditions_; }
  [[nodiscard]] double end_time() const { return end_time_; }
  /// Not ok() once it has failed.
  [[nodiscard]] const SolverStatus& status() const { return status_; }
  /// How the dynamic relaxation before the run ended; nothing: there was none, or it has not ended.
  struct Relaxed {
    std::uint64_t cycles = 0;
    double time = 0;   ///< of its own
    double ratio = 0;  ///< of the distortional kinetic energy to its greatest value
    bool converged = false;
    std::int64_t unfinished = 0;  ///< a curve that still changes later, and is not used in the run; 0: none
  };
  [[nodiscard]] const std::optional<Relaxed>& relaxed() const { return relaxed_; }
  /// Seconds of wall clock since go() began.
  [[nodiscard]] double seconds() const;

 private:
  Run() = default;
  /// Adds a force that is also a source of contacts; nullptr: nothing.
  template <class Contacts>
  void add_contacts(std::unique_ptr<Contacts> contacts);
  /// Holds the deck's initial velocities back until a dynamic relaxation has ended, and adds what relaxes.
  [[nodiscard]] static InitialMotion hold_back(Structure& structure);
  /// Steps to the end of the dynamic relaxation; an end of the whole run, if that comes first.
  [[nodiscard]] std::optional<RunEnd> relax();
  void take_events();
  [[nodiscard]] std::optional<RunEnd> end_reached() const;
  /// A failure if the time that remains until `end` needs more steps than allowed.
  [[nodiscard]] SolverStatus check_length(double end) const;

  const model::Model* model_ = nullptr;
  RunSettings settings_;
  double end_time_ = 0, first_step_ = 0;
  std::unique_ptr<contact::InitialState> initial_;
  std::unique_ptr<Stepper> stepper_;
  ContactForces* contacts_ = nullptr;
  Conditions conditions_;  ///< owned by the stepper
  std::unique_ptr<Transducers> transducers_;
  std::vector<ContactSource*> sources_;  ///< of contacts; all owned by the stepper
  std::vector<ContactEvent> events_;
  std::optional<RelaxationCheck> relaxation_;
  RelaxationDamping* damping_ = nullptr;  ///< of the relaxation; owned by the stepper
  InitialMotion motion_;                  ///< after the relaxation
  std::optional<Relaxed> relaxed_;
  SolverStatus status_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace gapcheck::solver
