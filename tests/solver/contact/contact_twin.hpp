#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "base/vector.hpp"

namespace gapcheck::solver {

/// A slow and obvious second version of a contact cycle: every node against every facet, in long double. It knows
/// shells without friction, SOFT = 0 and 2, PENOPT = 1 and automatic types, and solids as long as nodes are in front of
/// their faces. It shares no code with the contact rooms.
class ContactTwin {
 public:
  using Real = long double;
  using Point = std::array<Real, 3>;
  enum class Start : std::uint8_t { forced, ignored, moved, segments };
  enum class Memory : std::uint8_t { apart, touching, released };

  struct Facet {
    std::array<std::size_t, 4> nodes{};  ///< triangles repeat the third one
    int body = 0;
    bool solid = false;
    Real half = 0;  ///< half of the thickness, of shells
    Real stiffness = 0;
    Real release = 0;  ///< of solids: the penetration that is too deep
    Real mass = 0;     ///< of the segment, for SOFT = 2
    [[nodiscard]] bool triangle() const { return nodes[2] == nodes[3]; }
    [[nodiscard]] bool has(std::size_t node) const {
      return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
    }
  };

  ContactTwin(std::vector<Facet> facets, std::vector<int> body_of_node, bool single, Start start)
      : facets_(std::move(facets)),
        body_(std::move(body_of_node)),
        single_(single),
        start_(start),
        nodes_(body_.size()) {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      nodes_[n].stiffness = std::numeric_limits<Real>::infinity();
      for (const Facet& facet : facets_)
        if (facet.has(n)) {
          nodes_[n].half = std::max(nodes_[n].half, facet.half);
          nodes_[n].stiffness = std::min(nodes_[n].stiffness, facet.stiffness);
          nodes_[n].own.insert(facet.nodes.begin(), facet.nodes.end());
        }
    }
  }

  /// One cycle at `x`, whose nodes it may move; forces on all nodes.
  std::vector<Point> cycle(std::vector<Vector>& x) {
    std::vector<Point> forces(x.size(), Point{0, 0, 0});
    if (last_.empty()) last_ = x;
    if (single_) {
      side(x, forces, -1, -1);
    } else {
      side(x, forces, 1, 2);
      side(x, forces, 2, 1);
    }
    last_ = x;
    fresh_ = false;
    return forces;
  }
  /// That of the run, for SOFT = 2. Another step changes all springs.
  void set_step(Real step) {
    if (step != step_)
      for (Node& node : nodes_) node.facet = nullptr;
    step_ = step;
  }
  [[nodiscard]] Memory memory(std::size_t node) const { return nodes_[node].memory; }
  [[nodiscard]] std::size_t moved() const { return moved_; }
  /// Nodes behind the mid-surface of what they touch, SOFT = 2.
  [[nodiscard]] std::size_t passed() const { return passed_; }

 private:
  struct Node {
    Real half = 0, stiffness = 0, forgiven = 0;
    std::set<std::size_t> own;  ///< nodes of its elements
    Memory memory = Memory::apart;
    Point side{};                  ///< where the node was last seen from the facet, SOFT = 2
    const Facet* facet = nullptr;  ///< what it was last in contact with, SOFT = 2
    Real shared = 0;               ///< stiffness of the spring to it
  };
  struct Meeting {
    const Facet* facet = nullptr;
    Real distance = 0, penetration = 0;
    Point from{};  ///< from the closest point to the node
    std::array<Real, 4> weights{};
  };

  static Real dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static Point blend(const std::array<Point, 4>& corners, const std::array<Real, 4>& weights) {
    Point p{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t a = 0; a < 3; ++a) p[a] += weights[i] * corners[i][a];
    return p;
  }
  static std::array<Real, 4> bilinear(Real s, Real t) {
    return {(1 - s) * (1 - t) / 4, (1 + s) * (1 - t) / 4, (1 + s) * (1 + t) / 4, (1 - s) * (1 + t) / 4};
  }

  /// Parameters of the projection on the quad continued beyond its edges, by Newton's method on the squared distance.
  static std::array<Real, 2> project(const std::array<Point, 4>& c, const Point& q, Real s, Real t) {
    for (int i = 0; i < 100; ++i) {
      Point a{}, b{}, twist{};
      for (std::size_t k = 0; k < 3; ++k) {
        a[k] = ((1 - t) * (c[1][k] - c[0][k]) + (1 + t) * (c[2][k] - c[3][k])) / 4;
        b[k] = ((1 - s) * (c[3][k] - c[0][k]) + (1 + s) * (c[2][k] - c[1][k])) / 4;
        twist[k] = (c[0][k] - c[1][k] + c[2][k] - c[3][k]) / 4;
      }
      const Point r = minus(blend(c, bilinear(s, t)), q);
      const Real fs = dot(r, a), ft = dot(r, b), ss = dot(a, a), tt = dot(b, b), st = dot(a, b) + dot(r, twist);
      const Real determinant = ss * tt - st * st;
      const Real ds = (fs * tt - ft * st) / determinant, dt = (ft * ss - fs * st) / determinant;
      s -= ds;
      t -= dt;
      if (std::abs(ds) + std::abs(dt) < 1e-17L) break;
    }
    return {s, t};
  }

  /// Keeps the nearest of what is tried.
  static void attempt(const std::array<Point, 4>& c, const Point& q, const std::array<Real, 4>& weights,
                      Meeting& best) {
    const Point from = minus(q, blend(c, weights));
    const Real distance = std::sqrt(dot(from, from));
    if (best.distance >= 0 && distance >= best.distance) return;
    best.distance = distance;
    best.from = from;
    best.weights = weights;
  }

  /// Outside the ball around the first corner that holds the facet and all that is nearer to it than `bound`.
  static bool is_far(const std::array<Point, 4>& c, const Point& q, Real bound) {
    Real reach = 0;
    for (const Point& corner : c) reach = std::max(reach, std::sqrt(dot(minus(corner, c[0]), minus(corner, c[0]))));
    return std::sqrt(dot(minus(q, c[0]), minus(q, c[0]))) > reach + bound;
  }

  /// The closest point, and whether the projection lies in the band.
  static bool meet(const Facet& facet, const std::array<Point, 4>& c, const Point& q, Meeting& best) {
    best.distance = -1;
    const std::size_t corners = facet.triangle() ? 3 : 4;
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t j = (i + 1) % corners;
      const Point side = minus(c[j], c[i]);
      const Real u = std::clamp(dot(minus(q, c[i]), side) / dot(side, side), Real{0}, Real{1});
      std::array<Real, 4> weights{};
      weights[i] = 1 - u;
      weights[j] = u;
      attempt(c, q, weights, best);
    }
    if (facet.triangle()) {
      const Point a = minus(c[1], c[0]), b = minus(c[2], c[0]), n = cross(a, b), d = minus(q, c[0]);
      const Real v = dot(cross(d, b), n) / dot(n, n), w = dot(cross(a, d), n) / dot(n, n), u = 1 - v - w;
      if (u >= 0 && v >= 0 && w >= 0) attempt(c, q, {u, v, w, 0}, best);
      return std::min({u, v, w}) >= -0.25L;
    }
    for (const Real s0 : {-0.5L, 0.5L})
      for (const Real t0 : {-0.5L, 0.5L}) {
        const auto [s, t] = project(c, q, s0, t0);
        if (std::abs(s) <= 1 && std::abs(t) <= 1) attempt(c, q, bilinear(s, t), best);
      }
    const auto [s, t] = project(c, q, 0, 0);
    return std::abs(s) <= 1.5L && std::abs(t) <= 1.5L;
  }

  [[nodiscard]] bool skips(std::size_t node, const Facet& facet) const {
    for (const std::size_t corner : facet.nodes)
      if (nodes_[node].own.count(corner) > 0) return true;
    return false;
  }

  /// Nodes of body `a` against the facets of body `b`; -1: all.
  void side(std::vector<Vector>& x, std::vector<Point>& forces, int a, int b) {
    const std::vector<Vector> before = x;  // what is moved is not seen by the other nodes of this side
    Real largest = 0;
    for (const Vector& p : before) largest = std::max<Real>(largest, p.cwiseAbs().maxCoeff());
    const auto point = [&](std::size_t n) { return Point{before[n].x(), before[n].y(), before[n].z()}; };
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (a >= 0 && body_[n] != a) continue;
      Node& node = nodes_[n];
      Meeting nearest;
      bool in_zone = false;
      for (const Facet& facet : facets_) {
        if ((b >= 0 && facet.body != b) || facet.has(n) || (single_ && skips(n, facet))) continue;
        std::array<Point, 4> corners{};
        for (std::size_t i = 0; i < 4; ++i) corners[i] = point(facet.nodes[i]);
        Meeting here;
        const Real bound = node.half + facet.half;
        if (is_far(corners, point(n), bound)) continue;
        const bool in_band = meet(facet, corners, point(n), here);
        const Real tolerance = 1e-9L * bound + 4 * largest * std::numeric_limits<double>::epsilon();
        if (here.distance >= bound - tolerance) continue;
        // Solids have an outside.
        const Point out = cross(minus(corners[2], corners[0]), minus(corners[3], corners[1]));
        if (facet.solid && dot(out, here.from) <= 0) continue;
        in_zone = true;
        if (!in_band) continue;
        if (nearest.facet != nullptr && here.distance >= nearest.distance * (1 - 1e-9L)) continue;
        nearest = here;
        nearest.facet = &facet;
        nearest.penetration = bound - here.distance;
      }
      if (start_ == Start::segments)
        press(n, nearest, before, forces);
      else
        act(n, nearest, in_zone, x, forces);
    }
  }

  /// The facet saw the node in the cycle before: outside, by less than the thickness (solids: see depth).
  [[nodiscard]] bool followed(std::size_t n, const Facet& facet) const {
    if (fresh_) return false;
    const auto point = [&](std::size_t k) { return Point{last_[k].x(), last_[k].y(), last_[k].z()}; };
    std::array<Point, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) corners[i] = point(facet.nodes[i]);
    Meeting then;
    meet(facet, corners, point(n), then);
    const Real h = nodes_[n].half + facet.half;
    const Point out = cross(minus(corners[2], corners[0]), minus(corners[3], corners[1]));
    const Real distance = facet.solid && dot(out, then.from) < 0 ? -then.distance : then.distance;
    return distance >= h * (1 - 1e-9L) - 1e-12L && distance < h + std::max(h, facet.solid ? facet.release : 0);
  }

  /// Of the angle between two facets, whichever way they look.
  static Real cosine(const Facet& a, const Facet& b, const std::vector<Vector>& x) {
    const auto normal = [&](const Facet& facet) {
      const auto point = [&](std::size_t i) {
        const Vector& p = x[facet.nodes[i]];
        return Point{p.x(), p.y(), p.z()};
      };
      return cross(minus(point(2), point(0)), minus(point(3), point(1)));
    };
    const Point m = normal(a), n = normal(b);
    return std::abs(dot(m, n)) / std::sqrt(dot(m, m) * dot(n, n));
  }

  /// SOFT = 2: nothing is released or moved, and the side stays. Facets that face the other one most give their whole
  /// share.
  void press(std::size_t n, Meeting met, const std::vector<Vector>& x, std::vector<Point>& forces) {
    Node& node = nodes_[n];
    if (met.facet == nullptr) {
      node.memory = Memory::apart;
      node.forgiven = 0;
      node.side = {};
      node.facet = nullptr;
      return;
    }
    const Facet& facet = *met.facet;
    if (!facet.solid && dot(node.side, met.from) < 0) {
      met.penetration += 2 * met.distance;
      for (Real& component : met.from) component = -component;
      ++passed_;
    }
    node.side = met.from;
    if (node.memory == Memory::apart && !followed(n, facet)) node.forgiven = met.penetration;
    node.memory = Memory::touching;
    node.forgiven = std::min(node.forgiven, met.penetration);
    if (node.facet != met.facet) {  // the spring of a pair stays what it was when the pair began
      node.facet = met.facet;
      node.shared = 0;
      Real best = 0;
      for (const Facet& own : facets_)
        if (own.has(n)) best = std::max(best, cosine(own, facet, x));
      for (const Facet& own : facets_)
        if (own.has(n))
          node.shared += (best > 0.01L ? cosine(own, facet, x) / best : 1) * 0.05L / (own.triangle() ? 3 : 4) *
                         own.mass * facet.mass / (own.mass + facet.mass) / (step_ * step_);
    }
    give(n, met, node.shared * (met.penetration - node.forgiven), forces);
  }

  static void give(std::size_t n, const Meeting& met, Real force, std::vector<Point>& forces) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Real part = force * met.from[axis] / met.distance;
      forces[n][axis] += part;
      for (std::size_t i = 0; i < 4; ++i) forces[met.facet->nodes[i]][axis] -= met.weights[i] * part;
    }
  }

  void act(std::size_t n, const Meeting& met, bool in_zone, std::vector<Vector>& x, std::vector<Point>& forces) {
    Node& node = nodes_[n];
    if (node.memory == Memory::released) {
      if (!in_zone) node = {node.half, node.stiffness, 0, node.own, Memory::apart, {}, nullptr, 0};
      return;
    }
    if (met.facet == nullptr) {
      node.memory = Memory::apart;
      node.forgiven = 0;
      return;
    }
    const Facet& facet = *met.facet;
    const Real release = facet.solid ? facet.release : 0.4L * 2 * (node.half + facet.half);
    if (met.penetration > release) {
      node.memory = Memory::released;
      node.forgiven = 0;
      return;
    }
    const bool first = node.memory == Memory::apart && !followed(n, facet);
    node.memory = Memory::touching;
    if (first && start_ == Start::ignored) node.forgiven = met.penetration;
    node.forgiven = std::min(node.forgiven, met.penetration);
    if (first && start_ == Start::moved) {
      ++moved_;
      for (std::size_t axis = 0; axis < 3; ++axis)
        x[n][static_cast<int>(axis)] += static_cast<double>(1.002L * met.penetration * met.from[axis] / met.distance);
      return;
    }
    give(n, met, std::min(node.stiffness, facet.stiffness) * (met.penetration - node.forgiven), forces);
  }

  std::vector<Facet> facets_;
  std::vector<int> body_;
  bool single_;
  Start start_;
  std::vector<Node> nodes_;
  std::size_t moved_ = 0, passed_ = 0;
  Real step_ = 0;
  std::vector<Vector> last_;  ///< positions after the last cycle
  bool fresh_ = true;         ///< in the first cycle
};

}  // namespace gapcheck::solver
