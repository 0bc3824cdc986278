#include "solver/material/equation_of_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapcheck::solver {

PressureLine LinearPolynomial::at(double volume) const {
  const double mu = 1 / volume - 1;
  const double c2 = mu < 0 ? 0 : c[2], c6 = mu < 0 ? 0 : c[6];
  return {c[0] + mu * (c[1] + mu * (c2 + mu * c[3])), c[4] + mu * (c[5] + mu * c6),
          c[1] + mu * (2 * c2 + mu * 3 * c[3]), c[5] + 2 * mu * c6, c[1] + mu * (2 * c2 + mu * 3 * c[3])};
}

PressureLine Gruneisen::at(double volume) const {
  const double mu = 1 / volume - 1;
  if (mu < 0) return {stiffness * mu, gamma + a * mu, stiffness, a, stiffness};
  const double r = mu / (mu + 1), squared_share = 1 / ((mu + 1) * (mu + 1));  // r′
  const double top = mu * (1 + mu * (1 - gamma / 2 - mu * a / 2));
  const double top_slope = 1 + mu * (2 - gamma - mu * 1.5 * a);
  const double bottom = 1 - (s1 - 1) * mu - s2 * mu * r - s3 * mu * r * r;
  const double bottom_slope = -(s1 - 1) - s2 * (r + mu * squared_share) - s3 * (r * r + 2 * mu * r * squared_share);
  if (!(bottom > 0)) {
    constexpr double none = std::numeric_limits<double>::infinity();
    return {none, gamma + a * mu, none, a, none};
  }
  const double squared = bottom * bottom;
  const double slope = stiffness * (top_slope - 2 * top * bottom_slope / bottom) / squared;
  return {stiffness * top / squared, gamma + a * mu, slope, a, slope};
}

PressureLine PressureTable::at(double volume) const {
  const double strain = std::log(volume);
  const auto above = std::lower_bound(rows.begin() + 1, rows.end() - 1, strain,
                                      [](const Row& row, double value) { return row.strain < value; });
  const auto place = static_cast<std::size_t>(above - rows.begin()) - 1;
  const auto slope = [&](std::size_t from, double Row::*of) {
    return (rows[from + 1].*of - rows[from].*of) / (rows[from + 1].strain - rows[from].strain);
  };
  const double offset = strain - rows[place].strain, own = slope(place, &Row::cold),
               thermal = slope(place, &Row::thermal);
  // Over μ the slopes are −V times those over ln V.
  double steepest = own;
  if (place > 0) steepest = std::min(steepest, slope(place - 1, &Row::cold));
  if (place + 2 < rows.size()) steepest = std::min(steepest, slope(place + 1, &Row::cold));
  return {rows[place].cold + own * offset, gamma * (rows[place].thermal + thermal * offset), -volume * own,
          -volume * gamma * thermal, -volume * steepest};
}

PressureLine EquationOfState::at(double volume) const {
  return std::visit([&](const auto& one) { return one.at(volume); }, law);
}

namespace {

double isentropic_bulk(const PressureLine& line, double cold_slope, double volume, double energy) {
  const double slope = cold_slope + line.thermal_slope * energy;
  return (slope + line.pressure(energy) * volume * volume * line.thermal) / volume;
}

}  // namespace

double EquationOfState::bulk(double volume, double energy) const {
  const PressureLine line = at(volume);
  return isentropic_bulk(line, line.cold_slope, volume, energy);
}

double EquationOfState::bulk_bound(double volume, double energy) const {
  const PressureLine line = at(volume);
  return isentropic_bulk(line, line.steepest, volume, energy);
}

}  // namespace gapcheck::solver
