#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "contact/initial.hpp"
#include "model/model.hpp"
#include "solver/build/build.hpp"
#include "solver/contact/contact_forces.hpp"
#include "solver/step.hpp"
#include "solver/contact/transducers.hpp"

namespace gapcheck::solver {

struct RunSettings {
  double until = 0;          ///< end time; 0: ENDTIM of *CONTROL_TERMINATION
  std::uint64_t cycles = 0;  ///< greatest number of steps; 0: no limit
  BuildSettings build;
  StepSettings step;
  std::function<bool()> stop;  ///< asked before every step; true ends the run
};

enum class RunEnd : std::uint8_t {
  time,
  cycles,
  energy,   ///< ENDENG: the energy ratio has changed by as many percent
  step,     ///< DTMIN: the step has fallen to this share of the first one
  stopped,  ///< on request
  failed,
};

/// A calculation from a model to its end. The model must outlive it.
class Run {
 public:
  /// Initialises the contacts, whose moved nodes start where that leaves them, and builds the structure with all that
  /// acts on it. `surfaces`: of this model. What is calculated otherwise than the deck says goes to `diagnostics`.
  static std::variant<Run, Failure> prepare(const model::Model& model, contact::SurfaceStore& surfaces,
                                            const RunSettings& settings, Diagnostics& diagnostics);

  /// What result files are told of: every step, before the positions move on.
  class Observer {
   public:
    virtual ~Observer() = default;
    /// `end`: no further step follows, and why. A failure ends the run.
    [[nodiscard]] virtual std::optional<Failure> observe(const Run& run, std::optional<RunEnd> end) = 0;
  };

  /// Steps until the end; the state then is that of the last observation. An observer's failure comes before the run's.
  RunEnd go(Observer& observer);

  [[nodiscard]] const model::Model& model() const { return *model_; }
  [[nodiscard]] const contact::InitialState& initial() const { return *initial_; }
  [[nodiscard]] const Stepper& stepper() const { return *stepper_; }
  /// The contacts that are calculated, in deck order.
  [[nodiscard]] std::vector<ContactView> contacts() const;
  /// What the force transducers measure, in deck order.
  [[nodiscard]] std::vector<ContactState> transducers() const {
    return transducers_->measure(contacts(), stepper_->state());
  }
  /// What contacts have done once in the last force evaluation.
  [[nodiscard]] const std::vector<ContactEvent>& events() const { return events_; }
  [[nodiscard]] const ContactCounters& contact_counters() const { return contacts_->counters(); }
  [[nodiscard]] double end_time() const { return end_time_; }
  [[nodiscard]] const std::optional<Failure>& failure() const { return failure_; }
  /// Seconds of wall clock since go() began.
  [[nodiscard]] double seconds() const;

 private:
  Run() = default;
  /// Takes a force that is a source of contacts too; nullptr: nothing.
  template <class Contacts>
  void add_contacts(std::unique_ptr<Contacts> contacts);
  [[nodiscard]] std::optional<RunEnd> end_reached() const;
  /// A failure where the time left is more steps than can be made.
  [[nodiscard]] std::optional<Failure> check_length() const;

  const model::Model* model_ = nullptr;
  RunSettings settings_;
  double end_time_ = 0, first_step_ = 0;
  std::unique_ptr<contact::InitialState> initial_;
  std::unique_ptr<Stepper> stepper_;
  const ContactForces* contacts_ = nullptr;
  std::unique_ptr<Transducers> transducers_;
  std::vector<ContactSource*> sources_;  ///< of contacts; all owned by the stepper
  std::vector<ContactEvent> events_;
  std::optional<Failure> failure_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace gapcheck::solver
