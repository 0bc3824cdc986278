// Free vibrations against closed forms: orders of convergence in the mesh and in the time step.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "solver/step.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::vibration_test {
namespace {

constexpr double pi = std::numbers::pi;
const std::string no_viscosity = "*CONTROL_BULK_VISCOSITY\n1e-30,1e-30\n";

void expect_good(const SolverStatus& status) { ASSERT_TRUE(status.ok()) << status.error().message; }

/// Frequency of a node that starts from where it is at rest: from the time at which it comes back.
double frequency_of(Structure structure, std::size_t node, int axis, double factor) {
  const double start = structure.state.x[node][axis];
  StepSettings settings;
  settings.time_step_factor = factor;
  Stepper stepper(std::move(structure), settings);
  double before = 0;
  for (int i = 0; i < 200000; ++i) {
    if (const SolverStatus status = stepper.step(); !status.ok()) {
      ADD_FAILURE() << status.error().message;
      return 0;
    }
    const double now = stepper.state().x[node][axis] - start;
    if (i > 5 && now <= 0) return pi / (stepper.state().time - stepper.state().dt * now / (now - before));
    before = now;
  }
  ADD_FAILURE() << "it does not come back";
  return 0;
}

/// Errors of three meshes, each twice as fine as the one before, and the order from the last two.
struct Convergence {
  std::array<double, 3> error{};
  [[nodiscard]] double order() const { return std::log2(std::abs(error[1] / error[2])); }
  void record(const std::string& name) const {
    for (std::size_t i = 0; i < 3; ++i)
      testing::Test::RecordProperty(fmt::format("{}_error_{}", name, i + 1), fmt::format("{:.2e}", error[i]));
    testing::Test::RecordProperty(name + "_order", fmt::format("{:.2f}", order()));
  }
};

/// Lowest squared frequency of w and the divergence of the rotations of a Mindlin plate (Timoshenko beam) for a sine of
/// squared wave number `lambda`: stiffness in bending and shear, mass and inertia.
double mindlin_frequency(double lambda, double bending, double shear, double mass, double inertia) {
  const double a = shear * lambda / mass, b = shear / mass, c = shear * lambda / inertia,
               d = (bending * lambda + shear) / inertia;
  const double half = (a + d) / 2;
  return std::sqrt(half - std::sqrt(half * half - (a * d - b * c)));
}

constexpr double poisson = 0.3, thickness = 0.02;
constexpr double amplitude = 1e-6;  // of the velocity: small, as a plate that is held all around stiffens as it bends

/// The square plate of side 1, simply supported, thrown in its first mode; E = ρ = 1.
double plate_frequency(int n, int elform) {
  const bool triangles = elform == 4;
  std::string deck = grid_nodes(n, n, 0, {1.0 / n, 1.0 / n, 0}) + "*ELEMENT_SHELL\n";
  for (int j = 0, id = 1; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = 1 + i + j * (n + 1), b = a + 1, c = a + n + 2, d = a + n + 1;
      if (triangles) {
        deck += fmt::format("{},1,{},{},{},{}\n", id++, a, b, c, c);
        deck += fmt::format("{},1,{},{},{},{}\n", id++, a, c, d, d);
      } else {
        deck += fmt::format("{},1,{},{},{},{}\n", id++, a, b, c, d);
      }
    }
  Structure plate = structure_of(
      deck + elastic_deck(fmt::format("*SECTION_SHELL\n1,{},0.8333333333,2\n{}\n", elform, thickness), 1, poisson, 1),
      {{HourglassKind::stiffness, 0.02, 0.02, 5e-4}, {}});  // the mode bends: QW must not resist it
  for (std::uint32_t k = 0; k < plate.state.x.size(); ++k) {
    const double x = plate.state.x[k].x(), y = plate.state.x[k].y();
    const int i = static_cast<int>(k) % (n + 1), j = static_cast<int>(k) / (n + 1);
    plate.state.v[k].z() = amplitude * std::sin(pi * x) * std::sin(pi * y);
    plate.state.w[k] =
        amplitude * pi * Vector(std::sin(pi * x) * std::cos(pi * y), -std::cos(pi * x) * std::sin(pi * y), 0);
    unsigned held = 1u | 2u | 32u;
    if (i == 0 || i == n) held |= 4u | 8u;
    if (j == 0 || j == n) held |= 4u | 16u;
    plate.constraints.hold(NodeIndex{k}, static_cast<std::uint8_t>(held));
  }
  return frequency_of(std::move(plate), static_cast<std::size_t>(n / 2 * (n + 1) + n / 2), 2, 0.9);
}

double exact_plate() {
  const double shear = 5.0 / 6 / (2 * (1 + poisson)) * thickness;
  return mindlin_frequency(2 * pi * pi, std::pow(thickness, 3) / 12 / (1 - poisson * poisson), shear, thickness,
                           std::pow(thickness, 3) / 12);
}

TEST(Vibration, ThinPlateFormula) {
  const double kirchhoff = 2 * pi * pi * thickness / std::sqrt(12 * (1 - poisson * poisson));
  EXPECT_NEAR(exact_plate() / kirchhoff, 1, 2e-3);
  EXPECT_LT(exact_plate(), kirchhoff);
}

TEST(Vibration, SimplySupportedPlateOfQuads) {
  Convergence plate;
  for (std::size_t i = 0; i < 3; ++i) plate.error[i] = plate_frequency(6 << i, 2) / exact_plate() - 1;
  EXPECT_LT(std::abs(plate.error[2]), 0.005);
  EXPECT_NEAR(plate.order(), 2, 0.2);
  plate.record("plate_of_quads_6_12_24");
}

TEST(Vibration, SimplySupportedPlateOfFullQuads) {
  Convergence plate;
  for (std::size_t i = 0; i < 3; ++i) plate.error[i] = plate_frequency(6 << i, 16) / exact_plate() - 1;
  EXPECT_LT(std::abs(plate.error[2]), 0.005);
  EXPECT_NEAR(plate.order(), 2, 0.2);
  plate.record("plate_of_full_quads_6_12_24");
}

TEST(Vibration, SimplySupportedPlateOfTriangles) {
  Convergence plate;
  for (std::size_t i = 0; i < 3; ++i) plate.error[i] = plate_frequency(6 << i, 4) / exact_plate() - 1;
  EXPECT_LT(std::abs(plate.error[2]), 0.05);
  EXPECT_GT(plate.order(), 1.4);
  plate.record("plate_of_triangles_6_12_24");
}

// Thin plates: without transverse shear the frequency is 1e-3 above that of Mindlin's.
TEST(Vibration, SimplySupportedPlateOfKirchhoffTriangles) {
  Convergence plate;
  const double thin = pi * pi * thickness / std::sqrt(12 * (1 - poisson * poisson)) * 2;
  for (std::size_t i = 0; i < 3; ++i) plate.error[i] = plate_frequency(6 << i, 17) / thin - 1;
  EXPECT_LT(std::abs(plate.error[2]), 0.02);
  EXPECT_GT(plate.order(), 1.4);
  plate.record("plate_of_kirchhoff_triangles_6_12_24");
}

// A rod of bricks held at one end, at half the stable step: near the stable step the errors of mesh and step cancel.
TEST(Vibration, RodOfBricks) {
  Convergence rod;
  for (std::size_t m = 0; m < 3; ++m) {
    const int n = 5 << m;
    const double h = 10.0 / n;
    Structure bar = structure_of(brick_bar(n, {h, h, h}) + elastic_deck(solid_section, 400, 0, 4) + no_viscosity);
    for (std::uint32_t i = 0; i < bar.state.v.size(); ++i) {
      bar.state.v[i].x() = 1e-4 * std::sin(pi / 2 * bar.state.x[i].x() / 10);
      if (static_cast<int>(i) % (n + 1) == 0) bar.constraints.hold(NodeIndex{i}, 7);
    }
    rod.error[m] = frequency_of(std::move(bar), static_cast<std::size_t>(n), 0, 0.3) / (pi / 2) - 1;
  }
  EXPECT_LT(std::abs(rod.error[2]), 1e-3);
  EXPECT_NEAR(rod.order(), 2, 0.1);
  rod.record("rod_of_bricks_5_10_20");
}

// A beam of n layers of cubes on two supports, ten times as long as high; ν = 0, E = ρ = 1.
TEST(Vibration, BeamOfBricks) {
  constexpr double length = 10;
  const double exact = mindlin_frequency(pi * pi / (length * length), 1.0 / 12, 5.0 / 6 / 2, 1, 1.0 / 12);
  Convergence beam;
  for (std::size_t m = 0; m < 3; ++m) {
    const int layers = 2 << m, n = 10 * layers;
    const double h = 1.0 / layers;
    std::string deck = grid_nodes(n, 1, layers, {h, h, h}) + "*ELEMENT_SOLID\n";
    const int row = n + 1, layer = 2 * row;
    for (int k = 0, id = 1; k < layers; ++k)
      for (int i = 0; i < n; ++i, ++id) {
        const int a = 1 + i + k * layer;
        deck += fmt::format("{},1,{},{},{},{},{},{},{},{}\n", id, a, a + 1, a + 1 + row, a + row, a + layer,
                            a + 1 + layer, a + 1 + row + layer, a + row + layer);
      }
    Structure bar = structure_of(deck + elastic_deck(solid_section, 1, 0, 1) + no_viscosity,
                                 {{}, {HourglassKind::stiffness, 0.005}});
    for (std::uint32_t i = 0; i < bar.state.v.size(); ++i) {
      const Vector x = bar.state.x[i];
      const double k = pi / length;
      bar.state.v[i] = 1e-4 * Vector(-(x.z() - 0.5) * k * std::cos(k * x.x()), 0, std::sin(k * x.x()));
      const int station = static_cast<int>(i) % row;
      bar.constraints.hold(NodeIndex{i}, station == 0 || station == n ? 6 : 2);
    }
    const int middle = n / 2 + layers / 2 * layer;
    beam.error[m] = frequency_of(std::move(bar), static_cast<std::size_t>(middle), 2, 0.9) / exact - 1;
  }
  EXPECT_LT(std::abs(beam.error[2]), 0.01);
  EXPECT_NEAR(beam.order(), 2, 0.3);
  beam.record("beam_of_bricks_2_4_8_layers");
}

/// A strip of shells or bricks whose free vibration starts with a smooth velocity.
Structure free_strip(bool bricks) {
  const std::string mesh = bricks ? brick_bar(6, {0.5, 0.5, 0.5}) : plate(6, 1, {0.5, 0.5, 0});
  Structure strip =
      structure_of(mesh + elastic_deck(bricks ? solid_section : shell_section, 100, 0.3, 1) + no_viscosity,
                   {{HourglassKind::stiffness, 0.05}, {HourglassKind::stiffness, 0.05}});
  for (std::size_t i = 0; i < strip.state.v.size(); ++i) {
    const double x = strip.state.x[i].x();
    strip.state.v[i] = {0.05 * std::cos(pi * x / 3), 0.02 * std::sin(x), 0.3 * std::sin(pi * x / 3)};
  }
  return strip;
}

class TimeStep : public testing::TestWithParam<bool> {};

// Positions at one time with dt, dt/2, dt/4: differences fall with dt².
TEST_P(TimeStep, PositionsAreOfSecondOrder) {
  constexpr double end = 1, coarse = 0.01;
  std::array<std::vector<Vector>, 3> x;
  for (std::size_t i = 0; i < 3; ++i) {
    StepSettings settings;
    settings.greatest_step = coarse / (1 << i);
    Stepper stepper(free_strip(GetParam()), settings);
    const auto steps = static_cast<int>(std::lround(end / settings.greatest_step));
    for (int s = 0; s < steps; ++s) expect_good(stepper.step());
    ASSERT_NEAR(stepper.state().time, end, 1e-12) << "no element asked for a shorter step";
    x[i] = stepper.state().x;
  }
  double first = 0, second = 0;
  for (std::size_t n = 0; n < x[0].size(); ++n) {
    first += (x[0][n] - x[1][n]).squaredNorm();
    second += (x[1][n] - x[2][n]).squaredNorm();
  }
  const double order = std::log2(std::sqrt(first / second));
  EXPECT_NEAR(order, 2, 0.1);
  RecordProperty(fmt::format("positions_over_dt_{}_order", GetParam() ? "bricks" : "shells"),
                 fmt::format("{:.2f}", order));
}

// The sum of energies with v⁻·v⁺ is kept to rounding; with the velocity of the time itself its error falls with dt².
TEST_P(TimeStep, EnergyErrorIsOfSecondOrder) {
  std::array<double, 3> error{};
  for (std::size_t i = 0; i < 3; ++i) {
    StepSettings settings;
    settings.greatest_step = 0.012 / (1 << i);
    Stepper stepper(free_strip(GetParam()), settings);
    std::vector<Vector> before = stepper.state().v, spin = stepper.state().w;
    double start = 0, kept = 0;
    for (int s = 0; s < 200 << i; ++s) {
      expect_good(stepper.begin_step());
      const State& state = stepper.state();
      const std::vector<Vector>& after = state.v;
      double energy = stepper.energies().internal + stepper.energies().hourglass;
      for (std::size_t n = 0; n < after.size(); ++n) {
        energy += state.mass[n] / 8 * (before[n] + after[n]).squaredNorm();
        energy += state.inertia[n] / 8 * (spin[n] + state.w[n]).squaredNorm();
      }
      if (s == 0) start = energy;
      error[i] = std::max(error[i], std::abs(energy / start - 1));
      kept = std::max(kept, std::abs(stepper.energies().ratio() - 1));
      before = after;
      spin = state.w;
      stepper.end_step();
    }
    EXPECT_LT(kept, 1e-10);
  }
  const double order = std::log2(error[1] / error[2]);
  EXPECT_NEAR(order, 2, 0.15);
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2, 0.4);
  RecordProperty(fmt::format("energy_over_dt_{}_order", GetParam() ? "bricks" : "shells"),
                 fmt::format("{:.2f}", order));
}

INSTANTIATE_TEST_SUITE_P(All, TimeStep, testing::Bool(),
                         [](const auto& one) { return std::string(one.param ? "Bricks" : "Shells"); });

}  // namespace
}  // namespace gapcheck::solver::vibration_test
