#include "audit/fix/least_movement.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::audit {
namespace {

double left_side(const MoveCondition& c, std::span<const Vector> moves) {
  double sum = 0;
  for (std::size_t i = 0; i < c.count; ++i) sum += c.terms[i].coefficient * c.direction.dot(moves[c.terms[i].node]);
  return sum;
}

void push(const MoveCondition& c, double multiplier, std::span<const Vector> mobility, std::span<Vector> moves) {
  for (std::size_t i = 0; i < c.count; ++i) {
    const auto& term = c.terms[i];
    moves[term.node] += multiplier * term.coefficient * mobility[term.node].cwiseProduct(c.direction);
  }
}

}  // namespace

void MoveCondition::add(std::uint32_t node, double coefficient) {
  for (std::size_t i = 0; i < count; ++i) {
    if (terms[i].node != node) continue;
    terms[i].coefficient += coefficient;
    return;
  }
  if (count < terms.size()) terms[count++] = {node, coefficient};
}

double violation(const MoveCondition& condition, std::span<const Vector> moves) {
  const double missing = condition.bound - left_side(condition, moves);
  return condition.equal ? std::abs(missing) : missing;
}

double compliance(const MoveCondition& c, std::span<const Vector> mobility) {
  double sum = 0;
  for (std::size_t i = 0; i < c.count; ++i)
    sum += c.terms[i].coefficient * c.terms[i].coefficient *
           c.direction.dot(mobility[c.terms[i].node].cwiseProduct(c.direction));
  return std::isfinite(sum) && sum > 0 ? sum : 0;
}

MovementResult least_movement(std::span<MoveCondition> conditions, std::span<const Vector> mobility,
                              std::span<Vector> moves, double tolerance, std::size_t sweeps) {
  std::fill(moves.begin(), moves.end(), Vector::Zero());
  std::vector<double> compliances;
  compliances.reserve(conditions.size());
  for (MoveCondition& c : conditions) {
    compliances.push_back(compliance(c, mobility));
    if (compliances.back() == 0) c.multiplier = 0;
    if (c.multiplier != 0) push(c, c.multiplier, mobility, moves);
  }
  MovementResult result;
  for (; result.sweeps < sweeps; ++result.sweeps) {
    result.worst = 0;
    double largest_step = 0;
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      MoveCondition& c = conditions[i];
      if (compliances[i] == 0) continue;
      const double missing = c.bound - left_side(c, moves);
      const double wanted = c.multiplier + missing / compliances[i];
      const double multiplier = c.equal ? wanted : std::max(0.0, wanted);
      const double step = multiplier - c.multiplier;
      result.worst = std::max(result.worst, c.equal ? std::abs(missing) : missing);
      // A falling multiplier takes movement back: as long as that happens the least movement is not reached.
      largest_step = std::max(largest_step, std::abs(step) * compliances[i]);
      if (step == 0) continue;
      c.multiplier = multiplier;
      push(c, step, mobility, moves);
    }
    if (largest_step <= tolerance) break;
  }
  return result;
}

}  // namespace gapcheck::audit
