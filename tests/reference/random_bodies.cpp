#include "reference/random_bodies.hpp"

#include <algorithm>
#include <utility>

namespace gapcheck::reference {

void BodyMaker::all() {
  const int bodies = random_.pick(2, 4);
  for (int i = 0; i < bodies; ++i) {
    place();
    const double kind = random_.uniform(0, 1);
    if (kind < 0.62)
      plate();
    else if (kind < 0.9)
      block();
    else
      chain();
  }
  for (Node& n : scene_.nodes)
    if (random_.chance(0.03)) n.tc = random_.chance(0.5) ? 7 : random_.pick(1, 6);
}

std::int64_t BodyMaker::node(const Vector& x) {
  scene_.nodes.push_back({(at_ * x).unaryExpr([](double v) { return std::round(v * 0x1p20) * 0x1p-20; }), 0});
  return static_cast<std::int64_t>(scene_.nodes.size());
}

Part& BodyMaker::part(Kind kind) {
  Part p;
  p.id = static_cast<std::int64_t>(scene_.parts.size()) + 1;
  p.kind = kind;
  p.thickness = kind == Kind::shell ? random_.rounded(0.1, random_.chance(0.2) ? 3.0 : 1.2) : 0;
  p.diameter = kind == Kind::beam ? random_.rounded(0.2, 1.5) : 0;
  p.rigid = random_.chance(0.12);
  if (random_.chance(0.08)) p.optt = random_.rounded(0.1, 1.2);
  if (random_.chance(0.08)) p.sft = random_.rounded(0.5, 1.5);
  scene_.parts.push_back(p);
  return scene_.parts.back();
}

void BodyMaker::element(const Part& part, std::vector<std::int64_t> nodes) {
  Element e;
  e.id = static_cast<std::int64_t>(scene_.elements.size()) + 1;
  e.part = part.id;
  e.kind = part.kind;
  e.nodes = std::move(nodes);
  if (e.kind == Kind::shell && random_.chance(0.05))
    for (double& t : e.own) t = random_.chance(0.8) ? random_.rounded(0.1, 1.5) : 0;
  scene_.elements.push_back(std::move(e));
}

/// Close above the last body, mostly flat, sometimes turned at will.
void BodyMaker::place() {
  const double turn = random_.chance(0.12) ? 3.1 : random_.chance(0.5) ? 0.25 : 0.0;
  at_ = Eigen::Isometry3d::Identity();
  height_ += random_.chance(0.15) ? random_.uniform(-1.2, 0) : random_.uniform(0, 1.2);
  at_.translate(Vector(random_.uniform(-1.5, 1.5), random_.uniform(-1.5, 1.5), height_));
  at_.rotate(Eigen::AngleAxisd(random_.uniform(-turn, turn), Vector::UnitX()));
  at_.rotate(Eigen::AngleAxisd(random_.uniform(-turn, turn), Vector::UnitY()));
}

/// (nx + 1) x (ny + 1) nodes; `shake` moves them in the plane, `warp` out of it, in element sizes; `bend` is a
/// curvature.
BodyMaker::Grid BodyMaker::layer(int nx, int ny, double dx, double dy, double z, double shake, double warp,
                                 double bend) {
  Grid grid;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const Vector jitter{shake * dx * random_.uniform(-1, 1), shake * dy * random_.uniform(-1, 1),
                          warp * dx * random_.uniform(-1, 1)};
      const double x = i * dx, y = j * dy, middle = x - nx * dx / 2;
      grid.push_back(node(Vector(x, y, z + bend * middle * middle / 2) + jitter));
    }
  return grid;
}

void BodyMaker::shells(const Part& part, const Grid& grid, int nx, int ny, double triangles, bool flipped) {
  const Part p = part;  // element() does not touch parts, but a copy is safe
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const auto n = [&](int a, int b) { return grid[static_cast<std::size_t>((j + b) * (nx + 1) + i + a)]; };
      std::vector<std::int64_t> q{n(0, 0), n(1, 0), n(1, 1), n(0, 1)};
      if (flipped) std::swap(q[1], q[3]);
      if (random_.chance(triangles)) {
        element(p, {q[0], q[1], q[2], q[2]});
        element(p, {q[0], q[2], q[3], q[3]});
      } else {
        element(p, q);
      }
    }
}

void BodyMaker::plate() {
  const int nx = random_.pick(1, 4), ny = random_.pick(1, 4);
  const double dx = random_.uniform(0.4, 2.5), dy = dx * random_.uniform(0.6, 1.5);
  const double shake = random_.chance(0.5) ? 0.1 : 0, warp = random_.chance(0.2) ? 0.03 : 0;
  const double bend = random_.chance(0.2) ? random_.uniform(-0.5, 0.5) / dx : 0;
  const double triangles = random_.chance(0.3) ? 1 : random_.chance(0.3) ? 0.4 : 0;
  const Grid grid = layer(nx, ny, dx, dy, 0, shake, warp, bend);
  shells(part(Kind::shell), grid, nx, ny, triangles, random_.chance(0.3));
}

void BodyMaker::block() {
  const int nx = random_.pick(1, 3), ny = random_.pick(1, 3), nz = random_.chance(0.2) ? 2 : 1;
  const double dx = random_.uniform(0.4, 2.5), dy = dx * random_.uniform(0.6, 1.5), dz = dx * random_.uniform(0.6, 1.5);
  std::vector<Grid> layers;
  for (int k = 0; k <= nz; ++k) layers.push_back(layer(nx, ny, dx, dy, k * dz, 0, 0, 0));
  const Part p = part(Kind::solid);
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        std::vector<std::int64_t> nodes;
        for (const int up : {k, k + 1})
          for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            nodes.push_back(layers[std::size_t(up)][static_cast<std::size_t>((j + b) * (nx + 1) + i + a)]);
        element(p, nodes);
      }
  if (random_.chance(0.2)) shells(part(Kind::shell), layers.back(), nx, ny, 0, random_.chance(0.3));
  height_ += nz * dz;
}

void BodyMaker::chain() {
  const int n = random_.pick(1, 5);
  const double dx = random_.uniform(0.4, 1.5);
  const Part p = part(Kind::beam);
  std::int64_t last = node(Vector(0, 0.5, 0));
  for (int i = 1; i <= n; ++i) {
    const std::int64_t next = node(Vector(i * dx, 0.5 + random_.uniform(-0.2, 0.2), random_.uniform(-0.2, 0.2)));
    element(p, {last, next});
    last = next;
  }
}

}  // namespace gapcheck::reference
