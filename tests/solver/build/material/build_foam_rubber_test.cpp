// Cards of foams and rubbers, and single elements of them in whole runs.
#include "solver/build/material/build_foam_rubber.hpp"

#include <cmath>
#include <cstdlib>

#include "contact/stiffness/element_timestep.hpp"
#include "contact/stiffness/stiffness.hpp"
#include "solver/output/state_balance.hpp"
#include "solver/run_scene.hpp"
#include "solver/stretched_element.hpp"

namespace gapcheck::solver::build_foam_rubber_test {
namespace {

const std::string foam_curve = "*DEFINE_CURVE\n7\n0.,0.\n0.1,0.4\n0.6,0.5\n0.8,2.5\n";
const std::string rubber_curve = "*DEFINE_CURVE\n8\n-0.5,-3.\n0.,0.\n1.,1.5\n";

struct End {
  Symmetric stress{};
  double work = 0, lost = 0;  ///< internal energy, and what the elements do not store of it
};

/// The stress of the first solid at the end, the mean over its points.
End end_of(const std::string& deck, double greatest_step = 1e-3) {
  RunSettings settings;
  settings.step.greatest_step = greatest_step;
  RunScene scene(deck, settings);
  if (!scene.prepared()) {
    ADD_FAILURE() << scene.message();
    return {};
  }
  scene.go();
  EXPECT_NEAR(scene.energies().ratio(), 1, 1e-9);
  const StateBalance balance = state_balance(scene.run());
  EXPECT_NEAR(balance.created() / balance.largest, 0, 1e-2);
  const SolidElements& solids = scene.run().stepper().structure().solids;
  return {solids.point(0).stress, scene.energies().internal,
          scene.energies().internal - solids.stored(0, scene.state().x)};
}

/// ELFORM 1 and 2; the foam's damping is next to nothing.
double pressed(int elform, double to, const std::string& card1_end, const std::string& card2, End* end = nullptr) {
  const End all = end_of(stretched_cube("*MAT_057\n1,1.,3.,7," + card1_end + ",1e-9\n" + card2 + "\n" + foam_curve,
                                        {to - 1, 0, 0, 0}, 1, elform));
  if (end != nullptr) *end = all;
  EXPECT_NEAR(all.stress[yy], 0, 1e-9);
  return all.stress[xx];
}

// Pressed along x with free energy of the curve; the points of an eight-point brick are alike.
TEST(LowDensityFoam, BrickFollowsTheCurve) {
  for (const int elform : {1, 2, -1}) {
    End end;
    EXPECT_NEAR(pressed(elform, 0.65, "0.,0.,0.", "0.", &end), -0.45, 1e-3) << elform;
    EXPECT_NEAR(end.work, 0.02 + 0.25 * 0.425, 1e-4) << elform;
    EXPECT_NEAR(end.lost, 0, 1e-4) << elform;
    EXPECT_NEAR(pressed(elform, 1.1, "0.2,0.,0.", "0."), 0.2, 1e-9) << elform;    // TC
    EXPECT_NEAR(pressed(elform, 1.1, "0.2,0.,0.", "0.,1."), 0., 1e-9) << elform;  // FAIL
  }
}

// The viscous stress DAMP ρ c l ε̇ with l of the brick, ρ c² of the steepest piece: its force on a face, and its work.
TEST(LowDensityFoam, Damping) {
  const std::string deck = stretched_cube("*MAT_057\n1,1.,3.,7,0.,0.,0.,0.5\n0.\n" + foam_curve, {-0.01, 0, 0, 0}, 1);
  const End with = end_of(deck);
  // The work of the curve is 4 ε²/2 of a strain of 0.01, that of the damping 0.5 √10 ε̇ ε.
  EXPECT_NEAR(with.work, 2e-4 + 0.5 * std::sqrt(10) * 1e-4, 3e-6);
  EXPECT_NEAR(with.lost, 0.5 * std::sqrt(10) * 1e-4, 3e-6);
}

// Contacts take KCON, or the steepest piece; the step takes the greatest of both and of E.
TEST(LowDensityFoam, StiffnessOfContactsAndStep) {
  const auto material = [](const std::string& kcon, const std::string& young) {
    return model::read_text("*MAT_057\n1,2.," + young + ",7\n0.,0.,0.,0.,0.," + kcon + "\n" + foam_curve)
        .model.materials.at(0);
  };
  EXPECT_DOUBLE_EQ(contact::contact_modulus(material("0.", "3.")), 10);
  EXPECT_DOUBLE_EQ(contact::contact_modulus(material("5.", "3.")), 5);
  EXPECT_DOUBLE_EQ(contact::solid_sound_speed(material("5.", "3."), 2), std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(contact::solid_sound_speed(material("0.", "50."), 2), 5);
}

// The curve is that of the test: a bar of the foam pulled and pressed with its lateral stretch.
TEST(TabulatedRubber, FoamFollowsItsCurve) {
  for (const int elform : {1, 2})
    for (const double to : {0.6, 1.5}) {
      // Lateral motion of a constant rate reaches λ^−ν at the end.
      const double lateral = std::pow(to, -0.2) - 1;
      const End end = end_of(stretched_cube(
          "*MAT_181\n1,1.,5.,1e-9\n1.,1.,1.,8,0.,0.,0.,0.2\n" + rubber_curve + "*CONTROL_BULK_VISCOSITY\n1e-9,1e-9\n",
          {to - 1, lateral, lateral, 0}, 1, elform));
      const double nominal = to < 1 ? 6 * (to - 1) : 1.5 * (to - 1);
      EXPECT_NEAR(end.stress[xx] * (1 + lateral) * (1 + lateral), nominal, 2e-3 * std::abs(nominal)) << elform << to;
      EXPECT_NEAR(end.stress[yy], 0, 3e-3) << elform << to;
    }
}

/// 181 with rubber_curve at the rate 0.1 and twice that at 1.1; `fields`: TENSION, RTYPE, AVGOPT, PR and further cards.
std::string rubber_of_rates(const std::string& bulk, const std::string& fields) {
  return "*MAT_181\n1,1.," + bulk + ",1e-9\n1.,1.,1.,2," + fields + "\n" + rubber_curve +
         "*DEFINE_CURVE\n9\n-0.5,-6.\n0.,0.\n1.,3.\n*DEFINE_TABLE_2D\n2\n0.1,8\n1.1,9\n"
         "*CONTROL_BULK_VISCOSITY\n1e-9,1e-9\n";
}

// A bar pulled or pressed by the engineering rate v, at the end also by the true rate v/λ: the stress lies between the
// curves as the rate does, where TENSION says that it counts.
TEST(TabulatedRubber, RatesOfATable) {
  constexpr double step = 1e-4;
  for (const double to : {0.6, 1.5})
    for (const int tension : {-1, 0, 1})
      for (const int type : {0, 1})
        for (const double poisson : {0.2, 0.5}) {
          const double v = to - 1, lateral = std::pow(to, -poisson) - 1;
          const std::string rubber = rubber_of_rates(
              poisson < 0.5 ? "5." : "50.", fmt::format("{},{},0.,{}", tension, type, poisson < 0.5 ? poisson : 0.));
          const End end = end_of(stretched_cube(rubber, {v, lateral, lateral, 0}, 1), step);
          const double rate = std::abs(type == 0 ? v / to : v), slow = to < 1 ? 6 * v : 1.5 * v;
          const double nominal = to > 1 && tension == 0 ? slow : slow * (1 + (rate - 0.1));
          const double area = (1 + lateral) * (1 + lateral);
          EXPECT_NEAR((end.stress[xx] - end.stress[yy]) * area, nominal, 2e-3 * std::abs(nominal))
              << to << ' ' << tension << ' ' << type << ' ' << poisson;
        }
}

// AVGOPT below 0 averages the true rate over that time: ln(λ(t)/λ(t − T))/T.
TEST(TabulatedRubber, RatesOverAWindow) {
  const double lateral = std::pow(0.6, -0.2) - 1;
  const auto nominal = [&](double window) {
    const Symmetric stress = end_of(stretched_cube(rubber_of_rates("5.", fmt::format("0.,0.,{},0.2", -window)),
                                                   {-0.4, lateral, lateral, 0}, 1),
                                    1e-3)
                                 .stress;
    return (stress[xx] - stress[yy]) * (1 + lateral) * (1 + lateral);
  };
  const auto expected = [&](double window) {
    return 6 * -0.4 * (1 + std::log((0.6 + 0.4 * window) / 0.6) / window - 0.1);
  };
  EXPECT_GT(std::abs(expected(0.5) - expected(0.1)), 0.1);
  EXPECT_NEAR(nominal(0.1), expected(0.1), 0.01);
  EXPECT_NEAR(nominal(0.5), expected(0.5), 0.01);
  EXPECT_LT(std::abs(nominal(0.5)), std::abs(nominal(0.1)));
}

// A table of one curve, and rates below the first one, are the curve: bit by bit.
TEST(TabulatedRubber, SlowTableIsItsCurve) {
  const Stretch press{-0.01, 0.002, 0.003, 0.01};
  const auto stress = [&](int elform, const std::string& id, const std::string& table) {
    return end_of(stretched_cube("*MAT_181\n1,1.,5.,0.1\n1.,1.,1.," + id + ",1.,0.,0.,0.2\n" + rubber_curve +
                                     "*DEFINE_CURVE\n9\n-0.5,-6.\n0.,0.\n1.,3.\n" + table,
                                 press, 1, elform))
        .stress;
  };
  for (const int elform : {1, 2}) {
    const Symmetric curve = stress(elform, "8", "");
    EXPECT_EQ(stress(elform, "2", "*DEFINE_TABLE_2D\n2\n0.1,8\n1.1,9\n"), curve);
    EXPECT_EQ(stress(elform, "2", "*DEFINE_TABLE_2D\n2\n0.,8\n"), curve);
    EXPECT_NE(stress(elform, "2", "*DEFINE_TABLE_2D\n2\n0.001,8\n1.1,9\n"), curve);
  }
}

// Force over elongation of a specimen of 10 x 2 x 3 is the same as stress over strain.
TEST(TabulatedRubber, SpecimenAndHysteresis) {
  const Stretch press{-0.2, 0.1, 0.1, 0};
  const std::string off = "*CONTROL_BULK_VISCOSITY\n1e-9,1e-9\n";
  const auto stress = [&](const std::string& card2, const std::string& curve) {
    return end_of(stretched_cube("*MAT_181\n1,1.,50.,1e-9\n" + card2 + curve + off, press, 1)).stress;
  };
  const Symmetric unit = stress("1.,1.,1.,8\n", rubber_curve);
  const Symmetric of_test = stress("10.,2.,3.,8\n", "*DEFINE_CURVE\n8\n-5.,-18.\n0.,0.\n10.,9.\n");
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(unit[i], of_test[i], 1e-12);
  // Rubber: σxx − σyy = (f(λx) − f(λy)) / J is that of the law, σ without the pressure.
  EXPECT_LT(unit[xx] - unit[yy], -0.9);
}

// Constant rubbers in bricks have the stress of their law, with eight points too; 077_O with α = 2, −2 is 077_H with
// C10 and C01.
TEST(ConstantRubber, OgdenAndInvariantsAgree) {
  const Stretch s{-0.3, 0.2, 0.1, 0.2};
  const std::string ogden = "*MAT_077_O\n1,1.,0.49,0\n1.1,-0.28\n2.,-2.\n",
                    invariants = "*MAT_077_H\n1,1.,0.49,0\n0.55,0.14\n";
  for (const int elform : {1, 2}) {
    const Symmetric a = end_of(stretched_cube(ogden, s, 1, elform)).stress,
                    b = end_of(stretched_cube(invariants, s, 1, elform)).stress;
    for (const std::size_t i : {xy, yz, zx}) EXPECT_NEAR(a[i], b[i], 1e-9);
    EXPECT_NEAR(a[xx] - a[yy], b[xx] - b[yy], 1e-9);
    EXPECT_GT(std::abs(a[xx] - a[yy]), 0.5);
  }
  const model::Material material = model::read_text(ogden).model.materials.at(0);
  EXPECT_NEAR(contact::contact_modulus(material), 2 * 1.38 * 1.49 / (3 * 0.02), 1e-9);
}

TEST(BlatzKo, BrickInShear) {
  const Symmetric stress = end_of(stretched_cube("*MAT_007\n1,1.,1.5\n", {0, 0, 0, 0.8}, 1)).stress;
  EXPECT_NEAR(stress[xy], 1.2, 1e-3);
  EXPECT_NEAR(stress[xx], 0.96, 2e-3);
  EXPECT_NEAR(contact::contact_modulus(model::read_text("*MAT_007\n1,1.,1.5\n").model.materials.at(0)),
              2 * 1.5 * 1.463 / (3 * 0.074), 1e-9);
}

// 063 takes the last slope of its curve as E, and E of the card in contacts.
TEST(CrushableFoamCards, BrickFollowsTheCurve) {
  const std::string cards = "*MAT_063\n1,1.,3.,0.,9,0.4,1e-9\n*DEFINE_CURVE\n9\n0.,1.\n0.3,1.2\n0.6,5.\n0.61,5.5\n";
  for (const int elform : {1, 2}) {
    const End end = end_of(stretched_cube(cards + "*CONTROL_BULK_VISCOSITY\n1e-9,1e-9\n", {-0.15, 0, 0, 0}, 1, elform));
    EXPECT_NEAR(end.stress[xx], -1.1, 1e-9) << elform;
    EXPECT_NEAR(end.stress[yy], 0, 1e-9) << elform;
  }
  EXPECT_DOUBLE_EQ(contact::contact_modulus(model::read_text(cards).model.materials.at(0)), 1);
  EXPECT_NEAR(structure_of(stretched_cube(cards, {}, 1)).solids.properties(0).material.young, 50, 1e-9);
}

TEST(ViscoelasticCards, BrickAndShell) {
  // A constant shear rate; tensor strain rate 0.01.
  const double expected = 2 * 0.01 * (4 + 6 * (1 - std::exp(-3.0)) / 3);
  const std::string card = "*MAT_006\n1,1.,100.,10.,4.,3.\n";
  EXPECT_NEAR(end_of(stretched_cube(card, {0, 0, 0, 0.02}, 1)).stress[xy], expected, 0.01 * expected);
  RunSettings settings;
  settings.step.greatest_step = 1e-3;
  RunScene shell(stretched_square(card, {0, 0, 0, 0.02}, 1), settings);
  ASSERT_TRUE(shell.prepared()) << shell.message();
  shell.go();
  EXPECT_NEAR(shell.run().stepper().structure().shells.points(0)[0].stress[xy], expected, 0.01 * expected);
  EXPECT_EQ(contact::contact_modulus(model::read_text(card).model.materials.at(0)), 100);
}

// The test of a rubber of A = 0.4 and B = 0.1 gives these back.
TEST(MooneyRivlinFit, GivesTheConstantsOfItsTestBack) {
  std::string curve = "*DEFINE_CURVE\n7\n";
  for (const double stretch : {0.6, 0.8, 1.0, 1.3, 1.8, 2.4}) {
    const double stress = 2 * (stretch - 1 / (stretch * stretch)) * (0.4 + 0.1 / stretch);
    curve += fmt::format("{},{}\n", 10 * (stretch - 1), 6 * stress);
  }
  const model::Material material =
      model::read_text("*MAT_027\n1,1.,0.495\n10.,2.,3.,7\n" + curve).model.materials.at(0);
  EXPECT_NEAR(material.mooney_rivlin->a, 0.4, 1e-9);
  EXPECT_NEAR(material.mooney_rivlin->b, 0.1, 1e-9);
  EXPECT_NEAR(contact::contact_modulus(material), 2 * 1.0 * 1.495 / (3 * 0.01), 1e-6);
  const Material built =
      structure_of(stretched_cube("*MAT_027\n1,1.,0.495\n10.,2.,3.,7\n" + curve, {}, 1)).solids.properties(0).material;
  EXPECT_NEAR(built.rubber.a, 0.4, 1e-9);
}

/// GAPCHECK_FREE_CYCLES asks for longer runs.
std::uint64_t cycles(int elform) {
  const char* given = std::getenv("GAPCHECK_FREE_CYCLES");
  return given == nullptr ? (elform == 1 ? 8000 : 1500) : std::strtoull(given, nullptr, 10);
}

/// A cube of 2 x 2 x 2 bricks that is squeezed and let go. `step`: the greatest one; 0: that of the bricks.
double energy_created(const std::string& cards, int elform, double step, double& kinetic) {
  std::string nodes = grid_nodes(2, 2, 2, {1, 1, 1}) + "*ELEMENT_SOLID\n";
  for (int k = 0, id = 1; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i, ++id) {
        const int a = 1 + i + 3 * j + 9 * k;
        nodes +=
            fmt::format("{},1,{},{},{},{},{},{},{},{}\n", id, a, a + 1, a + 4, a + 3, a + 9, a + 10, a + 13, a + 12);
      }
  nodes += "*INITIAL_VELOCITY_NODE\n";
  for (int id = 1; id <= 27; ++id)
    nodes += fmt::format("{},{},{},{}\n", id, ((id - 1) % 3 - 1) * -0.1, ((id * 7) % 5 - 2) * 0.02,
                         ((id * 3) % 7 - 3) * 0.02);
  RunSettings settings;
  settings.cycles = cycles(elform);
  settings.step.energy_tolerance = 0;
  settings.step.greatest_step = step;
  RunScene scene(nodes + fmt::format("*SECTION_SOLID\n1,{}\n*PART\np\n1,1,1\n*CONTROL_HOURGLASS\n5,0.05\n", elform) +
                     "*CONTROL_BULK_VISCOSITY\n1e-9,1e-9\n*CONTROL_TERMINATION\n1e9\n" + cards,
                 settings);
  EXPECT_TRUE(scene.prepared()) << scene.message();
  if (!scene.prepared()) return 1;
  double start = 0, greatest = 0;
  scene.go([&](const solver::Run& run) {
    const Energies& e = run.stepper().energies();
    start = e.printed_initial;
    greatest = std::max(greatest, e.printed_kinetic);
    kinetic = e.printed_kinetic / start;
  });
  EXPECT_LT(greatest, 1.01 * start) << cards;
  const StateBalance balance = state_balance(scene.run());
  return balance.created() / balance.largest;
}

// A free block: nothing supplies energy, so nothing may gain any; without damping and hysteresis what
// it has vibrates on.
TEST(FoamRubber, VibratingBlocksKeepTheirEnergy) {
  const std::tuple<std::string, int, bool> cases[] = {
      {"*MAT_057\n1,1.,3.,7,0.,0.,0.,1e-9\n0.\n" + foam_curve, 1, true},
      {"*MAT_057\n1,1.,3.,7,0.,0.,0.,1e-9\n0.\n" + foam_curve, 2, true},
      {"*MAT_057\n1,1.,3.,7,0.,0.1,0.,0.1\n5.\n" + foam_curve, 1, false},
      {"*MAT_181\n1,1.,50.,1e-9\n1.,1.,1.,8\n" + rubber_curve, 1, true},
      {"*MAT_181\n1,1.,5.,1e-9\n1.,1.,1.,8,0.,0.,0.,0.2\n" + rubber_curve, 2, true},
      {rubber_of_rates("50.", "-1.,0.,0.,0."), 1, false},
      {rubber_of_rates("5.", "0.,1.,0.,0.2"), 2, false},
      {"*MAT_077_O\n1,1.,0.49,0\n1.1,-0.28\n2.,-2.\n", 1, true},
      {"*MAT_077_H\n1,1.,0.49,0\n0.55,0.14,0.,0.01\n", 2, true},
      {"*MAT_007\n1,1.,1.5\n", 1, true},
      {"*MAT_006\n1,1.,100.,10.,4.,0.003\n", 1, false},
      {"*MAT_063\n1,1.,3.,0.,9,0.4,0.1\n*DEFINE_CURVE\n9\n0.,0.1\n0.3,0.2\n0.61,15.\n", 1, false},
  };
  for (const auto& [cards, elform, lasts] : cases) {
    double kinetic = 0;
    EXPECT_NEAR(energy_created(cards, elform, 0.03, kinetic), 0, 2e-2) << cards;  // a step below all bounds
    if (lasts) {
      EXPECT_GT(kinetic, 0.1) << cards;
    }
  }
}

// With the bricks' own step. One that followed the vibration up and down would multiply the energy.
TEST(FoamRubber, VibratingRubberKeepsItsEnergyWithItsOwnStep) {
  const std::pair<std::string, int> cases[] = {
      {"*MAT_027\n1,1.,0.49,0.55,0.14\n\n", 1},
      {"*MAT_027\n1,1.,0.49,0.55,0.14\n\n", 2},
      {"*MAT_077_O\n1,1.,0.49,0\n1.1,-0.28\n2.,-2.\n", 1},
      {"*MAT_077_H\n1,1.,0.49,0\n0.55,0.14,0.,0.01\n", 2},
      {"*MAT_007\n1,1.,1.5\n", 1},
  };
  for (const auto& [cards, elform] : cases) {
    double kinetic = 0;
    EXPECT_NEAR(energy_created(cards, elform, 0, kinetic), 0, 1e-2) << cards << elform;
    EXPECT_GT(kinetic, 0.1) << cards;
  }
}

TEST(FoamRubber, HostileCards) {
  const std::pair<const char*, const char*> cases[] = {
      {"057\n1,1.,3.,7\n", ""},
      {"057\n1,1.,0.,7\n", "E = 0"},
      {"057\n1,1.,3.\n", "LCID = 0"},
      {"057\n1,1.,3.,5\n", "LCID = 5"},
      {"057\n1,1.,3.,6\n", "strains that rise"},
      {"057\n1,1.,3.,4\n", "stress at zero strain"},
      {"057\n1,1.,3.,3\n", "no stress in compression"},
      {"057\n1,1.,3.,7,-1.\n", "TC = -1"},
      {"057\n1,1.,3.,7,0.,1.5\n", "HU = 1.5"},
      {"057\n1,1.,3.,7,0.,0.5,-1.\n", "BETA = -1"},
      {"057\n1,1.,3.,7,0.,0.5,0.,-4.\n", "is a curve"},
      {"057\n1,1.,3.,7\n-1.\n", "SHAPE = -1"},
      {"057\n1,1.,3.,7\n0.,2.\n", "FAIL = 2"},
      {"057\n1,1.,3.,7\n0.,0.,0.,-1.\n", "ED or BETA1"},
      {"057\n1,1.,3.,7\n0.,0.,0.,0.,0.,-2.\n", "KCON = -2"},
      {"057\n1,1.,3.,7\n0.,0.,0.,0.,0.,0.,1.\n", "REF = 1"},
      {"057\n1,0.,3.,7\n", "out of range"},
      {"063\n1,1.,3.,0.,7,0.4\n", ""},
      {"063\n1,1.,3.,0.5,7,0.4\n", "out of range"},
      {"063\n1,1.,3.,0.,7,-1.\n", "TSC = -1"},
      {"063\n1,1.,3.,0.,3\n", "below 0"},
      {"063\n1,1.,3.,0.,7,0.4,0.1,1.\n", "MODEL = 1"},
      {"006\n1,1.,100.,10.,4.,3.\n", ""},
      {"006\n1,1.,0.,10.,4.,3.\n", "BULK = 0"},
      {"006\n1,1.,100.,10.,14.,3.\n", "GI = 14"},
      {"006\n1,1.,100.,10.,4.,-3.\n", "BETA = -3"},
      {"007\n1,1.,-1.\n", "G = -1"},
      {"007\n1,1.,1.,1.\n", "REF = 1"},
      {"181\n1,1.,50.\n1.,1.,1.,8\n", ""},
      {"181\n1,1.,0.\n1.,1.,1.,8\n", "KM = 0"},
      {"181\n1,1.,50.\n0.,1.,1.,8\n", "SGL = 0"},
      {"181\n1,1.,50.\n1.,1.,1.,2\n", ""},
      {"181\n1,1.,50.\n1.,1.,1.,2,2.\n", "TENSION = 2 is not calculated"},
      {"181\n1,1.,50.\n1.,1.,1.,2,0.,0.5\n", "RTYPE = 0.5 is not calculated"},
      {"181\n1,1.,50.\n1.,1.,1.,2,0.,0.,1.\n", "AVGOPT = 1 is not calculated"},
      {"181\n1,1.,50.\n1.,1.,1.,8,2.,5.,1.\n", ""},
      {"181\n1,1.,50.\n1.,1.,1.,2,1.\n0,0.5\n", "HU = 0.5 unloads by hysteresis, TENSION = 1 by the curves"},
      {"181\n1,1.,50.\n1.,1.,1.,2,-1.\n0,0.5\n", ""},
      {"181\n1,1.,0.\n1.,1.,1.,2\n", "KM = 0"},
      {"181\n1,1.,50.\n0.4,1.,1.,10\n", "to nothing"},
      {"181\n1,1.,50.\n1.,1.,1.,11\n", "the strain rate 0 of table 11 is below 0 or not above"},
      {"181\n1,1.,50.\n1.,1.,1.,12\n", "the strain rate -4 of table 12 is below 0"},
      {"181\n1,1.,50.\n1.,1.,1.,13\n", "the curve of 1 in table 13 = 4444 is no curve that is there"},
      {"181\n1,1.,50.\n1.,1.,1.,14\n", "curve 4 has a stress at zero strain"},
      {"181\n1,1.,50.\n1.,1.,1.,15\n", "table 15 has 101 strain rates; give 1 to 100"},
      {"057\n1,1.,3.,2\n", "is a table"},
      {"181\n1,1.,50.\n0.4,1.,1.,8\n", "to nothing"},
      {"181\n1,1.,50.\n1.,1.,1.,8,0.,0.,0.,-0.1\n", "viscosity BETA"},
      {"181\n1,1.,50.,0.,5.\n1.,1.,1.,8\n", "G = 5 is not calculated"},
      {"181\n1,1.,50.\n1.,1.,1.,8\n7\n", "LCUNLD"},
      {"181\n1,1.,50.\n1.,1.,1.,8\n0,0.,0.,0.,1.\n", "VISCO = 1"},
      {"181_WITH_FAILURE\n1,1.,50.\n1.,1.,1.,8\n1.\n", "WITH_FAILURE"},
      {"077_O\n1,1.,0.49,0\n1.1\n2.\n", ""},
      {"077_O\n1,1.,0.5,0\n1.1\n2.\n", "PR = 0.5"},
      {"077_O\n1,1.,0.49,2\n1.,1.,1.,8\n", "N = 2"},
      {"077_O\n1,1.,0.49,0\n1.1\n-2.\n", "no shear modulus"},
      {"077_O\n1,1.,0.49,0,1\n1.1\n2.\n0.5,3.\n", "relaxation modulus 0.5"},
      {"077_H\n1,1.,0.49,0,0,1.\n0.5\n", "G = 1"},
      {"077_H\n1,1.,0.49,0\n\n", "no shear modulus"},
      {"027\n1,1.,0.49,0.,0.\n1.,1.,1.,3\n", "out of range"},
      {"027\n1,1.,0.49,0.,0.\n0.,1.,1.,8\n", "out of range"},
  };
  std::string many_rates;
  for (int rate = 0; rate <= 100; ++rate) many_rates += fmt::format("{}.,8\n", rate);
  const std::string curves = foam_curve + rubber_curve +
                             "*DEFINE_CURVE\n6\n0.,0.\n0.5,1.\n0.5,2.\n*DEFINE_CURVE\n4\n0.,1.\n1.,2.\n"
                             "*DEFINE_CURVE\n3\n-1.,-1.\n0.,0.\n*DEFINE_TABLE_2D\n2\n0.,7\n1.,7\n"
                             "*DEFINE_TABLE_2D\n10\n0.,7\n1.,8\n*DEFINE_TABLE_2D\n11\n0.,8\n0.,8\n"
                             "*DEFINE_TABLE_2D\n12\n-4.,8\n0.,8\n*DEFINE_TABLE_2D\n13\n0.,8\n1.,4444\n"
                             "*DEFINE_TABLE_2D\n14\n0.,8\n1.,4\n*DEFINE_TABLE_2D\n15\n" +
                             many_rates;
  for (const auto& [cards, says] : cases) {
    RunScene scene(stretched_cube(std::string("*MAT_") + cards + curves, {0.01, 0, 0, 0}, 0.01));
    const std::string said = scene.message() + scene.read().text();
    EXPECT_EQ(!scene.prepared() || scene.read().errors() > 0, std::string_view(says) != "") << cards << said;
    EXPECT_NE(said.find(says), std::string::npos) << cards << said;
  }
  for (const char* card :
       {"057\n1,1.,3.,7\n", "063\n1,1.,3.,0.,7,0.4\n", "181\n1,1.,50.\n1.,1.,1.,8\n", "007\n1,1.,1.\n"}) {
    RunScene shell(stretched_square(std::string("*MAT_") + card + curves, {0.01, 0, 0, 0}, 0.01));
    EXPECT_NE(shell.message().find("in solids only"), std::string::npos) << card << shell.message();
  }
}

}  // namespace
}  // namespace gapcheck::solver::build_foam_rubber_test
