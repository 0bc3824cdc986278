#include "solver/material/erosion.hpp"

#include <cmath>

#include "solver/run_scene.hpp"
#include "solver/stretched_element.hpp"

namespace gapcheck::solver::erosion_test {
namespace {

// Strains and stresses whose measures are known, in turned axes.
TEST(Erosion, Measures) {
  const Matrix turn = spin_rotation(Vector(0.4, -0.9, 1.3));
  const ErosionMeasures of =
      erosion_measures(rotated({30, -60, 0, 0, 0, 0}, turn), rotated({0.03, -0.01, 0.01, 0, 0, 0}, turn), 0.7);
  EXPECT_NEAR(of.pressure, 10, 1e-12);
  EXPECT_NEAR(of.principal_stress, 30, 1e-12);
  EXPECT_NEAR(of.von_mises, std::sqrt(30.0 * 30 + 30 * 60 + 60 * 60), 1e-12);
  EXPECT_NEAR(of.least_strain, -0.01, 1e-15);
  EXPECT_NEAR(of.greatest_strain, 0.03, 1e-15);
  EXPECT_NEAR(of.shear_strain, 0.02, 1e-15);
  EXPECT_NEAR(of.volume_strain, 0.03, 1e-15);
  // The deviator is 0.02, −0.02, 0.
  EXPECT_NEAR(of.effective_strain, std::sqrt(2.0 / 3 * 8e-4), 1e-15);
  EXPECT_EQ(of.plastic_strain, 0.7);
}

TEST(Erosion, CountsCriteria) {
  Erosion erosion;
  EXPECT_EQ(erosion.given(), 0);
  EXPECT_EQ(erosion.met({}, 1e30), 0);
  erosion.max_strain = 0.1;
  erosion.min_pressure = 0;
  EXPECT_EQ(erosion.given(), 2);
  EXPECT_EQ(erosion.met({}, 0), 0) << "no tension at rest";
  ErosionMeasures of;
  of.pressure = -1e-9;
  EXPECT_EQ(erosion.met(of, 0), 1);
  of.greatest_strain = 0.1;
  EXPECT_EQ(erosion.met(of, 0), 2);
}

std::string element(bool solid, const std::string& erosion, const Stretch& s, int elform = 0,
                    const std::string& material = "*MAT_ELASTIC\n1,1.,1000.,0.25\n") {
  const std::string cards = material + "*MAT_ADD_EROSION\n" + erosion;
  return solid ? stretched_cube(cards, s, 1, elform == 0 ? 1 : elform)
               : stretched_square(cards, s, 1, elform == 0 ? 2 : elform);
}

/// When the element goes; 0: it stays to the end.
double time_of_failure(const std::string& deck, double dt = 1e-4) {
  RunSettings fine;
  fine.step.greatest_step = dt;
  RunScene scene(deck, fine);
  if (!scene.prepared()) {
    ADD_FAILURE() << scene.message();
    return -1;
  }
  double time = 0;
  scene.go([&](const solver::Run& run) {
    if (time == 0 && run.stepper().state().failed.count > 0) time = run.stepper().state().time;
  });
  EXPECT_NEAR(scene.energies().ratio(), 1, 1e-6);
  return time;
}

// Uniaxial strain at unit rate: ε = ln(1 + t), and the elastic law is one of logarithmic strains here. The element goes
// in the first step past the closed form.
TEST(Erosion, CriteriaOfASolid) {
  const double young = 1000, nu = 0.25, shear = young / (2 * (1 + nu)), bulk = young / (3 * (1 - 2 * nu));
  const Stretch pull{0.5, 0, 0, 0}, push{-0.5, 0, 0, 0};
  const auto when = [](double strain) { return (std::exp(strain) - 1) / 0.5; };
  const struct {
    const char* what;
    std::string cards;
    Stretch move;
    double strain;
  } cases[] = {
      {"MXPRES", "1,0.,20.\n", push, -20 / bulk},
      {"MNEPS", "1,0.,0.,-0.1\n", push, -0.1},
      {"EFFEPS", "1,0.,0.,0.,0.08\n", pull, 0.08 * 1.5},
      {"VOLEPS", "1,0.,0.,0.,0.,0.15\n", pull, 0.15},
      {"VOLEPS < 0", "1,0.,0.,0.,0.,-0.15\n", push, -0.15},
      {"MNPRES", "1\n-20.\n", pull, 20 / bulk},
      {"SIGP1", "1\n0.,50.\n", pull, 50 / (bulk + 4 * shear / 3)},
      {"SIGVM", "1\n0.,0.,50.\n", pull, 50 / (2 * shear)},
      {"MXEPS", "1\n0.,0.,0.,0.12\n", pull, 0.12},
      {"EPSSH", "1\n0.,0.,0.,0.,0.06\n", pull, 0.12},
  };
  for (const auto& one : cases)
    for (const int elform : {1, 2}) {
      const double time = time_of_failure(element(true, one.cards, one.move, elform));
      const double expected = std::abs(when(one.strain));
      EXPECT_GE(time, expected - 1e-9) << one.what;
      EXPECT_LE(time, expected + 2.5e-4) << one.what;
    }
}

// A shell in plane strain: the strain through it is −ν/(1 − ν) of that in the plane. Equal layers fail at once.
TEST(Erosion, CriteriaOfAShell) {
  const Stretch pull{0.5, 0, 0, 0};
  for (const int elform : {2, 16}) {
    const double volume = time_of_failure(element(false, "1,0.,0.,0.,0.,0.1\n", pull, elform));
    EXPECT_NEAR(volume, (std::exp(0.1 / (1 - 1.0 / 3)) - 1) / 0.5, 3e-4);
    const double least = time_of_failure(element(false, "1,0.,0.,-0.05\n", pull, elform));
    EXPECT_NEAR(least, (std::exp(0.15) - 1) / 0.5, 3e-4);
  }
}

// EXCL = 888 leaves out what has this value; blanks of card 1 are left out too, MNPRES = 0 is not: no tension.
TEST(Erosion, Exclusion) {
  const Stretch pull{0.5, 0, 0, 0};
  EXPECT_NEAR(time_of_failure(element(true, "1,888\n888,888,888,.12,888,888,888\n", pull)), (std::exp(0.12) - 1) / 0.5,
              3e-4);
  EXPECT_LE(time_of_failure(element(true, "1,888\n0.,888,888,.12,888,888,888\n", pull)), 3e-4);
  EXPECT_EQ(time_of_failure(element(true, "1,888\n888,888,888,888,888,888,888\n", pull)), 0);
}

// Both criteria must be met with NCS = 2; FAILTM alone ends an element at its time.
TEST(Erosion, TwoCriteriaAndTime) {
  const Stretch pull{0.5, 0, 0, 0};
  EXPECT_NEAR(time_of_failure(element(true, "1,0.,0.,0.,0.,0.,1,2\n0.,0.,0.,0.05,0.06\n", pull)),
              (std::exp(0.12) - 1) / 0.5, 3e-4);
  EXPECT_NEAR(time_of_failure(element(true, "1\n0.,0.,0.,0.,0.,0.,0.,0.35\n", pull)), 0.35, 2e-4);
  EXPECT_NEAR(time_of_failure(element(false, "1\n0.,0.,0.,0.,0.,0.,0.,0.35\n", pull)), 0.35, 2e-4);
}

// σ₁ = M t for small strains at unit rate: ∫ (M t − s)² dt = (M t − s)³ / (3 M) from the threshold on.
TEST(Erosion, Impulse) {
  const double modulus = 1000 * 0.75 / (1.25 * 0.5);
  const double time = time_of_failure(element(true, "1,-1.\n-1.,-1.,-1.,-1.,-1.,0.5,1e-4\n", {0.01, 0, 0, 0}), 1e-3);
  const double rate = modulus * 0.01;
  EXPECT_NEAR(time, (std::cbrt(3 * rate * 1e-4) + 0.5) / rate, 0.02 * time);
}

// Plastic strain, EFFEPS < 0, against FAIL of the material itself.
TEST(Erosion, PlasticStrain) {
  const Stretch pull{0.5, 0, 0, 0};
  const auto steel = [](const char* fail) { return fmt::format("*MAT_024\n1,1.,1000.,0.25,10.,100.,{}\n\n", fail); };
  for (const bool solid : {true, false}) {
    const double own = time_of_failure(element(solid, "1\n", pull, 0, steel("0.1")));
    EXPECT_GT(own, 0.1);
    EXPECT_EQ(time_of_failure(element(solid, "1,0.,0.,0.,-0.1\n", pull, 0, steel("0."))), own);
  }
}

// Bent about y, the layers at ±√(3/5) of half the thickness reach a strain first and the one in the middle never does.
TEST(Erosion, LayersThatMustFail) {
  const auto bent = [](const char* points) {
    const std::string deck =
        plate(1, 1, {1, 1, 0}) + "*PART\np\n1,1,1\n*SECTION_SHELL\n1,2,,3\n0.2\n*MAT_ELASTIC\n1,1.,1000.,0.\n" +
        fmt::format("*MAT_ADD_EROSION\n1,0.,0.,0.,0.01,0.,{}\n", points) +
        "*CONTROL_TERMINATION\n1.\n*DEFINE_CURVE\n1\n0.,1.\n1.,1.\n*BOUNDARY_PRESCRIBED_MOTION_SET\n2,6,0,1,0.2\n"
        "*SET_NODE_LIST\n1\n1,3\n*SET_NODE_LIST\n2\n2,4\n*SET_NODE_LIST\n3\n1,2,3,4\n"
        "*BOUNDARY_PRESCRIBED_MOTION_SET\n1,6,0,1,-0.2\n*BOUNDARY_SPC_SET\n3,0,1,1,1,1,0,1\n";
    return time_of_failure(deck, 1e-3);
  };
  // Curvature 0.4 t, so ε = 0.04 √0.6 t at the outer layers, and their effective strain is 2/3 of it.
  const double outer = 0.01 * 1.5 / (0.04 * std::sqrt(0.6));
  EXPECT_NEAR(bent("1"), outer, 5e-3);
  EXPECT_NEAR(bent("2"), outer, 5e-3);
  EXPECT_NEAR(bent("-60."), outer, 5e-3);
  EXPECT_EQ(bent("3"), 0);
  EXPECT_EQ(bent("-100."), 0);
}

// The strain turns with the body: a turning block that is not strained keeps its elements.
TEST(Erosion, RigidTurn) {
  Material material{MaterialKind::elastic, 1, 1000, 0.25, {}, 0, 0, 0, {}, 1};
  material.erosion.emplace();
  PointState point;
  const Matrix stretch = Vector(0.1, -0.05, 0.02).asDiagonal();
  for (int i = 0; i < 100; ++i) update_solid_stress(material, stretch, 0.01, point);
  const Symmetric before = point.strain;
  EXPECT_NEAR(before[xx], 0.1, 1e-12);
  Matrix spin = Matrix::Zero();
  spin(1, 0) = 1;
  spin(0, 1) = -1;
  const double dt = 2 * std::tan(std::acos(-1.0) / 4 / 500);  // a quarter turn in 500 Hughes-Winget steps
  for (int i = 0; i < 500; ++i) update_solid_stress(material, spin, dt, point);
  EXPECT_NEAR(point.strain[xx], before[yy], 1e-10);
  EXPECT_NEAR(point.strain[yy], before[xx], 1e-10);
  EXPECT_NEAR(point.strain[zz], before[zz], 1e-12);
}

// Refused before the first cycle, with the field's name and the line of the card.
TEST(Erosion, HostileCards) {
  const std::pair<const char*, const char*> cases[] = {
      {"1,0.,-20.\n", "MXPRES"},
      {"1,0.,0.,0.1\n", "MNEPS"},
      {"1,1.\n0.,1.,1.,1.,1.,1.,1.\n", ""},
      {"1,1.\n1.,0.,1.,1.,1.,1.,1.\n", "SIGP1"},
      {"1\n5.\n", "MNPRES"},
      {"1\n0.,-7.\n", "SIGP1"},
      {"1\n0.,0.,-7.\n", "SIGVM"},
      {"1\n0.,0.,0.,-7.\n", "MXEPS"},
      {"1\n0.,0.,0.,0.,-7.\n", "EPSSH"},
      {"1\n0.,0.,0.,0.,0.,0.,5.\n", "SIGTH"},
      {"1\n0.,0.,0.,0.,0.,-5.,5.\n", "SIGTH"},
      {"1\n0.,0.,0.,0.,0.,5.,-5.\n", "IMPULSE"},
      {"1\n0.,0.,0.,0.,0.,0.,0.,-1.\n", "FAILTM"},
      {"1,0.,0.,0.,0.,0.,2.5\n0.,1.\n", "NUMFIP"},
      {"1,0.,0.,0.,0.,0.,1e9\n0.,1.\n", "NUMFIP"},
      {"1,0.,0.,0.,0.,0.,-101.\n0.,1.\n", "NUMFIP"},
      {"1,0.,0.,0.,0.,0.,1,2\n0.,1.\n", "NCS"},
      {"1,0.,0.,0.,0.,0.,1,1.5\n0.,1.,1.\n", "NCS"},
      {"1\n0.,1.\n1.\n", "IDAM"},
      {"1\n0.,1.\n\n0.,0.,3.\n", "field 3 of card 4"},
      {"1\n0.,1.\n*MAT_ADD_EROSION\n1\n0.,2.\n", "two *MAT_ADD_EROSION"},
      {"1,0.,nan\n", "is not a number"},
      {"1\n0.,1e300\n", "is larger than 1e30"},
  };
  for (const auto& [cards, name] : cases) {
    RunScene scene(element(true, cards, {0.5, 0, 0, 0}));
    const std::string said = scene.message() + scene.read().text();
    EXPECT_EQ(!scene.prepared() || scene.read().errors() > 0, std::string_view(name) != "") << cards << said;
    EXPECT_NE(said.find(name), std::string::npos) << cards << said;
    if (!scene.prepared()) {
      EXPECT_GT(scene.status().error().place.line, 0u) << cards;
    }
  }
}

}  // namespace
}  // namespace gapcheck::solver::erosion_test
