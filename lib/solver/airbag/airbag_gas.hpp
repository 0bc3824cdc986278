#pragma once
#include <memory>
#include <vector>

#include "model/model.hpp"
#include "solver/state/motion.hpp"

namespace gapcheck::solver {

/// A value over a pressure: a constant, or a curve between whose points it is linear and beyond which it is constant.
struct PressureValue {
  double constant = 0;
  model::Curve curve = {};  ///< without points: the constant
  double pressure_unit = 1, unit = 1;
  [[nodiscard]] double at(double pressure) const {
    return curve.points.empty() ? constant : unit * curve.at(pressure / pressure_unit);
  }
};

/// An ideal gas of constant heat capacities that flows into a volume and out of it through an exit (Keyword User's
/// Manual, Vol. I, *AIRBAG_SIMPLE_AIRBAG_MODEL).
struct AirbagGas {
  double heat_volume = 0, heat_pressure = 0;  ///< CV, CP
  double inflow_temperature = 0;              ///< T
  std::shared_ptr<const TimeCurve> inflow;    ///< mass per time; nullptr: none
  double inflow_scale = 1;
  PressureValue shape, area;                         ///< MU, AREA over the absolute pressure
  PressureValue exit_flow;                           ///< LOU: mass per time over the pressure above the ambient one
  double ambient_pressure = 0, ambient_density = 0;  ///< PE, RO

  [[nodiscard]] double ratio() const { return heat_pressure / heat_volume; }
  [[nodiscard]] double pressure(double energy, double volume) const { return (ratio() - 1) * energy / volume; }
  /// The mass per time through the exit: isentropic, with the speed of sound as the limit of its speed; none inward.
  [[nodiscard]] double exit_rate(double pressure, double density) const;
};

/// What of it is in the volume.
struct GasContent {
  double mass = 0, energy = 0;
  double rate_in = 0, rate_out = 0;  ///< mass per time in the last step

  /// The ambient gas in `volume`.
  static GasContent start(const AirbagGas& gas, double volume);
  /// A step `dt` up to `time`, in which the volume changes: first without flow, isentropically, then what flows in,
  /// then out. Neither mass nor energy falls below zero, nor does the pressure below the ambient one by flow out.
  void advance(const AirbagGas& gas, double before, double now, double time, double dt);
};

}  // namespace gapcheck::solver
