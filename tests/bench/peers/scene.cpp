#include "scene.hpp"

#include <random>

namespace gapcheck::bench {
namespace {

constexpr double spacing = 5;

std::vector<Vector> plate_nodes(int n, const Vector& corner) {
  std::vector<Vector> nodes;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) nodes.push_back(corner + Vector(spacing * i, spacing * j, 0));
  }
  return nodes;
}

}  // namespace

std::string name(Points points) {
  static constexpr const char* names[] = {"nodes of a second plate", "random, at most two contact distances away",
                                          "random, in a cube around the plate"};
  return names[static_cast<std::size_t>(points)];
}

std::vector<std::array<std::uint32_t, 3>> Scene::triangles() const {
  std::vector<std::array<std::uint32_t, 3>> out;
  out.reserve(2 * quads.size());
  for (const auto& q : quads) {
    out.push_back({q[0], q[1], q[2]});
    out.push_back({q[0], q[2], q[3]});
  }
  return out;
}

Scene make_scene(int n, Points points) {
  Scene scene;
  scene.nodes = plate_nodes(n, Vector::Zero());
  const auto row = static_cast<std::uint32_t>(n + 1);
  for (std::uint32_t j = 0; j + 1 < row; ++j) {
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const std::uint32_t a = j * row + i;
      scene.quads.push_back({a, a + 1, a + row + 1, a + row});
    }
  }
  if (points == Points::plate) {
    scene.points = plate_nodes(n, Vector(0.3 * spacing, 0.4 * spacing, 0.7));
    return scene;
  }
  const double length = spacing * n, height = points == Points::slab ? 2 * scene.bound : length / 2;
  std::mt19937_64 random(4711);
  std::uniform_real_distribution<double> along(0, length), up(-height, height);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const double x = along(random), y = along(random), z = up(random);
    scene.points.emplace_back(x, y, z);
  }
  return scene;
}

}  // namespace gapcheck::bench
