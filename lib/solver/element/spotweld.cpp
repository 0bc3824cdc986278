#include "solver/element/spotweld.hpp"

#include "base/quad.hpp"

namespace gapcheck::solver {
namespace {

/// The mean of the last resultants, these included.
WeldResultants filtered(const WeldResultants& resultants, std::size_t filter, WeldHistory& history) {
  if (history.recent.size() < filter) {
    history.recent.push_back(resultants);
  } else {
    history.recent[history.oldest] = resultants;
    history.oldest = (history.oldest + 1) % filter;
  }
  WeldResultants mean{};
  for (const WeldResultants& one : history.recent)
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += one[i] / static_cast<double>(history.recent.size());
  return mean;
}

}  // namespace

bool weld_fails(const WeldLimits& limits, const WeldResultants& resultants, double time, double plastic_strain,
                WeldHistory& history) {
  if (limits.time > 0 && time >= limits.time) return true;
  if (limits.plastic_strain > 0 && plastic_strain >= limits.plastic_strain) return true;
  WeldResultants mean = limits.filter > 1 ? filtered(resultants, limits.filter, history) : resultants;
  mean[0] = std::max(mean[0], 0.0);
  double sum = 0;
  for (std::size_t i = 0; i < mean.size(); ++i)
    if (limits.strength[i] > 0) sum += mean[i] / limits.strength[i] * (mean[i] / limits.strength[i]);
  return sum >= 1;
}

WeldResultants brick_resultants(const std::array<Vector, 8>& x, const std::array<Vector, 8>& force) {
  std::array<Vector, 4> middle;
  for (std::size_t k = 0; k < 4; ++k) middle[k] = (x[k] + x[k + 4]) / 2;
  const Vector centre = (middle[0] + middle[1] + middle[2] + middle[3]) / 4;
  const Vector r = quad_normal(middle[0], middle[1], middle[2], middle[3]).normalized();
  const Vector along = middle[1] + middle[2] - middle[0] - middle[3];
  const Vector s = (along - along.dot(r) * r).normalized(), t = r.cross(s);
  Vector pull = Vector::Zero(), moment = Vector::Zero();
  for (std::size_t k = 0; k < 8; ++k) {
    const double side = k < 4 ? -0.5 : 0.5;
    pull += side * force[k];
    moment += side * (x[k] - centre).cross(force[k]);
  }
  return {pull.dot(r), pull.dot(s), pull.dot(t), moment.dot(r), moment.dot(s), moment.dot(t)};
}

}  // namespace gapcheck::solver
