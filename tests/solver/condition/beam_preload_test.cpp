#include <cmath>

#include "solver/conditioned.hpp"

namespace gapcheck::solver::beam_preload_test {
namespace {

constexpr double young = 1000, area = 0.06, density = 2, force = 0.3;

/// Two masses of 5 at a distance of 2, a beam of ELFORM 9 between them and what else is given.
std::string two_masses(const std::string& card, const std::string& curve = "0.,0.\n0.5,0.3\n1.,0.3\n",
                       const std::string& more = "") {
  return "*NODE\n1,0.,0.,0.\n2,2.,0.,0.\n3,0.,1.,0.\n*ELEMENT_BEAM\n7,1,1,2,3\n*ELEMENT_MASS\n1,1,5.\n2,2,5.\n"
         "*PART\np\n1,1,1\n*SECTION_BEAM\n1,9,1.,2\n0.3,0.3,0.2,0.2\n" +
         fmt::format("*MAT_SPOTWELD\n1,{},{},0.25,100.,50.\n\n", density, young) +
         "*SET_BEAM\n4\n7\n*INITIAL_AXIAL_FORCE_BEAM\n" + card + "\n*DEFINE_CURVE\n9\n" + curve + more;
}

// While the curve lasts the force is its own, whatever the masses do; then the beam is a spring that starts from its
// stress. The work of the preload is external work.
TEST(BeamPreload, FollowsTheCurveAndLetsGo) {
  for (const char* card : {"4,9", "4,9,,1"}) {
    Stepper stepper = good(two_masses(card)).stepper(fixed_step(1e-3));
    const double mass = 5 + density * area;
    double supplied = 0, worst = 0;
    while (stepper.state().time < 3) {
      ASSERT_TRUE(stepper.step().ok());
      const double at = stepper.state().time - stepper.state().dt;  // of the forces
      const double axial = stepper.structure().beams.axial(0);
      if (at < 1) {
        worst = std::max(worst, std::abs(axial - std::min(at / 0.5, 1.0) * force));
        supplied = stepper.energies().external;
        // ∫∫ F/m: F t³/(6 · 0.5 m), then a constant force.
        const double late = at - 0.5, moved = at < 0.5 ? force * at * at * at / 3 / mass
                                                       : force / mass * (0.125 / 3 + 0.25 * late + late * late / 2);
        EXPECT_NEAR(stepper.state().x[0].x(), moved + stepper.state().v[0].x() * stepper.state().dt, 3e-6) << at;
      } else if (at > 1.01) {
        EXPECT_NEAR(stepper.energies().external / supplied, 1, 1e-9);
      }
      EXPECT_NEAR(stepper.energies().total(), stepper.energies().external, 1e-12);
    }
    EXPECT_LT(worst, 1e-12);
    EXPECT_GT(supplied, 1e-3);
    // It goes on as a spring from F and the length at the end: energy ½ k (F/k)² + kinetic is all there is.
    double kinetic = 0;
    for (std::size_t i = 0; i < 2; ++i) kinetic += mass / 2 * stepper.state().v[i].squaredNorm();
    const double stress = stepper.structure().beams.points(0)[0].stress[0];
    EXPECT_NEAR(kinetic + stress * stress / 2 / young * area * 2, stepper.energies().external, 0.02 * supplied);
  }
}

// A force on a spring beside the beam, damped: both together come to rest where the spring carries the force.
TEST(BeamPreload, CompressesToTheStaticForce) {
  const std::string spring =
      "*ELEMENT_BEAM\n8,2,1,2\n*PART\nq\n2,2,2\n*SECTION_BEAM\n2,3\n0.5\n*MAT_ELASTIC\n2,2.,100.,0.25\n"
      "*DAMPING_GLOBAL\n0,2.\n";
  Stepper stepper = good(two_masses("4,9", "0.,0.\n5.,0.3\n60.,0.3\n", spring)).stepper(fixed_step(5e-3));
  while (stepper.state().time < 20) ASSERT_TRUE(stepper.step().ok());
  const double length = (stepper.state().x[1] - stepper.state().x[0]).norm();
  EXPECT_NEAR(100 * 0.5 * std::log(length / 2), -force, 1e-6);
  EXPECT_NEAR(stepper.structure().beams.axial(0), force, 1e-12);
  // ½ F² L/EA of the spring and of the beam; the rest of the work was damped.
  const double stored = force * force * length / 2 * (1 / (100 * 0.5) + 1 / (young * area));
  EXPECT_NEAR(stepper.energies().internal, stored, 2e-3 * stored);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-9);
}

// What falls ends it: 0.4 is never left towards 0.
TEST(BeamPreload, EndsWhereTheCurveFalls) {
  Stepper stepper = good(two_masses("4,9,2.", "0.,0.\n0.2,0.2\n0.4,0.\n")).stepper(fixed_step(1e-3));
  while (stepper.state().time < 0.1995) ASSERT_TRUE(stepper.step().ok());
  EXPECT_NEAR(stepper.structure().beams.axial(0), 0.4, 0.003);
  const double before = stepper.energies().external;
  while (stepper.state().time < 0.4) ASSERT_TRUE(stepper.step().ok());
  EXPECT_NEAR(stepper.energies().external, before, 0.02 * before);
}

// KBEND = 0 takes the bending moment away, 1 leaves it.
TEST(BeamPreload, Bending) {
  for (const bool kept : {false, true}) {
    Conditioned bent = good(two_masses(kept ? "4,9,,1" : "4,9"));
    bent.structure.state.w[0].z() = -1e-2;
    bent.structure.state.w[1].z() = 1e-2;
    Stepper stepper = std::move(bent).stepper(fixed_step(1e-3));
    const BeamElements& beams = stepper.structure().beams;
    double moment = 0;
    for (int i = 0; i < 200; ++i) {
      ASSERT_TRUE(stepper.step().ok());
      moment = std::max(moment, beams.end_moment(0).norm());
    }
    if (kept)
      EXPECT_GT(moment, 1e-5);
    else
      EXPECT_LT(moment, 1e-14);
    double axial = 0;
    for (const BeamPoint& point : beams.points(0)) axial += point.stress[0] / 4;
    EXPECT_NEAR(axial * area, beams.axial(0), 1e-12);
  }
}

TEST(BeamPreload, HostileCards) {
  const auto refused = [](const std::string& deck, Failure::Kind kind, std::string_view text) {
    const Conditioned bad = conditioned(deck);
    ASSERT_FALSE(bad.status.ok()) << text;
    EXPECT_EQ(bad.status.error().kind, kind);
    EXPECT_NE(bad.status.error().message.find(text), std::string::npos) << bad.status.error().message;
    EXPECT_EQ(bad.status.error().message.rfind("*INITIAL_AXIAL_FORCE_BEAM", 0), 0u) << bad.status.error().message;
    EXPECT_GT(bad.status.error().place.line, 0u);
  };
  refused(two_masses("5,9"), Failure::Kind::unknown_reference, "set 5");
  refused(two_masses("4,8"), Failure::Kind::unknown_reference, "curve 8");
  refused(two_masses("4,9,,2"), Failure::Kind::not_calculated, "KBEND = 2");
  refused(two_masses("4,9\n4,9"), Failure::Kind::contradiction, "beam 7 has two preloads");
  refused(two_masses("4,9,-1."), Failure::Kind::contradiction, "at its start");
  refused(two_masses("4,9", "0.,0.3\n"), Failure::Kind::contradiction, "at its start");
  refused(two_masses("4,9", "0.,-3.\n1.,-2.\n"), Failure::Kind::contradiction, "above zero");
  refused(two_masses("4,9", "0.,0.\n-1.,2.\n"), Failure::Kind::unknown_reference, "do not rise");
  const auto relaxed = [](int sidr) {
    std::string deck = two_masses("4,9");
    return deck.replace(deck.find("*DEFINE_CURVE\n9"), 15, fmt::format("*DEFINE_CURVE\n9,{}", sidr));
  };
  EXPECT_EQ(good(relaxed(1)).warnings, "");
  refused(relaxed(1) + "*CONTROL_DYNAMIC_RELAXATION\n,,,,,,,-999\n", Failure::Kind::contradiction, "SIDR = 1");
  EXPECT_NE(good(relaxed(2)).warnings.find("SIDR = 2"), std::string::npos);
  std::string truss = two_masses("4,9");
  truss.replace(truss.find("*SECTION_BEAM\n1,9,1.,2\n0.3,0.3,0.2,0.2\n"), 38, "*SECTION_BEAM\n1,3\n0.06\n");
  truss.replace(truss.find("*MAT_SPOTWELD"), 13, "*MAT_ELASTIC");
  refused(truss, Failure::Kind::not_calculated, "beam 7 is not integrated");
  EXPECT_NE(good(two_masses("4,9,100.")).warnings.find("above the yield stress"), std::string::npos);
  EXPECT_EQ(good(two_masses("4,9")).warnings, "");
}

}  // namespace
}  // namespace gapcheck::solver::beam_preload_test
