#include "solver/element/solid.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

namespace gapcheck::solver::solid_test {
namespace {

using Kernel = SolidForces (*)(const SolidProperties&, const SolidCorners&, double, SolidState&, PointState&);
using Corners = std::array<Vector, 8>;

constexpr double young = 1000;

SolidProperties elastic_solid(double nu = 0.3, HourglassKind hourglass = HourglassKind::stiffness) {
  SolidProperties properties;
  properties.material = {MaterialKind::elastic, 1, young, nu, {}, 0, 0, 0};
  properties.hourglass = {hourglass, 0.1};
  properties.linear_viscosity = properties.quadratic_viscosity = 0;
  return properties;
}

const Corners unit_cube{Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

double volume_of(Kernel kernel, const Corners& x) {
  return kernel == brick_forces ? brick_volume(x) : tetrahedron_volume(x);
}

struct OneSolid {
  SolidProperties properties = elastic_solid();
  Kernel kernel = brick_forces;
  SolidState state;
  PointState point;
  OneSolid(SolidProperties all, Kernel function, const Corners& x) : properties(std::move(all)), kernel(function) {
    state.mass = properties.material.density * volume_of(kernel, x);
    if (kernel == brick_forces && properties.hourglass.kind == HourglassKind::stiffness)
      state.reference = std::make_shared<HourglassReference>(hourglass_reference(properties, x, state.mass));
  }
  SolidForces step(const SolidCorners& corners, double dt) { return kernel(properties, corners, dt, state, point); }
};

SolidCorners at_rest(const Corners& x) {
  SolidCorners corners{x, {}};
  for (Vector& v : corners.v) v.setZero();
  return corners;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  Vector vector(double size) { return {number(size), number(size), number(size)}; }
  /// A cube with moved corners; for a tetrahedron corners 0, 1, 3, 4 of it in front.
  Corners shape(Kernel kernel, double size) {
    Corners x = unit_cube;
    for (Vector& corner : x) corner += vector(size);
    if (kernel == tetrahedron_forces) x = {x[0], x[1], x[3], x[4], x[4], x[4], x[4], x[4]};
    return x;
  }

 private:
  double number(double size) { return std::uniform_real_distribution<double>(-size, size)(engine_); }
  std::mt19937 engine_;
};

/// Volume of the trilinear brick by 2 x 2 x 2 Gauss points, which are exact for it.
double gauss_volume(const Corners& x) {
  constexpr double signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                  {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  double volume = 0;
  for (const auto& g : signs) {
    const Vector at = Vector(g[0], g[1], g[2]) / std::numbers::sqrt3;
    Matrix jacobian = Matrix::Zero();
    for (std::size_t a = 0; a < 8; ++a)
      for (int k = 0; k < 3; ++k) {
        double slope = signs[a][k] / 8;
        for (int j = 0; j < 3; ++j)
          if (j != k) slope *= 1 + signs[a][j] * at[j];
        jacobian.col(k) += slope * x[a];
      }
    volume += jacobian.determinant();
  }
  return volume;
}

TEST(Solid, VolumeOfWarpedBricks) {
  EXPECT_NEAR(brick_volume(unit_cube), 1, 1e-15);
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Corners x = random.shape(brick_forces, 0.3);
    EXPECT_NEAR(brick_volume(x), gauss_volume(x), 1e-14);
  }
  EXPECT_NEAR(tetrahedron_volume({Vector(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 1.0 / 6, 1e-16);
}

/// A cube of 3 x 3 x 3 cells with its eight inner nodes moved about.
struct Patch {
  std::vector<Vector> x;
  std::vector<Corners> elements;
  std::vector<std::array<int, 8>> nodes;
  [[nodiscard]] static bool inner(int node) {
    const auto between = [](int k) { return k == 1 || k == 2; };
    return between(node % 4) && between(node / 4 % 4) && between(node / 16);
  }
  explicit Patch(Kernel kernel) {
    Random random(17);
    for (int i = 0; i < 64; ++i) {
      x.emplace_back(i % 4, i / 4 % 4, i / 16);
      if (inner(i)) x.back() += random.vector(0.25);
    }
    for (int cell = 0; cell < 27; ++cell) {
      const int o = cell % 3 + cell / 3 % 3 * 4 + cell / 9 * 16;
      const std::array<int, 8> hex{o, o + 1, o + 5, o + 4, o + 16, o + 17, o + 21, o + 20};
      if (kernel == brick_forces) {
        nodes.push_back(hex);
        continue;
      }
      // Six tetrahedra about the diagonal 0–6; neighbours fit.
      constexpr std::size_t ring[7] = {1, 2, 3, 7, 4, 5, 1};
      for (std::size_t k = 0; k < 6; ++k) {
        const int last = hex[6];
        nodes.push_back({hex[0], hex[ring[k]], hex[ring[k + 1]], last, last, last, last, last});
      }
    }
    for (const auto& element : nodes) {
      Corners corners;
      for (std::size_t a = 0; a < 8; ++a) corners[a] = x[static_cast<std::size_t>(element[a])];
      elements.push_back(corners);
    }
  }
};

// A linear field: the inner nodes feel nothing, the stress is the elastic law's everywhere.
TEST(SolidPatch, LinearField) {
  constexpr double dt = 1e-9;
  Matrix gradient;
  gradient << 1, 0.5, -0.2, 0.3, -0.4, 0.7, 0.1, -0.6, 0.8;
  using Case = std::pair<Kernel, bool>;
  for (const auto& [kernel, exact] :
       {Case(brick_forces, true), Case(brick_forces, false), Case(tetrahedron_forces, true)}) {
    const Patch patch(kernel);
    std::vector<Vector> force(64, Vector::Zero());
    double volume = 0;
    for (std::size_t e = 0; e < patch.elements.size(); ++e) {
      SolidProperties properties = elastic_solid();
      properties.hourglass.exact_volume = exact;
      OneSolid solid(properties, kernel, patch.elements[e]);
      SolidCorners corners = at_rest(patch.elements[e]);
      for (std::size_t a = 0; a < 8; ++a) corners.v[a] = gradient * corners.x[a];
      const SolidForces forces = solid.step(corners, dt);
      ASSERT_TRUE(forces.good) << e;
      volume += forces.volume;
      EXPECT_NEAR(forces.hourglass_work / (dt * dt), 0, 1e-9);
      // σ = λ tr ε + 2 G ε
      constexpr double shear = young / 2.6, lame = young * 0.3 / 1.3 / 0.4;
      const Symmetric rate = to_symmetric(gradient);
      for (std::size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(solid.point.stress[c] / dt, 2 * shear * rate[c] + (c < 3 ? lame * gradient.trace() : 0), 1e-5)
            << e << " " << c;
      for (std::size_t a = 0; a < 8; ++a) force[static_cast<std::size_t>(patch.nodes[e][a])] += forces.force[a];
    }
    // Amplitudes are rounded at 1e-16. Gradients of the centre leave a force of up to some percent of σ A.
    double largest = 0;
    for (int node = 0; node < 64; ++node)
      if (Patch::inner(node)) largest = std::max(largest, force[static_cast<std::size_t>(node)].norm() / dt);
    if (exact) {
      EXPECT_NEAR(volume, 27, 1e-7);
      EXPECT_NEAR(largest, 0, 1e-4);
    } else {
      EXPECT_GT(std::abs(volume - 27), 1e-4);
      EXPECT_GT(largest, 0.001 * young);
      EXPECT_LT(largest, 0.1 * young);
    }
  }
}

// Through a whole circle about any axis a stressed, hourglassed solid keeps its stresses and forces in its own axes.
TEST(Solid, RigidRotationIsFree) {
  const Vector axis = Vector(0.3, -1, 0.6).normalized();
  constexpr int steps = 100;
  const Matrix turn = Eigen::AngleAxisd(2 * std::numbers::pi / steps, axis).toRotationMatrix();
  for (const Kernel kernel : {brick_forces, tetrahedron_forces}) {
    Random random(5);
    const Corners x = random.shape(kernel, 0.2);
    OneSolid solid(elastic_solid(), kernel, x);
    SolidCorners corners = at_rest(x);
    for (Vector& v : corners.v) v = random.vector(0.01);
    const SolidForces first = solid.step(corners, 1);
    const Symmetric stress = solid.point.stress;
    for (int step = 0; step < steps; ++step) {
      for (std::size_t a = 0; a < 8; ++a) {
        const Vector next = turn * corners.x[a];
        corners.v[a] = next - corners.x[a];
        corners.x[a] = next;
      }
      const SolidForces forces = solid.step(corners, 1);
      EXPECT_NEAR(forces.hourglass_work, 0, 1e-13);
      if (step == steps / 4 - 1) {
        const Matrix quarter = Eigen::AngleAxisd(std::numbers::pi / 2, axis).toRotationMatrix();
        for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(solid.point.stress[c], rotated(stress, quarter)[c], 1e-11);
        for (std::size_t a = 0; a < 8; ++a) EXPECT_NEAR((forces.force[a] - quarter * first.force[a]).norm(), 0, 1e-11);
      }
    }
    for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(solid.point.stress[c], stress[c], 1e-11);
  }
}

// The centre of the yield surface turns with the solid: stretched far beyond yield, turned by a quarter and stretched
// again along what was x, it has the stress of one that was not turned.
TEST(Solid, BackStressTurnsWithTheSolid) {
  for (const Kernel kernel : {brick_forces, tetrahedron_forces}) {
    SolidProperties properties = elastic_solid(0.3, HourglassKind::none);
    properties.material = plastic_kinematic(1, young, 0.3, 1, 0.5, 0);
    ASSERT_LT(properties.material.kinematic_slope, 1);
    Random random(2);
    const Corners x = random.shape(kernel, 0);
    std::array<Symmetric, 2> stress{}, back{};
    for (const bool turned : {false, true}) {
      OneSolid solid(properties, kernel, x);
      Corners now = x;
      const auto move = [&](const Matrix& by) {
        SolidCorners corners{now, {}};
        for (std::size_t a = 0; a < 8; ++a) {
          corners.x[a] = by * now[a];
          corners.v[a] = corners.x[a] - now[a];
        }
        now = corners.x;
        EXPECT_TRUE(solid.step(corners, 1).good);
      };
      Matrix stretch = Matrix::Identity();
      stretch(0, 0) = 1.01;
      for (int i = 0; i < 20; ++i) move(stretch);
      EXPECT_GT(std::abs(solid.point.back_stress[xx]), 0.01);
      constexpr int steps = 60;
      if (turned)
        for (int i = 0; i < steps; ++i)
          move(Eigen::AngleAxisd(std::numbers::pi / 2 / steps, Vector::UnitZ()).toRotationMatrix());
      Matrix back_again = Matrix::Identity();
      back_again(turned ? 1 : 0, turned ? 1 : 0) = 1 / 1.01;
      for (int i = 0; i < 5; ++i) move(back_again);
      const Matrix quarter = Eigen::AngleAxisd(-std::numbers::pi / 2, Vector::UnitZ()).toRotationMatrix();
      stress[turned ? 1 : 0] = turned ? rotated(solid.point.stress, quarter) : solid.point.stress;
      back[turned ? 1 : 0] = turned ? rotated(solid.point.back_stress, quarter) : solid.point.back_stress;
    }
    for (std::size_t c = 0; c < 6; ++c) {
      EXPECT_NEAR(stress[1][c], stress[0][c], 1e-8) << c;
      EXPECT_NEAR(back[1][c], back[0][c], 1e-10) << c;
    }
  }
}

TEST(Solid, ForcesAreInBalance) {
  Random random(9);
  for (int trial = 0; trial < 50; ++trial)
    for (const Kernel kernel : {brick_forces, tetrahedron_forces}) {
      const Corners x = random.shape(kernel, 0.2);
      OneSolid solid(elastic_solid(), kernel, x);
      SolidCorners corners = at_rest(x);
      for (Vector& v : corners.v) v = random.vector(0.5);
      const SolidForces forces = solid.step(corners, 1e-3);
      ASSERT_TRUE(forces.good);
      Vector force = Vector::Zero(), moment = Vector::Zero();
      for (std::size_t a = 0; a < 8; ++a) {
        force += forces.force[a];
        moment += corners.x[a].cross(forces.force[a]);
      }
      EXPECT_NEAR(force.norm(), 0, 1e-13);
      EXPECT_NEAR(moment.norm(), 0, 1e-12);
    }
}

TEST(Solid, StableStepIsABound) {
  Random random(21);
  for (int trial = 0; trial < 40; ++trial)
    for (const Kernel kernel : {brick_forces, tetrahedron_forces}) {
      const Corners x = trial == 0 ? random.shape(kernel, 0) : random.shape(kernel, 0.25);
      SolidProperties properties = elastic_solid(trial % 2 == 0 ? 0.3 : 0, HourglassKind::none);
      properties.hourglass.exact_volume = trial % 3 == 0;
      const OneSolid solid(properties, kernel, x);
      const int corners = kernel == brick_forces ? 8 : 4;
      constexpr double dt = 1e-8;
      Eigen::MatrixXd stiffness(3 * corners, 3 * corners);
      for (int column = 0; column < 3 * corners; ++column) {
        OneSolid copy = solid;
        SolidCorners moved = at_rest(x);
        moved.v[static_cast<std::size_t>(column / 3)][column % 3] = 1;
        const SolidForces forces = copy.step(moved, dt);
        for (int a = 0; a < corners; ++a)
          stiffness.block<3, 1>(3 * a, column) = forces.force[static_cast<std::size_t>(a)] / dt;
      }
      EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-5 * stiffness.norm()) << "forces have an energy";
      const Eigen::MatrixXd scaled = (stiffness + stiffness.transpose()) / 2 * corners / solid.state.mass;
      const double highest = std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues().tail(1)[0]);
      OneSolid copy = solid;
      const double step = copy.step(at_rest(x), 0).stable_step;
      EXPECT_LE(step, 2 / highest * (1 + 1e-5)) << trial;
      EXPECT_GE(step, 0.5 * 2 / highest) << trial;
    }
}

// Brick: volume / largest face; tetrahedron: the shortest height.
TEST(Solid, ManualTimeStep) {
  Corners box = unit_cube;
  for (Vector& x : box) x = x.cwiseProduct(Vector(3, 2, 0.5));
  OneSolid brick(elastic_solid(), brick_forces, box);
  const double speed = std::sqrt(brick.properties.material.wave_modulus());
  EXPECT_NEAR(brick.step(at_rest(box), 0).manual_step, 0.5 / speed, 1e-14);
  const Corners tet{Vector(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  OneSolid tetrahedron(elastic_solid(), tetrahedron_forces, tet);
  EXPECT_NEAR(tetrahedron.step(at_rest(tet), 0).manual_step, 1 / std::sqrt(3.0) / speed, 1e-14);
}

// Unit cube, mode (−1, 1, −1, 1, 1, −1, 1, −1) in x: q = 8 and Σ b² = 3/2, so Q = r M / 2 · dt.
TEST(Solid, HourglassStiffness) {
  constexpr double dt = 1e-8;
  constexpr double mode[8] = {-1, 1, -1, 1, 1, -1, 1, -1};
  OneSolid solid(elastic_solid(), brick_forces, unit_cube);
  SolidCorners corners = at_rest(unit_cube);
  for (std::size_t a = 0; a < 8; ++a) {
    corners.v[a].x() = mode[a];
    corners.x[a].x() += dt * mode[a];
  }
  const SolidForces forces = solid.step(corners, dt);
  const double expected = 0.1 * solid.properties.material.wave_modulus() / 2 * dt;
  for (std::size_t a = 0; a < 8; ++a) EXPECT_NEAR(forces.force[a].x(), mode[a] * expected, 1e-13);
  EXPECT_NEAR(forces.hourglass_work, 8 * expected * dt / 2, 1e-18);
  // Viscous: r / 4 ρ c V^(2/3) q, for as long as it moves.
  OneSolid viscous(elastic_solid(0.3, HourglassKind::viscous), brick_forces, unit_cube);
  const double damping = 0.1 / 4 * std::sqrt(viscous.properties.material.wave_modulus()) * 8;
  EXPECT_NEAR(viscous.step(corners, dt).force[1].x(), damping, 1e-6);
  EXPECT_EQ(viscous.step(at_rest(unit_cube), dt).force[1].norm(), 0);
}

// The energy of the modes depends on positions alone: no force in a brick that is turned and uniformly deformed, and
// the forces are the slopes of the energy.
TEST(Solid, HourglassStiffnessHasAnEnergy) {
  Random random(11);
  for (int i = 0; i < 10; ++i) {
    const Corners start = random.shape(brick_forces, 0.2);
    OneSolid solid(elastic_solid(), brick_forces, start);
    const HourglassReference& reference = *solid.state.reference;
    const auto energy = [&](const Corners& x) {
      double sum = 0;
      for (const auto& shape : reference.shapes) {
        Vector amplitude = Vector::Zero();
        for (std::size_t a = 0; a < 8; ++a) amplitude += shape[a] * x[a];
        sum += reference.stiffness / 2 * amplitude.squaredNorm();
      }
      return sum;
    };
    const Matrix turn = Eigen::AngleAxisd(2.1, random.vector(1).normalized()).toRotationMatrix();
    const Matrix strain = Matrix::Identity() + 0.2 * Matrix(random.vector(1).asDiagonal());
    Corners x = start;
    for (Vector& corner : x) corner = turn * strain * corner + Vector(3, -2, 1);
    EXPECT_NEAR(energy(x), 0, 1e-24 * reference.stiffness);
    for (Vector& corner : x) corner += random.vector(0.1);
    const SolidForces forces = solid.step(at_rest(x), 0);
    Vector sum = Vector::Zero(), moment = Vector::Zero();
    for (std::size_t a = 0; a < 8; ++a) {
      sum += forces.force[a];
      moment += x[a].cross(forces.force[a]);
      for (int axis = 0; axis < 3; ++axis) {
        Corners up = x, down = x;
        up[a][axis] += 1e-4;
        down[a][axis] -= 1e-4;
        EXPECT_NEAR(forces.force[a][axis], (energy(up) - energy(down)) / 2e-4, 1e-9 * reference.stiffness);
      }
    }
    EXPECT_LT(sum.norm() + moment.norm(), 1e-12 * reference.stiffness);
    EXPECT_NEAR(forces.hourglass_work, energy(x), 1e-12 * energy(x));
    EXPECT_GT(energy(x), 0);
  }
}

TEST(Solid, BulkViscosity) {
  SolidProperties properties = elastic_solid();
  properties.quadratic_viscosity = 1.5;
  properties.linear_viscosity = 0.06;
  const BulkViscosity q = bulk_viscosity(properties, 2, 10, 0.5, -4);
  EXPECT_DOUBLE_EQ(q.pressure, 2 * 0.5 * (1.5 * 0.5 * 16 + 0.06 * 10 * 4));
  EXPECT_DOUBLE_EQ(q.step_speed, 0.06 * 10 + 1.5 * 0.5 * 4);
  EXPECT_EQ(bulk_viscosity(properties, 2, 10, 0.5, 4).pressure, 0);
  EXPECT_DOUBLE_EQ(bulk_viscosity(properties, 2, 10, 0.5, 4).step_speed, q.step_speed);  // no toggle
}

TEST(Solid, TurnedInsideOutIsTold) {
  Corners x = unit_cube;
  std::swap(x[0], x[4]);
  std::swap(x[1], x[5]);
  std::swap(x[2], x[6]);
  std::swap(x[3], x[7]);
  OneSolid solid(elastic_solid(), brick_forces, unit_cube);
  EXPECT_FALSE(solid.step(at_rest(x), 0).good);
  Corners broken = unit_cube;
  broken[3].x() = NAN;
  EXPECT_FALSE(solid.step(at_rest(broken), 0).good);
}

SolidProperties rubber_solid(double nu) {
  constexpr double a = 60, b = 20;
  SolidProperties properties = elastic_solid(nu, HourglassKind::none);
  properties.material = {MaterialKind::rubber, 1, 4 * (a + b) * (1 + nu), nu, {}, 0, 0, 0};
  properties.material.rubber = mooney_rivlin(a, b, nu);
  return properties;
}

OneSolid undeformed_rubber(Kernel kernel, const Corners& x, double nu) {
  OneSolid solid(rubber_solid(nu), kernel, x);
  solid.state.mass = kernel == brick_forces ? one_point_volume(x) : tetrahedron_volume(x);
  solid.state.undeformed =
      std::make_shared<Matrix>((kernel == brick_forces ? brick_axes(x) : tetrahedron_axes(x)).inverse());
  return solid;
}

// The forces of rubber are the slopes of W V₀ with W at the centre, however far it is deformed; a turn changes nothing.
TEST(Solid, RubberHasAnEnergy) {
  Random random(23);
  for (const Kernel kernel : {brick_forces, tetrahedron_forces})
    for (int trial = 0; trial < 10; ++trial) {
      const Corners start = random.shape(kernel, 0.2);
      OneSolid solid = undeformed_rubber(kernel, start, 0.45);
      EXPECT_NEAR(solid.step(at_rest(start), 0).force[0].norm(), 0, 1e-11);
      Corners x = start;
      const Matrix turn = spin_rotation(random.vector(2));
      for (Vector& corner : x)
        corner = turn * (Matrix(Vector(1.3, 0.8, 1.1).asDiagonal()) * corner + random.vector(0.1));
      if (kernel == tetrahedron_forces) x[4] = x[5] = x[6] = x[7] = x[3];
      const SolidForces forces = solid.step(at_rest(x), 0);
      ASSERT_TRUE(forces.good);
      const auto energy = [&](const Corners& at) {
        OneSolid copy = undeformed_rubber(kernel, start, 0.45);
        const double volume = copy.step(at_rest(at), 0).volume;
        return stored_energy(copy.properties, copy.state, volume, copy.point);
      };
      constexpr double h = 1e-5;
      for (std::size_t corner = 0; corner < (kernel == brick_forces ? 8u : 4u); ++corner)
        for (int axis = 0; axis < 3; ++axis) {
          Corners up = x, down = x;
          up[corner][axis] += h;
          down[corner][axis] -= h;
          EXPECT_NEAR(forces.force[corner][axis], (energy(up) - energy(down)) / (2 * h), 1e-5) << corner << axis;
        }
      Corners turned = x;
      for (Vector& corner : turned) corner = turn * corner;
      EXPECT_NEAR(energy(turned), energy(x), 1e-9 * energy(x));
    }
}

// The first step of rubber as LS-DYNA prints it: L / (Q + √(Q² + c²)) with c² = K / ρ and Q = 0.06 c, a 1.0618th of L /
// c.
TEST(Solid, FirstStepOfRubber) {
  OneSolid solid = undeformed_rubber(brick_forces, unit_cube, 0.495);
  solid.properties.quadratic_viscosity = 1.5;
  solid.properties.linear_viscosity = 0.06;
  const SolidForces forces = solid.step(at_rest(unit_cube), 0);
  const double bulk = 4 * 80 * 1.495 / (3 * (1 - 2 * 0.495));
  EXPECT_NEAR(forces.manual_step, 1 / std::sqrt(bulk) / 1.0618, 1e-5 * forces.manual_step);
}

// Bricks with a face that is not a parallelogram: the mass is that of 8 det ∂x/∂ξ, which is less for a pyramid's
// frustum.
TEST(Solid, OnePointVolume) {
  EXPECT_NEAR(one_point_volume(unit_cube), 1, 1e-15);
  Corners frustum = unit_cube;
  for (std::size_t k = 4; k < 8; ++k) frustum[k] = Vector(0.5, 0.5, 1) + 0.5 * (unit_cube[k] - Vector(0.5, 0.5, 1));
  EXPECT_NEAR(brick_volume(frustum), 7.0 / 12, 1e-15);
  EXPECT_NEAR(one_point_volume(frustum), 9.0 / 16, 1e-15);
}

}  // namespace
}  // namespace gapcheck::solver::solid_test
