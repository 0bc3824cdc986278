#pragma once
#include <atomic>
#include <cstdint>

#include "geometry/closest_point.hpp"

namespace gapcheck::geometry {

/// How the decisions of one run were reached. Counters may be raised from any thread.
struct DecisionCounters {
  std::atomic<std::uint64_t> filter{0};        ///< floating-point filter with a proven error bound
  std::atomic<std::uint64_t> interval{0};      ///< 106 bits with a proven error bound, pieces of patches
  std::atomic<std::uint64_t> exact{0};         ///< CGAL's exact numbers
  std::atomic<std::uint64_t> triangulated{0};  ///< of these: warped quads decided on their documented triangulation
};

enum class Mode : std::uint8_t { filtered, exact };

/// The stage that reached one decision, in the order of the counters.
enum class Stage : std::uint8_t { filter, interval, exact, triangulated };

struct Decision {
  bool closer = false;
  Stage stage = Stage::filter;
};

/// Raises the counter of a stage; `triangulated` ones count as exact too.
void count(DecisionCounters& counters, Stage stage, std::uint64_t times = 1);

/// closer_than() without counters, for loops that keep a tally of their own.
[[nodiscard]] Decision decide(const Facet& facet, const Vector& query, double bound, Mode mode,
                              const ClosestPoint* hint = nullptr);

/// Is the facet nearer to the query than `bound`: squared distance < bound², decided exactly for the given doubles?
/// Negative bounds are never met. Quads: exact on the bilinear patch as far as pieces of it reach; open cases are
/// decided on the triangulation documented in docs/theory/decisions.md and counted. Mode::exact leaves the filter out
/// (slow twin, same answers). `hint` may carry closest_point() of the same pair to save its work.
[[nodiscard]] bool closer_than(const Facet& facet, const Vector& query, double bound, Mode mode,
                               DecisionCounters& counters, const ClosestPoint* hint = nullptr);

/// The same for a line (beam axis).
[[nodiscard]] bool closer_than(const Vector& a, const Vector& b, const Vector& query, double bound, Mode mode,
                               DecisionCounters& counters);

/// On which side of a plane a point lies, and the stage that decided it.
struct Side {
  int sign = 0;
  Stage stage = Stage::filter;
};

/// Sign of the side of the plane through a, b, c on which the query lies (orientation determinant): exact. 1 on the
/// side to which the normal (b - a) x (c - a) points, -1 on the other, 0 on the plane or for numbers that are not
/// finite.
[[nodiscard]] Side decide_side(const Vector& a, const Vector& b, const Vector& c, const Vector& query, Mode mode);

}  // namespace gapcheck::geometry
