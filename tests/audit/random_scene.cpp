#include "audit/random_scene.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace gapcheck::audit_test {
namespace {

class Maker {
 public:
  explicit Maker(std::uint64_t seed) : random_(seed * 0x9E3779B97F4A7C15ULL + 1) {}

  Scene make() {
    scene_.ssthk = chance(0.5) ? 1 : 0;
    const int bodies = pick(2, 5);
    for (int i = 0; i < bodies; ++i) add_body(i + 1);
    add_contacts();
    return std::move(scene_);
  }

 private:
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  bool chance(double p) { return uniform(0, 1) < p; }
  int pick(int low, int high) { return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1)); }

  /// Where the body lies: close above the last one, mostly flat, sometimes turned at will.
  Eigen::Isometry3d placement() {
    const double turn = chance(0.2) ? 3.1 : chance(0.5) ? 0.3 : 0.0;
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    height_ += chance(0.2) ? uniform(-1.5, 0) : uniform(-0.3, 1.3);
    place.translate(Vector(uniform(-2, 2), uniform(-2, 2), height_));
    place.rotate(Eigen::AngleAxisd(uniform(-turn, turn), Vector::UnitX()));
    place.rotate(Eigen::AngleAxisd(uniform(-turn, turn), Vector::UnitY()));
    return place;
  }

  std::int64_t add_node(const Vector& x) {
    const auto id = static_cast<std::int64_t>(scene_.nodes.size()) + 1;
    scene_.nodes.push_back({id, x.unaryExpr([](double v) { return std::round(v * 0x1p20) * 0x1p-20; })});
    return id;
  }
  void add_element(std::int64_t part, std::vector<std::int64_t> nodes) {
    scene_.elements.push_back({static_cast<std::int64_t>(scene_.elements.size()) + 1, part, std::move(nodes)});
  }

  /// A layer of (nx + 1) x (ny + 1) nodes; `shake` moves them in the plane, `warp` out of it, in element sizes.
  std::vector<std::int64_t> layer(int nx, int ny, double dx, double dy, double z, double shake, double warp,
                                  const Eigen::Isometry3d& place) {
    std::vector<std::int64_t> ids;
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        const Vector jitter{shake * dx * uniform(-1, 1), shake * dy * uniform(-1, 1), warp * dx * uniform(-1, 1)};
        ids.push_back(add_node(place * (Vector(i * dx, j * dy, z) + jitter)));
      }
    }
    return ids;
  }

  void add_body(std::int64_t part) {
    const double kind = uniform(0, 1);
    const int nx = pick(1, 6), ny = pick(1, 6);
    const double dx = uniform(0.3, 2.5), dy = dx * uniform(0.5, 1.6);
    const Eigen::Isometry3d place = placement();
    if (kind < 0.3)
      add_block(part, nx, ny, dx, dy, place);
    else
      add_plate(part, nx, ny, dx, dy, kind < 0.45, place);
  }

  void add_plate(std::int64_t part, int nx, int ny, double dx, double dy, bool triangles,
                 const Eigen::Isometry3d& place) {
    const double shake = chance(0.5) ? 0.1 : 0, warp = chance(0.2) ? 0.03 : 0;
    scene_.parts.push_back({part, false, uniform(0.05, 1.5)});
    const auto ids = layer(nx, ny, dx, dy, 0, shake, warp, place);
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const auto at = [&](int a, int b) { return ids[static_cast<std::size_t>((j + b) * (nx + 1) + i + a)]; };
        if (triangles) {
          add_element(part, {at(0, 0), at(1, 0), at(1, 1)});
          add_element(part, {at(0, 0), at(1, 1), at(0, 1)});
        } else {
          add_element(part, {at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
        }
      }
    }
  }

  /// One layer of bricks, so that every node lies on the surface.
  void add_block(std::int64_t part, int nx, int ny, double dx, double dy, const Eigen::Isometry3d& place) {
    scene_.parts.push_back({part, true, 0});
    const double height = dx * uniform(0.6, 1.5);
    const auto low = layer(nx, ny, dx, dy, 0, 0, 0, place), high = layer(nx, ny, dx, dy, height, 0, 0, place);
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        std::vector<std::int64_t> nodes;
        for (const auto* side : {&low, &high}) {
          for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            nodes.push_back((*side)[static_cast<std::size_t>((j + b) * (nx + 1) + i + a)]);
        }
        add_element(part, nodes);
      }
    }
    height_ += height;
  }

  std::int64_t add_set(std::vector<std::int64_t> parts) {
    const auto id = static_cast<std::int64_t>(scene_.sets.size()) + 1;
    scene_.sets.push_back({id, std::move(parts)});
    return id;
  }

  void add_contacts() {
    static const char* keywords[] = {"AUTOMATIC_SINGLE_SURFACE", "AUTOMATIC_SURFACE_TO_SURFACE",
                                     "AUTOMATIC_NODES_TO_SURFACE", "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE"};
    const int count = pick(1, 3);
    for (int i = 0; i < count; ++i) {
      Scene::Contact contact{.id = 10 * (i + 1), .keyword = keywords[pick(0, 3)]};
      if (contact.keyword != keywords[0]) split_parts(contact);
      if (chance(0.25)) contact.sst = uniform(0.2, 1.0), contact.mst = uniform(0.2, 1.0);
      if (chance(0.25)) contact.sfst = uniform(0.5, 1.5), contact.sfmt = uniform(0.5, 1.5);
      contact.ignore = chance(0.4) ? pick(1, 2) : 0;
      contact.snlog = chance(0.15) ? 1 : 0;
      scene_.contacts.push_back(contact);
    }
  }

  void split_parts(Scene::Contact& contact) {
    std::vector<std::int64_t> a, b;
    for (const auto& part : scene_.parts) (chance(0.5) ? a : b).push_back(part.id);
    if (a.empty()) a.push_back(b.back()), b.pop_back();
    if (b.empty()) b.push_back(a.back()), a.pop_back();
    contact.set_a = add_set(a), contact.set_b = add_set(b);
  }

  std::mt19937_64 random_;
  Scene scene_;
  double height_ = 0;
};

}  // namespace

Scene random_scene(std::uint64_t seed) { return Maker(seed).make(); }

}  // namespace gapcheck::audit_test
