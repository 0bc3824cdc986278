#pragma once
#include <memory>
#include <string>

#include "contact/initial.hpp"
#include "solver/conditioned.hpp"
#include "solver/interpolation/find_followers.hpp"
#include "solver/interpolation/follower_forces.hpp"

namespace gapcheck::solver {

/// A deck with *CONSTRAINED_INTERPOLATION, stepped without contacts.
class Followed {
 public:
  explicit Followed(const std::string& deck, double step) : read_(model::read_text(deck)) {
    Diagnostics diagnostics;
    auto built = build_structure(read_.model, {}, diagnostics);
    if (!built) {
      status_ = built.error();
      return;
    }
    Structure structure = std::move(built).value();
    std::vector<std::unique_ptr<Force>> forces;
    status_ = apply_conditions(read_.model, structure, forces, diagnostics);
    if (!status_.ok()) return;
    contact::SurfaceStore surfaces(read_.model);
    contact::InitialCounters counters;
    const contact::InitialState initial = contact::initialise_contacts(read_.model, surfaces, {}, counters);
    auto found = find_followers(read_.model, surfaces, initial, structure, diagnostics);
    for (const Diagnostic& d : diagnostics.sorted()) warnings_ += fmt::format("{}: {}\n", d.line, d.message);
    if (!found) {
      status_ = found.error();
      return;
    }
    StepSettings settings;
    settings.greatest_step = step;
    stepper_ = std::make_unique<Stepper>(std::move(structure), settings);
    for (auto& force : forces) stepper_->add(std::move(force));
    auto followers = std::make_unique<FollowerForces>(std::move(found).value(), read_.model, stepper_->structure());
    forces_ = followers.get();
    stepper_->add(std::move(followers));
  }

  [[nodiscard]] bool ready() const { return stepper_ != nullptr; }
  [[nodiscard]] const SolverStatus& status() const { return status_; }
  [[nodiscard]] const std::string& warnings() const { return warnings_; }
  [[nodiscard]] Stepper& stepper() { return *stepper_; }
  [[nodiscard]] const State& state() const { return stepper_->state(); }
  [[nodiscard]] const FollowerForces& forces() const { return *forces_; }

 private:
  model::Read read_;
  SolverStatus status_;
  std::string warnings_;
  std::unique_ptr<Stepper> stepper_;
  const FollowerForces* forces_ = nullptr;
};

}  // namespace gapcheck::solver
