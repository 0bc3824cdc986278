#include "solver/mortar/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/quad.hpp"

namespace gapcheck::solver {
namespace {

using Flat = Eigen::Vector2d;

double flat_cross(const Flat& a, const Flat& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A convex piece of a projected facet, counterclockwise.
struct FlatPiece {
  std::array<Flat, 4> x;
  std::array<std::uint8_t, 4> corner{};  ///< of the facet
  std::size_t size = 0;

  [[nodiscard]] double doubled_area() const {
    double sum = 0;
    for (std::size_t i = 2; i < size; ++i) sum += flat_cross(x[i - 1] - x[0], x[i] - x[0]);
    return sum;
  }
};

struct FlatPieces {
  std::array<FlatPiece, 2> piece;
  std::size_t size = 0;

  /// Adds the corners given if they turn one way, in counterclockwise order.
  void add(const std::array<Flat, 4>& x, std::array<std::uint8_t, 4> corners, std::size_t count) {
    FlatPiece& p = piece[size];
    p.size = count;
    for (std::size_t i = 0; i < count; ++i) p.x[i] = x[corners[i]];
    if (p.doubled_area() < 0) {
      std::reverse(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(count));
      for (std::size_t i = 0; i < count; ++i) p.x[i] = x[corners[i]];
    }
    p.corner = corners;
    size += p.doubled_area() > 0;
  }
};

/// Twice the area of the triangle at each corner of a quad: all of one sign where it is convex.
std::array<double, 4> turns(const std::array<Flat, 4>& x) {
  std::array<double, 4> turn{};
  for (std::size_t i = 0; i < 4; ++i) turn[i] = flat_cross(x[i] - x[(i + 3) % 4], x[(i + 1) % 4] - x[i]);
  return turn;
}

FlatPieces pieces_of(const std::array<Flat, 4>& x, bool triangle) {
  FlatPieces pieces;
  if (triangle) {
    pieces.add(x, {0, 1, 2, 2}, 3);
    return pieces;
  }
  const std::array<double, 4> turn = turns(x);
  const auto [least, most] = std::minmax_element(turn.begin(), turn.end());
  if (*least > 0 || *most < 0) {
    pieces.add(x, {0, 1, 2, 3}, 4);
    return pieces;
  }
  // The diagonal from the corner that turns the other way divides a concave quad.
  const bool positive = turn[0] + turn[1] + turn[2] + turn[3] > 0;
  const auto inward = static_cast<std::size_t>((positive ? least : most) - turn.begin());
  if (inward % 2 == 0) {
    pieces.add(x, {0, 1, 2, 2}, 3);
    pieces.add(x, {0, 2, 3, 3}, 3);
  } else {
    pieces.add(x, {1, 2, 3, 3}, 3);
    pieces.add(x, {1, 3, 0, 0}, 3);
  }
  return pieces;
}

/// The weights of a quad's corners at a place in it; nothing where the iteration does not settle.
std::optional<std::array<double, 4>> weights_in_quad(const FlatPiece& quad, const Flat& at) {
  const Flat middle = (quad.x[0] + quad.x[1] + quad.x[2] + quad.x[3]) / 4;
  const Flat along_s = (quad.x[1] + quad.x[2] - quad.x[0] - quad.x[3]) / 4;
  const Flat along_t = (quad.x[2] + quad.x[3] - quad.x[0] - quad.x[1]) / 4;
  const Flat twist = (quad.x[0] + quad.x[2] - quad.x[1] - quad.x[3]) / 4;
  constexpr int most_steps = 20;
  double s = 0, t = 0;
  for (int step = 0; step < most_steps; ++step) {
    const Flat rest = at - middle - s * along_s - t * along_t - s * t * twist;
    const Flat ds = along_s + t * twist, dt = along_t + s * twist;
    const double determinant = flat_cross(ds, dt);
    if (!(determinant > 0)) return std::nullopt;
    const double step_s = flat_cross(rest, dt) / determinant, step_t = flat_cross(ds, rest) / determinant;
    s += step_s;
    t += step_t;
    if (std::abs(step_s) + std::abs(step_t) < 1e-14) break;
  }
  // The place is in the quad, but for rounding.
  constexpr double outermost = 1 + 1e-6;
  if (!(std::abs(s) <= outermost) || !(std::abs(t) <= outermost)) return std::nullopt;
  return quad_weights(s, t);
}

/// The weights of the facet's corners at a place in one of its pieces.
std::optional<std::array<double, 4>> weights_at(const FlatPiece& piece, const Flat& at) {
  std::array<double, 4> of_facet{};
  if (piece.size == 4) {
    const auto weights = weights_in_quad(piece, at);
    if (!weights) return std::nullopt;
    for (std::size_t i = 0; i < 4; ++i) of_facet[piece.corner[i]] = (*weights)[i];
    return of_facet;
  }
  const double whole = piece.doubled_area();
  const double second = flat_cross(at - piece.x[0], piece.x[2] - piece.x[0]) / whole;
  const double third = flat_cross(piece.x[1] - piece.x[0], at - piece.x[0]) / whole;
  of_facet[piece.corner[0]] = 1 - second - third;
  of_facet[piece.corner[1]] = second;
  of_facet[piece.corner[2]] = third;
  return of_facet;
}

/// A polygon with at most the corners of two quads.
struct FlatPolygon {
  std::array<Flat, 8> x;
  std::size_t size = 0;
};

/// What of a polygon lies to the left of a line (Sutherland and Hodgman, Comm. ACM 17, 1974).
FlatPolygon left_of(const FlatPolygon& polygon, const Flat& from, const Flat& to) {
  FlatPolygon result;
  const auto side = [&](const Flat& x) { return flat_cross(to - from, x - from); };
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Flat &a = polygon.x[i], &b = polygon.x[(i + 1) % polygon.size];
    const double at_a = side(a), at_b = side(b);
    if (at_a >= 0 && result.size < 8) result.x[result.size++] = a;
    if ((at_a < 0) != (at_b < 0) && result.size < 8) result.x[result.size++] = a + at_a / (at_a - at_b) * (b - a);
  }
  return result;
}

FlatPolygon common_part(const FlatPiece& first, const FlatPiece& second) {
  FlatPolygon polygon;
  polygon.size = first.size;
  std::copy_n(first.x.begin(), first.size, polygon.x.begin());
  for (std::size_t i = 0; i < second.size && polygon.size > 2; ++i)
    polygon = left_of(polygon, second.x[i], second.x[(i + 1) % second.size]);
  return polygon;
}

struct TrianglePoint {
  std::array<double, 3> place;  ///< area coordinates
  double weight;                ///< sum 1
};

constexpr double inner = 0.445948490915965, outer = 0.091576213509771;
constexpr double inner_weight = 0.223381589678011, outer_weight = 0.109951743655322;
/// Dunavant's rule of degree 4.
constexpr std::array<TrianglePoint, 6> dunavant_rule{{{{1 - 2 * inner, inner, inner}, inner_weight},
                                                      {{inner, 1 - 2 * inner, inner}, inner_weight},
                                                      {{inner, inner, 1 - 2 * inner}, inner_weight},
                                                      {{1 - 2 * outer, outer, outer}, outer_weight},
                                                      {{outer, 1 - 2 * outer, outer}, outer_weight},
                                                      {{outer, outer, 1 - 2 * outer}, outer_weight}}};

Vector facet_point(const std::array<Vector, 4>& x, const std::array<double, 4>& w) {
  return w[0] * x[0] + w[1] * x[1] + w[2] * x[2] + w[3] * x[3];
}

/// Two facets with their projections.
struct FacetPair {
  const std::array<Vector, 4>&first, &second;
  std::array<Flat, 4> flat_first, flat_second;
  double least_area = 0;  ///< of a triangle that counts
};

/// Adds the points of one triangle of the polygon.
void add_triangle(const FacetPair& facets, const FlatPiece& first, const FlatPiece& second,
                  const std::array<Flat, 3>& corners, Overlap& overlap) {
  const double area = flat_cross(corners[1] - corners[0], corners[2] - corners[0]) / 2;
  if (!(area > facets.least_area)) return;
  for (const TrianglePoint& p : dunavant_rule) {
    const Flat at = p.place[0] * corners[0] + p.place[1] * corners[1] + p.place[2] * corners[2];
    const auto of_first = weights_at(first, at), of_second = weights_at(second, at);
    if (!of_first || !of_second) continue;
    const Vector way = facet_point(facets.second, *of_second) - facet_point(facets.first, *of_first);
    overlap.points.push_back({*of_first, *of_second, area * p.weight, overlap.normal.dot(way)});
    overlap.area += area * p.weight;
  }
}

void add_pieces(const FacetPair& facets, const FlatPiece& first, const FlatPiece& second, Overlap& overlap) {
  const FlatPolygon polygon = common_part(first, second);
  for (std::size_t i = 2; i < polygon.size; ++i)
    add_triangle(facets, first, second, {polygon.x[0], polygon.x[i - 1], polygon.x[i]}, overlap);
}

/// Whether two projections can have an area in common, by their boxes.
bool boxes_meet(const std::array<Flat, 4>& a, const std::array<Flat, 4>& b) {
  const auto low = [](const std::array<Flat, 4>& x) { return Flat(x[0].cwiseMin(x[1]).cwiseMin(x[2]).cwiseMin(x[3])); };
  const auto high = [](const std::array<Flat, 4>& x) {
    return Flat(x[0].cwiseMax(x[1]).cwiseMax(x[2]).cwiseMax(x[3]));
  };
  return (low(a).array() < high(b).array()).all() && (low(b).array() < high(a).array()).all();
}

}  // namespace

void find_overlap(const std::array<Vector, 4>& first, const std::array<Vector, 4>& second, Overlap& overlap) {
  overlap.points.clear();
  overlap.area = 0;
  overlap.normal = quad_normal(first).stableNormalized();
  Vector along = first[2] - first[0];
  if (along.squaredNorm() < (first[3] - first[1]).squaredNorm()) along = first[3] - first[1];
  along = (along - along.dot(overlap.normal) * overlap.normal).stableNormalized();
  const Vector across = overlap.normal.cross(along);
  // Facets side by side overlap by rounding.
  constexpr double least_share = 1e-12;
  FacetPair facets{first, second, {}, {}, least_share * quad_normal(first).norm() / 2};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector a = first[i] - first[0], b = second[i] - first[0];
    facets.flat_first[i] = {a.dot(along), a.dot(across)};
    facets.flat_second[i] = {b.dot(along), b.dot(across)};
  }
  if (!boxes_meet(facets.flat_first, facets.flat_second)) return;
  const FlatPieces of_first = pieces_of(facets.flat_first, first[2] == first[3]);
  const FlatPieces of_second = pieces_of(facets.flat_second, second[2] == second[3]);
  for (std::size_t i = 0; i < of_first.size; ++i)
    for (std::size_t k = 0; k < of_second.size; ++k) add_pieces(facets, of_first.piece[i], of_second.piece[k], overlap);
}

}  // namespace gapcheck::solver
