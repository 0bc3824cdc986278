#pragma once
#include <functional>
#include <optional>
#include <string>

#include "model/read.hpp"
#include "solver/run.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver {

/// A deck calculated as a whole, as `gapcheck run` does, but without files.
class RunScene : private Run::Observer {
 public:
  using Watch = std::function<void(const Run&)>;

  explicit RunScene(const std::string& deck, const RunSettings& settings = {})
      : read_(model::read_text(deck)), surfaces_(read_.model) {
    auto prepared = Run::prepare(read_.model, surfaces_, settings, diagnostics_);
    if (!prepared)
      status_ = prepared.error();
    else
      run_.emplace(std::move(prepared).value());
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
    status_ = run_->status();
    return end;
  }

  [[nodiscard]] const Run& run() const { return *run_; }
  [[nodiscard]] bool prepared() const { return run_.has_value(); }
  [[nodiscard]] const State& state() const { return run_->stepper().state(); }
  [[nodiscard]] const Energies& energies() const { return run_->stepper().energies(); }
  [[nodiscard]] const SolverStatus& status() const { return status_; }
  [[nodiscard]] std::string message() const { return status_.ok() ? "" : status_.error().message; }
  [[nodiscard]] const model::Read& read() const { return read_; }
  [[nodiscard]] contact::SurfaceStore& surfaces() { return surfaces_; }
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }
  [[nodiscard]] Vector momentum() const {
    Vector sum = Vector::Zero();
    for (std::size_t i = 0; i < state().x.size(); ++i) sum += state().mass[i] * state().v[i];
    return sum;
  }

 private:
  SolverStatus observe(const Run& run, std::optional<RunEnd>) override {
    if (watch_) watch_(run);
    return {};
  }

  model::Read read_;
  contact::SurfaceStore surfaces_;
  Diagnostics diagnostics_;
  std::optional<Run> run_;
  SolverStatus status_;
  Watch watch_;
};

}  // namespace gapcheck::solver
