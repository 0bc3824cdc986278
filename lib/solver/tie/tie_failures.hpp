#pragma once
#include <span>
#include <utility>
#include <vector>

#include "solver/tie/tie.hpp"
#include "solver/tie/tie_strength.hpp"

namespace gapcheck::solver {

/// Which ties by constraints have failed by their strength: those of TIED_..._FAILURE. What is too much for a tie is
/// the last force that it carries.
class TieFailures {
 public:
  TieFailures() = default;
  /// `interfaces`: of the ties, at the positions `x`.
  TieFailures(const model::Model& model, contact::SurfaceStore& surfaces, std::span<const TieRange> interfaces,
              const std::vector<Tie>& ties, const std::vector<Vector>& x);
  void check(std::size_t tie, const Vector& force, const SegmentAxes& axes);
  [[nodiscard]] bool failed(std::size_t tie) const { return !failed_.empty() && failed_[tie]; }
  /// Whether any has failed since this was last asked.
  [[nodiscard]] bool take_news() { return std::exchange(news_, false); }

 private:
  std::vector<TieStrength> strengths_;  ///< by tie; empty: none fails
  std::vector<bool> failed_;
  bool news_ = false;
};

}  // namespace gapcheck::solver
