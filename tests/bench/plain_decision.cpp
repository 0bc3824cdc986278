#include "plain_decision.hpp"

#include <algorithm>
#include <cmath>

#include "plain_kernel.hpp"

namespace gapcheck::bench {

void plain_four(geometry::PairArrays& pairs, bool triangles);
void plain_eight(geometry::PairArrays& pairs, bool triangles);

namespace {

struct Edge {
  Vector from, along;
};

double squared_distance(const Edge& edge) {
  const double length = edge.along.squaredNorm();
  const double ratio = length > 0 ? std::clamp(-edge.from.dot(edge.along) / length, 0.0, 1.0) : 0;
  return (edge.from + ratio * edge.along).squaredNorm();
}

/// Voronoi regions of the corners and edges, then the face.
double of_triangle(const Vector& a, const Vector& b, const Vector& c) {
  const Vector ab = b - a, ac = c - a;
  const double d1 = -ab.dot(a), d2 = -ac.dot(a);
  if (d1 <= 0 && d2 <= 0) return a.squaredNorm();
  const double d3 = -ab.dot(b), d4 = -ac.dot(b);
  if (d3 >= 0 && d4 <= d3) return b.squaredNorm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (a + d1 / (d1 - d3) * ab).squaredNorm();
  const double d5 = -ab.dot(c), d6 = -ac.dot(c);
  if (d6 >= 0 && d5 <= d6) return c.squaredNorm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (a + d2 / (d2 - d6) * ac).squaredNorm();
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return (b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)).squaredNorm();
  const double unit = 1 / (va + vb + vc);
  return (a + vb * unit * ab + vc * unit * ac).squaredNorm();
}

/// The projection on the patch continued beyond its edges, then the edges that it lies beyond.
double of_quad(const geometry::Corners& e) {
  const geometry::Patch p(e);
  const double aa = p.a.squaredNorm(), ab = p.a.dot(p.b), bb = p.b.squaredNorm(), ma = p.m.dot(p.a), mb = p.m.dot(p.b);
  const double unit = 1 / (aa * bb - ab * ab);
  double s = std::clamp((ab * mb - bb * ma) * unit, -2.0, 2.0), t = std::clamp((ab * ma - aa * mb) * unit, -2.0, 2.0);
  Vector r;
  for (int step = 0; step < 8; ++step) {
    const Vector rs = p.along_s(t), rt = p.along_t(s);
    r = p.m + t * p.b + s * rs;
    const double gs = r.dot(rs), gt = r.dot(rt), ss = rs.squaredNorm(), tt = rt.squaredNorm();
    const double st = rs.dot(rt) + r.dot(p.c), det = ss * tt - st * st;
    if (!(det > 1e-9 * ss * tt)) break;
    const double ds = (st * gt - tt * gs) / det, dt = (st * gs - ss * gt) / det;
    s += ds;
    t += dt;
    if (std::abs(ds) + std::abs(dt) <= 1e-7) break;
  }
  if (std::abs(s) < 1 && std::abs(t) < 1) return (p.m + t * p.b + s * p.along_s(t)).squaredNorm();
  double best = std::numeric_limits<double>::infinity();
  if (!(t > -1)) best = std::min(best, squared_distance({e[0], e[1] - e[0]}));
  if (!(s < 1)) best = std::min(best, squared_distance({e[1], e[2] - e[1]}));
  if (!(t < 1)) best = std::min(best, squared_distance({e[2], e[3] - e[2]}));
  if (!(s > -1)) best = std::min(best, squared_distance({e[3], e[0] - e[3]}));
  return best;
}

}  // namespace

bool plain_closer(const DecisionPair& pair) {
  const geometry::Corners e = geometry::seen_from(pair.facet, pair.query);
  if (geometry::separated_by_axis(e, pair.bound)) return false;
  const double square = pair.facet.triangle ? of_triangle(e[0], e[1], e[2]) : of_quad(e);
  return square < pair.bound * pair.bound;
}

void plain_batch(geometry::PairArrays& pairs, bool triangles, [[maybe_unused]] geometry::BatchWidth width) {
#if defined(GAPCHECK_WIDE_BATCHES)
  if (width == geometry::BatchWidth::eight) return plain_eight(pairs, triangles);
  if (width == geometry::BatchWidth::four) return plain_four(pairs, triangles);
#endif
  plain_all<2>(pairs, triangles);
}

}  // namespace gapcheck::bench
