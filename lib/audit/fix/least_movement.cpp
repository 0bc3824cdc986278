#include "audit/fix/least_movement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/work_watch.hpp"

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

namespace {

/// Sweeps between two accelerations, and steps of one of them at most.
constexpr double patient_sweeps = 100;  ///< after these the tolerance grows
constexpr std::size_t sweeps_between = 5, steps_at_once = 200;

/// Conjugate gradients on the conditions that push (and on equations): long chains of conditions, as in a stack of
/// sheets, take the sweeps alone a number of rounds that grows with the square of their length.
class Acceleration {
 public:
  Acceleration(std::span<MoveCondition> conditions, std::span<const double> compliances,
               std::span<const Vector> mobility, std::span<Vector> moves)
      : conditions_(conditions), compliances_(compliances), mobility_(mobility), moves_(moves) {}

  /// Until the residuals are within `tolerance` or rounding ends it. Multipliers that would become negative are left
  /// out from there on.
  /// At most `steps`; returns how many it took.
  std::size_t run(double tolerance, std::size_t steps) {
    active_.clear();
    for (std::uint32_t i = 0; i < conditions_.size(); ++i)
      if (compliances_[i] > 0 && (conditions_[i].equal || conditions_[i].multiplier > 0)) active_.push_back(i);
    residual_.resize(active_.size());
    direction_.assign(active_.size(), 0);
    double old = 0;  // 0: starts along the residual
    std::size_t step = 0;
    for (; step < steps && !work_stopped(); ++step) {
      double worst = 0, now = 0;
      for (std::size_t k = 0; k < active_.size(); ++k) {
        const MoveCondition& c = conditions_[active_[k]];
        residual_[k] = c.bound - left_side(c, moves_);
        worst = std::max(worst, std::abs(residual_[k]));
        now += residual_[k] * residual_[k] / compliances_[active_[k]];
      }
      if (worst <= tolerance) break;
      const double share = old == 0 ? 0 : now / old;
      for (std::size_t k = 0; k < active_.size(); ++k)
        direction_[k] = residual_[k] / compliances_[active_[k]] + share * direction_[k];
      const Step taken = advance();
      if (taken == Step::none) break;
      old = taken == Step::whole ? now : 0;
      if (taken == Step::cut) drop_zeros();
    }
    return step;
  }

 private:
  enum class Step : std::uint8_t { none, whole, cut };

  /// Along the direction to the minimum, or to where the first multiplier is zero.
  Step advance() {
    change_.assign(moves_.size(), Vector::Zero());
    for (std::size_t k = 0; k < active_.size(); ++k) push(conditions_[active_[k]], direction_[k], mobility_, change_);
    double slope = 0, curvature = 0, own = 0, farthest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < active_.size(); ++k) {
      const MoveCondition& c = conditions_[active_[k]];
      slope += residual_[k] * direction_[k];
      curvature += direction_[k] * left_side(c, change_);
      own += direction_[k] * direction_[k] * compliances_[active_[k]];
      if (!c.equal && direction_[k] < 0) farthest = std::min(farthest, -c.multiplier / direction_[k]);
    }
    // Conditions that contradict each other push without end, and move nothing.
    if (!(slope > 0) || !(curvature > 1e-9 * own)) return Step::none;
    const double length = std::min(slope / curvature, farthest);
    for (std::size_t k = 0; k < active_.size(); ++k) {
      MoveCondition& c = conditions_[active_[k]];
      c.multiplier += length * direction_[k];
      if (!c.equal && (c.multiplier < 0 ||
                       (direction_[k] < 0 && length == farthest && c.multiplier <= 1e-12 * -length * direction_[k])))
        c.multiplier = 0;
    }
    for (std::size_t n = 0; n < moves_.size(); ++n) moves_[n] += length * change_[n];
    return length < farthest ? Step::whole : Step::cut;
  }

  void drop_zeros() {
    std::erase_if(active_, [&](std::uint32_t i) { return !conditions_[i].equal && conditions_[i].multiplier == 0; });
    residual_.resize(active_.size());
    direction_.assign(active_.size(), 0);
  }

  std::span<MoveCondition> conditions_;
  std::span<const double> compliances_;
  std::span<const Vector> mobility_;
  std::span<Vector> moves_;
  std::vector<std::uint32_t> active_;
  std::vector<double> residual_, direction_;
  std::vector<Vector> change_;
};

}  // namespace

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
  std::size_t since = 0;
  Acceleration acceleration(conditions, compliances, mobility, moves);
  for (; result.sweeps < sweeps && !work_stopped(); ++result.sweeps) {
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
    // Conditions that say the same twice settle slowly.
    if (largest_step <= tolerance * (1 + static_cast<double>(result.sweeps) / patient_sweeps)) break;
    if (++since < sweeps_between) continue;
    since = 0;
    result.sweeps += acceleration.run(tolerance, std::min(steps_at_once, sweeps - result.sweeps));
  }
  return result;
}

}  // namespace gapcheck::audit
