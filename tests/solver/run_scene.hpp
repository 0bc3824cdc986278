#pragma once
#include <functional>
#include <optional>
#include <string>

#include "../model/read.hpp"
#include "solver/run.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// A deck calculated as a whole, as `gapcheck run` does, but without files.
class RunScene : private Run::Observer {
 public:
  using Watch = std::function<void(const Run&)>;

  explicit RunScene(const std::string& deck, const RunSettings& settings = {})
      : read_(model::read_text(deck)), surfaces_(read_.model) {
    auto prepared = Run::prepare(read_.model, surfaces_, settings, diagnostics_);
    if (auto* failure = std::get_if<Failure>(&prepared))
      failure_ = std::move(*failure);
    else
      run_.emplace(std::move(std::get<Run>(prepared)));
  }

  /// To the end; `watch` sees every step. The test fails where the run does.
  RunScene& go(const Watch& watch = {}) {
    const std::optional<RunEnd> end = try_to_go(watch);
    EXPECT_TRUE(end && *end != RunEnd::failed) << message();
    return *this;
  }
  /// The same for runs that may fail; nothing where the run could not be prepared.
  std::optional<RunEnd> try_to_go(const Watch& watch = {}) {
    if (!run_) return std::nullopt;
    watch_ = watch;
    const RunEnd end = run_->go(*this);
    if (run_->failure()) failure_ = run_->failure();
    return end;
  }

  [[nodiscard]] const Run& run() const { return *run_; }
  [[nodiscard]] bool prepared() const { return run_.has_value(); }
  [[nodiscard]] const State& state() const { return run_->stepper().state(); }
  [[nodiscard]] const Energies& energies() const { return run_->stepper().energies(); }
  [[nodiscard]] const std::optional<Failure>& failure() const { return failure_; }
  [[nodiscard]] std::string message() const { return failure_ ? failure_->message : ""; }
  [[nodiscard]] const model::Read& read() const { return read_; }
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }
  [[nodiscard]] Vector momentum() const {
    Vector sum = Vector::Zero();
    for (std::size_t i = 0; i < state().x.size(); ++i) sum += state().mass[i] * state().v[i];
    return sum;
  }

 private:
  std::optional<Failure> observe(const Run& run, std::optional<RunEnd>) override {
    if (watch_) watch_(run);
    return std::nullopt;
  }

  model::Read read_;
  contact::SurfaceStore surfaces_;
  Diagnostics diagnostics_;
  std::optional<Run> run_;
  std::optional<Failure> failure_;
  Watch watch_;
};

}  // namespace gapcheck::solver
