// What shells have through their thickness: plies of different materials (laminate theory), nodes off the mid-surface,
// thinning, bulk viscosity, Lobatto points.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numeric>
#include <random>

#include "solver/element/shell_strip.hpp"

namespace gapcheck::solver::shell_layers_test {
namespace {

constexpr double thickness = 0.4;

struct Ply {
  double young, poisson, share;
};

const std::vector<Ply> plies{{1000, 0.3, 0.25}, {100, 0.1, 0.5}, {3000, 0.2, 0.25}};

ShellProperties laminate(const std::vector<Ply>& all, double reference = 0) {
  ShellProperties properties;
  properties.layers.clear();
  properties.reference = reference;
  properties.shear_factor = 5.0 / 6;
  properties.hourglass.kind = HourglassKind::none;
  double below = 0, modulus = 0, largest = 0;
  for (const Ply& ply : all) {
    properties.layers.push_back({2 * (below + ply.share / 2) - 1, 2 * ply.share});
    properties.layer_materials.push_back(elastic_material(ply.young, ply.poisson));
    modulus += ply.share * properties.layer_materials.back().plate_modulus();
    largest = std::max(largest, properties.layer_materials.back().plate_modulus() * 1.3);
    below += ply.share;
  }
  properties.material = elastic_material(modulus * (1 - 0.2 * 0.2), 0.2);
  properties.stiffest = largest / modulus;
  return properties;
}

/// A, B and D of the plies' plane stress matrices, with the points in the middle of the plies, about the nodes.
std::array<Eigen::Matrix3d, 3> stiffness_of(const std::vector<Ply>& all, double reference) {
  std::array<Eigen::Matrix3d, 3> abd;
  abd.fill(Eigen::Matrix3d::Zero());
  double below = 0;
  for (const Ply& ply : all) {
    Eigen::Matrix3d q;
    q << 1, ply.poisson, 0, ply.poisson, 1, 0, 0, 0, (1 - ply.poisson) / 2;
    q *= ply.young / (1 - ply.poisson * ply.poisson);
    const double z = thickness * (below + ply.share / 2 - 0.5 - reference / 2);
    for (std::size_t power = 0; power < 3; ++power)
      abd[power] += q * ply.share * thickness * std::pow(z, static_cast<double>(power));
    below += ply.share;
  }
  return abd;
}

TEST(ShellLayers, LaminateTheory) {
  for (const double reference : {0.0, 1.0, -0.6}) {
    const auto abd = stiffness_of(plies, reference);
    const ShellProperties properties = laminate(plies, reference);
    for (int column = 0; column < 6; ++column) {
      Eigen::Matrix<double, 6, 1> unit = Eigen::Matrix<double, 6, 1>::Zero();
      unit[column] = 1e-4;
      ShellStrain strain;
      strain.xx = unit[0];
      strain.yy = unit[1];
      strain.xy = unit[2] / 2;
      strain.bend_xx = unit[3];
      strain.bend_yy = unit[4];
      strain.bend_xy = unit[5] / 2;
      std::vector<PointState> points(plies.size());
      double t = thickness;
      const ShellResultants n = integrate_layers(properties, strain, 1, t, points);
      const Eigen::Vector3d membrane = abd[0] * unit.head<3>() + abd[1] * unit.tail<3>(),
                            bending = abd[1] * unit.head<3>() + abd[2] * unit.tail<3>();
      EXPECT_LT((Eigen::Vector3d(n.xx, n.yy, n.xy) - membrane).norm(), 1e-12 * abd[0].norm() * 1e-4 + 1e-15);
      EXPECT_LT((Eigen::Vector3d(n.bend_xx, n.bend_yy, n.bend_xy) - bending).norm(), 1e-12 * abd[0].norm() * 1e-4);
    }
  }
}

// A strip bends about its own neutral line wherever its nodes are: P L³ / 3 E I, here without Poisson's ratio.
TEST(ShellLayers, CantileverWithNodesOnASurface) {
  const auto tip = [](double reference, ShellKernel kernel) {
    Strip strip = straight(10, 10, 1, thickness);
    strip.kernel = kernel;
    strip.properties.reference = reference;
    strip.properties.hourglass = {HourglassKind::stiffness, 1e-3, 1e-3, 1e-3};
    return strip.tip({0, 0, 1});
  };
  for (const ShellKernel kernel : {quad_forces, full_forces})
    for (const double reference : {1.0, -1.0}) {
      const double ratio = tip(reference, kernel) / tip(0, kernel);
      EXPECT_NEAR(ratio, 1, 1e-3);
      testing::Test::RecordProperty(kernel == quad_forces ? "offset_one_point" : "offset_full",
                                    fmt::format("{:.6f}", ratio));
    }
}

TEST(ShellLayers, StableStepOfPliesAndReferences) {
  const std::array<Vector, 4> x{Vector(0, 0, 0), {1, 0.1, 0}, {1.1, 0.9, 0}, {-0.1, 1, 0}};
  for (const double reference : {0.0, 1.0, 3.0})
    for (const double h : {0.02, 0.4})
      for (const ShellKernel kernel : {quad_forces, full_forces}) {
        const ShellProperties properties = laminate(plies, reference);
        OneShell shell(properties, h, kernel);
        const double share = shell_area(x) * h / 4, inertia = share * properties.inertia(shell_area(x), h);
        Eigen::VectorXd root(24);
        for (int i = 0; i < 24; ++i) root[i] = 1 / std::sqrt(i % 6 < 3 ? share : inertia);
        const Eigen::MatrixXd k = shell_stiffness(shell, x);
        EXPECT_LT((k - k.transpose()).norm(), 1e-5 * k.norm());
        const Eigen::MatrixXd scaled = root.asDiagonal() * (k + k.transpose()) / 2 * root.asDiagonal();
        const double highest = std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues()[23]);
        EXPECT_LE(shell.step(at_rest(x), 0).stable_step, 2 / highest * (1 + 1e-5)) << reference << h;
      }
}

TEST(ShellLayers, StoredEnergyIsThatOfEachPly) {
  const ShellProperties properties = laminate(plies);
  std::vector<PointState> points(plies.size());
  ShellStrain strain;
  strain.xx = 1e-3;
  double t = thickness;
  const ShellResultants n = integrate_layers(properties, strain, 1, t, points);
  ShellState state;
  state.thickness = thickness;
  EXPECT_NEAR(stored_energy(properties, state, 2, points), 2 * n.xx * strain.xx / 2, 1e-12 * n.xx);
}

/// What one step of the resultants does per area.
double work_of(const ShellResultants& n, const ShellStrain& e) {
  return n.xx * e.xx + n.yy * e.yy + 2 * n.xy * e.xy + n.bend_xx * e.bend_xx + n.bend_yy * e.bend_yy +
         2 * n.bend_xy * e.bend_xy + 2 * n.yz * e.yz + 2 * n.zx * e.zx;
}

// Whatever SHRF is, the work of the resultants is what the layers store and dissipate.
TEST(ShellLayers, ShearFactorOfPlasticWork) {
  Material damaged = plastic_kinematic(1, 1000, 0.3, 1, 100, 1), viscous = elastic_material(1000, 0.3);
  damaged.softening = 0.002;
  damaged.rupture = 0.1;
  viscous.kind = MaterialKind::viscoelastic;
  viscous.viscoelastic = Viscoelastic{};
  viscous.viscoelastic->bulk = 800;
  viscous.viscoelastic->long_shear = 100;
  viscous.viscoelastic->relaxing_shear = 280;
  viscous.viscoelastic->decay = 3;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(-1e-3, 1e-3);
  for (const Material& material :
       {plastic_kinematic(1, 1000, 0.3, 1, 100, 1), plastic_kinematic(1, 1000, 0.3, 1, 100, 0), damaged, viscous})
    for (const double factor : {1.0, 5.0 / 6, 0.3}) {
      ShellProperties properties;
      properties.material = material;
      properties.layers = gauss_rule(3);
      properties.shear_factor = factor;
      ShellState state;
      state.thickness = thickness;
      std::vector<PointState> points(3);
      ShellResultants last;
      double work = 0, dissipated = 0;
      for (int step = 0; step < 50; ++step) {
        ShellStrain e;
        for (double* component : {&e.xx, &e.yy, &e.xy, &e.yz, &e.zx}) *component = number(random);
        for (double* component : {&e.bend_xx, &e.bend_yy, &e.bend_xy}) *component = number(random) / thickness;
        const ShellResultants n = integrate_layers(properties, e, 0.01, state.thickness, points);
        work += (work_of(last, e) + work_of(n, e)) / 2;
        dissipated += n.plastic_work;
        last = n;
      }
      EXPECT_GT(dissipated, 0.2 * work);
      // Damage that grows in a step is taken at its middle.
      const double tolerance = material.rupture > 0 ? 5e-3 : 1e-8;
      EXPECT_NEAR((stored_energy(properties, state, 1, points) + dissipated) / work, 1, tolerance) << factor;
    }
}

// ISTUPD = 4: elastic strain does not thin, plastic flow does: by its own volume.
TEST(ShellLayers, ThinningByFlowAlone) {
  const auto thickness_after = [](double strain, bool by_flow) {
    ShellProperties properties;
    properties.material = plastic_kinematic(1, 1000, 0.3, 1, 0, 0);
    properties.thins = true;
    properties.thins_by_flow = by_flow;
    std::vector<PointState> points(2);
    double t = 1;
    for (int step = 0; step < 100; ++step) {
      ShellStrain increment;
      increment.xx = increment.yy = strain / 100;
      static_cast<void>(integrate_layers(properties, increment, 1, t, points));
    }
    return t;
  };
  constexpr double elastic = 5e-4;  // below 0.7e-3, where σ = E ε / (1 − ν) reaches 1
  EXPECT_EQ(thickness_after(elastic, true), 1);
  EXPECT_NEAR(std::log(thickness_after(elastic, false)), -2 * 0.3 / 0.7 * elastic, 1e-9);
  // Beyond it: −2 (ε − σ (1 − ν) / E), all of it flow.
  constexpr double whole = 0.1;
  EXPECT_NEAR(std::log(thickness_after(whole, true)), -2 * (whole - 0.7e-3), 1e-6);
  EXPECT_NEAR(std::log(thickness_after(whole, false)), -2 * (whole - 0.7e-3) - 2 * 0.3 / 1000, 1e-6);
}

ShellCorners square_at_rate(double rate) {
  ShellCorners corners = at_rest({Vector(-1, -1, 0), {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  for (std::size_t i = 0; i < 4; ++i) corners.v[i] = rate / 2 * corners.x[i];
  return corners;
}

// q = ρ l (Q1 l ε̇² + Q2 c |ε̇|) in compression, l = √A; with TYPE −1 its work is not in the printed energy.
TEST(ShellLayers, BulkViscosity) {
  constexpr double density = 2, young = 1000, dt = 1e-6, rate = -30, length = 2;
  for (const ShellKernel kernel : {quad_forces, warped_quad_forces, full_forces})
    for (const bool in_energy : {false, true}) {
      ShellProperties properties;
      properties.material = elastic_material(young, 0.3, density);
      properties.projection = kernel == warped_quad_forces ? ShellProjection::full : ShellProjection::none;
      const ShellForces without = OneShell(properties, thickness, kernel).step(square_at_rate(rate), dt);
      properties.viscosity = {1.5, 0.06, in_energy};
      OneShell shell(properties, thickness, kernel);
      const ShellForces with = shell.step(square_at_rate(rate), dt);
      const double c = std::sqrt(young / 0.91 / density),
                   pressure = density * length * (1.5 * length * rate * rate - 0.06 * c * rate);
      EXPECT_NEAR(shell.state.viscous_pressure, pressure, 1e-4 * pressure);
      EXPECT_NEAR(with.force[2].x() - without.force[2].x(), -pressure * thickness * length / 2, 1e-4 * pressure);
      const double work = -length * length * thickness * rate * dt * pressure / 2;
      EXPECT_NEAR(with.dissipated, work, 1e-4 * work);
      EXPECT_EQ(with.viscous_work, in_energy ? 0 : with.dissipated);
      EXPECT_LT(with.stable_step, without.stable_step);
      EXPECT_EQ(with.manual_step, without.manual_step);
      OneShell grows(properties, thickness, kernel);
      grows.step(square_at_rate(-rate), dt);
      EXPECT_EQ(grows.state.viscous_pressure, 0);
    }
}

TEST(Lobatto, ExactToItsDegree) {
  for (int n = 3; n <= 10; ++n) {
    const std::vector<GaussPoint> rule = lobatto_rule(n);
    EXPECT_EQ(rule.front().place, -1);
    EXPECT_EQ(rule.back().place, 1);
    for (int degree = 0; degree < 2 * n - 2; ++degree) {
      double sum = 0;
      for (const GaussPoint& point : rule) sum += point.weight * std::pow(point.place, degree);
      EXPECT_NEAR(sum, degree % 2 == 0 ? 2.0 / (degree + 1) : 0, 2e-14) << n << " " << degree;
    }
  }
  EXPECT_EQ(lobatto_rule(2)[0].place, gauss_rule(2)[0].place);
}

}  // namespace
}  // namespace gapcheck::solver::shell_layers_test
