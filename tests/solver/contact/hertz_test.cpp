// An elastic ball pressed against a rigid plate: F = 4/3 E* √R δ^1.5 (Hertz 1881).
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::hertz_test {
namespace {

constexpr double poisson = 0.3, reach = 0.06;  // E = ρ = R = 1; how far the ball is pressed

/// An eighth of a ball of n³ bricks, fine at its pole on the z axis; node ids from 1, x fastest.
std::string eighth_of_a_ball(int n, double grading) {
  std::string text = "*NODE\n";
  const auto fine_at_zero = [&](int i) { return std::pow(static_cast<double>(i) / n, grading); };
  for (int k = 0, id = 1; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i, ++id) {
        // From the cube to the ball: its surface wholly, its middle not at all.
        const Vector cube(fine_at_zero(i), fine_at_zero(j), 1 - fine_at_zero(n - k));
        const double most = cube.maxCoeff(), norm = cube.norm();
        const Vector x = norm > 0 ? Vector(cube * (1 - most + most * most / norm)) : cube;
        // Faces of symmetry: TC holds x, y or both.
        const int code = (i == 0 ? 1 : 0) + (j == 0 ? 2 : 0), held = code == 3 ? 4 : code;
        text += fmt::format("{},{:.17g},{:.17g},{:.17g},{}\n", id, x.x(), x.y(), x.z(), held);
      }
  text += "*ELEMENT_SOLID\n";
  const int row = n + 1, layer = row * row;
  for (int k = 0, id = 1; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i, ++id) {
        const int a = 1 + i + j * row + k * layer;
        text += fmt::format("{},1,{},{},{},{},{},{},{},{}\n", id, a, a + 1, a + 1 + row, a + row, a + layer,
                            a + 1 + layer, a + 1 + row + layer, a + row + layer);
      }
  return text + fmt::format("*SET_NODE_LIST_GENERATE\n1\n1,{}\n", layer);
}

/// A ball on a rigid plate under this contact; `name`: of the properties that are recorded.
void press_ball(const std::string& contact, const std::string& name, double exponent_error) {
  constexpr double end = 8, speed = reach / end;
  RunScene scene(
      eighth_of_a_ball(9, 1.5) +
      "*NODE\n90001,-0.5,-0.5,1.05\n90002,1.,-0.5,1.05\n90003,1.,1.,1.05\n90004,-0.5,1.,1.05\n"
      "*ELEMENT_SHELL\n90001,2,90001,90004,90003,90002\n*PART\nball\n1,1,1\n*PART\nplate\n2,2,2\n*SECTION_SOLID\n1,1\n"
      "*SECTION_SHELL\n2,2\n0.1\n" +
      fmt::format("*MAT_ELASTIC\n1,1.,1.,{}\n*MAT_RIGID\n2,1.,1000.,0.3\n1.,7.,7.\n", poisson) +
      fmt::format("*INITIAL_VELOCITY_GENERATION\n1,2,0.,0.,0.,{0}\n0.,0.,0.,0.,0.,1.\n"
                  "*BOUNDARY_PRESCRIBED_MOTION_SET\n1,3,0,1\n*DEFINE_CURVE\n1\n0.,{0}\n1000.,{0}\n",
                  speed) +
      fmt::format("*CONTROL_TERMINATION\n{}\n*CONTROL_TIMESTEP\n0.,0.4\n", end) + contact);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const double constant = 4.0 / 3 / (1 - poisson * poisson);
  double x = 0, y = 0, xx = 0, xy = 0, count = 0, ratio = 0, deepest = 0;
  scene.go([&](const solver::Run& run) {
    for (const ContactNode& node : run.contacts()[0].nodes()) deepest = std::max(deepest, node.penetration);
    const double approach = speed * run.stepper().state().time;
    const double force = 4 * run.contacts()[0].state().force_b.z();
    if (approach < 0.4 * reach || force <= 0) return;
    const double a = std::log(approach), b = std::log(force);
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
    count += 1;
    ratio += force / (constant * std::pow(approach, 1.5));
  });
  ASSERT_GT(count, 100);
  const double exponent = (count * xy - x * y) / (count * xx - x * x);
  EXPECT_NEAR(exponent, 1.5, exponent_error);
  EXPECT_NEAR(ratio / count, 1, 0.12);
  EXPECT_LT(deepest, 0.08 * reach) << "the penalty is stiff beside the ball";
  testing::Test::RecordProperty(name + "_exponent", fmt::format("{:.3f}", exponent));
  testing::Test::RecordProperty(name + "_constant_ratio", fmt::format("{:.3f}", ratio / count));
}

TEST(Hertz, BallOnARigidPlate) {
  press_ball("*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n1,2,3,3\n0.\n40.,40.\n0\n0.,0,0,1\n", "hertz", 0.12);
}

// The pressure begins with its square: a little softer at first.
TEST(Hertz, BallOnARigidPlateByMortar) {
  press_ball("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n1,2,3,3\n0.\n40.,40.\n", "hertz_mortar", 0.15);
}

}  // namespace
}  // namespace gapcheck::solver::hertz_test
