#pragma once
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

#include "geometry/closest_point.hpp"

namespace gapcheck::geometry::test {

/// A facet and a point, made by one of the families below.
struct Pair {
  Facet facet;
  Vector query = Vector::Zero();
  double distance = 0;  ///< where it is a double without rounding, by construction; else 0
};

enum class Family : std::uint8_t {
  lattice,     ///< small integers: flat, axis-aligned, many exact ties
  flat,        ///< rotated rectangles, trapezoids, plain triangles
  warped,      ///< quads warped by 1 to 40 degrees
  skew,        ///< four random points: folded, non-convex, strongly warped
  sliver,      ///< one side 1e-3 to 1e-9 of the other
  degenerate,  ///< repeated corners, collapsed edges, no area
  on_border,   ///< the query lies on or straight above an edge or corner
  far_away,    ///< offsets of 1e3 to 1e9
  any_size,    ///< sizes of 1e-6 to 1e6
  oblique,     ///< quads in oblique planes, flat to the last bit
  on_bound,    ///< the distance is a double without rounding: above a face, an edge, a corner, a saddle
  on_surface,  ///< the query lies on the facet, or beside it by rounding
};
inline constexpr Family all_families[] = {Family::lattice,   Family::flat,     Family::warped,
                                          Family::skew,      Family::sliver,   Family::degenerate,
                                          Family::on_border, Family::far_away, Family::any_size};
/// Ties, and distances of the size of rounding.
inline constexpr Family tied_families[] = {Family::oblique, Family::on_bound, Family::on_surface};
[[nodiscard]] std::string_view name(Family family);

/// Reproducible random pairs.
class Maker {
 public:
  explicit Maker(std::uint64_t seed) : random_(seed) {}
  [[nodiscard]] Pair make(Family family);
  [[nodiscard]] double uniform(double low, double high);
  [[nodiscard]] int integer(int low, int high);
  [[nodiscard]] double power_of_ten(double low, double high);
  [[nodiscard]] Vector point(double reach);
  /// A quad near the unit square, warped by `low` to `high` degrees: the angle between the two triangles of a diagonal.
  [[nodiscard]] Pair warped(double low, double high);

 private:
  Pair lattice();
  Pair flat();
  Pair degenerate();
  Pair on_border();
  Pair oblique();
  Pair on_bound();
  Pair on_surface();
  void rotate(Pair& pair);
  std::mt19937_64 random_;
};

/// For failure messages: all digits.
[[nodiscard]] std::string describe(const Pair& pair, double bound = 0);

/// Corner i becomes corner 0 (quads).
[[nodiscard]] Facet rotated(const Facet& facet, std::size_t i);
/// The same facet with its corners in the opposite order.
[[nodiscard]] Facet reversed(const Facet& facet);

}  // namespace gapcheck::geometry::test
