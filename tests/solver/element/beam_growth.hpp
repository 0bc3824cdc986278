#pragma once
#include "solver/structure_of.hpp"

namespace gapcheck::solver {

/// The step that one beam allows, without TSSFAC.
inline double beam_step(Structure beam) {
  beam.beams.finish(beam.state.x.size());
  return beam.beams.update(beam.state).stable_step;
}

/// Speeds of the second node and spins of the first one after 300 steps of this size, over those at the start.
inline double beam_growth(Structure beam, double step) {
  StepSettings settings;
  settings.bounded_step = false;
  settings.time_step_factor = 1e9;
  settings.greatest_step = step;
  settings.energy_tolerance = 0;
  const auto motion = [](const State& state) { return state.v[1].norm() + state.w[0].norm(); };
  const double before = motion(beam.state);
  Stepper stepper(std::move(beam), settings);
  for (int i = 0; i < 300; ++i) static_cast<void>(stepper.step());
  return motion(stepper.state()) / before;
}

/// Whether the step is sharp: 0.999 of it keeps a small motion small, 1.02 of it does not.
inline void expect_sharp_step(const Structure& beam, double step, const std::string& which = "") {
  EXPECT_LT(beam_growth(beam, 0.999 * step), 100) << which;
  EXPECT_GT(beam_growth(beam, 1.02 * step), 1e4) << which;
}

}  // namespace gapcheck::solver
