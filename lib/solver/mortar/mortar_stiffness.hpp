#pragma once
#include "solver/mortar/mortar_law.hpp"
#include "solver/mortar/mortar_mobility.hpp"
#include "solver/mortar/mortar_surface.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// The pressure laws of pairs of faces, nowhere steeper than the time step allows.
class MortarStiffness {
 public:
  explicit MortarStiffness(const MortarSurface& surface) : surface_(surface), mobility_(surface) {}
  /// The step of the run.
  void set_timestep(double timestep);
  /// Called in every cycle: how much the contact may add to ω² dt² beside the elements, and what bodies are free to do.
  void follow(const State& state);
  /// Of a pair of faces.
  [[nodiscard]] MortarLaw law_of(std::uint32_t tracked, std::uint32_t other) const;
  /// The step up to which no pair needs a bound at the slope κ, where no element limits it; infinity: none.
  [[nodiscard]] double step_of_bodies(const State& state);

 private:
  const MortarSurface& surface_;
  MortarMobility mobility_;
  double timestep_ = 0, room_ = 0;
  bool new_step_ = true;
};

}  // namespace gapcheck::solver
