// INN of *CONTROL_ACCURACY: results of quads that do not depend on which corner comes first.
#include <gtest/gtest.h>

#include <random>

#include "solver/element/shell_stiffness.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::shell_axes_test {
namespace {

constexpr double young = 1000, poisson = 0.3, thickness = 0.2;

class Quads {
 public:
  std::array<Vector, 4> next() {
    std::array<Vector, 4> x{Vector(0, 0, 0), {1.4, 0, 0}, {1.4, 1, 0}, {0, 1, 0}};
    for (Vector& corner : x) corner += 0.2 * vector();
    return x;
  }
  Vector vector() { return {number_(random_), number_(random_), number_(random_)}; }

 private:
  std::mt19937 random_{3};
  std::uniform_real_distribution<double> number_{-1, 1};
};

template <class T>
std::array<T, 4> from(const std::array<T, 4>& corners, std::size_t first) {
  std::array<T, 4> turned;
  for (std::size_t i = 0; i < 4; ++i) turned[i] = corners[(i + first) % 4];
  return turned;
}

// The second corner first: x becomes y, y becomes −x.
TEST(ShellAxes, TurnByARightAngle) {
  Quads quads;
  for (int trial = 0; trial < 50; ++trial) {
    const std::array<Vector, 4> x = quads.next();
    for (const auto axes_of : {quad_axes, full_axes}) {
      const Matrix a = axes_of(x, ShellAxes::invariant), b = axes_of(from(x, 1), ShellAxes::invariant);
      EXPECT_NEAR((b.col(0) - a.col(1)).norm(), 0, 1e-14);
      EXPECT_NEAR((b.col(1) + a.col(0)).norm(), 0, 1e-14);
      EXPECT_NEAR((a.transpose() * a - Matrix::Identity()).norm(), 0, 1e-14);
    }
  }
}

// Along the sides of a rectangle; half way between what both sides of a parallelogram ask for.
TEST(ShellAxes, OfARectangleAndAParallelogram) {
  const auto first = [](double shear) {
    const std::array<Vector, 4> x{Vector(0, 0, 0), {3, 0, 0}, {3 + shear, 1, 0}, {shear, 1, 0}};
    return Vector(quad_axes(x, ShellAxes::invariant).col(0));
  };
  EXPECT_NEAR((first(0) - Vector(1, 0, 0)).norm(), 0, 1e-14);
  const double angle = -std::atan(0.5) / 2;
  EXPECT_NEAR((first(0.5) - Vector(std::cos(angle), std::sin(angle), 0)).norm(), 0, 1e-14);
}

/// A quad that is sheared, stretched and bent far beyond yield, its corners from `first` on; forces on corner 0 and the
/// others, in the order of the first numbering.
std::array<Vector, 8> forces_after(ShellProperties properties, ShellKernel kernel, std::size_t first) {
  Quads quads;
  std::array<Vector, 4> x = quads.next(), v, w;
  for (std::size_t i = 0; i < 4; ++i) {
    v[i] = quads.vector() + Vector(x[i].y(), 0, 0);
    w[i] = quads.vector();
  }
  OneShell shell(std::move(properties), thickness, kernel);
  ShellForces forces;
  for (int step = 0; step < 100; ++step) {
    for (std::size_t i = 0; i < 4; ++i) x[i] += 2e-3 * v[i];
    forces = shell.step({from(x, first), from(v, first), from(w, first)}, 2e-3);
  }
  EXPECT_TRUE(forces.good);
  std::array<Vector, 8> result;
  for (std::size_t i = 0; i < 4; ++i) {
    result[(i + first) % 4] = forces.force[i];
    result[4 + (i + first) % 4] = forces.moment[i];
  }
  return result;
}

double difference(const ShellProperties& properties, ShellKernel kernel, std::size_t first) {
  const std::array<Vector, 8> a = forces_after(properties, kernel, 0), b = forces_after(properties, kernel, first);
  double largest = 0, size = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    largest = std::max(largest, (a[i] - b[i]).norm());
    size = std::max(size, a[i].norm());
  }
  return largest / size;
}

TEST(ShellAxes, AllOrdersOfTheCornersGiveTheSameForces) {
  for (const Material& material : {elastic_material(young, poisson), plastic_kinematic(1, young, poisson, 2, 100, 0),
                                   plastic_kinematic(1, young, poisson, 2, 100, 1)})
    for (const ShellKernel kernel : {quad_forces, warped_quad_forces, full_forces}) {
      ShellProperties properties;
      properties.material = material;
      properties.layers = gauss_rule(3);
      properties.thins = true;
      properties.form = kernel == full_forces ? ShellForm::full : ShellForm::one_point;
      properties.projection = kernel == warped_quad_forces ? ShellProjection::full : ShellProjection::none;
      if (kernel == full_forces) properties.hourglass.kind = HourglassKind::none;
      properties.axes = ShellAxes::invariant;
      for (std::size_t first = 1; first < 4; ++first) EXPECT_LT(difference(properties, kernel, first), 1e-12);
      properties.axes = ShellAxes::side;
      EXPECT_GT(difference(properties, kernel, 1), 1e-4);
    }
}

std::string plate(int inn, int elform, std::size_t first) {
  std::string text = fmt::format("*CONTROL_ACCURACY\n0,{}\n", inn) + grid_nodes(4, 3, 0, Vector(5, 5, 1));
  text += fmt::format("*PART\np\n1,1,1\n*SECTION_SHELL\n1,{},1,3\n1\n*MAT_PLASTIC_KINEMATIC\n1,7.85e-6,210,.3,.2,1\n\n",
                      elform);
  text += "*ELEMENT_SHELL\n";
  for (int j = 0, id = 1; j < 3; ++j)
    for (int i = 0; i < 4; ++i, ++id) {
      const int n = 1 + i + 5 * j;
      const std::array<int, 4> c =
          from(std::array<int, 4>{n, n + 1, n + 6, n + 5}, (first + static_cast<std::size_t>(id)) % 4);
      text += fmt::format("{},1,{},{},{},{}\n", id, c[0], c[1], c[2], c[3]);
    }
  return text;
}

/// Largest difference of two runs of a plate that yields, whose shells begin with other corners, over 300 cycles.
double difference_of_runs(int inn, int elform) {
  std::vector<std::vector<Vector>> x;
  for (const std::size_t first : {0u, 1u}) {
    Structure structure = structure_of(plate(inn, elform, first) + "*END\n");
    structure.state.v[10] = {10, 30, 5};
    structure.state.v[19] = {-20, 10, -60};
    structure.state.v[4] = {10, 10, 40};
    Stepper stepper(std::move(structure), {});
    for (int cycle = 0; cycle < 300; ++cycle) EXPECT_TRUE(stepper.step().ok());
    x.push_back(stepper.state().x);
  }
  double largest = 0;
  for (std::size_t i = 0; i < x[0].size(); ++i) largest = std::max(largest, (x[0][i] - x[1][i]).norm());
  return largest;
}

TEST(ShellAxes, RunsOfOtherOrders) {
  for (const int elform : {2, 10, 16})
    for (const int inn : {2, 4, -2}) EXPECT_LT(difference_of_runs(inn, elform), 1e-11) << elform;
  EXPECT_GT(difference_of_runs(1, 2), 1e-6);
}

}  // namespace
}  // namespace gapcheck::solver::shell_axes_test
