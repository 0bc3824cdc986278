#include <Eigen/Geometry>
#include <cmath>

#include "solver/conditioned.hpp"

namespace gapcheck::solver::section_preload_test {
namespace {

constexpr double young = 1e4, density = 2, area = 0.5 * 0.25, stress = 2;
constexpr int bricks = 5;
const std::string without_poisson = "*MAT_ELASTIC\n1,2.,1e4,0.\n";

/// A bar of five bricks of length 1, held at both ends in x. Nodes of station i: 1 + i + 6 k.
std::string bar(int elform, const std::string& more, const std::string& material = "*MAT_ELASTIC\n1,2.,1e4,0.3\n") {
  std::string deck = brick_bar(bricks, {1, 0.5, 0.25}) +
                     fmt::format("*PART\np\n1,1,1\n*SECTION_SOLID\n1,{}\n", elform) + material + "*BOUNDARY_SPC_NODE\n";
  for (int k = 0; k < 4; ++k) deck += fmt::format("{},0,1\n{},0,1\n", 1 + 6 * k, 6 + 6 * k);
  return deck + "1,0,0,1,1\n" + more;
}

/// A plane across x, and a stress that rises until 1 and stays until 3.
std::string preload(const std::string& plane = "0,1.5,0.,0.,2.5,0.,0.\n\n", const std::string& card = "1,4,9",
                    const std::string& curve = "0.,0.\n1.,2.\n3.,2.\n") {
  return "*DATABASE_CROSS_SECTION_PLANE_ID\n4,bolt\n" + plane + "*INITIAL_STRESS_SECTION\n" + card +
         "\n*DEFINE_CURVE\n9\n" + curve;
}

double axial(const Stepper& stepper, std::size_t solid) {
  double sum = 0;
  const auto points = stepper.structure().solids.points(solid);
  for (const PointState& point : points) sum += point.stress[xx];
  return sum / static_cast<double>(points.size());
}

double pull_at_start(const Stepper& stepper) {
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum -= stepper.external().force[6 * k].x();
  return sum;
}

// The section shrinks by what the others stretch, 4 σ/E, and becomes wider by ν times that.
TEST(SectionPreload, CarriesTheStressOnThePresentArea) {
  Stepper stepper = good(bar(1, preload() + "*DAMPING_GLOBAL\n0,20.\n")).stepper(fixed_step(1e-3));
  ASSERT_TRUE(run_until(stepper, 3).ok());
  const double wider = 1 + 2 * 0.3 * 4 * stress / young;
  EXPECT_NEAR(pull_at_start(stepper), stress * area * wider, 2e-6 * stress * area);
}

// Without lateral strain: the section follows its curve whatever the bolt does, pulls its ends with σ A, keeps that
// when the curve has ended, and the work that it has supplied is what all bricks store: σ² V / 2 E.
TEST(SectionPreload, PullsAndKeeps) {
  for (const int elform : {1, 2, -1, -2}) {
    Stepper stepper =
        good(bar(elform, preload() + "*DAMPING_GLOBAL\n0,20.\n", without_poisson)).stepper(fixed_step(1e-3));
    double worst = 0;
    while (stepper.state().time < 3) {
      ASSERT_TRUE(stepper.step().ok());
      const double at = stepper.state().time - stepper.state().dt;
      if (at <= 3) worst = std::max(worst, std::abs(axial(stepper, 1) - std::min(at, 1.0) * stress));
      ASSERT_NEAR(stepper.energies().total(), stepper.energies().external, 1e-9 * stress * stress / young);
    }
    EXPECT_LT(worst, 1e-12) << elform;
    EXPECT_NEAR(pull_at_start(stepper), stress * area, 1e-6 * stress * area) << elform;
    EXPECT_NEAR(stepper.structure().solids.section_force(0), stress * area, 1e-6 * stress * area) << elform;
    const double supplied = stepper.energies().external;
    const double stored = stress * stress / (2 * young) * area * bricks;
    EXPECT_NEAR(stepper.energies().internal, stored, 2e-3 * stored) << elform;
    ASSERT_TRUE(run_until(stepper, 5).ok());
    EXPECT_NEAR(pull_at_start(stepper), stress * area, 1e-6 * stress * area) << elform;
    EXPECT_NEAR(stepper.energies().external, supplied, 1e-6 * stored) << elform;
  }
}

// Afterwards both sides of a load P in the middle of the bolt are springs: P k₁ / (k₁ + k₂) more on one, the rest less
// on the other.
TEST(SectionPreload, LoadedBoltIsTwoSprings) {
  const double load = 0.02;
  for (const int elform : {1, 2}) {
    std::string deck = bar(elform, preload() + "*DAMPING_GLOBAL\n0,20.\n*LOAD_NODE_POINT\n", without_poisson);
    for (int k = 0; k < 4; ++k) deck += fmt::format("{},1,8,{}\n", 3 + 6 * k, load / 4);  // x = 2
    deck += "*DEFINE_CURVE\n8\n0.,0.\n3.5,0.\n5.,1.\n";
    Stepper stepper = good(deck).stepper(fixed_step(1e-3));
    ASSERT_TRUE(run_until(stepper, 8).ok());
    // k₁ = E A / 2, k₂ = E A / 3
    EXPECT_NEAR(pull_at_start(stepper), stress * area + load * 3 / 5, 2e-3 * load) << elform;
    EXPECT_NEAR(axial(stepper, 4), stress - load * 2 / 5 / area, 2e-3 * load / area) << elform;
  }
}

// A plane on a layer of nodes takes the bricks in front of it, and each of them once; sets, radius and edges as well.
TEST(SectionPreload, WhichSolids) {
  const auto chosen = [](const std::string& text) {
    const Conditioned result = good(bar(1, text));
    std::string list;
    for (std::size_t i = 0; i < bricks; ++i)
      if (result.structure.solids.section_of(i) != no_position) list += std::to_string(i + 1);
    return list;
  };
  EXPECT_EQ(chosen(preload()), "2");
  EXPECT_EQ(chosen(preload("0,2.,0.,0.,3.,0.,0.\n\n")), "3");
  EXPECT_EQ(chosen(preload("0,2.,0.,0.,1.,0.,0.\n\n")), "2");
  // Along the bar: all that are cut, within a radius of 1.2 about x = 2.5.
  EXPECT_EQ(chosen(preload("0,2.5,0.25,0.1,2.5,0.25,1.\n\n")), "12345");
  EXPECT_EQ(chosen(preload("0,2.5,0.25,0.1,2.5,0.25,1.,1.2\n\n")), "234");
  // From x = 1, y = 0 along x by 2, and along z × x = y by 1, or against it.
  EXPECT_EQ(chosen(preload("0,1.,0.,0.1,1.,0.,1.\n2.,0.,0.1,2.,1.\n")), "23");
  EXPECT_EQ(chosen(preload("0,1.,0.,0.1,1.,0.,1.\n2.,0.,0.1,2.,0.\n")), "23");
  EXPECT_EQ(chosen(preload("0,1.,.4,0.1,1.,.4,1.\n0.,.4,0.1,.6,0.\n")), "1");
  const std::string sets = "*SET_SOLID\n3\n4,2\n*DEFINE_VECTOR\n6,0.,0.,0.,2.,0.,0.\n*SET_PART\n5\n1\n";
  EXPECT_EQ(chosen(sets + "*DATABASE_CROSS_SECTION_SET_ID\n4,x\n0,3\n*INITIAL_STRESS_SECTION\n1,4,9,5,6\n"
                          "*DEFINE_CURVE\n9\n0.,0.\n1.,2.\n"),
            "24");
  // Without an id sections count from 1.
  EXPECT_EQ(chosen("*DATABASE_CROSS_SECTION_PLANE\n0,3.5,0.,0.,4.,0.,0.\n\n*INITIAL_STRESS_SECTION\n1,1,9\n"
                   "*DEFINE_CURVE\n9\n0.,0.\n1.,2.\n"),
            "4");
}

// IZSHEAR = 0 takes the shear of the section away, 1 leaves it.
TEST(SectionPreload, Shear) {
  for (const bool kept : {false, true}) {
    Conditioned sheared = good(bar(1, preload("0,1.5,0.,0.,2.5,0.,0.\n\n", kept ? "1,4,9,,,1" : "1,4,9")));
    for (std::size_t i = 0; i < 24; ++i) sheared.structure.state.v[i].y() = 1e-3 * static_cast<double>(i % 6);
    Stepper stepper = std::move(sheared).stepper(fixed_step(1e-3));
    double most = 0;
    for (int i = 0; i < 100; ++i) {
      ASSERT_TRUE(stepper.step().ok());
      most = std::max(most, std::abs(stepper.structure().solids.point(1).stress[xy]));
    }
    if (kept)
      EXPECT_GT(most, 1e-2);
    else
      EXPECT_LT(most, 1e-14);
  }
}

// A skew brick with its section, turned with everything else.
TEST(SectionPreload, TurnsWithTheModel) {
  const Matrix turn = Eigen::AngleAxisd(1.1, Vector(1, -2, 0.5).normalized()).toRotationMatrix();
  const std::vector<Vector> corners{{0, 0, 0},   {2, 0.1, 0},   {2.2, 1.1, 0.1}, {0.1, 1, 0},
                                    {0, 0.2, 1}, {1.9, 0, 1.1}, {2, 1.3, 1.2},   {0.2, 1.1, 0.9}};
  for (const int elform : {1, 2, -1, -2, 10}) {
    std::array<std::vector<Vector>, 2> end;
    for (const bool turned : {false, true}) {
      const Matrix by = turned ? turn : Matrix::Identity();
      std::string deck = "*NODE\n";
      for (std::size_t i = 0; i < 8; ++i) {
        const Vector x = by * corners[i];
        deck += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", i + 1, x.x(), x.y(), x.z());
      }
      deck += elform == 10 ? "*ELEMENT_SOLID\n1,1,1,2,4,5,5,5,5,5\n" : "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n";
      deck += elastic_deck(fmt::format("*SECTION_SOLID\n1,{}\n", elform), young, 0.3, density);
      const Vector tail = by * Vector(0.5, 0.3, 0.3), head = by * Vector(1.5, 0.5, 0.4);
      deck += preload(fmt::format("0,{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n\n", tail.x(), tail.y(), tail.z(),
                                  head.x(), head.y(), head.z()),
                      "1,4,9", "0.,0.\n.05,20.\n.1,20.\n");
      Conditioned both = good(deck);
      for (double& mass : both.structure.state.mass)
        if (mass == 0) mass = 1;  // nodes of the brick that the tetrahedron does not have
      Stepper stepper = std::move(both).stepper(fixed_step(1e-3));
      run(stepper, 200);
      EXPECT_NEAR(stepper.energies().total(), stepper.energies().external, 1e-12) << elform;
      end[turned] = stepper.state().x;
    }
    double moved = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_LT((turn * end[0][i] - end[1][i]).norm(), 1e-12) << elform;
      moved = std::max(moved, (end[0][i] - corners[i]).norm());
    }
    EXPECT_GT(moved, 1e-3) << elform;
  }
}

TEST(SectionPreload, HostileCards) {
  const auto refused = [](const std::string& deck, Failure::Kind kind, std::string_view text) {
    const Conditioned bad = conditioned(deck);
    ASSERT_FALSE(bad.status.ok()) << text;
    EXPECT_EQ(bad.status.error().kind, kind) << bad.status.error().message;
    EXPECT_NE(bad.status.error().message.find(text), std::string::npos) << bad.status.error().message;
    EXPECT_EQ(bad.status.error().message.rfind("*INITIAL_STRESS_SECTION", 0), 0u) << bad.status.error().message;
    EXPECT_GT(bad.status.error().place.line, 0u);
  };
  using enum Failure::Kind;
  const std::string plane = "0,1.5,0.,0.,2.5,0.,0.\n\n";
  refused(bar(1, preload(plane, "1,5,9")), unknown_reference, "cross-section 5");
  refused(bar(1, preload(plane, "1,4,8")), unknown_reference, "curve 8");
  refused(bar(1, preload(plane, "1,4,9,7")), unknown_reference, "part set 7");
  refused(bar(1, preload(plane, "1,4,9,,7")), unknown_reference, "vector 7");
  refused(bar(1, preload(plane, "1,4,9,,,2")), not_calculated, "IZSHEAR = 2");
  refused(bar(1, preload(plane, "1,4,9,,,,3")), not_calculated, "ISTIFF");
  refused(bar(1, preload(plane, "1,4,9\n1,4,9")), contradiction, "two preloads");
  refused(bar(1, preload(plane, "1,4,9", "0.,2.\n1.,1.\n")), contradiction, "at its start");
  refused(bar(1, preload(plane, "1,4,9", "0.,-2.\n1.,-1.\n")), contradiction, "above zero");
  refused(bar(1, preload(plane, "1,4,9", "0.,0.\n1.,1e9\n")), contradiction, "Young's modulus");
  refused(bar(1, preload("0,1.5,0.,0.,1.5,0.,0.\n\n")), contradiction, "no direction");
  refused(bar(1, preload("0,9.5,0.,0.,10.,0.,0.\n\n")), contradiction, "has no solids");
  refused(bar(1, preload("0,1.5,0.,0.,2.5,0.,0.,-1.\n\n")), contradiction, "not a length");
  refused(bar(1, preload("0,1.5,0.,0.,2.5,0.,0.\n3.,0.,0.,1.,1.\n")), contradiction, "XHEV");
  refused(bar(1, preload() + "*DATABASE_CROSS_SECTION_PLANE_ID\n4,x\n" + plane), contradiction, "two cross-sections 4");
  const std::string by_set = "*DATABASE_CROSS_SECTION_SET_ID\n4,x\n0,3\n*DEFINE_CURVE\n9\n0.,0.\n1.,2.\n";
  refused(bar(1, by_set + "*INITIAL_STRESS_SECTION\n1,4,9\n*SET_SOLID\n3\n1\n"), contradiction, "VID");
  refused(bar(1, by_set + "*DEFINE_VECTOR\n6,0.,0.,0.,1.\n*INITIAL_STRESS_SECTION\n1,4,9,,6\n"), unknown_reference,
          "HSID = 3");
  refused(bar(1, preload(), "*MAT_NULL\n1,2.\n"), not_calculated, "without stress");
  refused(bar(1, preload(), "*MAT_RIGID\n1,2.,1e4,0.3\n"), not_calculated, "is rigid");
  EXPECT_NE(good(bar(1, preload(), "*MAT_PLASTIC_KINEMATIC\n1,2.,1e4,0.3,1.,0.,1.\n\n")).warnings.find("yield stress"),
            std::string::npos);
}

}  // namespace
}  // namespace gapcheck::solver::section_preload_test
