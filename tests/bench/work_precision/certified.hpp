#pragma once
#include <string>

#include "geometry/decide.hpp"
#include "pair.hpp"

namespace gapcheck::bench {

[[nodiscard]] inline geometry::Facet facet_of(const ContactPair<double>& pair) { return {pair.x, pair.triangle}; }

/// gapcheck's closest point, and its proven decision with that point as the hint: what a contact search pays.
struct Certified {
  [[nodiscard]] static std::string name() { return "certified"; }
  [[nodiscard]] static Answer<double> answer(const ContactPair<double>& pair) {
    const geometry::Facet facet = facet_of(pair);
    const auto closest = geometry::closest_point(facet, pair.query);
    const auto decision = geometry::decide(facet, pair.query, pair.bound, geometry::Mode::filtered, &closest);
    return {std::sqrt(closest.squared_distance), decision.closer};
  }
};

}  // namespace gapcheck::bench
