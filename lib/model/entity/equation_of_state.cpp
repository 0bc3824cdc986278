#include "model/entity/equation_of_state.hpp"

#include <algorithm>

namespace gapcheck::model {
namespace {

/// −dC/d ln V at V = 1, and with T the thermal part; on the side of compression.
double table_bulk(const EquationOfState& state) {
  for (std::size_t i = 0; i + 1 < state.rows.size(); ++i) {
    const auto& [low, high] = std::minmax(state.rows[i], state.rows[i + 1]);
    if (!(low[0] < 0 && high[0] >= 0)) continue;
    const double share = -low[0] / (high[0] - low[0]);
    const double c = low[1] + share * (high[1] - low[1]), t = low[2] + share * (high[2] - low[2]);
    const double c_slope = (high[1] - low[1]) / (high[0] - low[0]), t_slope = (high[2] - low[2]) / (high[0] - low[0]);
    return -c_slope - state.gamma * t_slope * state.e0 + (c + state.gamma * t * state.e0) * state.gamma * t;
  }
  return 0;
}

}  // namespace

double initial_bulk_modulus(const EquationOfState& state, double density) {
  const auto& c = state.polynomial;
  switch (state.kind) {
    case EquationOfState::Kind::linear_polynomial:
      return c[1] + c[5] * state.e0 + (c[0] + c[4] * state.e0) * c[4];
    case EquationOfState::Kind::gruneisen:
      return density * state.c * state.c + state.a * state.e0 + state.gamma * state.e0 * state.gamma;
    case EquationOfState::Kind::tabulated:
      return table_bulk(state);
    default:
      return 0;
  }
}

}  // namespace gapcheck::model
