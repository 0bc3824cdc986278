#pragma once
#include <span>

#include "contact/pair/candidates.hpp"
#include "contact/pair/hit.hpp"

namespace gapcheck::solver {

/// Which resting pairs of a node its awake ones make necessary. See docs/theory/solver-contact.md, "What is left out".
class NeededPairs {
 public:
  /// `hits`: of the awake pairs. `released`: the node was too deep.
  NeededPairs(const contact::PairScene& scene, std::span<const contact::Hit> hits, bool released);

  /// False: none is.
  [[nodiscard]] bool any() const { return within_ > 0 || zone_ || all_; }
  /// `used`: of the search margin.
  [[nodiscard]] bool has(const contact::Candidate& candidate, double used) const;

 private:
  const contact::PairScene& scene_;
  double within_ = 0;  ///< those with a back that may be so near: the node is behind the nearest segment alone
  bool zone_ = false;  ///< those in whose zone the node may be: a released node stays so until it has left all zones
  bool all_ = false;   ///< the same: if the node presses on one of them it slides along the others
};

}  // namespace gapcheck::solver
