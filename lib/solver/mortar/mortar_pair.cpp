#include "solver/mortar/mortar_pair.hpp"

#include <algorithm>
#include <cmath>

#include "base/quad.hpp"

namespace gapcheck::solver {
namespace {

/// Faces whose normals are farther from opposite than 60 degrees do not see each other: their projections are slivers.
constexpr double least_cosine = 0.5;

/// Sign of the tracked face's normal towards the other face by their fronts; 0: neither has one; nothing: they do not
/// look at each other.
std::optional<double> sign_by_front(const MortarFace& tracked, const MortarFace& other, double cosine) {
  if (!(std::abs(cosine) >= least_cosine)) return std::nullopt;
  if (tracked.oriented && other.oriented && cosine > 0) return std::nullopt;
  if (tracked.oriented) return 1;
  if (other.oriented) return cosine > 0 ? -1 : 1;
  return 0;
}

}  // namespace

Vector MortarTouch::velocity(std::size_t side, const State& state) const {
  Vector sum = point[side].of(state.v);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector& arm = offset[side][i];
    if (arm != Vector::Zero()) sum += point[side].weights[i] * state.w[point[side].nodes[i].value].cross(arm);
  }
  return sum;
}

void sight_pair(const MortarSurface& surface, const std::vector<Vector>& x, MortarPair& pair, double release,
                MortarSight& sight) {
  const MortarFace &tracked = surface[pair.tracked], &other = surface[pair.other];
  const std::array<Vector, 4> first = MortarSurface::corners(tracked, x), second = MortarSurface::corners(other, x);
  pair.deepest = 0;
  pair.released = false;
  sight.faces = false;
  const double cosine = quad_normal(first).stableNormalized().dot(quad_normal(second).stableNormalized());
  const std::optional<double> sign = sign_by_front(tracked, other, cosine);
  if (!sign) return;
  find_overlap(first, second, sight.overlap);
  if (sight.overlap.points.empty()) return;
  sight.faces = true;
  const double h = tracked.half + other.half;
  sight.sign = *sign;
  if (sight.sign == 0) {
    double mean = 0, nearest = std::abs(sight.overlap.points.front().distance);
    for (const OverlapPoint& p : sight.overlap.points) {
      mean += p.area * p.distance;
      nearest = std::min(nearest, std::abs(p.distance));
    }
    if (pair.side == 0 || nearest >= h) pair.side = mean < 0 ? -1 : 1;
    sight.sign = pair.side;
  }
  for (const OverlapPoint& p : sight.overlap.points) {
    const double depth = h - sight.sign * p.distance;
    if (depth > release)
      pair.released = true;
    else
      pair.deepest = std::max(pair.deepest, depth);
  }
}

MortarPush integrate_pressure(const MortarSight& sight, const MortarLaw& law, double distance, double forgiven,
                              double release) {
  MortarPush sum;
  for (const OverlapPoint& p : sight.overlap.points) {
    const double whole = distance - sight.sign * p.distance, depth = whole - forgiven;
    if (!(depth > 0) || whole > release) continue;
    const double push = law.pressure(depth) * p.area;
    sum.push += push;
    sum.area += p.area;
    sum.stored += law.energy(depth) * p.area;
    sum.deepest = std::max(sum.deepest, depth);
    for (std::size_t i = 0; i < 4; ++i) {
      sum.tracked[i] += push * p.first[i];
      sum.other[i] += push * p.second[i];
    }
  }
  if (!(sum.push > 0)) return sum;
  for (std::size_t i = 0; i < 4; ++i) {
    sum.tracked[i] /= sum.push;
    sum.other[i] /= sum.push;
  }
  return sum;
}

}  // namespace gapcheck::solver
