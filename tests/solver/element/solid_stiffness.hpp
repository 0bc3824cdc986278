#pragma once
#include <Eigen/Core>
#include <random>

#include "solver/element/solid.hpp"

namespace gapcheck::solver {

using Bricks = std::array<Vector, 8>;

inline const Bricks brick_of_unit_size{Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                       {0, 0, 1},       {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

/// One solid with eight points and without viscosity.
struct EightPoints {
  SolidProperties properties;
  SolidRule rule = SolidRule::eight_points;
  SolidState state;
  std::array<PointState, 8> points{};

  EightPoints(SolidProperties all, SolidRule how, const Bricks& x) : properties(std::move(all)), rule(how) {
    const BrickMap start = brick_map(rule, brick_modes(x));
    state.mass = properties.material.density * start.total;
    if (properties.material.kind == MaterialKind::rubber)
      state.undeformed_brick = std::make_shared<const BrickMap>(start);
  }
  SolidForces step(const Bricks& x, const Bricks& v, double dt) {
    return eight_point_forces(properties, rule, {x, v}, dt, state, points);
  }
  SolidForces move(const Bricks& from, const Bricks& to) {
    Bricks v;
    for (std::size_t a = 0; a < 8; ++a) v[a] = to[a] - from[a];
    return step(to, v, 1);
  }
};

inline SolidProperties elastic_eight(double young, double poisson, double density = 1) {
  SolidProperties properties;
  properties.material = {MaterialKind::elastic, density, young, poisson, {}, 0, 0, 0};
  properties.linear_viscosity = properties.quadratic_viscosity = 0;
  return properties;
}

inline Bricks nothing() {
  Bricks v;
  v.fill(Vector::Zero());
  return v;
}

/// ∂force / ∂position at rest, without stress; 24 x 24.
inline Eigen::MatrixXd brick_stiffness(const EightPoints& solid, const Bricks& x) {
  constexpr double dt = 1e-8;
  Eigen::MatrixXd stiffness(24, 24);
  for (int column = 0; column < 24; ++column) {
    EightPoints copy = solid;
    Bricks v = nothing();
    v[static_cast<std::size_t>(column / 3)][column % 3] = 1;
    const SolidForces forces = copy.step(x, v, dt);
    for (std::size_t a = 0; a < 8; ++a) stiffness.block<3, 1>(3 * static_cast<int>(a), column) = forces.force[a] / dt;
  }
  return stiffness;
}

class BrickRandom {
 public:
  explicit BrickRandom(unsigned seed) : engine_(seed) {}
  double number(double size) { return std::uniform_real_distribution<double>(-size, size)(engine_); }
  Vector vector(double size) { return {number(size), number(size), number(size)}; }
  Bricks moved(Bricks x, double size) {
    for (Vector& corner : x) corner += vector(size);
    return x;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace gapcheck::solver
