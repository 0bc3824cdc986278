#include "geometry/decide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/certificate.hpp"
#include "geometry/exact.hpp"
#include "geometry/exact_quick.hpp"
#include "geometry/pieces.hpp"
#include "geometry/precise.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry {
namespace {

using exact::Piece;

/// A point of the patch to try; any is right, the nearest is the best.
struct Trial {
  double s = 0, t = 0;
};

Trial trial_on_patch(const Corners& e) {
  const Location at = locate_on_patch(e, Patch(e));
  if (!std::isfinite(at.s) || !std::isfinite(at.t)) return {};
  return {at.s, at.t};
}

/// Corners of a piece, to within 10 roundoffs of the patch's size.
Corners piece_corners(const Corners& e, const Piece& p) {
  const auto at = [&](double s, double t) { return blend(e, quad_weights(2 * s - 1, 2 * t - 1)); };
  return {at(p.s0, p.t0), at(p.s1, p.t0), at(p.s1, p.t1), at(p.s0, p.t1)};
}

constexpr int greatest_depth = 96, most_pieces = 4096;

/// The two halves of a piece of a patch, cut across its longer side; the same piece twice at the limit of doubles.
std::array<Piece, 2> halves(const Piece& piece, const Patch& patch) {
  std::array<Piece, 2> out{piece, piece};
  const double s = 0.5 * (piece.s0 + piece.s1), t = 0.5 * (piece.t0 + piece.t1);
  if (patch.a.norm() * (piece.s1 - piece.s0) >= patch.b.norm() * (piece.t1 - piece.t0)) {
    out[0].s1 = out[1].s0 = s;
  } else {
    out[0].t1 = out[1].t0 = t;
  }
  return out;
}

bool too_small(const Piece& piece) { return !(piece.s0 < piece.s1 && piece.t0 < piece.t1); }

/// Proves a patch piece by piece: pieces that stay open are halved. Returns `closer` as soon as one piece is, `apart`
/// if all are; otherwise `open`. `prove(piece, corners)` gives the verdict on one piece.
template <class Prove>
Verdict subdivide(const Corners& e, const Prove& prove) {
  struct Task {
    Piece piece;
    int depth;
  };
  const Patch patch(e);
  std::array<Task, greatest_depth + 2> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {Piece{}, 0};
  bool stuck = false;
  for (int pieces = 0; waiting > 0; ++pieces) {
    if (pieces == most_pieces) return Verdict::open;
    const auto [piece, depth] = stack[--waiting];
    const Verdict verdict = prove(piece, piece_corners(e, piece));
    if (verdict == Verdict::closer) return verdict;
    if (verdict == Verdict::apart) continue;
    const std::array<Piece, 2> parts = halves(piece, patch);
    if (depth == greatest_depth || too_small(parts[0]) || too_small(parts[1])) {
      stuck = true;
      continue;
    }
    for (const Piece& part : parts) stack[waiting++] = {part, depth + 1};
  }
  return stuck ? Verdict::open : Verdict::apart;
}

bool settled(Verdict verdict) { return verdict == Verdict::closer || verdict == Verdict::apart; }

/// What doubles prove, and the point that they tried last.
struct Filtered {
  Verdict verdict;
  Trial trial;
};

/// The projection of a flat parallelogram, held inside: cheap, and near enough for most proofs.
Trial affine_trial(const Patch& p) {
  const double aa = p.a.squaredNorm(), ab = p.a.dot(p.b), bb = p.b.squaredNorm(), ma = p.m.dot(p.a), mb = p.m.dot(p.b);
  const double unit = 1 / (aa * bb - ab * ab);
  return {std::clamp((ab * mb - bb * ma) * unit, -1.0, 1.0), std::clamp((ab * ma - aa * mb) * unit, -1.0, 1.0)};
}

/// What a point of the quad proves by itself (as Certificate::at() does); the plane through it may prove more.
bool point_is_closer(const Patch& p, const Trial& at, double size, double bound) {
  const double inside = bound - 64 * roundoff * size;
  const Vector w = (p.m + at.t * p.b) + at.s * (p.a + at.t * p.c);
  return inside > 0 && w.squaredNorm() < inside * inside;
}

/// `near`: the pair is probably closer, so a proof of the contrary is not worth trying.
Filtered filter(const Certificate& certificate, const Corners& e, double bound, bool triangle, const ClosestPoint* hint,
                bool near) {
  if (!near && certificate.separated_by_mean_plane(e)) return {Verdict::apart, {}};
  const auto at = [&](double s, double t) { return Filtered{certificate.at(e, s, t, triangle), {s, t}}; };
  if (hint != nullptr && std::abs(hint->s) <= 1 && std::abs(hint->t) <= 1) return at(hint->s, hint->t);
  if (triangle) {
    const Location nearest = locate_on_triangle(e);
    return at(nearest.s, nearest.t);
  }
  const Patch patch(e);
  if (const Trial trial = affine_trial(patch); point_is_closer(patch, trial, certificate.size(), bound))
    return {Verdict::closer, trial};
  const Location quick = locate_on_patch(e, patch, true);
  const Filtered first = at(quick.s, quick.t);
  if (first.verdict != Verdict::open) return first;
  const Location nearest = locate_on_patch(e, patch);
  return at(nearest.s, nearest.t);
}

Verdict prove_triangle(const Facet& facet, const Vector& query, double size, double bound, const Trial& trial) {
  const auto& x = facet.x;
  const precise::Differences corners{{x[0], x[1], x[2], x[2]}, {query, query, query, query}};
  if (precise::separated_by_axis(corners, bound)) return Verdict::apart;
  const Verdict verdict = precise::triangle_verdict(corners, size, bound, trial.s, trial.t);
  return settled(verdict) ? verdict : precise::triangle_edges_verdict(facet, query, size, bound);
}

/// The triangle that a quad with two equal neighbours is.
std::optional<Facet> as_triangle(const Facet& quad) {
  const auto& x = quad.x;
  if (x[0] == x[1]) return Facet{{x[0], x[2], x[3], x[3]}, true};
  if (x[1] == x[2]) return Facet{{x[0], x[1], x[3], x[3]}, true};
  if (x[2] == x[3] || x[3] == x[0]) return Facet{{x[0], x[1], x[2], x[2]}, true};
  return std::nullopt;
}

/// The patch first near the point tried last, if that is inside and at the bound, then its edges and pieces.
Verdict prove_quad(const Facet& facet, const Vector& query, double size, double bound, const Filtered& first) {
  const auto& x = facet.x;
  const precise::Differences corners{x, {query, query, query, query}};
  const Trial trial = first.trial;
  const bool tied = first.verdict == Verdict::tied;
  if (precise::separated_by_axis(corners, bound)) return Verdict::apart;
  std::optional<precise::Place> inside;
  constexpr double off_border = 1 - 1e-9;
  if (tied && std::abs(trial.s) < off_border && std::abs(trial.t) < off_border) {
    if (const Verdict verdict = precise::patch_verdict(corners, size, bound, trial.s, trial.t); settled(verdict))
      return verdict;
    inside = precise::Place{trial.s, trial.t};
  }
  const Verdict verdict = precise::quad_verdict(facet, query, size, bound, inside);
  if (settled(verdict) || inside) return verdict;
  const Trial other = trial_on_patch(seen_from(facet, query));
  return precise::quad_verdict(facet, query, size, bound, precise::Place{other.s, other.t});
}

/// What the filter left open: more digits for what lies at the bound, and pieces of quads.
Verdict prove_further(double size, const Facet& facet, const Vector& query, double bound, const Filtered& first) {
  if (!all_finite(facet, query)) return Verdict::open;
  if (facet.triangle) return prove_triangle(facet, query, size, bound, first.trial);
  if (const auto triangle = as_triangle(facet)) {
    const Location nearest = locate_on_triangle(seen_from(*triangle, query));
    return prove_triangle(*triangle, query, size, bound, {nearest.s, nearest.t});
  }
  return prove_quad(facet, query, size, bound, first);
}

/// In exact numbers; `filtered` uses doubles first wherever they are certain.
Decision decide_exactly(const Facet& facet, const Vector& query, double bound, Mode mode) {
  if (!all_finite(facet, query)) return {false, Stage::exact};
  if (std::isinf(bound)) return {true, Stage::exact};
  const auto& x = facet.x;
  const auto triangle = mode == Mode::filtered ? exact::quick_triangle_closer : exact::triangle_closer;
  if (facet.triangle) return {triangle(x[0], x[1], x[2], query, bound), Stage::exact};
  if (mode == Mode::filtered ? exact::quick_flat_and_convex(facet) : exact::flat_and_convex(facet)) {
    const bool closer = triangle(x[0], x[1], x[2], query, bound) || triangle(x[0], x[2], x[3], query, bound);
    return {closer, Stage::exact};
  }
  const Corners e = scaled_view(facet, query).corners;
  const Verdict verdict = subdivide(e, [&](const Piece& piece, const Corners& corners) {
    const Trial trial = trial_on_patch(corners);
    return exact::piece_verdict(facet, query, bound, piece, trial.s, trial.t);
  });
  if (verdict != Verdict::open) return {verdict == Verdict::closer, Stage::exact};
  return {exact::fan_closer(facet, query, bound), Stage::triangulated};
}

}  // namespace

void count(DecisionCounters& counters, Stage stage, std::uint64_t times) {
  std::atomic<std::uint64_t>* const counter = stage == Stage::filter     ? &counters.filter
                                              : stage == Stage::interval ? &counters.interval
                                              : stage == Stage::exact    ? &counters.exact
                                                                         : &counters.triangulated;
  counter->fetch_add(times, std::memory_order_relaxed);
  if (stage == Stage::triangulated) counters.exact.fetch_add(times, std::memory_order_relaxed);
}

Decision decide(const Facet& facet, const Vector& query, double bound, Mode mode, const ClosestPoint* hint) {
  if (!(bound > 0)) return {false, Stage::filter};
  if (mode == Mode::filtered) {
    const Corners e = seen_from(facet, query);
    const bool near = hint != nullptr && hint->squared_distance < bound * bound;
    if (!near && separated_by_axis(e, bound)) return {false, Stage::filter};
    const double size = size_of(e);
    if (usable(size)) {
      const Certificate certificate(size, bound);
      const Filtered first = filter(certificate, e, bound, facet.triangle, hint, near);
      if (settled(first.verdict)) return {first.verdict == Verdict::closer, Stage::filter};
      if (const Verdict second = prove_further(size, facet, query, bound, first); settled(second))
        return {second == Verdict::closer, Stage::interval};
    }
  }
  return decide_exactly(facet, query, bound, mode);
}

bool closer_than(const Facet& facet, const Vector& query, double bound, Mode mode, DecisionCounters& counters,
                 const ClosestPoint* hint) {
  const Decision decision = decide(facet, query, bound, mode, hint);
  count(counters, decision.stage);
  return decision.closer;
}

bool closer_than(const Vector& a, const Vector& b, const Vector& query, double bound, Mode mode,
                 DecisionCounters& counters) {
  if (!(bound > 0)) {
    count(counters, Stage::filter);
    return false;
  }
  const Corners e{a - query, b - query, b - query, a - query};
  const double size = size_of(e);
  if (mode == Mode::filtered && usable(size)) {
    const Certificate certificate(size, bound);
    const double s = closest_point_on_line(e[0], e[1], Vector::Zero()).s;
    const Verdict verdict = separated_by_axis(e, bound) ? Verdict::apart : certificate.at(e, s, -1, true);
    if (verdict == Verdict::closer || verdict == Verdict::apart) {
      count(counters, Stage::filter);
      return verdict == Verdict::closer;
    }
  }
  count(counters, Stage::exact);
  if (!a.allFinite() || !b.allFinite() || !query.allFinite()) return false;
  return std::isinf(bound) || exact::segment_closer(a, b, query, bound);
}

Side decide_side(const Vector& a, const Vector& b, const Vector& c, const Vector& query, Mode mode) {
  if (mode == Mode::filtered) {
    const Vector u = a - query, v = b - query, w = c - query;
    const double size = size_of({u, v, w, w});
    const double det = u.dot(v.cross(w));
    const Vector au = u.cwiseAbs(), av = v.cwiseAbs(), aw = w.cwiseAbs();
    const double terms = au.x() * (av.y() * aw.z() + av.z() * aw.y()) + au.y() * (av.z() * aw.x() + av.x() * aw.z()) +
                         au.z() * (av.x() * aw.y() + av.y() * aw.x());
    // Nine roundings of relative size on each product; the last term covers underflow at the sizes let in.
    const double error = 16 * roundoff * terms + 1e-290;
    if (size >= 1e-90 && size <= 1e90 && std::abs(det) > error) return {det < 0 ? 1 : -1, Stage::filter};
  }
  if (!a.allFinite() || !b.allFinite() || !c.allFinite() || !query.allFinite()) return {0, Stage::exact};
  return {-exact::orientation(a, b, c, query), Stage::exact};
}

}  // namespace gapcheck::geometry
