#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "reference/scene.hpp"

namespace gapcheck::reference {

/// The same numbers on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed * 0x9E3779B97F4A7C15ULL + 1) {}
  double uniform(double low, double high) { return low + (high - low) * double(engine_() >> 11) * 0x1p-53; }
  /// A value for a card: three decimals.
  double rounded(double low, double high) { return std::round(uniform(low, high) * 1000) / 1000; }
  bool chance(double p) { return uniform(0, 1) < p; }
  int pick(int low, int high) { return low + int(engine_() % std::uint64_t(high - low + 1)); }

 private:
  std::mt19937_64 engine_;
};

/// Fills a scene with parts, each close above the last one.
class BodyMaker {
 public:
  BodyMaker(Random& random, Scene& scene) : random_(random), scene_(scene) {}
  void all();

 private:
  using Grid = std::vector<std::int64_t>;
  std::int64_t node(const Vector& x);
  Part& part(Kind kind);
  void element(const Part& part, std::vector<std::int64_t> nodes);
  void shells(const Part& part, const Grid& grid, int nx, int ny, double triangles, bool flipped);
  Grid layer(int nx, int ny, double dx, double dy, double z, double shake, double warp, double bend);
  void place();
  void plate();
  void block();
  void chain();

  Random& random_;
  Scene& scene_;
  Eigen::Isometry3d at_ = Eigen::Isometry3d::Identity();
  double height_ = 0;
};

}  // namespace gapcheck::reference
