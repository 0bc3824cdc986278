// Decks with discrete beams.
#include "solver/build/build_discrete_beams.hpp"

#include <cmath>
#include <numbers>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::build_discrete_beams_test {
namespace {

/// Node 1 is held, node 2 at `x`; beam 1 between them.
std::string deck(const std::string& section, const std::string& material, const std::string& x = "0.,0.,0.",
                 const std::string& third = "0") {
  return "*NODE\n1,0.,0.,0.,7,7\n2," + x + "\n3,0.,0.,5.,7,7\n*ELEMENT_BEAM\n1,1,1,2," + third +
         "\n*PART\nspring\n1,1,1\n*SECTION_BEAM\n" + section + material +
         "*CONTROL_TERMINATION\n1.\n*CONTROL_TIMESTEP\n0.,0.05\n";
}

const std::string linear = "*MAT_LINEAR_ELASTIC_DISCRETE_BEAM\n1,2.,100.,200.,300.,400.,500.,600.\n1.,2.,3.,4.,5.,6.\n";
const std::string section = "1,6,,,,0.\n3.,8.\n";

// Half of RO VOL and of INER at each end; the step is that of the stiffest direction.
TEST(BuildDiscreteBeams, MassInertiaAndLaws) {
  const Structure structure = structure_of(deck(section, linear + "0.,0.,7.\n"));
  ASSERT_EQ(structure.beams.size(), 1u);
  EXPECT_NEAR(structure.state.mass[1], 3, 1e-12);
  EXPECT_NEAR(structure.state.inertia[1], 4, 1e-12);
  const DiscreteBeam& beam = *structure.beams.properties(0).discrete;
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(beam.laws[i].stiffness, 100.0 * static_cast<double>(i + 1));
    EXPECT_EQ(beam.laws[i].damping, static_cast<double>(i + 1));
  }
  EXPECT_EQ(beam.laws[2].preload, 7);
}

TEST(BuildDiscreteBeams, AxesBySystemThirdNodeOrGlobal) {
  const auto axes = [](const std::string& text) {
    const Structure structure = structure_of(text);
    return structure.beams.axes(0, structure.state.x);
  };
  EXPECT_EQ(axes(deck(section, linear)), Matrix(Matrix::Identity()));
  EXPECT_EQ(axes(deck(section, linear, "0.,2.,0.")), Matrix(Matrix::Identity()));
  Matrix by_node;  // r = y, s = z
  by_node << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  EXPECT_LT((axes(deck(section, linear, "0.,2.,0.", "3")) - by_node).norm(), 1e-12);
  EXPECT_LT(
      (axes(deck("1,6,,,,0.\n3.,8.,5\n", linear, "0.,2.,0.") + "*DEFINE_COORDINATE_VECTOR\n5,0.,1.,0.,0.,0.,1.\n") -
       by_node)
          .norm(),
      1e-12);
  // SCOOR = 2: r lies on the line.
  EXPECT_LT((axes(deck("1,6,,,,2.\n3.,8.\n", linear, "0.,2.,0.")).col(0) - Vector(0, 1, 0)).norm(), 1e-12);
}

// x = v / ω sin ωt with ω² = k / (m / 2) of the free end, and with damping c the decay e^(−c t / m).
TEST(BuildDiscreteBeams, AMassOnASpringVibrates) {
  for (const double damping : {0.0, 4.0}) {
    const std::string material =
        fmt::format("*MAT_066\n1,2.,,150.\n0.,{}\n", damping) + "*INITIAL_VELOCITY_NODE\n2,0.,0.5\n";
    RunScene scene(deck(section, material));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double worst = 0;
    scene.go([&](const solver::Run& run) {
      const State& state = run.stepper().state();
      const double rate = damping / 6, w = std::sqrt(50 - rate * rate), t = state.time;
      worst = std::max(worst, std::abs(state.x[1].y() - 0.5 / w * std::exp(-rate * t) * std::sin(w * t)));
    });
    RecordProperty(damping > 0 ? "damped" : "free", fmt::format("{:.2g}", worst / (0.5 / std::sqrt(50.0))));
    EXPECT_LT(worst, 0.02 * 0.5 / std::sqrt(50.0)) << damping;
    const Energies& e = scene.energies();
    EXPECT_NEAR(e.total() / e.initial, 1, 1e-3) << damping;
  }
}

// A pendulum on a cable: at the lowest point v² = 2 g h, F = m (g + v² / l).
TEST(BuildDiscreteBeams, PendulumOnACable) {
  const std::string material =
      "*MAT_CABLE_DISCRETE_BEAM\n1,1e-3,1e6\n*ELEMENT_MASS\n1,2,3.\n*LOAD_BODY_Z\n1,1.\n*DEFINE_CURVE\n1\n0.,10.\n9.,"
      "10.\n";
  RunScene scene(deck("1,6\n0.,0.,0,0.1\n", material, "1.,0.,0."));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double greatest = 0, lowest = 0;
  scene.go([&](const solver::Run& run) {
    greatest = std::max(greatest, run.stepper().structure().beams.axial(0));
    lowest = std::min(lowest, run.stepper().state().x[1].z());
  });
  RecordProperty("pendulum", fmt::format("{:.2g}", greatest / 90 - 1));
  EXPECT_NEAR(lowest, -1, 2e-3);
  EXPECT_NEAR(greatest, 3 * 3 * 10, 1);
}

TEST(BuildDiscreteBeams, AbsurdInputIsRefused) {
  const auto refused = [](const std::string& text, const std::string& part) {
    const Failure failure = failure_of(text);
    EXPECT_NE(failure.message.find(part), std::string::npos) << failure.message;
    EXPECT_GT(failure.place.line, 0u);
  };
  refused(deck("1,6\n0.,8.\n", linear), "VOL is zero");
  refused(deck("1,6\n-1.,8.\n", linear), "VOL is -1");
  refused(deck("1,6,,,,4.\n3.,8.\n", linear), "SCOOR is 4; set -3 to 3");
  refused(deck("1,6\n3.,8.,77\n", linear), "coordinate system 77 (CID) cannot be used");
  refused(deck("1,6\n3.,-8.\n", linear), "INER is -8");
  refused(deck("1,6\n3.,0.\n", "*MAT_066\n1,2.,,,,40.\n\n"), "INER is zero, but its beams resist rotation");
  refused(deck(section, "*MAT_066\n1,2.,-100.\n\n"), "the stiffness of r is -100");
  refused(deck(section, "*MAT_067\n1,2.,33\n\n"), "curve 33 of r is not there");
  refused(deck(section, "*MAT_068\n1,2.,0.\n\n4\n*DEFINE_CURVE\n4\n0.,1.\n1.,2.\n"), "yield forces, but no stiffness");
  refused(deck(section, "*MAT_068\n1,2.,9.\n\n4\n*DEFINE_CURVE\n4\n0.,0.\n1.,2.\n"), "the yield force of r is 0");
  refused(deck(section, "*MAT_071\n1,2.,9.\n", "1.,0.,0."), "CA is zero");
  refused(deck("1,6\n3.,0.,0,1.,1.5\n", "*MAT_071\n1,2.,9.\n", "1.,0.,0."), "unstressed length of -0.5");
  refused(deck("1,6\n3.,0.,0,1.\n", "*MAT_071\n1,2.,9.,,,,,2\n0.,0.,0.9\n", "1.,0.,0."), "FRACL0");
  refused(deck("1,6\n3.,0.,0,1.\n", "*MAT_071\n1,0.,9.\n", "1.,0.,0."), "RO is 0");
}

TEST(BuildDiscreteBeams, WhatIsTakenInsteadOfInerIsNamed) {
  const model::Read read = model::read_text(deck("1,6\n3.,0.\n", linear));
  Diagnostics diagnostics;
  ASSERT_TRUE(build_structure(read.model, {}, diagnostics));
  ASSERT_EQ(diagnostics.sorted().size(), 1u);
  EXPECT_NE(diagnostics.sorted()[0].message.find("INER is zero; its beams get an inertia"), std::string::npos);
}

// A beam that fails by its force lets its node fly on.
TEST(BuildDiscreteBeams, AFailedBeamHasNoForce) {
  const std::string material =
      "*MAT_NONLINEAR_ELASTIC_DISCRETE_BEAM\n1,2.,,4\n\n\n,10.\n*DEFINE_CURVE\n4\n0.,0.\n1.,150.\n"
      "*INITIAL_VELOCITY_NODE\n2,0.,2.\n";
  RunScene scene(deck(section, material));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  ASSERT_EQ(scene.run().stepper().failures().size(), 1u);
  // ½ m v² − ½ F² / k is left.
  EXPECT_NEAR(scene.state().v[1].y(), std::sqrt(4 - 2 * (100.0 / 300) / 3), 0.02);
}

}  // namespace
}  // namespace gapcheck::solver::build_discrete_beams_test
