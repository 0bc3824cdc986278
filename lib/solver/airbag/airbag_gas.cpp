#include "solver/airbag/airbag_gas.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {

double AirbagGas::exit_rate(double pressure, double density) const {
  const double above = pressure - ambient_pressure;
  const double by_curve = exit_flow.at(above);
  if (!(above > 0) || !(density > 0)) return std::max(by_curve, 0.0);
  const double k = ratio(), critical = std::pow(2 / (k + 1), k / (k - 1));
  const double q = std::max(ambient_pressure / pressure, critical);
  const double flow = std::sqrt(2 * pressure * density * k / (k - 1) * (std::pow(q, 2 / k) - std::pow(q, (k + 1) / k)));
  return std::max(shape.at(pressure) * area.at(pressure) * flow + by_curve, 0.0);
}

GasContent GasContent::start(const AirbagGas& gas, double volume) {
  return {gas.ambient_density * volume, gas.ambient_pressure * volume / (gas.ratio() - 1), 0, 0};
}

void GasContent::advance(const AirbagGas& gas, double before, double now, double time, double dt) {
  rate_in = rate_out = 0;
  const double k = gas.ratio();
  energy *= std::pow(before / now, k - 1);
  if (!(dt > 0)) return;
  if (gas.inflow != nullptr) {
    const double in = gas.inflow_scale * (gas.inflow->integral(time) - gas.inflow->integral(time - dt));
    mass += in;
    energy += gas.heat_pressure * gas.inflow_temperature * in;
    rate_in = in / dt;
  }
  const double pressure = gas.pressure(energy, now), rate = gas.exit_rate(pressure, mass / now);
  if (!(rate > 0) || !(mass > 0)) return;
  // What stays expands isentropically: its energy falls with the power k of its mass.
  double kept = std::exp(-rate * dt / mass);
  if (pressure > gas.ambient_pressure) kept = std::max(kept, std::pow(gas.ambient_pressure / pressure, 1 / k));
  rate_out = mass * (1 - kept) / dt;
  mass *= kept;
  energy *= std::pow(kept, k);
}

}  // namespace gapcheck::solver
