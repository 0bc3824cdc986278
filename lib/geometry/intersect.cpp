#include "geometry/intersect.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/arithmetic.hpp"

namespace gapcheck::geometry {
namespace {

using Signs = std::array<int, 3>;

bool finite(const Triangle& t) { return t[0].allFinite() && t[1].allFinite() && t[2].allFinite(); }
bool all_zero(const Signs& s) { return s[0] == 0 && s[1] == 0 && s[2] == 0; }
/// All of them on one side, none on the plane.
bool one_side(const Signs& s) { return s[0] != 0 && s[0] == s[1] && s[0] == s[2]; }
bool both_sides(const Signs& s) { return std::max({s[0], s[1], s[2]}) > 0 && std::min({s[0], s[1], s[2]}) < 0; }
/// No two of them are opposite.
bool agree(const Signs& s) { return !both_sides(s); }

/// Exact answers from the signs of determinants; remembers whether one of them needed exact numbers.
class Decider {
 public:
  explicit Decider(Mode mode) : mode_(mode) {}
  [[nodiscard]] Stage stage() const { return stage_; }

  bool triangles_meet(const Triangle& a, const Triangle& b) {
    const Signs of_a = sides(b, a);
    if (one_side(of_a)) return false;
    const Signs of_b = sides(a, b);
    if (one_side(of_b)) return false;
    if (all_zero(of_a) && all_zero(of_b)) return flat_triangles_meet(a, b);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (segment_meets(a[i], a[j], b, of_a[i], of_a[j]) || segment_meets(b[i], b[j], a, of_b[i], of_b[j])) return true;
    }
    return false;
  }

  /// The two triangles cut the line in which their planes meet in two pieces, each from the edges at the corner that is
  /// alone on its side. They overlap if each begins before the other ends; each comparison is one determinant
  /// (Guigue and Devillers, Fast and robust triangle-triangle overlap test using orientation predicates, 2003).
  bool triangles_cross(Triangle a, Triangle b) {
    const Signs of_a = sides(b, a);
    if (!both_sides(of_a)) return false;
    const Signs of_b = sides(a, b);
    if (!both_sides(of_b)) return false;
    const std::size_t alone_a = alone(of_a), alone_b = alone(of_b);
    std::rotate(a.begin(), a.begin() + alone_a, a.end());
    std::rotate(b.begin(), b.begin() + alone_b, b.end());
    // Turned so that each sees the other's first corner on its positive side.
    if (of_a[alone_a] < 0) std::swap(b[1], b[2]);
    if (of_b[alone_b] < 0) std::swap(a[1], a[2]);
    return side(a[0], a[1], b[0], b[1]) < 0 && side(a[0], a[2], b[2], b[0]) < 0;
  }

  bool segment_meets(const Vector& p, const Vector& q, const Triangle& t) {
    return segment_meets(p, q, t, side(t[0], t[1], t[2], p), side(t[0], t[1], t[2], q));
  }

  bool segment_crosses(const Vector& p, const Vector& q, const Triangle& t) {
    return side(t[0], t[1], t[2], p) * side(t[0], t[1], t[2], q) < 0 && line_meets(p, q, t);
  }

  Passage passage(const Vector& p, const Vector& q, const Triangle& t) {
    const int of_p = side(t[0], t[1], t[2], p), of_q = side(t[0], t[1], t[2], q);
    if (of_p * of_q > 0) return Passage::none;
    if (of_p == 0 || of_q == 0) return segment_meets(p, q, t, of_p, of_q) ? Passage::touching : Passage::none;
    const Signs s = around(p, q, t);
    if (both_sides(s)) return Passage::none;
    return s[0] != 0 && s[1] != 0 && s[2] != 0 ? Passage::through : Passage::touching;
  }

  bool segments_meet(const Vector& p, const Vector& q, const Vector& r, const Vector& s) {
    if (side(p, q, r, s) != 0) return false;
    for (int axis = 0; axis < 3; ++axis)
      if (turn(p, q, r, axis) != 0 || turn(p, q, s, axis) != 0 || turn(r, s, p, axis) != 0 || turn(r, s, q, axis) != 0)
        return flat_segments_meet(p, q, r, s, axis);
    return boxes_meet(p, q, r, s);  // all on one line
  }

 private:
  int side(const Vector& a, const Vector& b, const Vector& c, const Vector& query) {
    const Side found = decide_side(a, b, c, query, mode_);
    if (found.stage == Stage::exact) stage_ = Stage::exact;
    return found.sign;
  }
  Signs sides(const Triangle& t, const Triangle& of) {
    return {side(t[0], t[1], t[2], of[0]), side(t[0], t[1], t[2], of[1]), side(t[0], t[1], t[2], of[2])};
  }
  static std::size_t alone(const Signs& s) {
    for (std::size_t i = 0; i < 2; ++i)
      if (s[i] != 0 && s[i] * s[(i + 1) % 3] <= 0 && s[i] * s[(i + 2) % 3] <= 0) return i;
    return 2;
  }

  /// On which side the line through p and q passes the edges.
  Signs around(const Vector& p, const Vector& q, const Triangle& t) {
    return {side(p, q, t[0], t[1]), side(p, q, t[1], t[2]), side(p, q, t[2], t[0])};
  }
  /// The line through p and q, which is not in the triangle's plane, passes through the closed triangle.
  bool line_meets(const Vector& p, const Vector& q, const Triangle& t) { return agree(around(p, q, t)); }
  bool segment_meets(const Vector& p, const Vector& q, const Triangle& t, int of_p, int of_q) {
    if (of_p * of_q > 0) return false;
    if (of_p == 0 && of_q == 0) return flat_segment_meets(p, q, t);
    return line_meets(p, q, t);
  }

  /// 1 if a, b, c turn left as seen against an axis, -1 if they turn right, 0 if they lie on a line.
  int turn(const Vector& a, const Vector& b, const Vector& c, int axis) {
    const auto flat = [&](const Vector& x, double height) {
      return Vector(x[(axis + 1) % 3], x[(axis + 2) % 3], height);
    };
    return side(flat(a, 0), flat(b, 0), flat(c, 0), flat(c, 1));
  }
  /// An axis along which the triangle has an area; -1 if it has none.
  int axis_of(const Triangle& t) {
    for (int axis = 0; axis < 3; ++axis)
      if (turn(t[0], t[1], t[2], axis) != 0) return axis;
    return -1;
  }
  static bool boxes_meet(const Vector& p, const Vector& q, const Vector& r, const Vector& s) {
    return (p.cwiseMin(q).array() <= r.cwiseMax(s).array()).all() &&
           (r.cwiseMin(s).array() <= p.cwiseMax(q).array()).all();
  }
  /// Of segments in one plane that is not parallel to the axis.
  bool flat_segments_meet(const Vector& p, const Vector& q, const Vector& r, const Vector& s, int axis) {
    return boxes_meet(p, q, r, s) && turn(p, q, r, axis) * turn(p, q, s, axis) <= 0 &&
           turn(r, s, p, axis) * turn(r, s, q, axis) <= 0;
  }
  /// The triangle has an area along the axis, and the point is in its plane.
  bool flat_inside(const Vector& p, const Triangle& t, int axis) {
    return agree({turn(t[0], t[1], p, axis), turn(t[1], t[2], p, axis), turn(t[2], t[0], p, axis)});
  }
  /// A segment in the triangle's plane, or any with a triangle without area.
  bool flat_segment_meets(const Vector& p, const Vector& q, const Triangle& t) {
    const int axis = axis_of(t);
    if (axis >= 0 && flat_inside(p, t, axis)) return true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector &r = t[i], &s = t[(i + 1) % 3];
      if (axis >= 0 ? flat_segments_meet(p, q, r, s, axis) : segments_meet(p, q, r, s)) return true;
    }
    return false;
  }
  /// Triangles in one plane, or one of them without area.
  bool flat_triangles_meet(const Triangle& a, const Triangle& b) {
    for (std::size_t i = 0; i < 3; ++i)
      if (segment_meets(a[i], a[(i + 1) % 3], b)) return true;
    const int axis = axis_of(a);
    return axis >= 0 && flat_inside(b[0], a, axis);
  }

  Mode mode_;
  Stage stage_ = Stage::filter;
};

/// Calls a decider and counts the answer.
template <class Ask>
bool answer(Mode mode, DecisionCounters& counters, const Ask& ask) {
  Decider decider(mode);
  const bool yes = ask(decider);
  count(counters, decider.stage());
  return yes;
}

/// The piece of the line from `origin` along the unit vector `along` on which a triangle lies, given the heights of its
/// corners over a plane through the line.
std::pair<double, double> piece_on_line(const Triangle& t, const std::array<double, 3>& height, const Vector& origin,
                                        const Vector& along) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto add = [&](const Vector& x) {
    const double at = along.dot(x - origin);
    low = std::min(low, at);
    high = std::max(high, at);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (height[i] == 0) add(t[i]);
    if (height[i] * height[j] < 0) add(t[i] + height[i] / (height[i] - height[j]) * (t[j] - t[i]));
  }
  return {low, high};
}

std::array<double, 3> heights(const Triangle& t, const Triangle& plane, const Vector& normal, double tolerance) {
  std::array<double, 3> height{};
  for (std::size_t i = 0; i < 3; ++i) {
    height[i] = normal.dot(t[i] - plane[0]);
    if (std::abs(height[i]) <= tolerance) height[i] = 0;
  }
  return height;
}

}  // namespace

bool triangles_meet(const Triangle& a, const Triangle& b, Mode mode, DecisionCounters& counters) {
  return finite(a) && finite(b) &&
         answer(mode, counters, [&](Decider& decider) { return decider.triangles_meet(a, b); });
}

bool triangles_cross(const Triangle& a, const Triangle& b, Mode mode, DecisionCounters& counters) {
  return finite(a) && finite(b) &&
         answer(mode, counters, [&](Decider& decider) { return decider.triangles_cross(a, b); });
}

bool segment_meets(const Vector& p, const Vector& q, const Triangle& t, Mode mode, DecisionCounters& counters) {
  return p.allFinite() && q.allFinite() && finite(t) &&
         answer(mode, counters, [&](Decider& decider) { return decider.segment_meets(p, q, t); });
}

bool segment_crosses(const Vector& p, const Vector& q, const Triangle& t, Mode mode, DecisionCounters& counters) {
  return p.allFinite() && q.allFinite() && finite(t) &&
         answer(mode, counters, [&](Decider& decider) { return decider.segment_crosses(p, q, t); });
}

Passage passage(const Vector& p, const Vector& q, const Triangle& t, Mode mode, DecisionCounters& counters) {
  if (!p.allFinite() || !q.allFinite() || !finite(t)) return Passage::none;
  Decider decider(mode);
  const Passage found = decider.passage(p, q, t);
  count(counters, decider.stage());
  return found;
}

bool segments_meet(const Vector& p, const Vector& q, const Vector& r, const Vector& s, Mode mode,
                   DecisionCounters& counters) {
  return p.allFinite() && q.allFinite() && r.allFinite() && s.allFinite() &&
         answer(mode, counters, [&](Decider& decider) { return decider.segments_meet(p, q, r, s); });
}

Line common_line(const Triangle& a, const Triangle& b, double tolerance) {
  const Vector of_a = (a[1] - a[0]).cross(a[2] - a[0]).stableNormalized();
  const Vector of_b = (b[1] - b[0]).cross(b[2] - b[0]).stableNormalized();
  const Vector along = of_a.cross(of_b).stableNormalized();
  const auto [low_a, high_a] = piece_on_line(a, heights(a, b, of_b, tolerance), a[0], along);
  const auto [low_b, high_b] = piece_on_line(b, heights(b, a, of_a, tolerance), a[0], along);
  const double low = std::max(low_a, low_b), high = std::min(high_a, high_b);
  if (!(low <= high)) return {};
  // The line itself: a point of a's piece, carried along. The piece's ends lie on b's plane, and so on the line.
  const std::array<double, 3> height = heights(a, b, of_b, tolerance);
  Vector on_line = a[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (height[i] == 0) on_line = a[i];
    if (height[i] * height[j] < 0) on_line = a[i] + height[i] / (height[i] - height[j]) * (a[j] - a[i]);
  }
  const double at = along.dot(on_line - a[0]);
  return {on_line + (low - at) * along, on_line + (high - at) * along};
}

}  // namespace gapcheck::geometry
