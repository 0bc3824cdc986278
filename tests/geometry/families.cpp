#include "families.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace gapcheck::geometry::test {

std::string_view name(Family family) {
  static constexpr std::string_view names[] = {"lattice",    "flat",      "warped",   "skew",    "sliver",
                                               "degenerate", "on_border", "far_away", "any_size"};
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
