#pragma once
#include "geometry/batch/pair_arrays.hpp"
#include "geometry/lanes.hpp"
#include "geometry/nearest_slack.hpp"

/// The arithmetic of pair_batch.hpp for one width. Every lane does the same, whatever its neighbours hold. The
/// constants are derived in docs/theory/decisions.md.
namespace gapcheck::geometry {
namespace {

inline constexpr double batch_roundoff = 0x1p-53;
/// Newton steps after the solution of the flat parallelogram: the remaining error does not matter to most proofs.
inline constexpr int steps_to_prove = 2;
/// Parameters that moved less in the last step are good to rounding after it.
inline constexpr double settled_step = 1e-7;
/// Closest points this near to the border do not count as located.
inline constexpr double border = 1e-6;

/// What is known about the sizes in one lane.
template <class V>
struct Scale {
  V squared_bound, error, limit;  ///< B², the error of squared lengths, B² plus that error
  Mask<V> usable;

  /// `squares`: at least the square of every corner.
  Scale(const V& bound, const V& squares)
      : squared_bound(bound * bound),
        error(128 * batch_roundoff * (squares + squared_bound)),
        limit(squared_bound + error),
        usable((bound > 0.0) & (squares >= 1e-60) & (squares <= 1e60) & (squared_bound <= 1e60)) {}
  /// The point w of the facet is nearer.
  [[nodiscard]] Mask<V> closer(const V& ww) const { return usable & (ww + error < squared_bound); }
  /// The plane through w at right angles to it is not, and all corners lie behind it; `least`: the smallest w·corner.
  [[nodiscard]] Mask<V> separated(const V& ww, const V& least) const {
    return usable & (ww > limit) & (least > 0.0) & (least * least >= ww * limit);
  }
};

template <class V>
inline void put(PairArrays& p, std::size_t first, const Mask<V>& closer, const Mask<V>& apart, const Mask<V>& located) {
  p.closer |= bits<V>(closer) << first;
  p.apart |= bits<V>(apart) << first;
  p.located |= bits<V>(located) << first;
}

/// Products of the vectors of r(s,t) = m + a s + b t + c s t.
template <class V>
struct Products {
  V mm, ma, mb, mc, aa, ab, ac, bb, bc, cc;
  Products(const Vectors<V>& m, const Vectors<V>& a, const Vectors<V>& b, const Vectors<V>& c)
      : mm(dot(m, m)),
        ma(dot(m, a)),
        mb(dot(m, b)),
        mc(dot(m, c)),
        aa(dot(a, a)),
        ab(dot(a, b)),
        ac(dot(a, c)),
        bb(dot(b, b)),
        bc(dot(b, c)),
        cc(dot(c, c)) {}
  [[nodiscard]] V squared_distance(const V& s, const V& t) const {
    return mm + s * (2.0 * ma + s * aa) + t * (2.0 * mb + t * bb) +
           s * t * (2.0 * (mc + ab) + 2.0 * (s * ac + t * bc) + s * t * cc);
  }
};

/// Parameters of trial points, one per lane. `inside`: it is the stationary point, and lies within the borders.
template <class V>
struct Trials {
  V s, t;
  Mask<V> inside, settled;
};

template <class V>
inline Trials<V> stationary_point(const Products<V>& g, int steps) {
  const V unit = 1.0 / (g.aa * g.bb - g.ab * g.ab);
  V s = clamped<V>((g.ab * g.mb - g.bb * g.ma) * unit, -2, 2),
    t = clamped<V>((g.ab * g.ma - g.aa * g.mb) * unit, -2, 2);
  Mask<V> moving = s == s;
  for (int step = 0; step < steps; ++step) {
    const V st = s * t;
    const V rc = g.mc + s * g.ac + t * g.bc + st * g.cc;
    const V gs = g.ma + s * g.aa + t * g.ab + st * g.ac + t * rc, gt = g.mb + s * g.ab + t * g.bb + st * g.bc + s * rc;
    const V ss = g.aa + t * (2.0 * g.ac + t * g.cc), tt = g.bb + s * (2.0 * g.bc + s * g.cc);
    const V mixed = g.ab + s * g.ac + t * g.bc + st * g.cc + rc, det = ss * tt - mixed * mixed;
    const V inverse = 1.0 / det;
    const V ds = (mixed * gt - tt * gs) * inverse, dt = (mixed * gs - ss * gt) * inverse;
    const Mask<V> sound = moving & (det > 1e-9 * ss * tt);
    s = sound ? s + ds : s;
    t = sound ? t + dt : t;
    moving = moving & ~(sound & (amount(ds) + amount(dt) <= settled_step));
    if (bits<V>(moving) == 0) break;
  }
  return {s, t, (amount(s) < 1.0) & (amount(t) < 1.0), ~moving};
}

/// For points beyond the border: the nearest point of the edge, or the better of the two, that they lie beyond.
template <class V>
inline void move_to_border(const Products<V>& g, Trials<V>& trial) {
  const V one = all<V>(1);
  const V end_s = trial.s > 0.0 ? one : -one, end_t = trial.t > 0.0 ? one : -one;
  const V along_t = clamped<V>(-(g.mb + g.ac + end_s * (g.mc + g.ab)) / (g.bb + g.cc + 2.0 * end_s * g.bc), -1, 1);
  const V along_s = clamped<V>(-(g.ma + g.bc + end_t * (g.mc + g.ab)) / (g.aa + g.cc + 2.0 * end_t * g.ac), -1, 1);
  const Mask<V> beyond_s = ~(amount(trial.s) < 1.0), beyond_t = ~(amount(trial.t) < 1.0);
  const Mask<V> nearer_s = g.squared_distance(end_s, along_t) <= g.squared_distance(along_s, end_t);
  const Mask<V> to_s = beyond_s & (~beyond_t | nearer_s);
  const V s = to_s ? end_s : along_s, t = to_s ? along_t : end_t;
  trial.s = trial.inside ? trial.s : s;
  trial.t = trial.inside ? trial.t : t;
}

/// Products of a point of the patch with the vectors of the patch.
template <class V>
struct PointProducts {
  V ww, wm, wa, wb, wc;
  [[nodiscard]] V least_of_corners() const {
    const V even = wm + wc, odd = wm - wc, sum = wa + wb, difference = wa - wb;
    return smaller(even - amount(sum), odd - amount(difference));
  }
};

/// Upper bound of the drop of the squared distance below its value at the trial point, as a fraction. `least` <= 0:
/// none.
template <class V>
struct Drop {
  V drop, least;
};

template <class V>
inline V usable_slope(const V& slope, const V& parameter, const V& margin) {
  const Mask<V> leads_out = ((parameter >= 1.0) & (slope <= -margin)) | ((parameter <= -1.0) & (slope >= margin));
  return leads_out ? V{} : amount(slope) + margin;
}

template <class V>
inline Drop<V> drop_bound(const Products<V>& g, const PointProducts<V>& w, const Trials<V>& at, const V& squares) {
  const V margin = 512 * batch_roundoff * squares;
  const V turn = g.bc + at.s * g.cc, tt = g.bb + at.s * (g.bc + turn), mixed = g.ab + at.s * g.ac + w.wc;
  const V q0 = tt * g.aa - mixed * mixed, q1 = 2.0 * (tt * g.ac - mixed * turn), q2 = tt * g.cc - turn * turn;
  const V swing = amount(q1);
  const V least = (swing >= 2.0 * q2 ? q0 + q2 - swing : q0 - 0.5 * swing) - 32768 * batch_roundoff * squares * squares;
  const V gs = usable_slope<V>(w.wa + at.t * w.wc, at.s, margin),
          gt = usable_slope<V>(w.wb + at.s * w.wc, at.t, margin);
  const V ss = g.aa + 2.0 * amount(g.ac) + g.cc + margin;
  return {2.001 * ((tt + margin) * gs * gs + ss * gt * gt), least};
}

template <class V>
inline void decide_quads(PairArrays& p, std::size_t first) {
  const auto e0 = load<V>(p.corner[0], first), e1 = load<V>(p.corner[1], first), e2 = load<V>(p.corner[2], first),
             e3 = load<V>(p.corner[3], first);
  const auto low = e0 + e1, high = e3 + e2, right = e1 - e0, left = e2 - e3;
  const V quarter = all<V>(0.25);
  const auto m = quarter * (low + high), a = quarter * (right + left), b = quarter * (high - low),
             c = quarter * (left - right);
  const Products<V> g(m, a, b, c);
  Trials<V> at = stationary_point(g, steps_to_prove);
  if (bits<V>(~at.inside) != 0) move_to_border(g, at);

  const auto w = (m + at.t * b) + at.s * (a + at.t * c);
  const PointProducts<V> on{dot(w, w), dot(w, m), dot(w, a), dot(w, b), dot(w, c)};
  const V squares = 4.0 * (g.mm + g.aa + g.bb + g.cc), least = on.least_of_corners();
  const Scale<V> scale(load<V>(p.bound + first), squares);
  const Mask<V> closer = scale.closer(on.ww);
  Mask<V> apart = scale.separated(on.ww, least);
  const Mask<V> face = closer & at.settled & (amount(at.s) < 1.0 - border) & (amount(at.t) < 1.0 - border);
  // The margin must be small compared with the square itself, otherwise it proves nothing near the query.
  Mask<V> nearest = (least >= on.ww - scale.error) & (on.ww >= 0x1p20 * scale.error);
  const Mask<V> open = (scale.usable & (on.ww > scale.limit) & ~apart) | (face & ~nearest);
  if (bits<V>(open) != 0) {
    const Drop<V> fall = drop_bound(g, on, at, squares);
    const Mask<V> bounded = scale.usable & (fall.least > 0.0);
    apart = apart | (bounded & (on.ww > scale.limit) & ((on.ww - scale.limit - scale.error) * fall.least >= fall.drop));
    const V slack = nearest_share_of_distance * on.ww + nearest_share_of_size * squares;
    nearest = nearest | (bounded & (fall.drop <= fall.least * slack));
  }
  store<V>(p.s + first, at.s);
  store<V>(p.t + first, at.t);
  store<V>(p.squared_distance + first, on.ww);
  put<V>(p, first, closer, apart, face & nearest);
}

template <class V>
inline void decide_triangles(PairArrays& p, std::size_t first) {
  const auto e = load<V>(p.corner[0], first), u = load<V>(p.corner[1], first) - e, v = load<V>(p.corner[2], first) - e;
  const V ee = dot(e, e), eu = dot(e, u), ev = dot(e, v), uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
  const V unit = 1.0 / (uu * vv - uv * uv);
  V x = (uv * ev - vv * eu) * unit, y = (uv * eu - uu * ev) * unit;  // the point e + x u + y v
  const Mask<V> inside = (x > 0.0) & (y > 0.0) & (x + y < 1.0);
  const Mask<V> within = (x > border) & (y > border) & (x + y < 1.0 - border);
  if (bits<V>(~inside) != 0) {
    const V on_u = clamped<V>(-eu / uu, 0, 1), on_v = clamped<V>(-ev / vv, 0, 1);
    const V to_v = vv - uv - (uv - uu), from_u = ev - eu + uv - uu, third = clamped<V>(-from_u / to_v, 0, 1);
    const V by_u = ee + on_u * (2.0 * eu + on_u * uu), by_v = ee + on_v * (2.0 * ev + on_v * vv);
    const V by_third = (ee + 2.0 * eu + uu) + third * (2.0 * from_u + third * to_v);
    const Mask<V> u_first = by_u <= by_v, third_first = by_third < smaller(by_u, by_v);
    const V border_x = third_first ? 1.0 - third : (u_first ? on_u : V{});
    const V border_y = third_first ? third : (u_first ? V{} : on_v);
    x = inside ? x : border_x;
    y = inside ? y : border_y;
  }
  x = clamped<V>(x, 0, 1);
  y = smaller(clamped<V>(y, 0, 1), V(1.0 - x));

  const auto w = e + (x * u + y * v);
  const V ww = dot(w, w), wu = dot(w, u), wv = dot(w, v), zero{};
  const V least = dot(w, e) + smaller(zero, smaller(wu, wv));
  const Scale<V> scale(load<V>(p.bound + first), 2.0 * (ee + uu + vv));
  const Mask<V> closer = scale.closer(ww);
  store<V>(p.s + first, clamped<V>((2.0 * x + y - 1.0) / (1.0 - y), -1, 1));
  store<V>(p.t + first, 2.0 * y - 1.0);
  store<V>(p.squared_distance + first, ww);
  put<V>(p, first, closer, scale.separated(ww, least), closer & within & (least >= ww - scale.error));
}

/// All pairs of the arrays.
template <std::size_t N>
inline void decide_all(PairArrays& p, bool triangles) {
  p.closer = p.apart = p.located = 0;
  for (std::size_t first = 0; first < p.size; first += N)
    triangles ? decide_triangles<Lanes<N>>(p, first) : decide_quads<Lanes<N>>(p, first);
  const std::uint64_t present = filled(p.size);
  p.closer &= present;
  p.apart &= present;
  p.located &= present;
}

}  // namespace
}  // namespace gapcheck::geometry
