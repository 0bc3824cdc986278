#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "solver/airbag/airbag_gas.hpp"
#include "solver/airbag/control_volume.hpp"
#include "solver/state/force.hpp"
#include "solver/state/step_beside.hpp"

namespace gapcheck::solver {

/// A pressure by the volume relative to that at the start (Keyword User's Manual, Vol. I,
/// *AIRBAG_SIMPLE_PRESSURE_VOLUME).
struct PressureByVolume {
  PressureValue over_volume;                      ///< LCID, where it has points
  double coefficient = 0;                         ///< BETA CN
  std::shared_ptr<const TimeCurve> coefficients;  ///< CN over time, where it is given; `coefficient` is BETA then
  [[nodiscard]] double pressure(double relative, double time) const;
  /// -dp/d(relative volume), in size.
  [[nodiscard]] double stiffness(double relative, double time) const;
};

/// One control volume with its law.
struct AirbagInput {
  std::uint32_t airbag = 0;  ///< position in Model::airbags
  ControlVolume surface;
  double volume_scale = 1, pressure_scale = 1, excluded = 0;  ///< V = scale · surface - excluded
  std::optional<AirbagGas> gas;                               ///< otherwise:
  PressureByVolume law;
};

/// What an airbag holds at one time.
struct AirbagState {
  std::uint32_t airbag = 0;
  double volume = 0, area = 0;
  double pressure = 0;  ///< absolute
  double energy = 0, mass = 0, density = 0, temperature = 0;
  double rate_in = 0, rate_out = 0;
};

/// Pressures of control volumes on their surfaces, along the present normals: what is above the ambient pressure, on
/// the corners so that their work is that of the pressure on the volume. The work counts as external. Serial, in the
/// order of the deck.
class Airbags : public Force {
 public:
  /// The start is that of `state`; all volumes must be above zero there.
  Airbags(std::vector<AirbagInput> airbags, const State& state);

  void add(State& state, Forces& forces) override;
  [[nodiscard]] SolverStatus status() const override { return status_; }
  /// From the stiffness of the gas against all masses at its surface; it only falls.
  [[nodiscard]] double stable_step() const override { return step_; }

  /// At the last evaluation, in the order of the deck.
  [[nodiscard]] const std::vector<AirbagState>& states() const { return states_; }

 private:
  struct Bag {
    AirbagInput input;
    double start = 0;   ///< volume at the start
    double before = 0;  ///< at the last evaluation
    GasContent content;
  };
  /// Takes the airbag to a new volume; returns -dp/dV of the surface, in size.
  double advance(Bag& bag, double volume, const State& state, AirbagState& now) const;

  std::vector<Bag> bags_;
  std::vector<AirbagState> states_;
  SolverStatus status_;
  double step_ = std::numeric_limits<double>::infinity();
};

}  // namespace gapcheck::solver
