#pragma once
#include "solver/mortar/mortar_law.hpp"
#include "solver/mortar/mortar_surface.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// The pressure laws of pairs of faces, no stiffer than the time step allows.
class MortarStiffness {
 public:
  /// The step of the run.
  void set_timestep(double timestep);
  /// Called in every cycle: how much the contact may add to ω² dt² beside the elements.
  void follow_step(const State& state);
  [[nodiscard]] MortarLaw law_of(const MortarFace& tracked, const MortarFace& other) const;

 private:
  double timestep_ = 0, room_ = 0;
  bool new_step_ = true;
};

}  // namespace gapcheck::solver
