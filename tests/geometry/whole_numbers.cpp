#include "whole_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace gapcheck::geometry::test {
namespace {

struct Whole {
  mpz_class x, y, z;
  friend Whole operator-(const Whole& a, const Whole& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Whole operator+(const Whole& a, const Whole& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend mpz_class operator*(const Whole& a, const Whole& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
};
Whole cross(const Whole& a, const Whole& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// x = mantissa · 2^exponent with an odd mantissa, or 0.
struct Binary {
  std::int64_t mantissa = 0;
  int exponent = std::numeric_limits<int>::max();
  explicit Binary(double x) {
    if (x == 0) return;
    const double fraction = std::frexp(x, &exponent);
    mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    exponent -= 53;
    for (; mantissa % 2 == 0; mantissa /= 2) ++exponent;
  }
  [[nodiscard]] mpz_class times_power(int unit) const {
    mpz_class value(mantissa);
    if (mantissa != 0) value <<= static_cast<mp_bitcnt_t>(exponent - unit);
    return value;
  }
};

/// The corners less the query, in whole multiples of 2^exponent.
struct Seen {
  std::array<Whole, 4> corner;
  int exponent = 0;
  Seen(const Facet& facet, const Vector& query) {
    exponent = std::numeric_limits<int>::max();
    const auto look = [&](const Vector& v) {
      for (int k = 0; k < 3; ++k) exponent = std::min(exponent, Binary(v[k]).exponent);
    };
    look(query);
    for (const Vector& x : facet.x) look(x);
    const auto whole = [&](const Vector& v) {
      const auto at = [&](int k) { return Binary(v[k]).times_power(exponent); };
      return Whole{at(0), at(1), at(2)};
    };
    const Whole q = whole(query);
    for (std::size_t i = 0; i < 4; ++i) corner[i] = whole(facet.x[i]) - q;
  }
};

SquaredDistance lesser(SquaredDistance a, SquaredDistance b) {
  return a.numerator * b.denominator <= b.numerator * a.denominator ? std::move(a) : std::move(b);
}

SquaredDistance of_segment(const Whole& a, const Whole& b) {
  const Whole along = b - a;
  const mpz_class length = along * along, towards = -(a * along);
  if (towards <= 0) return {a * a};
  if (towards >= length) return {b * b};
  return {mpz_class((a * a) * length - towards * towards), length};
}

SquaredDistance of_triangle(const Whole& a, const Whole& b, const Whole& c) {
  const Whole u = b - a, v = c - a;
  const mpz_class uu = u * u, uv = u * v, vv = v * v, au = a * u, av = a * v;
  const mpz_class area = uu * vv - uv * uv, l = uv * av - vv * au, m = uv * au - uu * av;
  if (area > 0 && l >= 0 && m >= 0 && l + m <= area) return {mpz_class((a * a) * area + l * au + m * av), area};
  return lesser(of_segment(a, b), lesser(of_segment(b, c), of_segment(c, a)));
}

bool flat_and_turning_one_way(const std::array<Whole, 4>& p) {
  std::array<Whole, 4> turn;
  for (std::size_t i = 0; i < 4; ++i) turn[i] = cross(p[(i + 1) % 4] - p[i], p[(i + 2) % 4] - p[(i + 1) % 4]);
  if (turn[0] * (p[3] - p[0]) != 0 || turn[1] * (p[0] - p[1]) != 0 || turn[2] * (p[1] - p[2]) != 0) return false;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (turn[i] * turn[j] < 0) return false;
  return true;
}

/// A piece of a patch, its corners in multiples of 2^(exponent - cuts).
struct Piece {
  std::array<Whole, 4> corner;
  int cuts = 0;
  double nearness = 0;  ///< binary logarithm of the middle's squared distance, roughly: which piece comes first
  bool operator<(const Piece& other) const { return nearness > other.nearness; }
};

Whole four_middles(const Piece& p) { return p.corner[0] + p.corner[1] + p.corner[2] + p.corner[3]; }

double logarithm(const mpz_class& value) {
  signed long exponent = 0;
  const double fraction = mpz_get_d_2exp(&exponent, value.get_mpz_t());
  return std::log2(fraction) + static_cast<double>(exponent);
}

Whole twice(const Whole& a) { return a + a; }

/// Halves along the longer side.
std::array<Piece, 2> halves(const Piece& p) {
  const auto& e = p.corner;
  const Whole across = e[1] - e[0], other = e[2] - e[3], up = e[3] - e[0], up_other = e[2] - e[1];
  std::array<Piece, 2> half;
  if (across * across + other * other >= up * up + up_other * up_other) {
    const Whole low = e[0] + e[1], high = e[3] + e[2];
    half[0].corner = {twice(e[0]), low, high, twice(e[3])};
    half[1].corner = {low, twice(e[1]), twice(e[2]), high};
  } else {
    const Whole left = e[0] + e[3], right = e[1] + e[2];
    half[0].corner = {twice(e[0]), twice(e[1]), right, left};
    half[1].corner = {left, right, twice(e[2]), twice(e[3])};
  }
  for (Piece& h : half) {
    h.cuts = p.cuts + 1;
    const Whole middle = four_middles(h);
    h.nearness = logarithm(mpz_class(middle * middle)) - 2 * h.cuts;
  }
  return half;
}

/// A bound's square in the units of a piece: value · 4^shift.
class SquaredBound {
 public:
  SquaredBound(double bound, int exponent) : exponent_(exponent) {
    const Binary b(bound);
    square_ = mpz_class(b.mantissa) * b.mantissa;
    bound_exponent_ = b.exponent;
  }
  /// value < bound² · factor, where `value` counts in squares of 2^(exponent - cuts).
  [[nodiscard]] bool exceeds(const mpz_class& value, const mpz_class& factor, int cuts) const {
    const int shift = 2 * (bound_exponent_ - exponent_ + cuts);
    if (shift >= 0) return value < mpz_class((square_ * factor) << static_cast<mp_bitcnt_t>(shift));
    return mpz_class(value << static_cast<mp_bitcnt_t>(-shift)) < square_ * factor;
  }

 private:
  mpz_class square_;
  int exponent_, bound_exponent_;
};

bool kept_apart(const Piece& p, const Whole& direction, const SquaredBound& bound) {
  const mpz_class length = direction * direction;
  return length > 0 && std::all_of(p.corner.begin(), p.corner.end(), [&](const Whole& e) {
           const mpz_class height = direction * e;
           return height >= 0 && !bound.exceeds(mpz_class(height * height), length, p.cuts);
         });
}

}  // namespace

std::optional<SquaredDistance> whole_squared_distance(const Facet& facet, const Vector& query) {
  const Seen seen(facet, query);
  const auto& e = seen.corner;
  SquaredDistance square;
  if (facet.triangle) {
    square = of_triangle(e[0], e[1], e[2]);
  } else {
    if (!flat_and_turning_one_way(e)) return std::nullopt;
    square = lesser(of_triangle(e[0], e[1], e[2]), of_triangle(e[0], e[2], e[3]));
  }
  square.exponent = seen.exponent;
  return square;
}

bool less(const SquaredDistance& distance, double bound) {
  return SquaredBound(bound, static_cast<int>(distance.exponent)).exceeds(distance.numerator, distance.denominator, 0);
}

std::optional<bool> closer_by_halving(const Facet& facet, const Vector& query, double bound, int pieces) {
  const Seen seen(facet, query);
  const SquaredBound limit(bound, seen.exponent);
  std::priority_queue<Piece> open;
  open.push({seen.corner, 0, 0});
  for (; pieces > 0 && !open.empty(); --pieces) {
    const Piece piece = open.top();
    open.pop();
    const Whole middle = four_middles(piece);
    if (limit.exceeds(mpz_class(middle * middle), 16, piece.cuts)) return true;
    for (const Whole& e : piece.corner)
      if (limit.exceeds(mpz_class(e * e), 1, piece.cuts)) return true;
    if (kept_apart(piece, middle, limit)) continue;
    for (Piece& half : halves(piece)) open.push(std::move(half));
  }
  if (open.empty()) return false;
  return std::nullopt;
}

}  // namespace gapcheck::geometry::test
