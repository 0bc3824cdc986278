#include "geometry/follow.hpp"

#include <algorithm>
#include <cmath>

#include "base/triple.hpp"
#include "geometry/nearest_slack.hpp"
#include "geometry/patch.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry {
namespace {

constexpr int most_steps = 5;
/// Relative move of the last step of Newton's method, which converges quadratically.
constexpr double last_step = 1e-8;
/// Nearer to the border than this, others decide which feature is closest.
constexpr double border = 1 - 1e-9;

GAPCHECK_INLINE double largest(Triple p) { return larger(larger(std::abs(p.x), std::abs(p.y)), std::abs(p.z)); }

using Rows = std::array<FollowedPairs::Row, 3>;

GAPCHECK_INLINE void make_patches(FollowedPairs& f, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const Triple e0 = load(f.corner[0], i), e1 = load(f.corner[1], i), e2 = load(f.corner[2], i),
                 e3 = load(f.corner[3], i);
    const Triple low = e0 + e1, high = e3 + e2, right = e1 - e0, left = e2 - e3;
    store(f.patch[0], i, 0.25 * (low + high));
    store(f.patch[1], i, 0.25 * (right + left));
    store(f.patch[2], i, 0.25 * (high - low));
    store(f.patch[3], i, 0.25 * (left - right));
    f.settled[i] = 0;
  }
}

/// One step of Newton's method for the pairs that have not settled.
GAPCHECK_INLINE void step(FollowedPairs& f, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const Triple m = load(f.patch[0], i), a = load(f.patch[1], i), b = load(f.patch[2], i), c = load(f.patch[3], i);
    const double s = f.s[i], t = f.t[i], settled = f.settled[i];
    const Triple rs = a + t * c, rt = b + s * c, r = (m + t * b) + s * rs;
    const double gs = dot(r, rs), gt = dot(r, rt), ss = dot(rs, rs), tt = dot(rt, rt);
    const double st = dot(rs, rt) + dot(r, c), det = ss * tt - st * st, unit = 1 / det;
    const double ds = (st * gt - tt * gs) * unit, dt = (st * gs - ss * gt) * unit;
    const double moved = std::abs(ds) + std::abs(dt), least = 1e-12 * (ss * tt);
    const double small = moved <= last_step ? 1.0 : 0.0, regular = det > least ? 1.0 : 0.0;
    const double going = 1 - settled;
    f.s[i] = s + going * ds;  // steps of regular patches are finite
    f.t[i] = t + going * dt;
    f.settled[i] = settled + going * (small * regular);
  }
}

/// Upper bound of largest_drop() inside the patch, as a fraction: it can be compared without a division.
struct Drop {
  double above, below;
};
GAPCHECK_INLINE Drop largest_drop_inside(const FollowedPairs& f, std::size_t i, Triple rs, Triple rt, Triple w,
                                         double size) {
  const Triple a = load(f.patch[1], i), c = load(f.patch[3], i);
  const double error = roundoff * size * size;
  const double aa = dot(a, a), ac = dot(a, c), cc = dot(c, c), tt = dot(rt, rt), turn = dot(c, rt);
  const double mixed = dot(a, rt) + dot(w, c);
  // The square term is never negative: leaving it out makes a lower bound without a case.
  const double q0 = tt * aa - mixed * mixed, q1 = 2 * (tt * ac - mixed * turn);
  const double below = q0 - std::abs(q1) - 32768 * error * size * size;
  const double gs = std::abs(dot(w, rs)) + 512 * error, gt = std::abs(dot(w, rt)) + 512 * error;
  const double ss = aa + 2 * std::abs(ac) + cc + 512 * error;
  return {2.001 * ((tt + 512 * error) * gs * gs + ss * gt * gt), below};
}

GAPCHECK_INLINE void judge(FollowedPairs& f, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const Triple e0 = load(f.corner[0], i), e1 = load(f.corner[1], i), e2 = load(f.corner[2], i),
                 e3 = load(f.corner[3], i);
    const double s = f.s[i], t = f.t[i];
    // quad_weights() without its array: the loop is there to be vectorised.
    const double left = 0.5 * (1 - s), right = 0.5 * (1 + s), low = 0.5 * (1 - t), high = 0.5 * (1 + t);
    const Triple w = ((left * low) * e0 + (right * low) * e1) + ((right * high) * e2 + (left * high) * e3);
    const double square = dot(w, w);
    const double size = larger(larger(largest(e0), largest(e1)), larger(largest(e2), largest(e3)));
    const Triple rs = load(f.patch[1], i) + t * load(f.patch[3], i), rt = load(f.patch[2], i) + s * load(f.patch[3], i);
    store(f.offset, i, w);
    f.squared_distance[i] = square;
    f.size[i] = size;
    f.turn[i] = dot(cross(rs, rt), w);
    const double hull = smaller(smaller(dot(w, e0), dot(w, e1)), smaller(dot(w, e2), dot(w, e3))) - square;
    const double before = smaller(hull, 0.0), slack = 64 * roundoff * size;
    f.hull[i] = slack * slack * square - before * before;
    const Drop drop = largest_drop_inside(f, i, rs, rt, w, size);
    f.convexity[i] = drop.below;
    f.level[i] = (nearest_share_of_distance * square + nearest_share_of_size * size * size) * drop.below - drop.above;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bool inside = std::abs(f.s[i]) < border && std::abs(f.t[i]) < border;
    // The hull of the corners lies beyond the plane through the point, or the squared distance falls nowhere.
    const bool nearest = f.hull[i] >= 0 || (f.convexity[i] > 0 && f.level[i] >= 0);
    f.settled[i] = f.settled[i] > 0 && inside && nearest && usable(f.size[i]) ? 1 : 0;
  }
}

GAPCHECK_INLINE bool all_settled(const FollowedPairs& f, std::size_t count) {
  return std::all_of(f.settled.begin(), f.settled.begin() + count, [](double settled) { return settled > 0; });
}

GAPCHECK_INLINE void follow_pairs(FollowedPairs& f, std::size_t count) {
  make_patches(f, count);
  for (int i = 0; i < most_steps; ++i) {
    step(f, count);
    if (i > 0 && all_settled(f, count)) break;
  }
  judge(f, count);
}

#if GAPCHECK_WIDE_VECTORS
GAPCHECK_FOUR_LANES void follow_wide(FollowedPairs& f, std::size_t count) { follow_pairs(f, count); }
#endif

/// Pads to whole vectors by repeating the last pair. Returns the new number of pairs.
std::size_t pad(FollowedPairs& pairs, std::size_t count) {
  constexpr std::size_t lanes = 4;
  const std::size_t padded = (count + lanes - 1) / lanes * lanes;
  for (std::size_t i = count; i < padded; ++i) {
    for (auto& rows : pairs.corner)
      for (auto& row : rows) row[i] = row[count - 1];
    pairs.s[i] = pairs.s[count - 1];
    pairs.t[i] = pairs.t[count - 1];
  }
  return padded;
}

}  // namespace

void follow_narrow(FollowedPairs& pairs, std::size_t count) {
  follow_pairs(pairs, pad(pairs, std::min(count, FollowedPairs::capacity)));
}

void follow(FollowedPairs& pairs, std::size_t count) {
#if GAPCHECK_WIDE_VECTORS
  if (lanes_of_processor() != Lanes::two)
    return follow_wide(pairs, pad(pairs, std::min(count, FollowedPairs::capacity)));
#endif
  follow_narrow(pairs, count);
}

}  // namespace gapcheck::geometry
