#pragma once
#include <limits>
#include <string>

#include "certified.hpp"

namespace gapcheck::bench {

/// gapcheck's proven decision without a closest point; it has no distance.
struct DecisionAlone {
  [[nodiscard]] static std::string name() { return "decision alone"; }
  [[nodiscard]] static Answer<double> answer(const ContactPair<double>& pair) {
    const auto decision = geometry::decide(facet_of(pair), pair.query, pair.bound, geometry::Mode::filtered);
    return {std::numeric_limits<double>::quiet_NaN(), decision.closer};
  }
};

}  // namespace gapcheck::bench
