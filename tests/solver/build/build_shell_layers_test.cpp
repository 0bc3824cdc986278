// Plies of single shells, and points through the thickness that the deck lists.
#include "solver/build/build_shell_layers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "solver/run_scene.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::build_shell_layers_test {
namespace {

constexpr double poisson = 0.3;

/// Two quads side by side; materials 1 (E = 1000, ρ = 2) and 2 (E = 100, ρ = 4), both with ν = 0.3, as parts 1 and 2.
const std::string mesh =
    "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,2.,0.,0.\n6,2.,1.,0.\n*MAT_ELASTIC\n1,2.,1000.,0.3\n"
    "*MAT_ELASTIC\n2,4.,100.,0.3\n*PART\nq\n2,1,2\n";
const std::string part = "*PART\np\n1,1,1\n";
const std::string section = "*SECTION_SHELL\n1,2,0.8333,2\n0.4\n";

/// Membrane and bending stiffness of a shell along x, and what couples them, from its layers.
std::array<double, 3> stiffness(const ShellProperties& properties, double thickness) {
  std::vector<PointState> points(properties.layers.size());
  std::array<double, 3> result{};
  for (const bool bends : {false, true}) {
    std::fill(points.begin(), points.end(), PointState());
    ShellStrain strain;
    (bends ? strain.bend_xx : strain.xx) = 1e-6;
    double t = thickness;
    const ShellResultants n = integrate_layers(properties, strain, 1, t, points);
    if (bends)
      result[2] = n.bend_xx / 1e-6, result[1] = n.xx / 1e-6;
    else
      result[0] = n.xx / 1e-6;
  }
  return result;
}

double mass_of(const Structure& structure) {
  return std::accumulate(structure.state.mass.begin(), structure.state.mass.end(), 0.0);
}

// Three plies from below, 0.1 of material 1, 0.25 of 2, 0.05 of 1: laminate theory with the points in their middles.
TEST(BuildShellLayers, PliesOfOneElement) {
  const Structure structure = structure_of(
      mesh + part + section +
      "*ELEMENT_SHELL_COMPOSITE\n1,1,1,2,3,4\n1,0.1,0.,,2,0.25,0.\n1,0.05,0.\n2,1,2,5,6,3\n2,0.2,0.,,2,0.1,0.\n");
  ASSERT_EQ(structure.shells.size(), 2u);
  const ShellProperties& first = structure.shells.properties(0);
  ASSERT_EQ(first.layers.size(), 3u);
  const std::array young{1000., 100., 1000.}, height{0.1, 0.25, 0.05};
  double a = 0, b = 0, d = 0, below = -0.2;
  for (std::size_t i = 0; i < 3; ++i) {
    const double modulus = young[i] / (1 - poisson * poisson), z = below + height[i] / 2;
    a += modulus * height[i];
    b += modulus * height[i] * z;
    d += modulus * height[i] * z * z;
    below += height[i];
  }
  const auto k = stiffness(first, structure.shells.state(0).thickness);
  EXPECT_NEAR(structure.shells.state(0).thickness, 0.4, 1e-15);
  EXPECT_NEAR(k[0] / a, 1, 1e-9);
  EXPECT_NEAR(k[1] / b, 1, 1e-9);
  EXPECT_NEAR(k[2] / d, 1, 1e-9);
  EXPECT_NEAR(structure.shells.state(1).thickness, 0.3, 1e-15);
  EXPECT_NEAR(stiffness(structure.shells.properties(1), 0.3)[0], 100 * 0.3 / (1 - poisson * poisson), 1e-8);
  EXPECT_NEAR(mass_of(structure), 2 * 0.15 + 4 * 0.25 + 4 * 0.3, 1e-14);
}

// The same plies as a part's give the same run, bit for bit; LONG has one ply to a line.
TEST(BuildShellLayers, ElementPliesAreThoseOfAPart) {
  const std::string load =
      "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n4,0,1,1,1,1,1,1\n*LOAD_NODE_POINT\n5,3,9,0.1\n6,3,9,0.2\n*DEFINE_CURVE\n9\n"
      "0.,1.\n9.,1.\n*CONTROL_TERMINATION\n1.\n";
  const std::string plies = "1,0.1,0.,,2,0.25,0.\n1,0.05,0.\n", one_each = "1,0.1\n2,0.25\n1,0.05\n";
  const std::string elements = "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,2,5,6,3\n";
  RunScene of_part(mesh + elements + "*PART_COMPOSITE\nc\n1,2,0.8333\n" + plies + load + section);
  RunScene own(mesh + part + section + "*ELEMENT_SHELL_COMPOSITE\n1,1,1,2,3,4\n" + plies + "2,1,2,5,6,3\n" + plies +
               load);
  RunScene long_form(mesh + part + section + "*ELEMENT_SHELL_COMPOSITE_LONG\n1,1,1,2,3,4\n" + one_each +
                     "2,1,2,5,6,3\n" + one_each + load);
  for (RunScene* scene : {&of_part, &own, &long_form}) {
    ASSERT_TRUE(scene->prepared()) << scene->message();
    scene->go();
  }
  EXPECT_GT(own.state().x[4].z(), 1e-3);
  EXPECT_EQ(own.run().model().mesh.shells.layups.size(), 1u) << "shared";
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(own.state().x[i], of_part.state().x[i]) << i;
    EXPECT_EQ(own.state().x[i], long_form.state().x[i]) << i;
  }
}

/// A quad whose section refers to rule 7.
std::string ruled(const std::string& rule, const std::string& more = "") {
  return mesh + part + "*SECTION_SHELL\n1,2,0.8333,2,,-7\n0.4\n*ELEMENT_SHELL\n1,1,1,2,3,4\n*INTEGRATION_SHELL\n" +
         rule + more;
}

// n layers of equal thickness with their points in the middle: E t³ / 12 (1 − 1/n²).
TEST(BuildShellLayers, EqualLayers) {
  for (const int n : {1, 2, 3, 12}) {
    const Structure structure = structure_of(ruled(fmt::format("7,{},1\n", n)));
    const auto k = stiffness(structure.shells.properties(0), 0.4);
    const double modulus = 1000 / (1 - poisson * poisson);
    EXPECT_NEAR(k[0], modulus * 0.4, 1e-7) << n;
    EXPECT_NEAR(k[1], 0, 1e-9) << n;
    EXPECT_NEAR(k[2], modulus * 0.064 / 12 * (1 - 1.0 / (n * n)), 1e-9) << n;
  }
}

// Points of Gauss as a list are Gauss's rule; other points bend as Σ E wf t (s t / 2)².
TEST(BuildShellLayers, ListedPoints) {
  const Structure gauss = structure_of(ruled("7,2\n-0.577350269,0.5\n0.577350269,0.5\n"));
  const double modulus = 1000 / (1 - poisson * poisson);
  EXPECT_NEAR(stiffness(gauss.shells.properties(0), 0.4)[2], modulus * 0.064 / 12, 1e-8);
  const Structure listed = structure_of(ruled("7,3,0,0\n-0.9,0.2\n0.1,0.5\n0.8,0.3\n"));
  const auto k = stiffness(listed.shells.properties(0), 0.4);
  EXPECT_NEAR(k[1], modulus * 0.4 * 0.2 * (-0.9 * 0.2 + 0.1 * 0.5 + 0.8 * 0.3), 1e-8);
  EXPECT_NEAR(k[2], modulus * 0.4 * 0.04 * (0.81 * 0.2 + 0.01 * 0.5 + 0.64 * 0.3), 1e-8);
  EXPECT_NEAR(mass_of(listed), 2 * 0.4, 1e-15);
}

// A sandwich by the parts of its points: stiffness and mass of each layer.
TEST(BuildShellLayers, PartsOfPoints) {
  const Structure structure = structure_of(ruled("7,3\n-0.75,0.25\n0.,0.5,2\n0.75,0.25,1\n"));
  const double outer = 1000 / (1 - poisson * poisson);
  const auto k = stiffness(structure.shells.properties(0), 0.4);
  EXPECT_NEAR(k[0], 0.4 * (outer * 0.5 + outer / 10 * 0.5), 1e-8);
  EXPECT_NEAR(k[2], 0.4 * outer * 0.5 * 0.15 * 0.15, 1e-8);
  EXPECT_NEAR(mass_of(structure), 0.4 * (2 * 0.5 + 4 * 0.5), 1e-14);
  // Gravity of the part pulls on that mass.
  RunScene scene(
      ruled("7,3\n-0.75,0.25\n0.,0.5,2\n0.75,0.25,1\n",
            "*LOAD_BODY_Z\n9,10.\n*SET_PART_LIST\n4\n1\n*LOAD_BODY_PARTS\n4\n*DEFINE_CURVE\n9\n0.,1.\n9.,1.\n"
            "*CONTROL_TERMINATION\n0.2\n"));
  scene.go();
  EXPECT_NEAR(scene.state().v[0].z() / (-10 * (scene.state().time + scene.run().stepper().next_step() / 2)), 1, 1e-9);
}

TEST(BuildShellLayers, Refused) {
  const auto refused = [](const std::string& deck, Failure::Kind kind, std::string_view text) {
    const Failure failure = failure_of(deck);
    EXPECT_EQ(failure.kind, kind) << text;
    EXPECT_NE(failure.message.find(text), std::string::npos) << failure.message;
    EXPECT_GT(failure.place.line, 0u) << text;
  };
  refused(ruled("8,2,1\n"), Failure::Kind::unknown_reference, "rule 7");
  refused(ruled("7,0,1\n"), Failure::Kind::contradiction, "NIP = 0");
  refused(ruled("7,-3,1\n"), Failure::Kind::contradiction, "NIP = -3");
  refused(ruled("7,2000000000,1\n"), Failure::Kind::contradiction, "NIP = 2000000000");
  refused(ruled("7,2000000000\n0.,1.\n"), Failure::Kind::contradiction, "NIP = 2000000000");
  refused(ruled("7,2,2\n0.,0.5\n0.,0.5\n"), Failure::Kind::contradiction, "ESOP = 2");
  refused(ruled("7,2,0,3\n0.,0.5\n0.,0.5\n"), Failure::Kind::contradiction, "FAILOPT = 3");
  refused(ruled("7,3\n-0.5,0.5\n0.5,0.5\n"), Failure::Kind::contradiction, "lists 2 of its 3");
  refused(ruled("7,2\n-1.5,0.5\n0.5,0.5\n"), Failure::Kind::contradiction, "S = -1.5");
  refused(ruled("7,2\n-0.5,1.5\n0.5,-0.5\n"), Failure::Kind::contradiction, "WF = -0.5");
  refused(ruled("7,2\n-0.5,1.\n0.5,1.\n"), Failure::Kind::contradiction, "sum is 2");
  refused(ruled("7,2\n-0.5,0.5\n0.5,0.5,9\n"), Failure::Kind::unknown_reference, "part 9");
  refused(ruled("7,2\n-0.5,0.5\n0.5,0.5,3\n", "*PART\nr\n3,1,3\n*MAT_PLASTIC_KINEMATIC\n3,4.,100.,0.3,1.,1.,1.\n"),
          Failure::Kind::not_calculated, "material type");
  std::string membrane = ruled("7,2,1\n");
  membrane.replace(membrane.find("1,2,0.8333,2,,-7"), 3, "1,9");
  refused(membrane, Failure::Kind::not_calculated, "membranes");
  const auto element = [](const std::string& plies) {
    return mesh + part + section + "*ELEMENT_SHELL_COMPOSITE\n1,1,1,2,3,4\n" + plies;
  };
  refused(element("9,0.1,0.\n"), Failure::Kind::missing_material, "material 9");
  refused(element("1,-0.1,0.,,2,0.3,0.\n"), Failure::Kind::missing_material, "thickness -0.1");
  refused(element("3,0.1,0.\n") + "*MAT_RIGID\n3,2.,1000.,0.3\n", Failure::Kind::bad_material, "material 3");
}

// Layers that fail beside others that do not.
TEST(BuildShellLayers, MixedFailure) {
  const std::string points = "\n-0.5,0.5\n0.5,0.5,3\n", failing =
                                                            "*MAT_PLASTIC_KINEMATIC\n3,4.,100.,0.3,1.,1.,1.\n"
                                                            ",,0.2\n*PART\nr\n3,1,3\n";
  const auto deck = [&](const std::string& failopt) {
    std::string text = ruled("7,2,0," + failopt + points, failing);
    const std::string elastic = "*MAT_ELASTIC\n1,2.,1000.,0.3\n";
    return text.replace(text.find(elastic), elastic.size(), "*MAT_PLASTIC_KINEMATIC\n1,2.,1000.,0.3,1.,1.,1.\n\n");
  };
  const Failure failure = failure_of(deck("0"));
  EXPECT_NE(failure.message.find("FAILOPT"), std::string::npos) << failure.message;
  EXPECT_EQ(structure_of(deck("1")).shells.properties(0).layers.size(), 2u);
}

}  // namespace
}  // namespace gapcheck::solver::build_shell_layers_test
