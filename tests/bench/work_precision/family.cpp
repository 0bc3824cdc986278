#include "family.hpp"

#include <functional>
#include <limits>

#include "../stopwatch.hpp"
#include "families.hpp"
#include "geometry/decide.hpp"
#include "geometry/exact.hpp"
#include "reference.hpp"

namespace gapcheck::bench {
namespace {

using geometry::Facet;
using geometry::test::Maker;
using geometry::test::Pair;
using Family = geometry::test::Family;

double longest_side(const Facet& facet) {
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i) longest = std::max(longest, (facet.x[(i + 1) % 4] - facet.x[i]).norm());
  return longest;
}

Vector at(const Facet& facet, double s, double t) {
  const auto& x = facet.x;
  return 0.25 *
         ((1 - s) * (1 - t) * x[0] + (1 + s) * (1 - t) * x[1] + (1 + s) * (1 + t) * x[2] + (1 - s) * (1 + t) * x[3]);
}

/// As in a contact: the point lies over the facet or a little beside it, at most half a side away.
Pair placed(Maker& maker, Pair pair) {
  const auto& x = pair.facet.x;
  const Vector up = (x[2] - x[0]).cross(x[3] - x[1]).normalized();
  const double height = maker.uniform(0.05, 0.5) * longest_side(pair.facet) * (maker.integer(0, 1) == 0 ? 1 : -1);
  const double s = maker.uniform(-1.2, 1.2), t = maker.uniform(-1.2, 1.2);
  pair.query = at(pair.facet, s, t) + height * up;
  return pair;
}

Pair warped(Maker& maker, double degrees) { return placed(maker, maker.warped(degrees, degrees)); }

Pair moved(Maker& maker, Pair pair, double offset) {
  const Vector by = offset * maker.point(1);
  for (Vector& x : pair.facet.x) x += by;
  if (pair.facet.triangle) pair.facet.x[3] = pair.facet.x[2];
  pair.query += by;
  return pair;
}

Pair resized(Pair pair, double size) {
  for (Vector& x : pair.facet.x) x *= size;
  pair.query *= size;
  return pair;
}

/// Folded quads are left out: the reference does not vouch for their distances.
Pair degenerate(Maker& maker) {
  Pair pair = maker.make(Family::degenerate);
  while (!pair.facet.triangle && !geometry::exact::flat_and_convex(pair.facet)) pair = maker.make(Family::degenerate);
  return pair;
}

Pair on_surface(Maker& maker) {
  Pair pair = maker.integer(0, 1) == 0 ? maker.make(Family::flat) : maker.warped(1, 40);
  pair.query = at(pair.facet, maker.uniform(-1, 1), maker.uniform(-1, 1));
  return pair;
}

enum class Bound {
  near,      ///< within 2 % of the distance
  last_bit,  ///< the distance, rounded, or one of its neighbours
  ordinary,  ///< whatever the distance is
};

struct Recipe {
  std::string name;
  int group;
  Bound bound;
  std::function<Pair(Maker&)> make;
};

std::vector<Recipe> recipes() {
  std::vector<Recipe> list;
  const auto add = [&](std::string name, int group, std::function<Pair(Maker&)> make, Bound bound = Bound::near) {
    list.push_back({std::move(name), group, bound, std::move(make)});
  };
  const auto flat = [](Maker& maker) { return placed(maker, maker.make(Family::flat)); };
  const auto any = [flat](Maker& maker) { return maker.integer(0, 1) == 0 ? flat(maker) : warped(maker, 10); };
  add("flat", 0, flat);
  for (const int degrees : {1, 5, 10, 20, 40}) {
    add("warped " + std::to_string(degrees) + "°", 0, [degrees](Maker& maker) { return warped(maker, degrees); });
  }
  add("on the bound, flat", 1, flat, Bound::last_bit);
  add(
      "on the bound, warped 10°", 1, [](Maker& maker) { return warped(maker, 10); }, Bound::last_bit);
  add("over an edge or corner", 1, [](Maker& maker) { return maker.make(Family::on_border); });
  add("on the mid-surface", 1, on_surface, Bound::ordinary);
  add("slivers, 1e-3 to 1e-9", 2, [](Maker& maker) { return maker.make(Family::sliver); });
  add("degenerate", 2, degenerate);
  add("four random corners", 2, [](Maker& maker) { return maker.make(Family::skew); });
  for (const char* offset : {"1e3", "1e5", "1e7", "1e9"}) {
    add(std::string("offset by ") + offset, 3,
        [any, by = std::stod(offset)](Maker& maker) { return moved(maker, any(maker), by); });
  }
  for (const char* size : {"1e-6", "1e-3", "1e3", "1e6"}) {
    add(std::string("size ") + size, 3, [any, to = std::stod(size)](Maker& maker) { return resized(any(maker), to); });
  }
  return list;
}

mpf_class reference(const Facet& facet, const Vector& query) { return geometry::test::squared_distance(facet, query); }

long double rounded(const mpf_class& value) {
  const double head = value.get_d();
  return head + static_cast<long double>(mpf_class(value - head).get_d());
}

double bound_of(Maker& maker, Bound kind, long double distance, double size) {
  if (kind == Bound::ordinary || !(distance > 1e-9 * size)) return maker.uniform(0.05, 0.5) * (size > 0 ? size : 1);
  const double nearest = static_cast<double>(distance);
  if (kind == Bound::near) return nearest * maker.uniform(0.98, 1.02);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const int step = maker.integer(-1, 1);
  return step == 0 ? nearest : std::nextafter(nearest, step * infinity);
}

void add_pair(PairFamily& family, const Facet& facet, const Vector& query, double bound, const mpf_class& square) {
  family.pairs.add({facet.x, query, bound, facet.triangle});
  Stopwatch watch;
  const auto decision = geometry::decide(facet, query, bound, geometry::Mode::exact);
  family.exact_seconds += watch.lap();
  if (decision.stage == geometry::Stage::triangulated) ++family.triangulated;
  const mpf_class difference = square - mpf_class(bound, 600) * bound;
  const bool tie = abs(difference) <= 1e-60 * bound * bound;
  if (!tie && (difference < 0) != decision.closer) ++family.disagreements;
  family.truth.push_back({rounded(mpf_class(sqrt(square))), longest_side(facet), decision.closer});
}

}  // namespace

void add_pair(PairFamily& family, const Facet& facet, const Vector& query, double bound) {
  add_pair(family, facet, query, bound, reference(facet, query));
}

std::vector<PairFamily> made_families(std::size_t count) {
  std::vector<PairFamily> families;
  std::uint64_t seed = 1000;
  for (const Recipe& recipe : recipes()) {
    PairFamily family;
    family.name = recipe.name;
    family.group = groups[recipe.group];
    Maker maker(++seed);
    for (std::size_t i = 0; i < count; ++i) {
      const Pair pair = recipe.make(maker);
      const mpf_class square = reference(pair.facet, pair.query);
      const double bound = bound_of(maker, recipe.bound, rounded(mpf_class(sqrt(square))), longest_side(pair.facet));
      add_pair(family, pair.facet, pair.query, bound, square);
    }
    families.push_back(std::move(family));
  }
  return families;
}

}  // namespace gapcheck::bench
