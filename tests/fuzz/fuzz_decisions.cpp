// A facet, points and bounds out of bytes: "nearer than the bound?" has the same answer with and without the filters,
// pair by pair and in batches.
#include <cmath>
#include <utility>
#include <vector>

#include "fuzz.hpp"
#include "geometry/batch/pair_batch.hpp"
#include "geometry/decide.hpp"
#include "numbers.hpp"

namespace gapcheck::fuzz::decisions_target {
namespace {

using geometry::Mode;

/// The bound itself, and where the distance is to be told from one that is a last bit away: on patches that takes exact
/// numbers a second.
std::vector<double> bounds_near(const geometry::Facet& facet, const Vector& query, double bound) {
  if (!facet.triangle) return {bound};
  const double distance = std::sqrt(geometry::closest_point(facet, query).squared_distance);
  return {bound, distance, std::nextafter(distance, 0.), std::nextafter(distance, 1e300)};
}

void answers_agree(const geometry::Facet& facet, const Vector& query, double bound) {
  const auto closest = geometry::closest_point(facet, query);
  const bool exact = decide(facet, query, bound, Mode::exact).closer;
  require(decide(facet, query, bound, Mode::filtered).closer == exact);
  require(decide(facet, query, bound, Mode::filtered, &closest).closer == exact);
  for (const geometry::BatchWidth width : geometry::batch_widths()) {
    geometry::PairBatch batch(facet.triangle);
    batch.add(geometry::seen_from(facet, query), bound);
    batch.decide(width);
    if (batch.verdict(0) != geometry::Verdict::open) require((batch.verdict(0) == geometry::Verdict::closer) == exact);
  }
}

}  // namespace

GAPCHECK_FUZZ_TARGET(decisions) {
  Numbers numbers(input);
  geometry::Facet facet;
  facet.triangle = numbers.byte() % 4 != 0;
  for (Vector& corner : facet.x) corner = numbers.vector();
  if (facet.triangle) facet.x[3] = facet.x[2];
  for (int pair = 0; pair < 2; ++pair) {
    const Vector query = numbers.vector();
    const double given = numbers.number();
    for (const double bound : bounds_near(facet, query, given)) answers_agree(facet, query, bound);
    const auto side = [&](Mode mode) { return decide_side(facet.x[0], facet.x[1], facet.x[2], query, mode).sign; };
    require(side(Mode::filtered) == side(Mode::exact));
  }
}

}  // namespace gapcheck::fuzz::decisions_target
