#include "solver/contact/needed_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {

using contact::Candidate;

namespace {

/// Room for what choose_hit() treats as equally near, and for rounding in sums of motion.
constexpr double nearness_slack = 1e-8, motion_slack = 1e-13;

}  // namespace

NeededPairs::NeededPairs(const contact::PairScene& scene, std::span<const contact::Hit> hits, bool released)
    : scene_(scene), zone_(released) {
  bool presses = false, meets = false;
  for (const contact::Hit& hit : hits) {
    if (!hit.in_band) continue;
    meets = true;
    if (std::signbit(hit.distance)) within_ = std::max(within_, -hit.distance);
    presses = presses || !scene.slides(hit.slot, hit.segment, hit.distance);
  }
  // A node that presses on another segment does not slide along this one.
  all_ = meets && !presses;
}

bool NeededPairs::has(const Candidate& candidate, double used) const {
  if (all_ && candidate.zone != Candidate::Zone::outside) return true;
  if (zone_ && candidate.zone == Candidate::Zone::unknown) return true;
  return within_ > 0 && scene_.oriented(candidate.segment) &&
         candidate.apart - used <= within_ * (1 + nearness_slack) + motion_slack * used;
}

}  // namespace gapcheck::solver
