// Runs that begin with a dynamic relaxation.
#include <cmath>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::relaxation_run_test {
namespace {

constexpr double young = 1e4, density = 2, area = 0.5 * 0.25;
constexpr int bricks = 4;

std::string control(const std::string& card) { return "*CONTROL_DYNAMIC_RELAXATION\n" + card + "\n"; }

/// A bar of four bricks of length 1 without lateral strain, its first end held in x. Nodes of station i: 1 + i + 5 k.
std::string bar(const std::string& more, bool both_ends = false) {
  std::string deck = brick_bar(bricks, {1, 0.5, 0.25}) + "*PART\np\n1,1,1\n*SECTION_SOLID\n1,1\n" +
                     fmt::format("*MAT_ELASTIC\n1,{},{},0.\n", density, young) + "*BOUNDARY_SPC_NODE\n";
  for (int k = 0; k < 4; ++k) deck += fmt::format("{},0,1\n", 1 + 5 * k);
  for (int k = 0; both_ends && k < 4; ++k) deck += fmt::format("{},0,1\n", 5 + 5 * k);
  return deck + "1,0,0,1,1\n*SET_NODE_LIST\n4\n5,10,15,20\n*SET_NODE_LIST\n5\n1,6,11,16\n*CONTROL_TERMINATION\n0.5\n" +
         more;
}

/// A force F at the free end, by a curve with this SIDR.
std::string pull(double force, int sidr) {
  return fmt::format("*LOAD_NODE_SET\n4,1,9,{}\n*DEFINE_CURVE\n9,{}\n0.,0.\n0.2,1.\n100.,1.\n", force / 4, sidr);
}

// With the same stress in all of it, ln(l / L) = F / EA. The load stays (SIDR = 2), and so does the bar.
TEST(RelaxationRun, BarUnderItsLoadComesToRest) {
  constexpr double force = 6;
  RunScene scene(bar(pull(force, 2) + control("100,1e-12,0.98,,,,,1")));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const double exact = bricks * (std::exp(force / young / area) - 1);
  double first = 0, worst = 0, kinetic = 0;
  bool begun = false;
  scene.go([&](const solver::Run& run) {
    const double shift = run.stepper().state().x[4].x() - bricks;
    if (!begun) {
      EXPECT_EQ(run.stepper().state().time, 0);
      EXPECT_EQ(run.stepper().state().cycle, 0u);
      first = shift;
    }
    begun = true;
    worst = std::max(worst, std::abs(shift - exact));
    kinetic = std::max(kinetic, run.stepper().energies().printed_kinetic);
    EXPECT_NEAR(run.stepper().energies().ratio(), 1, 1e-3);
  });
  RecordProperty("error", fmt::format("{:.3g}", std::abs(first / exact - 1)));
  EXPECT_NEAR(first / exact, 1, 1e-4);
  ASSERT_TRUE(scene.run().relaxed());
  EXPECT_TRUE(scene.run().relaxed()->converged);
  EXPECT_EQ(scene.run().relaxed()->cycles % 100, 0u);
  EXPECT_LT(scene.run().relaxed()->ratio, 1e-12);
  // The load begins again with its curve, so the bar is let go and pulled once more.
  EXPECT_GT(worst, 0.5 * exact);
  EXPECT_GT(kinetic, 0);
}

// A load for the relaxation alone, and one that continues it.
TEST(RelaxationRun, RestContinuesUnderAConstantLoad) {
  constexpr double force = 6;
  const std::string kept = fmt::format("*LOAD_NODE_SET\n4,1,8,{}\n*DEFINE_CURVE\n8\n0.,1.\n100.,1.\n", force / 4);
  RunScene scene(bar(pull(force, 1) + kept));
  const double exact = bricks * (std::exp(force / young / area) - 1);
  double worst = 0;
  scene.go([&](const solver::Run& run) {
    worst = std::max(worst, std::abs(run.stepper().state().x[4].x() - bricks - exact));
    const Energies& e = run.stepper().energies();
    ASSERT_NEAR(e.total() - e.initial, e.external, 1e-6 * e.external);
  });
  EXPECT_LT(worst / exact, 0.03) << "at DRTOL = 0.001";
  const Energies& e = scene.energies();
  EXPECT_NEAR(e.internal, force * exact / 2, 0.02 * force * exact) << "stored";
  EXPECT_GT(e.external, 0.9 * force * exact / 2);
}

// Let go by the end of its load the bar keeps ½ F u, which the work and the loss of the relaxation leave.
TEST(RelaxationRun, EnergyOfTheReleasedBar) {
  constexpr double force = 6;
  RunScene scene(bar(pull(force, 1) + control("100,1e-12,0.98") + "*CONTROL_BULK_VISCOSITY\n0.,1e-20\n"));
  const double exact = bricks * (std::exp(force / young / area) - 1);
  double least = 1, start = 0, stored = 0, external = 0;
  scene.go([&](const solver::Run& run) {
    const Energies& e = run.stepper().energies();
    const double sum = e.kinetic + e.internal + e.hourglass;
    if (run.stepper().state().cycle == 0) start = sum, stored = e.internal, external = e.external;
    ASSERT_NEAR(sum, start, 1e-4 * start);
    ASSERT_NEAR(e.external, external, 1e-12) << "nothing works on it";
    least = std::min(least, e.internal / stored);
  });
  EXPECT_NEAR(stored, force * exact / 2, 2e-3 * stored);
  EXPECT_NEAR(scene.energies().absorbed.damping, external - stored, 1e-3 * stored);
  EXPECT_LT(least, 0.1) << "it swings through";
}

// A cantilever of n one-point shells without Poisson's effect under a tip load: P L³/3EI (1 − 1/4n²) + P L/GA.
TEST(RelaxationRun, CantileverComesToRest) {
  constexpr double load = 0.02, stiffness = 1e4 * 0.064 / 12;
  RunScene scene(plate(4, 1, {2, 1, 0}) + elastic_deck("*SECTION_SHELL\n1,2,,3\n0.4\n", 1e4, 0, 1) +
                 "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n6,0,1,1,1,1,1,1\n*LOAD_NODE_POINT\n5,3,9,0.01\n10,3,9,0.01\n"
                 "*DEFINE_CURVE\n9,1\n0.,0.\n1.,1.\n1000.,1.\n*CONTROL_TERMINATION\n0.001\n" +
                 control("250,1e-12,0.99"));
  std::optional<double> tip;
  scene.go([&](const solver::Run& run) {
    if (!tip) tip = run.stepper().state().x[4].z();
  });
  const double exact = load * 512 / (3 * stiffness) * (1 - 1.0 / 64) + load * 8 / (5e3 * 0.4);
  RecordProperty("cantilever", fmt::format("{:.6f}", *tip / exact));
  EXPECT_NEAR(*tip / exact, 1, 1e-3);
}

// A bolt of bricks between supports, tightened in the relaxation, keeps its force in the run.
TEST(RelaxationRun, PreloadOfASectionStays) {
  constexpr double stress = 2;
  RunScene scene(
      bar("*DATABASE_CROSS_SECTION_PLANE_ID\n4,bolt\n0,1.5,0.,0.,2.5,0.,0.\n\n*INITIAL_STRESS_SECTION\n"
          "1,4,9\n*DEFINE_CURVE\n9,1\n0.,0.\n0.2,2.\n100.,2.\n" +
              control("100,1e-10,0.98"),
          true));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double worst = 0;
  std::size_t states = 0;
  scene.go([&](const solver::Run& run) {
    double pulled = 0;
    for (std::size_t k = 0; k < 4; ++k) pulled -= run.stepper().external().force[5 * k].x();
    worst = std::max(worst, std::abs(pulled - stress * area));
    ++states;
    EXPECT_NEAR(run.stepper().energies().ratio(), 1, 1e-3);
  });
  EXPECT_GT(states, 50u);
  EXPECT_LT(worst / (stress * area), 2e-4);
  RecordProperty("error", fmt::format("{:.3g}", worst / (stress * area)));
  // What the section supplied beyond the losses is stored: σ² V / 2 E.
  EXPECT_NEAR(scene.energies().printed_internal() / (stress * stress / 2 / young * area * bricks), 1, 1e-3);
}

// A beam between two masses that a spring holds apart, tightened by *INITIAL_AXIAL_FORCE_BEAM.
TEST(RelaxationRun, PreloadOfABeamStays) {
  constexpr double force = 0.3;
  RunScene scene(
      "*NODE\n1,0.,0.,0.\n2,2.,0.,0.\n3,0.,1.,0.\n*ELEMENT_BEAM\n7,1,1,2,3\n8,2,1,2\n*ELEMENT_MASS\n1,1,5.\n2,2,5.\n"
      "*PART\np\n1,1,1\n*PART\nq\n2,2,2\n*SECTION_BEAM\n1,9,1.,2\n0.3,0.3,0.2,0.2\n*SECTION_BEAM\n2,3\n0.5\n"
      "*MAT_SPOTWELD\n1,2.,1000.,0.25,100.,50.\n\n*MAT_ELASTIC\n2,2.,100.,0.25\n*SET_BEAM\n4\n7\n"
      "*INITIAL_AXIAL_FORCE_BEAM\n4,9\n*DEFINE_CURVE\n9,1\n0.,0.\n5.,0.3\n1000.,0.3\n*CONTROL_TERMINATION\n2.\n" +
      control("100,1e-12,0.98"));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double worst = 0;
  scene.go([&](const solver::Run& run) {
    worst = std::max(worst, std::abs(run.stepper().structure().beams.axial(0) - force));
  });
  EXPECT_LT(worst / force, 1e-4);
  const double length = (scene.state().x[1] - scene.state().x[0]).norm();
  EXPECT_NEAR(100 * 0.5 * std::log(length / 2), -force, 1e-4 * force) << "the spring is pressed by it";
}

/// Two bricks of 1 x 1 x 1 one above the other, touching, the lower one on a support; gravity by curve 1.
std::string stack(const std::string& more) {
  std::string nodes = "*NODE\n", lower;
  for (int b = 0; b < 2; ++b)
    for (int k = 0; k < 8; ++k)
      nodes +=
          fmt::format("{},{},{},{}\n", 10 * b + k + 1, k % 4 == 1 || k % 4 == 2 ? 1 : 0, k % 4 > 1 ? 1 : 0, b + k / 4);
  for (int k = 1; k <= 4; ++k) lower += fmt::format("{},0,1,1,1\n", k);
  return nodes +
         "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n2,2,11,12,13,14,15,16,17,18\n*PART\np\n1,1,1\n*PART\nq\n2,1,1\n" +
         "*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,1.,100.,0.\n*BOUNDARY_SPC_NODE\n" + lower +
         "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n0.\n\n*LOAD_BODY_Z\n1,1.,2\n*DEFINE_CURVE\n1\n0.,1.\n100.,1."
         "\n"
         "*DEFINE_CURVE\n2,1\n0.,0.\n1.,1.\n1000.,1.\n*CONTROL_TERMINATION\n1.\n" +
         more;
}

// The upper brick rests on the lower one by its weight, from the first cycle of the run on.
TEST(RelaxationRun, ContactForceContinues) {
  RunScene scene(stack(control("100,1e-12,0.98,30.")));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double worst = 0;
  std::size_t states = 0;
  scene.go([&](const solver::Run& run) {
    worst = std::max(worst, std::abs(run.contacts()[0].state().force_a.norm() - 1));
    EXPECT_NEAR(run.stepper().energies().ratio(), 1, 1e-3);
    ++states;
  });
  EXPECT_GT(states, 10u);
  EXPECT_LT(worst, 5e-3);
  EXPECT_LT(std::abs(scene.state().v[12].z()), 2e-3) << "after a second at 1 per second squared";
}

// With DT below zero the contact does not act in the relaxation: the upper brick falls into the lower one; with BT
// below zero and DT as usual it begins there at |BT|.
TEST(RelaxationRun, BirthsAndDeathsOfContacts) {
  const auto lowest = [](const std::string& times) {
    std::string deck = stack(control("100,1e-3,0.98,3."));
    const std::string card = "1,2,3,3\n0.\n";
    deck.replace(deck.find(card), card.size(), "1,2,3,3\n0.,0.,0.,0.,0.,0," + times + "\n");
    RunScene scene(deck);
    EXPECT_TRUE(scene.prepared()) << scene.message();
    std::optional<double> height;
    (void)scene.try_to_go([&](const solver::Run& run) {
      if (!height) height = run.stepper().state().x[8].z();
    });
    return height.value_or(0);
  };
  EXPECT_GT(lowest("0.,0."), 0.93);
  EXPECT_LT(lowest("0.,-1e20"), 0.8);
  EXPECT_GT(lowest("-1e-6,1e20"), 0.93);
}

// Initial velocities wait for the end of the relaxation, those of rigid bodies too.
TEST(RelaxationRun, InitialVelocitiesBeginWithTheRun) {
  const std::string body =
      "*NODE\n111,0.,0.,9.\n112,1.,0.,9.\n113,1.,2.,9.\n114,0.,2.,9.\n115,0.,0.,12.\n116,1.,0.,12.\n117,1.,2.,12.\n"
      "118,0.,2.,12.\n*ELEMENT_SOLID\n9,7,111,112,113,114,115,116,117,118\n*PART\nbox\n7,7,7\n*SECTION_SOLID\n7,1\n"
      "*MAT_RIGID\n7,2.,1000.,0.3\n*SET_NODE_GENERAL\n70\nPART,7\n*INITIAL_VELOCITY\n70\n0.,3.,0.\n";
  for (const std::string phase : {"0", "1"}) {
    RunScene scene(bar(pull(6, 1) + body + control("100,1e-12,0.98") +
                       "*INITIAL_VELOCITY_GENERATION\n1,2,0.,0.,4.,5.\n0.,0.,0.,0.,0.,0.," + phase + "\n"));
    if (phase == "0") {
      EXPECT_FALSE(scene.prepared());
      EXPECT_NE(scene.message().find("PHASE"), std::string::npos) << scene.message();
      continue;
    }
    ASSERT_TRUE(scene.prepared()) << scene.message();
    bool begun = false;
    scene.go([&](const solver::Run& run) {
      const State& state = run.stepper().state();
      if (!begun) {
        EXPECT_NEAR(state.x[4].y(), 0, 1e-6) << "not moved by what it will have";
        const double held = density * area / 8;  // node 1 is held in y and z
        EXPECT_NEAR(run.stepper().energies().initial, (density * bricks * area - held) / 2 * 41 + 12 / 2. * 9, 1e-2)
            << "½ m v²";
        EXPECT_NEAR(run.stepper().structure().rigid[0].velocity().y(), 3, 1e-12);
        EXPECT_NEAR(state.x[20].y(), 0, 1e-12);
      }
      begun = true;
    });
    EXPECT_NEAR(scene.state().x[20].y(), 3 * scene.state().time, 1e-9);
    EXPECT_NEAR(scene.energies().ratio(), 1, 1e-3);
  }
}

// A bar stretched by a motion for the relaxation alone, then held there by one for the run.
TEST(RelaxationRun, MotionsOfBothPhases) {
  const std::string deck =
      "*BOUNDARY_PRESCRIBED_MOTION_SET\n4,1,2,9\n4,1,0,8\n*DEFINE_CURVE\n9,1\n0.,0.\n0.5,0.01\n100.,0.01\n"
      "*DEFINE_CURVE\n8\n0.,0.\n100.,0.\n";
  RunScene scene(bar(deck + control("100,1e-12,0.98")));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double worst = 0;
  scene.go([&](const solver::Run& run) {
    worst = std::max(worst, std::abs(run.stepper().state().x[4].x() - bricks - 0.01));
    EXPECT_NEAR(run.stepper().energies().ratio(), 1, 1e-3);
  });
  EXPECT_LT(worst, 1e-12);
  const double energy = young * area * bricks / 2 * std::pow(std::log(1 + 0.01 / bricks), 2);
  EXPECT_NEAR(scene.energies().internal / energy, 1, 0.01);
  // Without a second motion the end is free in the run.
  RunScene freed(bar("*BOUNDARY_PRESCRIBED_MOTION_SET\n4,1,2,9\n*DEFINE_CURVE\n9,1\n0.,0.\n0.5,0.01\n100.,0.01\n" +
                     control("100,1e-6,0.98")));
  double least = 1;
  freed.go([&](const solver::Run& run) { least = std::min(least, run.stepper().state().x[4].x() - bricks); });
  EXPECT_LT(least, -0.005);
}

// Supports hold in the whole relaxation, whatever their birth and death.
TEST(RelaxationRun, TimesOfSupportsCountInTheRun) {
  RunScene scene(bar(pull(6, 2) + control("100,1e-6,0.98") + "*BOUNDARY_SPC_SET_BIRTH_DEATH\n4,0,1\n0.1,0.2\n"));
  std::optional<double> start;
  double later = 0;
  scene.go([&](const solver::Run& run) {
    if (!start) start = run.stepper().state().x[4].x() - bricks;
    if (run.stepper().state().time < 0.1) later = run.stepper().state().x[4].x() - bricks;
  });
  EXPECT_EQ(*start, 0);
  EXPECT_GT(later, 1e-4);
}

// Where nothing acts in the relaxation, the run is that without one, bit for bit.
TEST(RelaxationRun, RelaxationOfNothingChangesNothing) {
  const std::string deck = bar(pull(6, 0) + "*INITIAL_VELOCITY\n4\n1.,2.,3.\n");
  RunScene plain(deck), relaxed(deck + control(",,,,,,,1"));
  plain.go();
  relaxed.go();
  ASSERT_TRUE(relaxed.run().relaxed());
  EXPECT_EQ(relaxed.run().relaxed()->cycles, 250u);
  EXPECT_FALSE(plain.run().relaxed());
  for (std::size_t i = 0; i < plain.state().x.size(); ++i) EXPECT_EQ(plain.state().x[i], relaxed.state().x[i]);
  EXPECT_EQ(plain.energies().total(), relaxed.energies().total());
}

// DRTERM ends it; so do the limits of the whole run.
TEST(RelaxationRun, OtherEnds) {
  RunScene timed(bar(pull(6, 1) + control(",1e-9,,0.05,0.45")));
  timed.go();
  ASSERT_TRUE(timed.run().relaxed());
  EXPECT_FALSE(timed.run().relaxed()->converged);
  EXPECT_NEAR(timed.run().relaxed()->time, 0.05, 0.01);
  EXPECT_EQ(timed.run().relaxed()->unfinished, 9) << "the load rises until 0.2";
  RunScene whole(bar(pull(6, 1) + control(",1e-9,,0.05,0.9")));
  whole.go();
  EXPECT_NEAR(static_cast<double>(timed.run().relaxed()->cycles),
              2.0 * static_cast<double>(whole.run().relaxed()->cycles), 4);
  RunSettings settings;
  settings.cycles = 40;
  RunScene limited(bar(pull(6, 1)), settings);
  EXPECT_EQ(limited.try_to_go(), RunEnd::cycles);
  EXPECT_FALSE(limited.run().relaxed());
}

TEST(RelaxationRun, Refused) {
  const auto refused = [](const std::string& deck, std::string_view text) {
    RunScene scene(deck);
    ASSERT_FALSE(scene.prepared()) << text;
    EXPECT_NE(scene.message().find(text), std::string::npos) << scene.message();
    EXPECT_GT(scene.status().error().place.line, 0u) << text;
  };
  const std::string moved = "*DEFINE_CURVE\n9,2\n0.,0.\n1.,1.\n*BOUNDARY_PRESCRIBED_MOTION_SET\n4,1,";
  refused(bar(moved + "2,9\n"), "SIDR = 2");
  refused(bar(moved + "1,9\n"), "VAD = 1");
  refused(bar(moved + "0,9,1.,0,5.,1.\n"), "BIRTH");
  refused(bar(pull(1, 1) + control("-3")), "NRCYCK");
  RunScene rigid("*NODE\n1,0.,0.,0.\n" + std::string("*CONTROL_TERMINATION\n1.\n") + control(",,,,,,,1"));
  EXPECT_FALSE(rigid.prepared());
  EXPECT_NE(rigid.message().find("DRTERM"), std::string::npos) << rigid.message();
}

}  // namespace
}  // namespace gapcheck::solver::relaxation_run_test
