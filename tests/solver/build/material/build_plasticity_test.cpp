// Materials 018, 081 and 123.
#include "solver/build/material/build_plasticity.hpp"

#include <cmath>

#include "solver/output/state_balance.hpp"
#include "solver/run_scene.hpp"
#include "solver/stretched_element.hpp"

namespace gapcheck::solver::build_plasticity_test {
namespace {

Material built(const std::string& cards) {
  return structure_of(stretched_square("*MAT_" + cards, {}, 1)).shells.properties(0).material;
}

// σ = K (ε₀ + ε̄)^N at any plastic strain; ε₀ where K ε^N meets E ε, or by SIGY as stress or strain.
TEST(PowerLaw, YieldStress) {
  const auto check = [](const std::string& sigy, double first) {
    const Material material = built("018\n1,1.,1000.,0.3,50.,0.25\n" + sigy + "\n");
    for (const double strain : {0.0, 1e-4, 3e-3, 0.05, 0.4, 2.0}) {
      const double expected = 50 * std::pow(first + strain, 0.25);
      EXPECT_NEAR(material.yield.stress(strain), expected, 1e-4 * expected) << sigy << " " << strain;
    }
  };
  const double meets = std::pow(1000.0 / 50, 1 / (0.25 - 1));
  EXPECT_NEAR(50 * std::pow(meets, 0.25), 1000 * meets, 1e-9);
  check("", meets);
  check("20.", std::pow(0.4, 4));
  check("0.01", 0.01);
  const Material rates = built("018\n1,1.,1000.,0.3,50.,0.25,40.,5.\n0.,1.,0.3\n");
  EXPECT_EQ(rates.rate_c, 40);
  EXPECT_TRUE(rates.viscoplastic);
  EXPECT_EQ(rates.failure_strain, 0.3);
}

Material damaged() {
  Material material{MaterialKind::plastic, 1, 1000, 0.3, YieldCurve(10, 20), 0, 0, 0};
  material.softening = 0.1;
  material.rupture = 0.3;
  return material;
}

// 081: the stress is that of 024 times 1 − ω, ω from 0 at EPPF to 1 at EPPFR; then the point fails. All work is stored
// or dissipated.
TEST(PlasticityWithDamage, FollowsTheUndamagedStress) {
  for (const bool shell : {false, true}) {
    Material plain = damaged();
    plain.softening = plain.rupture = 0;
    PointState point, other;
    double work = 0, failed_at = 0;
    Symmetric increment{1e-4, -0.5e-4, shell ? 0 : -0.5e-4, 0, 0, 0};
    for (int i = 0; i < 4000 && !point.failed; ++i) {
      const Symmetric before = point.stress;
      if (shell) {
        update_plane_stress(damaged(), increment, 1, point);
        update_plane_stress(plain, increment, 1, other);
      } else {
        update_stress(damaged(), increment, 1, point);
        update_stress(plain, increment, 1, other);
      }
      if (point.failed) break;
      failed_at = point.plastic_strain;
      work += (contract(before, increment) + contract(point.stress, increment)) / 2;
      const double omega = std::clamp((other.plastic_strain - 0.1) / 0.2, 0.0, 1.0);
      ASSERT_NEAR(point.plastic_strain, other.plastic_strain, 1e-12);
      ASSERT_NEAR(point.stress[xx], (1 - omega) * other.stress[xx], 1e-9);
      ASSERT_NEAR(elastic_energy(damaged(), point) + point.plastic_work, work, 2e-4 * work + 1e-7);
    }
    EXPECT_TRUE(point.failed);
    EXPECT_NEAR(failed_at, 0.3, 2e-4);
  }
}

/// The stretch (in x, with y held or free of strain) at which a shell fails; 0: it does not.
double fails_at(const std::string& cards, const Stretch& s, double end) {
  RunSettings settings;
  settings.step.greatest_step = 1e-4 * end;
  RunScene scene(stretched_square("*MAT_" + cards, s, end), settings);
  EXPECT_TRUE(scene.prepared()) << scene.message();
  double time = 0;
  if (!scene.prepared()) return time;
  scene.go([&](const solver::Run& run) {
    if (run.stepper().state().failed.count > 0 && time == 0) time = run.stepper().state().time;
  });
  return time;
}

// 123: EPSMAJ is the larger strain in the plane, EPSTHIN the strain through the thickness; FAIL the plastic strain.
TEST(ModifiedPlasticity, FailsByItsStrains) {
  const std::string card1 = "123\n1,1.,1e5,0.3,10.,5.";  // elastic strains are nothing beside the plastic ones
  const auto major = fails_at(card1 + "\n0.,0.,0,0,0.,0.,0.1\n", {0.5, 0, 0, 0}, 1);
  EXPECT_NEAR(std::log(1 + 0.5 * major), 0.1, 1e-3);
  // Constant volume: with y held the sheet thins as it stretches, with both stretched twice as fast.
  const auto thin = fails_at(card1 + "\n0.,0.,0,0,0.,0.1\n", {0.5, 0, 0, 0}, 1),
             both = fails_at(card1 + "\n0.,0.,0,0,0.,0.1\n", {0.5, 0.5, 0, 0}, 1);
  EXPECT_NEAR(std::log(1 + 0.5 * thin), 0.1, 1e-3);
  EXPECT_NEAR(std::log(1 + 0.5 * both), 0.05, 1e-3);
  const auto plastic = fails_at(card1 + ",0.1\n", {0.5, 0, 0, 0}, 1);
  EXPECT_NEAR(std::log(1 + 0.5 * plastic) * 2 / std::sqrt(3), 0.1, 1e-3);
  EXPECT_NEAR(fails_at(card1 + ",0.1\n0.,0.,0,0,0.,0.,0.,1.\n", {0.5, 0, 0, 0}, 1), plastic, 1e-3);
  EXPECT_EQ(fails_at(card1 + "\n0.,0.,0,0,0.,0.5,0.5\n", {0.5, 0, 0, 0}, 1), 0);
  const Material rates = built(card1 + "\n40.,5.\n0.,0.1,0.5\n20.,30.,50.\n");
  EXPECT_EQ(rates.rate_c, 40);
  EXPECT_NEAR(rates.yield.stress(0.3), 40, 1e-12);
}

TEST(PlasticityVariants, HostileCards) {
  const std::pair<const char*, const char*> cases[] = {
      {"018\n1,1.,1000.,0.3,50.,0.25\n", ""},
      {"018\n1,1.,1000.,0.3,0.,0.25\n", "K = 0"},
      {"018\n1,1.,1000.,0.3,50.,1.5\n", "N = 1.5"},
      {"018\n1,1.,0.,0.3,50.,0.25\n", "E = 0"},
      {"018\n1,1.,1000.,0.3,50.,0.25\n-1.\n", "SIGY = -1"},
      {"018\n1,1.,1000.,0.3,1e-9,0.01\n30.\n", "strain at yield"},
      {"081\n1,1.,1000.,0.3,10.,5.,0.1\n0.,0.,0,0,0.3\n", ""},
      {"081\n1,1.,1000.,0.3,10.,5.\n", ""},
      {"081\n1,1.,1000.,0.3,10.,5.,0.4\n0.,0.,0,0,0.3\n", "EPPFR = 0.3 is not above EPPF = 0.4"},
      {"081\n1,1.,1000.,0.3,10.,5.,-0.4\n0.,0.,0,0,0.3\n", "EPPF or EPPFR is below 0"},
      {"081\n1,1.,1000.,0.3,10.,5.,0.1\n0.,0.,0,0,0.3,0.,7\n", "LCDM"},
      {"081\n1,1.,1000.,0.3,10.,5.,0.1\n0.,0.,0,0,0.3,0.,0,2\n", "NUMINT = 2"},
      {"123\n1,1.,1000.,0.3,10.,5.\n0.,0.,0,0,0.,0.3,0.2,2.\n", ""},
      {"123\n1,1.,1000.,0.3,10.,5.\n0.,0.,0,0,0.,-0.3\n", "EPSTHIN < 0"},
      {"123\n1,1.,1000.,0.3,10.,5.\n0.,0.,0,0,0.,0.,-0.3\n", "EPSMAJ < 0"},
      {"123\n1,1.,1000.,0.3,10.,5.\n0.,0.,0,0,0.,0.3,0.,2.5\n", "NUMINT = 2.5"},
      {"123\n1,1.,1000.,0.3,10.,5.\n0.,0.,0,0,0.,0.3\n*MAT_ADD_EROSION\n1\n0.,0.3\n", "keep one of them"},
      {"123\n1,1.,1000.,0.3,10.,5.\n0.,0.,9\n", "yield curve or table that is not there"},
  };
  for (const auto& [cards, says] : cases) {
    RunScene scene(stretched_square(std::string("*MAT_") + cards, {0.01, 0, 0, 0}, 0.01));
    const std::string said = scene.message() + scene.read().text();
    EXPECT_EQ(!scene.prepared() || scene.read().errors() > 0, std::string_view(says) != "") << cards << said;
    EXPECT_NE(said.find(says), std::string::npos) << cards << said;
  }
  RunScene solid(stretched_cube("*MAT_123\n1,1.,1000.,0.3,10.,5.\n0.,0.,0,0,0.,0.3\n", {0.01, 0, 0, 0}, 0.01));
  EXPECT_NE(solid.message().find("for shells only"), std::string::npos) << solid.message();
}

}  // namespace
}  // namespace gapcheck::solver::build_plasticity_test
