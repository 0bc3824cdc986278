#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "solver/conditioned.hpp"
#include "solver/output/state_balance.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::initial_stress_test {
namespace {

constexpr double young = 1000, density = 2;

std::string six(const Symmetric& s) {
  return fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}", s[0], s[1], s[2], s[3], s[4], s[5]);
}

/// All points of a solid with the same stress.
std::string of_solid(int id, int points, const Symmetric& stress, double strain = 0) {
  std::string text = fmt::format("{},{}\n", id, points);
  for (int i = 0; i < points; ++i) text += six(stress) + fmt::format(",{}\n", strain);
  return text;
}

/// Nodes with the coordinates turned about the origin.
std::string nodes_at(const std::vector<Vector>& x, const Matrix& turn) {
  std::string text = "*NODE\n";
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vector at = turn * x[i];
    text += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", i + 1, at.x(), at.y(), at.z());
  }
  return text;
}

/// Holds all nodes in all directions.
std::string held(int nodes) {
  std::string text = "*BOUNDARY_SPC_NODE\n";
  for (int i = 1; i <= nodes; ++i) text += fmt::format("{},0,1,1,1,1,1,1\n", i);
  return text;
}

/// A skew brick without parallel sides.
const std::vector<Vector> skew_brick{{0, 0, 0},   {2, 0.1, 0},   {2.2, 1.1, 0.1}, {0.1, 1, 0},
                                     {0, 0.2, 1}, {1.9, 0, 1.1}, {2, 1.3, 1.2},   {0.2, 1.1, 0.9}};
const std::string one_solid = "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n";

// A uniform stress pulls at the surfaces alone: inner nodes of bars of any element stay where they are, and the ends
// are held with σ A.
TEST(InitialStress, UniformIsInEquilibrium) {
  for (const int elform : {1, 2, -1, -2}) {
    std::string deck = brick_bar(3, {1, 0.5, 0.25}) +
                       elastic_deck(fmt::format("*SECTION_SOLID\n1,{}\n", elform), young, 0.3, density) +
                       "*BOUNDARY_SPC_NODE\n";
    for (int k = 0; k < 4; ++k) deck += fmt::format("{},0,1\n{},0,1\n", 1 + 4 * k, 4 + 4 * k);
    deck += "*INITIAL_STRESS_SOLID\n";
    for (int i = 1; i <= 3; ++i) deck += of_solid(i, elform == 1 ? 1 : 8, {8, 0, 0, 0, 0, 0});
    Stepper stepper = good(deck).stepper(fixed_step(1e-3));
    const std::vector<Vector> start = stepper.state().x;
    run(stepper, 200);
    double pull = 0, moved = 0;
    for (std::size_t k = 0; k < 4; ++k) pull += stepper.external().force[4 * k].x();
    for (std::size_t i = 0; i < start.size(); ++i) moved = std::max(moved, (stepper.state().x[i] - start[i]).norm());
    EXPECT_NEAR(pull, -8 * 0.5 * 0.25, 1e-12) << elform;
    EXPECT_LT(moved, 1e-13) << elform;
  }
}

// Let go at one end, a brick is a spring of E A / L under two masses of m / 2: u = −σ L / E (1 − cos ω t). What it
// stored is no work, and it is what makes it move: the energies of the state balance.
TEST(InitialStress, LetsGo) {
  const double stress = 0.05, length = 2;
  std::string deck =
      brick_bar(1, {length, 0.5, 0.25}) + elastic_deck(solid_section, young, 0, density) +
      "*CONTROL_BULK_VISCOSITY\n1e-12,1e-12\n*BOUNDARY_SPC_NODE\n1,0,1,1,1\n3,0,1,1,1\n5,0,1,1,1\n7,0,1,1,1\n"
      "*INITIAL_STRESS_SOLID\n" +
      of_solid(1, 1, {stress, 0, 0, 0, 0, 0});
  Stepper stepper = good(deck).stepper(fixed_step(1e-4));
  const double omega = std::sqrt(2 * young / density) / length;
  const double stored = stress * stress / (2 * young) * length * 0.5 * 0.25;
  double most = 0, worst = 0;
  while (stepper.state().time < 2 * std::numbers::pi / omega) {
    ASSERT_TRUE(stepper.step().ok());
    const double at = stepper.state().time;
    const double expected = -stress * length / young * (1 - std::cos(omega * at));
    worst = std::max(worst, std::abs(stepper.state().x[1].x() - length - expected));
    most = std::max(most, stepper.energies().kinetic);
    EXPECT_NEAR(stepper.energies().total(), stepper.energies().initial, 1e-11 * stored);
  }
  EXPECT_LT(worst, 2e-4 * stress * length / young);
  EXPECT_NEAR(most, stored, 1e-4 * stored);
}

TEST(InitialStress, BalancesByState) {
  for (const bool shells : {false, true}) {
    std::string deck = shells ? plate(1, 1, {2, 0.5, 0}) + elastic_deck(shell_section, young, 0, density)
                              : brick_bar(1, {2, 0.5, 0.25}) + elastic_deck(solid_section, young, 0, density);
    deck += shells ? "*INITIAL_STRESS_SHELL\n1,1,2\n-.57735,0.05\n.57735,0.05\n"
                   : "*INITIAL_STRESS_SOLID\n" + of_solid(1, 1, {0.05, 0, 0, 0, 0, 0});
    deck += "*CONTROL_TERMINATION\n0.05\n";
    RunScene scene(deck);
    double created = 0, largest = 0;
    scene.go([&](const solver::Run& run) {
      const StateBalance balance = state_balance(run);
      created = std::max(created, std::abs(balance.created()));
      largest = balance.largest;
    });
    EXPECT_LT(created, 2e-3 * largest) << shells;
  }
}

// Everything turned, stresses too, moves alike.
TEST(InitialStress, TurnsWithTheModel) {
  const Matrix turn = Eigen::AngleAxisd(1.1, Vector(1, -2, 0.5).normalized()).toRotationMatrix();
  const Symmetric stress{5, -3, 2, 1, 0.5, -2};
  const std::vector<Vector> quad{{0, 0, 0}, {2, 0.1, 0}, {2.2, 1.1, 0}, {0.1, 1, 0}};
  const Symmetric in_plane{5, -3, 0, 1, 0.5, -2};
  for (const int elform : {1, 2, -1, -2, 102, 116, 103}) {
    const bool shells = elform > 100;
    std::array<std::vector<Vector>, 2> end;
    for (const bool turned : {false, true}) {
      const Matrix by = turned ? turn : Matrix::Identity();
      const std::string written = six(rotated(shells ? in_plane : stress, by));
      std::string deck = nodes_at(shells ? quad : skew_brick, by);
      if (shells) {
        const int points = elform == 116 ? 4 : 1;
        deck += elform == 103 ? "*ELEMENT_SHELL\n1,1,1,2,3,3\n" : "*ELEMENT_SHELL\n1,1,1,2,3,4\n";
        deck +=
            elastic_deck(fmt::format("*SECTION_SHELL\n1,{},1.,2\n0.1\n", elform == 116 ? 16 : 2), young, 0.3, density);
        deck += fmt::format("*INITIAL_STRESS_SHELL\n1,{},2\n", points);
        for (const char* place : {"-.57735,", ".57735,"})
          for (int i = 0; i < points; ++i) deck += place + written + "\n";
      } else {
        deck += one_solid + elastic_deck(fmt::format("*SECTION_SOLID\n1,{}\n", elform), young, 0.3, density);
        deck += fmt::format("*INITIAL_STRESS_SOLID\n1,{}\n", elform == 1 ? 1 : 8);
        for (int i = 0; i < (elform == 1 ? 1 : 8); ++i) deck += written + "\n";
      }
      Conditioned both = good(deck);
      if (elform == 103) both.structure.state.mass[3] = 1;  // the fourth node belongs to nothing
      Stepper stepper = std::move(both).stepper(fixed_step(1e-3));
      run(stepper, 100);
      end[turned] = stepper.state().x;
    }
    double moved = 0;
    for (std::size_t i = 0; i < end[0].size(); ++i) {
      EXPECT_LT((turn * end[0][i] - end[1][i]).norm(), 1e-12) << elform << " node " << i;
      moved = std::max(moved, (end[0][i] - (shells ? quad : skew_brick)[i]).norm());
    }
    EXPECT_GT(moved, 1e-4) << elform;
  }
}

// σ = s T over the thickness is a moment s t² / 6 per width; its sign follows from T, whatever the order of the rows.
TEST(InitialStress, LayersBend) {
  const double s = 6, width = 0.5, thickness = 0.1;
  for (const int elform : {2, 16}) {
    const int points = elform == 16 ? 4 : 1;
    std::string deck =
        plate(1, 1, {2, width, 0}) +
        elastic_deck(fmt::format("*SECTION_SHELL\n1,{},1.,3\n{}\n", elform, thickness), young, 0.3, density) + held(4) +
        fmt::format("*INITIAL_STRESS_SHELL\n1,{},3\n", points);
    for (const double place : {std::sqrt(0.6), -std::sqrt(0.6), 0.0})
      for (int i = 0; i < points; ++i) deck += fmt::format("{:.17g},{:.17g}\n", place, s * place);
    Stepper stepper = good(deck).stepper(fixed_step(1e-4));
    run(stepper, 1);
    // Nodes 2 and 4 at x = 2: tension above pulls the upper side back; the support holds with −M about y at x = 2.
    const double moment = stepper.external().moment[1].y() + stepper.external().moment[3].y();
    EXPECT_NEAR(moment, s * thickness * thickness / 6 * width, 1e-13) << elform;
    EXPECT_NEAR(stepper.external().force[1].norm(), 0, 1e-13);
  }
}

// Points lie next to the corners, in the order of the corners: a stress in one alone pulls most at that corner.
TEST(InitialStress, OrderOfPoints) {
  for (std::size_t loaded = 0; loaded < 8; ++loaded) {
    std::string deck = nodes_at(skew_brick, Matrix::Identity()) + one_solid +
                       elastic_deck("*SECTION_SOLID\n1,2\n", young, 0, density) + held(8) +
                       "*INITIAL_STRESS_SOLID\n1,8\n";
    // Shear whose parts add up at the corner.
    const int x = loaded % 4 == 1 || loaded % 4 == 2 ? 1 : -1, y = loaded % 4 >= 2 ? 1 : -1, z = loaded >= 4 ? 1 : -1;
    for (std::size_t i = 0; i < 8; ++i)
      deck += i == loaded ? fmt::format("0.,0.,0.,{},{},{}\n", x * y, y * z, z * x) : "0.\n";
    Stepper stepper = good(deck).stepper(fixed_step(1e-4));
    run(stepper, 1);
    std::size_t most = 0;
    for (std::size_t i = 0; i < 8; ++i)
      if (stepper.external().force[i].norm() > stepper.external().force[most].norm()) most = i;
    EXPECT_EQ(most, loaded);
  }
  for (std::size_t loaded = 0; loaded < 4; ++loaded) {
    std::string deck = plate(1, 1, {1, 1, 0}) + elastic_deck("*SECTION_SHELL\n1,16,1.,1\n0.1\n", young, 0, density) +
                       held(4) + "*INITIAL_STRESS_SHELL\n1,4,1\n";
    for (std::size_t i = 0; i < 4; ++i) deck += i == loaded ? "0.,1.,1.\n" : "0.\n";
    Stepper stepper = good(deck).stepper(fixed_step(1e-4));
    run(stepper, 1);
    constexpr std::array<std::size_t, 4> node_of_corner{0, 1, 3, 2};
    std::size_t most = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (stepper.external().force[i].norm() > stepper.external().force[most].norm()) most = i;
    EXPECT_EQ(most, node_of_corner[loaded]);
  }
}

// A point that has flowed by 0.1 yields at σy + Eₚ 0.1 only; each element of a set begins so.
TEST(InitialStress, PlasticStrainHardens) {
  const double tangent = 100, hardening = young * tangent / (young - tangent);
  for (const double strain : {0.0, 0.1}) {
    std::string deck =
        brick_bar(1, {1, 1, 1}) +
        fmt::format("*PART\np\n1,1,1\n*SECTION_SOLID\n1,1\n*MAT_PLASTIC_KINEMATIC\n1,{},{},0.,10.,{},1.\n", density,
                    young, tangent) +
        "*SET_SOLID\n3\n1\n*INITIAL_STRESS_SOLID_SET\n" + of_solid(3, 1, {}, strain) +
        "*BOUNDARY_SPC_NODE\n1,0,1,1,1\n3,0,1,1,1\n5,0,1,1,1\n7,0,1,1,1\n"
        "*SET_NODE\n4\n2,4,6,8\n*BOUNDARY_PRESCRIBED_MOTION_SET\n4,1,2,5\n*DEFINE_CURVE\n5\n0.,0.\n1.,0.04\n"
        "*CONTROL_BULK_VISCOSITY\n1e-12,1e-12\n";
    Stepper stepper = good(deck).stepper(fixed_step(1e-3));
    double before = 0, at_yield = 0;
    while (stepper.state().time < 1 && at_yield == 0) {
      ASSERT_TRUE(stepper.step().ok());
      const PointState point = stepper.structure().solids.point(0);
      if (point.plastic_strain > strain) at_yield = before;
      before = point.stress[xx] - (point.stress[yy] + point.stress[zz]) / 2;
    }
    EXPECT_NEAR(at_yield, 10 + hardening * strain, 0.06) << strain;
  }
}

std::string shell_deck(const std::string& cards, const std::string& material = "*MAT_ELASTIC\n1,2.,1000.,0.3\n",
                       int elform = 2) {
  return plate(1, 1, {1, 1, 0}) + fmt::format("*PART\np\n1,1,1\n*SECTION_SHELL\n1,{},1.,2\n0.1\n", elform) + material +
         "*INITIAL_STRESS_SHELL\n" + cards;
}

std::string solid_deck(const std::string& cards, const std::string& material = "*MAT_ELASTIC\n1,2.,1000.,0.3\n",
                       int elform = 1) {
  return brick_bar(1, {1, 1, 1}) + fmt::format("*PART\np\n1,1,1\n*SECTION_SOLID\n1,{}\n", elform) + material +
         "*INITIAL_STRESS_SOLID\n" + cards;
}

TEST(InitialStress, HostileCards) {
  const auto refused = [](const std::string& deck, Failure::Kind kind, std::string_view text) {
    const Conditioned bad = conditioned(deck);
    ASSERT_FALSE(bad.status.ok()) << text;
    EXPECT_EQ(bad.status.error().kind, kind) << bad.status.error().message;
    EXPECT_NE(bad.status.error().message.find(text), std::string::npos) << bad.status.error().message;
    EXPECT_EQ(bad.status.error().message.rfind("*INITIAL_STRESS_S", 0), 0u) << bad.status.error().message;
    EXPECT_GT(bad.status.error().place.line, 0u);
  };
  using enum Failure::Kind;
  const std::string two = "-.57735,1.\n.57735,1.\n";
  refused(shell_deck("9,1,2\n" + two), unknown_reference, "shell 9");
  refused(shell_deck("1,4,2\n" + two + two + two + two), contradiction, "NPLANE is 4");
  refused(shell_deck("1,1,2\n" + two, "*MAT_ELASTIC\n1,2.,1000.,0.3\n", 16), contradiction, "4 points in the plane");
  refused(shell_deck("1,1,3\n" + two + "0.\n"), contradiction, "NTHICK 3");
  refused(shell_deck("1,1,2\n-.57735,1.\n"), contradiction, "1 of its 2 points");
  refused(shell_deck("1,1,2\n-.7,1.\n.57735,1.\n"), contradiction, "T = -0.7 of its point 1");
  refused(shell_deck("1,1,2\n.57735,1.\n.57735,1.\n"), contradiction, "point 2");
  refused(shell_deck("1,0,2\n" + two), contradiction, "NPLANE");
  refused(shell_deck("1,1,-2\n" + two), contradiction, "NTHICK");
  refused(shell_deck("1,2000000000,2000000000\n" + two), contradiction, "cannot be read");
  refused(shell_deck("1,1,2,-1\n" + two), contradiction, "NHISV is -1");
  refused(shell_deck("1,1,2,2000000000\n" + two), contradiction, "cannot be read");
  refused(shell_deck("1,1,2,0,6\n" + two), not_calculated, "NTENSR");
  refused(shell_deck("1,1,2,0,0,2\n" + two), contradiction, "LARGE is 2");
  refused(shell_deck("1,1,2,0,0,0,1,1\n" + two), not_calculated, "NTHINT");
  refused(shell_deck("1,1,2\n" + two + "1,1,2\n" + two), contradiction, "two start stresses");
  refused(shell_deck("1,1,2\n-.57735,1.,0.,1.\n.57735\n"), contradiction, "across it");
  refused(shell_deck("1,1,2\n-.57735,1e4\n.57735\n"), contradiction, "beyond Young's modulus");
  refused(shell_deck("1,1,2\n-.57735,,,,,,,0.1\n.57735\n"), contradiction, "does not flow");
  refused(shell_deck("1,1,2\n" + two, "*MAT_RIGID\n1,2.,1000.,0.3\n"), contradiction, "is rigid");
  refused(shell_deck("1,1,2\n" + two, "*MAT_NULL\n1,2.\n"), contradiction, "has no stress");
  refused(solid_deck("9,1\n1.\n"), unknown_reference, "solid 9");
  refused(solid_deck("1,8\n1.\n1.\n1.\n1.\n1.\n1.\n1.\n1.\n"), contradiction, "NINT is 8");
  refused(solid_deck("1,1\n1.\n", "*MAT_ELASTIC\n1,2.,1000.,0.3\n", 2), contradiction, "has 8 points");
  refused(solid_deck("1,1,2\n1.\n1.,1.\n"), contradiction, "without LARGE");
  refused(solid_deck("1,1,0,1,1\n1.\n1.\n"), not_calculated, "IVEFLG");
  refused(solid_deck("1,1,0,0,0,1\n1.\n"), not_calculated, "IALEGP");
  refused(solid_deck("1,1\n1.\n", "*MAT_MOONEY-RIVLIN_RUBBER\n1,2.,0.49,1.,1.\n"), not_calculated, "rubber");
  const auto plastic = [](double beta, double fails = 0) {
    return fmt::format("*MAT_PLASTIC_KINEMATIC\n1,2.,1000.,0.3,10.,100.,{}\n,,{}\n", beta, fails);
  };
  refused(solid_deck("1,1\n1.,,,,,,.1\n", plastic(0.5)), not_calculated, "BETA below 1");
  refused(solid_deck("1,1\n1.,,,,,,-.1\n", plastic(1)), contradiction, "out of range");
  refused(solid_deck("1,1\n1.,,,,,,1e9\n", plastic(1)), contradiction, "out of range");
  refused(solid_deck("1,1\n1.,,,,,,.3\n", plastic(1, 0.3)), contradiction, "where it fails");
  const std::string set =
      brick_bar(1, {1, 1, 1}) + elastic_deck(solid_section, young, 0, density) + "*INITIAL_STRESS_SOLID_SET\n7,1\n1.\n";
  refused(set, unknown_reference, "no set 7");
}

TEST(InitialStress, Warnings) {
  EXPECT_EQ(good(shell_deck("1,1,2\n-.57735,1.\n.57735,1.\n")).warnings, "");
  EXPECT_NE(good(shell_deck("1,1,2\n-.57735,1.,,.01\n.57735,1.\n")).warnings.find("across the shell"),
            std::string::npos);
  EXPECT_NE(good(shell_deck("1,1,2,1\n-.57735,1.\n7.\n.57735,1.\n0.\n")).warnings.find("NHISV"), std::string::npos);
  EXPECT_EQ(good(shell_deck("1,1,2,1\n-.57735,1.\n0.\n.57735,1.\n0.\n")).warnings, "");
  const std::string plastic = "*MAT_PLASTIC_KINEMATIC\n1,2.,1000.,0.3,10.,100.,1.\n\n";
  EXPECT_EQ(good(solid_deck("1,1\n9.9\n", plastic)).warnings, "");
  EXPECT_NE(good(solid_deck("1,1\n10.1\n", plastic)).warnings.find("beyond the yield stress"), std::string::npos);
  EXPECT_EQ(good(solid_deck("1,1\n20.1,,,,,,.1\n", plastic)).warnings, "");
}

}  // namespace
}  // namespace gapcheck::solver::initial_stress_test
