#pragma once
#include "geometry/certificate.hpp"
#include "geometry/closest_point.hpp"

/// Decisions in exact numbers; slow. All coordinates must be finite; bounds positive and finite.
namespace gapcheck::geometry::exact {

[[nodiscard]] bool segment_closer(const Vector& a, const Vector& b, const Vector& query, double bound);
[[nodiscard]] bool triangle_closer(const Vector& a, const Vector& b, const Vector& c, const Vector& query,
                                   double bound);
/// The plane through three points that are not on a line.
[[nodiscard]] bool plane_closer(const Vector& a, const Vector& b, const Vector& c, const Vector& query, double bound);
/// The four triangles between the edges and the mean of the corners.
[[nodiscard]] bool fan_closer(const Facet& facet, const Vector& query, double bound);
/// Are two straight edges, each from [0] to [1], nearer to each other than the bound?
[[nodiscard]] bool edges_closer(const std::array<Vector, 2>& first, const std::array<Vector, 2>& second, double bound);
/// A quad whose corners lie in one plane and turn one way (or all on a line): the patch is their convex hull.
[[nodiscard]] bool flat_and_convex(const Facet& facet);
/// What the piece of the patch between the parameters (s0, t0) and (s1, t1), here all in [0, 1], proves; (s, t) in [-1,
/// 1] is a point of the piece to try. Never `tied`.
struct Piece {
  double s0 = 0, s1 = 1, t0 = 0, t1 = 1;
};
[[nodiscard]] Verdict piece_verdict(const Facet& facet, const Vector& query, double bound, const Piece& piece, double s,
                                    double t);
/// Sign of the determinant |a - d, b - d, c - d|.
[[nodiscard]] int orientation(const Vector& a, const Vector& b, const Vector& c, const Vector& d);

}  // namespace gapcheck::geometry::exact
