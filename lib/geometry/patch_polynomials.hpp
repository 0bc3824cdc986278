#pragma once
#include <algorithm>
#include <array>
#include <limits>

#include "geometry/closest_point.hpp"
#include "geometry/patch.hpp"

/// The squared distance of a patch from the query and its slopes as polynomials, for pieces.cpp.
namespace gapcheck::geometry::precise {
namespace {

/// Coefficients in Bernstein form, over the patch or a piece of it: of the squared distance, and of half its
/// derivatives, all as [power of s][power of t].
struct Coefficients {
  std::array<std::array<double, 3>, 3> square;
  std::array<std::array<double, 3>, 2> by_s;
  std::array<std::array<double, 2>, 3> by_t;
};

/// The sides of a quad as differences of its own corners: their errors are relative to themselves.
struct Sides {
  Vector low, high, left, right;
  explicit Sides(const Facet& quad)
      : low(quad.x[1] - quad.x[0]),
        high(quad.x[2] - quad.x[3]),
        left(quad.x[3] - quad.x[0]),
        right(quad.x[2] - quad.x[1]) {}
};

inline Coefficients coefficients(const Corners& e, const Sides& d) {
  const auto mean = [](double a, double b) { return 0.5 * (a + b); };
  Coefficients k;
  k.square = {{{e[0].squaredNorm(), e[0].dot(e[3]), e[3].squaredNorm()},
               {e[0].dot(e[1]), mean(e[0].dot(e[2]), e[1].dot(e[3])), e[3].dot(e[2])},
               {e[1].squaredNorm(), e[1].dot(e[2]), e[2].squaredNorm()}}};
  k.by_s = {{{e[0].dot(d.low), mean(e[0].dot(d.high), e[3].dot(d.low)), e[3].dot(d.high)},
             {e[1].dot(d.low), mean(e[1].dot(d.high), e[2].dot(d.low)), e[2].dot(d.high)}}};
  k.by_t = {{{e[0].dot(d.left), e[3].dot(d.left)},
             {mean(e[0].dot(d.right), e[1].dot(d.left)), mean(e[3].dot(d.right), e[2].dot(d.left))},
             {e[1].dot(d.right), e[2].dot(d.right)}}};
  return k;
}

/// What the coefficients must exceed. Their errors, halvings included, are below 512 roundoffs of their size.
struct Margins {
  double nearer, farther, by_s, by_t;

  Margins(double size, double bound, const Sides& d) {
    const double error = 512 * roundoff * size;
    nearer = bound * bound * (1 - 8 * roundoff) - error * size;
    farther = bound * bound * (1 + 8 * roundoff) + error * size;
    by_s = error * std::max(d.low.lpNorm<1>(), d.high.lpNorm<1>()) + 1e-290;
    by_t = error * std::max(d.left.lpNorm<1>(), d.right.lpNorm<1>()) + 1e-290;
  }
};

template <class Table>
double least(const Table& k) {
  double out = std::numeric_limits<double>::infinity();
  for (const auto& row : k)
    for (const double value : row) out = std::min(out, value);
  return out;
}
template <class Table>
double greatest(const Table& k) {
  double out = -std::numeric_limits<double>::infinity();
  for (const auto& row : k)
    for (const double value : row) out = std::max(out, value);
  return out;
}
/// The derivative is nowhere zero.
template <class Table>
bool never_zero(const Table& k, double margin) {
  return least(k) > margin || greatest(k) < -margin;
}

/// A direction across the patch, r_t - g(s) r_s or r_s - g(t) r_t with a linear g: chosen at right angles to the mean
/// of the other sides, since along a sliver both slopes are zero nearly at the same places.
struct Across {
  double first, last, margin;  ///< g at the ends of its range
  Across(const Vector& side_first, const Vector& side_last, const Vector& other, double own_margin,
         double other_margin) {
    const double square = other.squaredNorm();
    first = side_first.dot(other) / square;
    last = side_last.dot(other) / square;
    margin = 2 * (own_margin + std::max(std::abs(first), std::abs(last)) * other_margin);
  }
  /// The slope across is nowhere zero on a piece, where g goes from `from` to `to`. `own` and `other`: coefficients of
  /// the slopes along both parameters, [power of the parameter of g][power of the other].
  template <class Own, class Other>
  [[nodiscard]] bool never_zero(double from, double to, const Own& own, const Other& other) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto raised = [&](std::size_t i) {
        return j == 0 ? own(i, 0) : j == 2 ? own(i, 1) : 0.5 * (own(i, 0) + own(i, 1));
      };
      const double slopes[] = {raised(0) - from * other(0, j),
                               raised(1) - 0.5 * (from * other(1, j) + to * other(0, j)), raised(2) - to * other(1, j)};
      for (const double slope : slopes) {
        low = std::min(low, slope);
        high = std::max(high, slope);
      }
    }
    return low > margin || high < -margin;
  }
};

/// A part of the patch, its parameters in [-1, 1].
struct Piece {
  Coefficients k;
  double s0 = -1, s1 = 1, t0 = -1, t1 = 1;
  int depth = 0;
};

/// The halves of a piece, cut at a value of s.
inline void cut_s(const Piece& piece, Piece& first, Piece& last) {
  first = last = piece;
  ++first.depth, ++last.depth;
  first.s1 = last.s0 = 0.5 * (piece.s0 + piece.s1);
  const auto cut = [](const auto& k, auto& low, auto& high, std::size_t j) {
    const double before = 0.5 * (k[0][j] + k[1][j]), after = 0.5 * (k[1][j] + k[2][j]);
    low[1][j] = before;
    high[1][j] = after;
    low[2][j] = high[0][j] = 0.5 * (before + after);
  };
  for (std::size_t j = 0; j < 3; ++j) cut(piece.k.square, first.k.square, last.k.square, j);
  for (std::size_t j = 0; j < 2; ++j) cut(piece.k.by_t, first.k.by_t, last.k.by_t, j);
  for (std::size_t j = 0; j < 3; ++j)
    first.k.by_s[1][j] = last.k.by_s[0][j] = 0.5 * (piece.k.by_s[0][j] + piece.k.by_s[1][j]);
}

/// The same at a value of t.
inline void cut_t(const Piece& piece, Piece& first, Piece& last) {
  first = last = piece;
  ++first.depth, ++last.depth;
  first.t1 = last.t0 = 0.5 * (piece.t0 + piece.t1);
  const auto cut = [](const auto& k, auto& low, auto& high) {
    const double before = 0.5 * (k[0] + k[1]), after = 0.5 * (k[1] + k[2]);
    low[1] = before;
    high[1] = after;
    low[2] = high[0] = 0.5 * (before + after);
  };
  for (std::size_t i = 0; i < 3; ++i) cut(piece.k.square[i], first.k.square[i], last.k.square[i]);
  for (std::size_t i = 0; i < 2; ++i) cut(piece.k.by_s[i], first.k.by_s[i], last.k.by_s[i]);
  for (std::size_t i = 0; i < 3; ++i)
    first.k.by_t[i][1] = last.k.by_t[i][0] = 0.5 * (piece.k.by_t[i][0] + piece.k.by_t[i][1]);
}

}  // namespace
}  // namespace gapcheck::geometry::precise
