#include "families.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace gapcheck::geometry::test {

std::string_view name(Family family) {
  static constexpr std::string_view names[] = {"lattice",  "flat",       "warped",    "skew",
                                               "sliver",   "degenerate", "on_border", "far_away",
                                               "any_size", "oblique",    "on_bound",  "on_surface"};
  return names[static_cast<std::size_t>(family)];
}

double Maker::uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
int Maker::integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
double Maker::power_of_ten(double low, double high) { return std::pow(10.0, uniform(low, high)); }
Vector Maker::point(double reach) { return {uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)}; }

void Maker::rotate(Pair& pair) {
  const Eigen::AngleAxisd turn(uniform(0, 2 * std::numbers::pi), point(1).normalized());
  for (Vector& x : pair.facet.x) x = turn * x;
  pair.query = turn * pair.query;
}

Pair Maker::lattice() {
  Pair pair;
  const double w = integer(1, 6), h = integer(1, 6), shift = integer(-2, 2);
  pair.facet.x = {Vector(0, 0, 0), Vector(w, 0, 0), Vector(w + shift, h, 0), Vector(shift, h, 0)};
  if (integer(0, 3) == 0) pair.facet.x[2].z() = integer(-1, 1);
  if (integer(0, 2) == 0) {
    pair.facet.triangle = true;
    pair.facet.x[3] = pair.facet.x[2];
  }
  pair.query = Vector(integer(-6, 12), integer(-6, 12), integer(-6, 6));
  return pair;
}

Pair Maker::flat() {
  Pair pair;
  const double w = uniform(0.5, 2), h = uniform(0.5, 2);
  pair.facet.x = {Vector(0, 0, 0), Vector(w, 0, 0), Vector(w + uniform(-0.2, 0.2), h, 0),
                  Vector(uniform(-0.2, 0.2), h, 0)};
  if (integer(0, 2) == 0) {
    pair.facet.triangle = true;
    pair.facet.x[3] = pair.facet.x[2];
  }
  pair.query = Vector(uniform(-1, 3), uniform(-1, 3), uniform(-1, 1));
  rotate(pair);
  return pair;
}

Pair Maker::warped(double low, double high) {
  Pair pair;
  const double lift = std::tan(uniform(low, high) * std::numbers::pi / 360) / (2 * std::numbers::sqrt2);
  pair.facet.x = {Vector(0, 0, lift), Vector(1, 0, -lift), Vector(1, 1, lift), Vector(0, 1, -lift)};
  for (Vector& x : pair.facet.x) {
    x.x() += uniform(-0.15, 0.15);
    x.y() += uniform(-0.15, 0.15);
  }
  pair.query = Vector(uniform(-1, 2), uniform(-1, 2), uniform(-1.5, 1.5));
  rotate(pair);
  return pair;
}

Pair Maker::degenerate() {
  Pair pair;
  for (Vector& x : pair.facet.x) x = Vector(integer(-2, 2), integer(-2, 2), integer(-2, 2));
  auto& x = pair.facet.x;
  switch (integer(0, 7)) {
    case 0:
      x[1] = x[0];
      break;
    case 1:
      x[3] = x[0];
      break;
    case 2:
      x[3] = x[2] = x[1] = x[0];
      break;
    case 3:
      x[1] = x[0], x[3] = x[2];
      break;
    case 4:
      x[2] = x[0];
      break;
    case 5:
      x[2] = x[0] + 2 * (x[1] - x[0]), x[3] = x[0] + integer(-1, 3) * (x[1] - x[0]);
      break;
    case 6:
      x[3] = x[2];
      break;
    default:
      x[2] = 0.5 * (x[1] + x[3]);
      break;
  }
  pair.facet.triangle = integer(0, 2) == 0;
  if (pair.facet.triangle) x[3] = x[2];
  pair.query = integer(0, 1) == 0 ? point(3) : Vector(integer(-3, 3), integer(-3, 3), integer(-3, 3));
  return pair;
}

Pair Maker::on_border() {
  Pair pair = integer(0, 1) == 0 ? flat() : lattice();
  const std::size_t i = static_cast<std::size_t>(integer(0, 3));
  const double ratio = integer(0, 8) / 8.0;
  const Vector up = (pair.facet.x[1] - pair.facet.x[0]).cross(pair.facet.x[2] - pair.facet.x[0]);
  pair.query = pair.facet.x[i] + ratio * (pair.facet.x[(i + 1) % 4] - pair.facet.x[i]) + integer(-2, 2) * 0.5 * up;
  return pair;
}

/// Whole numbers below 2^40 times a power of two: all of them are doubles.
Pair Maker::oblique() {
  const auto whole = [&](int reach) {
    return Vector(integer(-reach, reach), integer(-reach, reach), integer(-reach, reach));
  };
  constexpr int span = 1 << 20, slant = 1 << 12;
  Pair pair;
  const Vector origin = whole(1 << 30), u = whole(slant), v = whole(slant);
  const int low = integer(0, span), high = integer(0, span);
  const std::array<std::array<int, 2>, 4> at{
      {{0, 0}, {span, low}, {span - integer(0, span / 4), span + low}, {integer(0, span / 4), high + 1}}};
  for (std::size_t i = 0; i < 4; ++i) pair.facet.x[i] = origin + at[i][0] * u + at[i][1] * v;
  pair.query = origin + integer(-span, 2 * span) * u + integer(-span, 2 * span) * v;
  if (integer(0, 3) != 0) pair.query += integer(1, span) * u.cross(v) / slant;
  const double factor = std::ldexp(1.0, integer(-60, 20));
  for (Vector& x : pair.facet.x) x *= factor;
  pair.query *= factor;
  return pair;
}

namespace {

/// A rotation times `length`, both in whole numbers: the quaternion (a, b, c, d).
struct WholeTurn {
  Eigen::Matrix3d matrix;
  double length;
  WholeTurn(double a, double b, double c, double d) : length(a * a + b * b + c * c + d * d) {
    matrix << a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c),  //
        2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b),        //
        2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d;
  }
};

}  // namespace

/// A facet around (0,0,0) to (8,8,0), above it, or beside it by the sides of right-angled triangles and boxes.
Pair Maker::on_bound() {
  Pair pair;
  auto& x = pair.facet.x;
  x = {Vector(0, 0, 0), Vector(8, 0, 0), Vector(8, 8, 0), Vector(0, 8, 0)};
  static constexpr std::array<std::array<double, 3>, 4> beside{{{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {20, 21, 29}}};
  static constexpr std::array<std::array<double, 4>, 4> off{{{1, 2, 2, 3}, {2, 3, 6, 7}, {4, 4, 7, 9}, {6, 6, 7, 11}}};
  const std::size_t which = static_cast<std::size_t>(integer(0, 3));
  switch (integer(0, 3)) {
    case 0:
      pair.distance = std::ldexp(integer(1, 1 << 20), -integer(0, 20));
      pair.query = Vector(integer(1, 7), integer(1, 7), pair.distance);
      break;
    case 1:
      pair.distance = beside[which][2];
      pair.query = Vector(8 + beside[which][0], integer(0, 8), beside[which][1]);
      break;
    case 2:
      pair.distance = off[which][3];
      pair.query = Vector(8 + off[which][0], 8 + off[which][1], off[which][2]);
      break;
    default: {
      // z = c s t over the square, seen from above its centre: nearest there up to the height 1/c.
      const double rise = std::ldexp(1.0, integer(-4, 2));
      for (std::size_t i = 0; i < 4; ++i) x[i].z() = i % 2 == 0 ? rise : -rise;
      pair.distance = std::min(16 / rise, 1024.0) * integer(1, 1 << 10) / (1 << 10);
      pair.query = Vector(4, 4, pair.distance);
      break;
    }
  }
  if (x[0].z() == 0 && integer(0, 2) == 0) {
    // The half of the square in which the nearest point lies.
    pair.facet.triangle = true;
    if (pair.query.x() < pair.query.y()) x[1] = x[3];
    x[3] = x[2];
  }
  const WholeTurn turn(integer(0, 5), integer(-5, 5), integer(-5, 5), integer(1, 5));
  const Vector offset(integer(-1000, 1000), integer(-1000, 1000), integer(-1000, 1000));
  const double factor = std::ldexp(1.0, integer(-30, 30));
  for (Vector& corner : x) corner = factor * (turn.matrix * corner + offset);
  pair.query = factor * (turn.matrix * pair.query + offset);
  pair.distance *= factor * turn.length;
  return pair;
}

Pair Maker::on_surface() {
  Pair pair = integer(0, 2) == 0 ? lattice() : integer(0, 1) == 0 ? flat() : warped(1, 40);
  const auto& x = pair.facet.x;
  const double s = integer(0, 16) / 16.0, t = pair.facet.triangle ? 0 : integer(0, 16) / 16.0;
  pair.query = (1 - s) * (1 - t) * x[0] + s * (1 - t) * x[1] + s * t * x[2] + (1 - s) * t * x[3];
  if (integer(0, 3) == 0) pair.query += std::ldexp(1.0, -integer(40, 1000)) * point(1);
  return pair;
}

Pair Maker::make(Family family) {
  Pair pair;
  switch (family) {
    case Family::lattice:
      return lattice();
    case Family::flat:
      return flat();
    case Family::warped:
      return warped(1, 40);
    case Family::skew:
      for (Vector& x : pair.facet.x) x = point(1);
      pair.query = point(1.5);
      return pair;
    case Family::sliver: {
      pair = integer(0, 1) == 0 ? flat() : warped(1, 20);
      const Vector long_side = (pair.facet.x[1] - pair.facet.x[0]).normalized();
      const double ratio = power_of_ten(-9, -3);
      for (Vector& x : pair.facet.x) x = ratio * x + (1 - ratio) * x.dot(long_side) * long_side;
      pair.query *= integer(0, 1) == 0 ? 1.0 : ratio;
      return pair;
    }
    case Family::degenerate:
      return degenerate();
    case Family::on_border:
      return on_border();
    case Family::far_away: {
      pair = integer(0, 1) == 0 ? flat() : warped(1, 40);
      const Vector offset = power_of_ten(3, 9) * point(1);
      for (Vector& x : pair.facet.x) x += offset;
      pair.query += offset;
      if (pair.facet.triangle) pair.facet.x[3] = pair.facet.x[2];
      return pair;
    }
    case Family::any_size: {
      pair = integer(0, 1) == 0 ? flat() : warped(1, 40);
      const double size = power_of_ten(-6, 6);
      for (Vector& x : pair.facet.x) x *= size;
      pair.query *= integer(0, 3) == 0 ? size * power_of_ten(-3, 3) : size;
      return pair;
    }
    case Family::oblique:
      return oblique();
    case Family::on_bound:
      return on_bound();
    case Family::on_surface:
      return on_surface();
  }
  return pair;
}

std::string describe(const Pair& pair, double bound) {
  const auto text = [](const Vector& x) { return fmt::format("{{{:a}, {:a}, {:a}}}", x.x(), x.y(), x.z()); };
  const auto& x = pair.facet.x;
  return fmt::format("{} {} {} {} triangle {} query {} bound {:a}", text(x[0]), text(x[1]), text(x[2]), text(x[3]),
                     pair.facet.triangle, text(pair.query), bound);
}

Facet rotated(const Facet& facet, std::size_t i) {
  Facet out;
  out.triangle = facet.triangle;
  if (facet.triangle) {
    for (std::size_t k = 0; k < 3; ++k) out.x[k] = facet.x[(i + k) % 3];
    out.x[3] = out.x[2];
  } else {
    for (std::size_t k = 0; k < 4; ++k) out.x[k] = facet.x[(i + k) % 4];
  }
  return out;
}

Facet reversed(const Facet& facet) {
  if (facet.triangle) return {{facet.x[2], facet.x[1], facet.x[0], facet.x[0]}, true};
  return {{facet.x[3], facet.x[2], facet.x[1], facet.x[0]}, false};
}

}  // namespace gapcheck::geometry::test
