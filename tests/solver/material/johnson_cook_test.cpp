#include "solver/material/johnson_cook.hpp"

#include <cmath>

#include "solver/run_scene.hpp"
#include "solver/stretched_element.hpp"

namespace gapcheck::solver::johnson_cook_test {
namespace {

Material material_with(const JohnsonCook& law) {
  Material material{MaterialKind::plastic, 1, 1e5, 0.3, {}, 0, 0, 0, {}, 1};
  material.johnson_cook = std::make_shared<const JohnsonCook>(law);
  return material;
}

double von_mises(const Symmetric& stress) {
  const Symmetric s = deviator(stress);
  return std::sqrt(1.5 * contract(s, s));
}

// In simple shear at a constant rate with m = 1 the softening has the closed form
// 1 − T* = exp(−R (A ε + B ε^(n+1) / (n+1)) / (ρ CP (TM − TR))), R = 1 + C ln ε̇*, with all work as heat.
TEST(JohnsonCook, AdiabaticShear) {
  JohnsonCook law;
  law.a = 300;
  law.b = 400;
  law.n = 0.4;
  law.c = 0.02;
  law.rate = 0.1;
  law.heat = 2;
  law.warming = 500;
  const Material material = material_with(law);
  PointState point;
  constexpr double dt = 1e-4, rate = 10;  // ε̇ = 2/√3 of the tensor's shear rate
  const Symmetric increment{0, 0, 0, rate * dt * std::sqrt(3.0) / 2, 0, 0};
  for (int i = 0; i < 1000; ++i) update_stress(material, increment, dt, point);
  const double strain = point.plastic_strain, factor = 1 + 0.02 * std::log(rate / 0.1);
  EXPECT_NEAR(strain, rate * 0.1, 0.02);
  const double work = 300 * strain + 400 * std::pow(strain, 1.4) / 1.4;
  const double softening = std::exp(-factor * work / (2 * 500));
  EXPECT_LT(softening, 0.7);
  EXPECT_NEAR(von_mises(point.stress), (300 + 400 * std::pow(strain, 0.4)) * factor * softening, 0.5);
}

// With VP = 1 the rate is that of the plastic strain; in steady flow of a shell that is stretched equally in both
// directions at e it is 2 e.
TEST(JohnsonCook, PlasticRateInAShell) {
  JohnsonCook law;
  law.a = 300;
  law.c = 0.1;
  law.rate = 1;
  Material material = material_with(law);
  material.viscoplastic = true;
  PointState point;
  for (int i = 0; i < 200; ++i) update_plane_stress(material, {1e-3, 1e-3, 0, 0, 0, 0}, 1e-4, point);
  EXPECT_NEAR(von_mises(point.stress), 300 * (1 + 0.1 * std::log(20)), 1e-3);
  // Below EPSO the rate does not count.
  point = {};
  for (int i = 0; i < 200; ++i) update_plane_stress(material, {1e-3, 1e-3, 0, 0, 0, 0}, 1, point);
  EXPECT_NEAR(von_mises(point.stress), 300, 1e-6);
}

// σ* = 0 in shear and 1/3 in uniaxial tension; D4 counts ln ε̇*.
TEST(JohnsonCook, StrainAtFailure) {
  JohnsonCook law;
  law.a = 300;
  law.rate = 0.01;
  law.d = {0.05, 0.4, -1.5, 0.1, 0};
  law.fails = true;
  const Material material = material_with(law);
  const auto fails_at = [&](bool tension) {
    PointState point;
    double last = 0;
    const Symmetric shear{0, 0, 0, 1e-4, 0, 0}, pull{1e-4, -0.5e-4, 0, 0, 0, 0};
    for (int i = 0; i < 20000 && !point.failed; ++i) {
      last = point.plastic_strain;
      update_plane_stress(material, tension ? pull : shear, 1e-3, point);
    }
    EXPECT_TRUE(point.failed);
    EXPECT_EQ(point.stress, Symmetric{});
    return last;
  };
  const double shear_rate = 0.2 / std::sqrt(3.0);
  EXPECT_NEAR(fails_at(false), 0.45 * (1 + 0.1 * std::log(shear_rate / 0.01)), 1e-3);
  // Flow is at constant volume: the rate is 0.1.
  EXPECT_NEAR(fails_at(true), (0.05 + 0.4 * std::exp(-0.5)) * (1 + 0.1 * std::log(0.1 / 0.01)), 6e-3);
}

TEST(JohnsonCook, LimitsOfTheStress) {
  JohnsonCook law;
  law.a = 300;
  law.b = 1000;
  law.n = 0.5;
  law.most_stress = 500;
  EXPECT_NEAR(law.stress(0.01, 0), 400, 1e-9);
  EXPECT_EQ(law.stress(1, 0), 500);
  law.c = 0.1;
  law.saturation = 520;
  EXPECT_NEAR(law.stress(0.01, std::exp(1)), 440, 1e-9);
  EXPECT_EQ(law.stress(1, std::exp(1)), 520);
  law.heat = 1;
  law.warming = 100;
  EXPECT_EQ(law.warmth(1e9), 1) << "molten";
  EXPECT_EQ(law.softening(1), 0);
}

const std::string polynomial = "*EOS_001\n7,0.,1000.,500.,0.,1.5,1.5,0.\n0.,1.\n*CONTROL_BULK_VISCOSITY\n1e-9,1e-9\n";

PointState end_of(const std::string& deck, bool solid, double* internal = nullptr) {
  RunSettings settings;
  settings.step.greatest_step = 1e-3;
  RunScene scene(deck, settings);
  if (!scene.prepared()) {
    ADD_FAILURE() << scene.message();
    return {};
  }
  scene.go();
  EXPECT_NEAR(scene.energies().ratio(), 1, 1e-9);
  if (internal != nullptr) *internal = scene.energies().internal;
  const Structure& structure = scene.run().stepper().structure();
  return solid ? structure.solids.point(0) : structure.shells.points(0)[0];
}

// With n = 1 and neither rate nor heat it is material 010 in solids and 024 in shells.
TEST(JohnsonCook, LinearHardeningIsThatOfTheOtherMaterials) {
  double work[2];
  const Stretch press{-0.3, 0.1, 0, 0.1}, pull{0.3, -0.1, 0, 0.1};
  const PointState solid = end_of(
      stretched_cube("*MAT_JOHNSON_COOK\n1,1.,400.\n20.,50.,1.\n0.\n" + polynomial, press, 1, 1, 7), true, &work[0]);
  const PointState other =
      end_of(stretched_cube("*MAT_010\n1,1.,400.,20.,50.\n" + polynomial, press, 1, 1, 7), true, &work[1]);
  EXPECT_GT(solid.plastic_strain, 0.1);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(solid.stress[i], other.stress[i], 1e-8);
  EXPECT_NEAR(work[0], work[1], 1e-9 * work[0]);
  for (const char* name :
       {"JOHNSON_COOK\n1,1.,0.,1000.,0.3\n20.,50.,1.\n0.\n", "SIMPLIFIED_JOHNSON_COOK\n1,1.,1000.,0.3\n20.,50.,1.\n"}) {
    const PointState shell = end_of(stretched_square(std::string("*MAT_") + name, pull, 1), false);
    const PointState steel =
        end_of(stretched_square(fmt::format("*MAT_024\n1,1.,1000.,0.3,20.,{}\n", 1000 * 50.0 / 1050), pull, 1), false);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(shell.stress[i], steel.stress[i], 1e-6);
  }
}

// Pulled at a mean stress of 1000 t PC = −10 is met at once: SPALL is 2 where it is not given.
TEST(JohnsonCook, Spall) {
  const auto stress = [](const char* spall) {
    return end_of(stretched_cube(std::string("*MAT_JOHNSON_COOK\n1,1.,400.\n20.\n0.,-10.,") + spall +
                                     "\n*EOS_001\n7,0.,1000.\n0.,1.\n*CONTROL_BULK_VISCOSITY\n1e-9,1e-9\n",
                                 {0.1, 0, 0, 0}, 1, 1, 7),
                  true)
        .stress[xx];
  };
  EXPECT_NEAR(stress("1."), 10 + 2.0 / 3 * 20, 1e-9);
  for (const char* spall : {"0.", "2.", "3."}) EXPECT_EQ(stress(spall), 0) << spall;
}

// A solid and a shell in a whole run go when the damage is complete.
TEST(JohnsonCook, ElementsFail) {
  const auto failed = [](const std::string& deck) {
    RunSettings settings;
    settings.step.greatest_step = 1e-4;
    RunScene scene(deck, settings);
    EXPECT_TRUE(scene.prepared()) << scene.message();
    double strain = 0, last = 0;
    scene.go([&](const solver::Run& run) {
      const Structure& structure = run.stepper().structure();
      if (run.stepper().state().failed.count > 0 && strain == 0) strain = last;
      last = structure.solids.size() > 0 ? structure.solids.point(0).plastic_strain
                                         : structure.shells.points(0)[0].plastic_strain;
    });
    return strain;
  };
  const Stretch shear{0, 0, 0, 1};
  EXPECT_NEAR(
      failed(stretched_cube("*MAT_JOHNSON_COOK\n1,1.,4000.\n20.\n0.,0.,0.,0.,0.1,0.1\n" + polynomial, shear, 1, 1, 7)),
      0.2, 1e-3);
  EXPECT_NEAR(failed(stretched_square("*MAT_JOHNSON_COOK\n1,1.,0.,1e4,0.3\n20.\n0.,0.,0.,0.,0.1,0.1\n", shear, 1)), 0.2,
              1e-3);
  EXPECT_NEAR(failed(stretched_square("*MAT_SIMPLIFIED_JOHNSON_COOK\n1,1.,1e4,0.3\n20.,0.,0.,0.,0.2\n", shear, 1)), 0.2,
              1e-3);
}

TEST(JohnsonCook, TurnsWithTheBody) {
  JohnsonCook law;
  law.a = 20;
  const Material material = material_with(law);
  PointState point;
  update_solid_stress(material, Vector(0.01, -0.005, 0.002).asDiagonal(), 1, point);
  const Symmetric before = point.stress;
  Matrix spin = Matrix::Zero();
  spin(1, 0) = 1;
  spin(0, 1) = -1;
  const double dt = 2 * std::tan(std::acos(-1.0) / 4 / 500);
  for (int i = 0; i < 500; ++i) update_solid_stress(material, spin, dt, point);
  EXPECT_NEAR(point.stress[xx], before[yy], 1e-9 * std::abs(before[xx]));
  EXPECT_NEAR(point.stress[yy], before[xx], 1e-9 * std::abs(before[xx]));
}

TEST(JohnsonCook, HostileCards) {
  const std::pair<const char*, const char*> cases[] = {
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.,50.,1.\n0.\n", ""},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n", "A = 0"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n-20.\n", "A = -20"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.,-1.\n", "B = -1"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.,50.\n", "N = 0"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.,0.,0.,-1.\n", "C = -1"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.,0.,0.,1.\n", "EPSO = 0"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.,0.,0.,0.,1.,300.,300.\n5.\n", "TM = 300"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.,0.,0.,0.,0.,900.,300.\n5.\n", "M = 0"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.\n-5.\n", "CP is below 0"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.\n0.,5.\n", "PC = 5"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.\n0.,-5.,7.\n", "SPALL = 7"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.\n0.,0.,0.,0.,-1.\n", "D1 + D2"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.\n0.\n0.,0.,0.,-1.\n", "EFMIN"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.\n0.\n0.,3.\n", "C2/P"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.\n0.\n0.,0.,1.\n", "EROD"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.\n0.\n0.,0.,0.,0.,2.\n", "NUMINT"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3,1e-3\n20.\n", "DTF"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3,0.,3.\n20.\n", "VP = 3"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3,0.,0.,1.\n20.\n", "RATEOP"},
      {"JOHNSON_COOK\n1,1.,0.,1000.,0.3\n20.\n", "G = 0"},
      {"JOHNSON_COOK\n1,1.,nan,1000.,0.3\n20.\n", "is not a number"},
      {"JOHNSON_COOK\n1,1.,400.,1000.,0.3\n1e300\n", "is larger than 1e30"},
      {"JOHNSON_COOK\n1,0.,400.,1000.,0.3\n20.\n", "out of range"},
      {"SIMPLIFIED_JOHNSON_COOK\n1,1.,1000.,0.3\n20.\n", ""},
      {"SIMPLIFIED_JOHNSON_COOK\n1,1.,1000.,0.3\n20.,0.,0.,0.,-1.\n", "PSFAIL"},
      {"SIMPLIFIED_JOHNSON_COOK\n1,1.,1000.,0.3\n20.,0.,0.,0.,0.,-1.\n", "SIGMAX"},
      {"SIMPLIFIED_JOHNSON_COOK\n1,1.,1000.,0.5\n20.\n", "out of range"},
  };
  for (const auto& [cards, says] : cases) {
    RunScene scene(stretched_cube(std::string("*MAT_") + cards + polynomial, {0.01, 0, 0, 0}, 0.01, 1, 7));
    const std::string said = scene.message() + scene.read().text();
    EXPECT_EQ(!scene.prepared() || scene.read().errors() > 0, std::string_view(says) != "") << cards << said;
    EXPECT_NE(said.find(says), std::string::npos) << cards << said;
  }
  RunScene shell(stretched_square("*MAT_JOHNSON_COOK\n1,1.,400.,1000.,0.3\n20.\n0.,-5.\n", {0.01, 0, 0, 0}, 0.01));
  EXPECT_NE(shell.message().find("PC = -5 is not calculated in shells"), std::string::npos) << shell.message();
  RunScene without(stretched_square("*MAT_JOHNSON_COOK\n1,1.,400.\n20.\n", {0.01, 0, 0, 0}, 0.01));
  EXPECT_NE(without.message().find("in solids only"), std::string::npos) << without.message();
}

}  // namespace
}  // namespace gapcheck::solver::johnson_cook_test
