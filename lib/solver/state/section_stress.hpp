#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/state/motion.hpp"
#include "solver/state/state.hpp"
#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// A normal stress that replaces that of the material. Without `shear` also the shear stresses on the same face are
/// replaced, by zero.
struct ImposedStress3 {
  Vector normal = Vector::Zero();  ///< of length 1
  double stress = 0;
  bool shear = false;

  [[nodiscard]] Symmetric on(const Symmetric& stress_of_material) const;
};

/// The solids of a cross-section, whose normal stress is given while the curve lasts (*INITIAL_STRESS_SECTION).
struct SectionStress {
  std::int64_t id = 0;  ///< of the cross-section
  TimeCurve curve;      ///< stress over time
  double end = 0;       ///< of what is imposed
  ImposedStress3 imposed = {};
  /// Its solids, and which of their corners lie in front of the section, one bit each.
  std::vector<std::pair<std::uint32_t, std::uint8_t>> solids = {};
  Phases phases = {};

  [[nodiscard]] bool active(const State& state) const {
    return phases.now(state.relaxing) && state.time >= curve.start() && state.time <= end;
  }
};

}  // namespace gapcheck::solver
