#include <cmath>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::contact_timestep_test {
namespace {

constexpr double rho = 7.85e-9, young = 210000, bulk = 175000;

RuleDeck plate(double thickness, const std::string& keyword = "AUTOMATIC_SINGLE_SURFACE", const std::string& sfs = "1.",
               int soft = 0) {
  RuleDeck deck;
  deck.shell_part(1, thickness).plate(1, 1, 3, 3, Vector(0, 0, 0), 4, 4);
  return deck.contact(2, keyword, "0,0,5", fmt::format("0.\n{},1.\n{}\n", sfs, soft));
}

/// Twice the root of m / k at a corner of the plate: m = ρ A t / 4, k = 0.1 SFS K A / d.
double stable(double thickness, double sfs) {
  return 2 * std::sqrt(rho * 16 * thickness / 4 / (0.1 * sfs * bulk * 16 / std::sqrt(32.0)));
}

TEST(ContactTimestep, ThinShellsAndStiffSprings) {
  const double run = 0.9 * 4 * std::sqrt(rho * 0.91 / young);
  ASSERT_LT(stable(0.1, 1), run);
  ASSERT_GT(stable(1, 1), run);
  ASSERT_LT(stable(1, 100), run);
  for (const auto& [thickness, sfs] : {std::pair{0.1, 1.0}, std::pair{1.0, 100.0}}) {
    const Report report = run_rule("GC420", plate(thickness, "AUTOMATIC_SINGLE_SURFACE", fmt::format("{}", sfs)));
    ASSERT_EQ(report.findings.size(), 1U);
    const Finding& f = report.findings[0];
    EXPECT_EQ(f.severity, Severity::warning);
    EXPECT_EQ(f.contact, 2);
    EXPECT_EQ(f.node, 1);
    EXPECT_EQ(f.part, 1);
    EXPECT_NE(f.message.find(fmt::format("below a step of {:.3E}", stable(thickness, sfs))), std::string::npos)
        << f.message;
    EXPECT_NE(f.message.find(fmt::format("{:.3E} (0.9 of shell", run)), std::string::npos) << f.message;
  }
  EXPECT_EQ(listed(run_rule("GC420", plate(1))), 0U);
  EXPECT_EQ(listed(run_rule("GC420", plate(1, "AUTOMATIC_SINGLE_SURFACE", "100.", 2))), 0U);
}

// Two nodes of the same mass on one spring swing faster than one of them against a wall, by the root of two.
TEST(ContactTimestep, NoteOnFreePairs) {
  const double run = 0.9 * 4 * std::sqrt(rho * 0.91 / young);
  const double thin = 0.3;
  ASSERT_GT(stable(thin, 1), run);
  ASSERT_LT(stable(thin, 1) / std::sqrt(2), run);
  const Report report = run_rule("GC420", plate(thin));
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].severity, Severity::note);
  EXPECT_NE(report.findings[0].message.find(
                fmt::format("below a step of {:.3E} (node 1 against nodes as light)", stable(thin, 1) / std::sqrt(2))),
            std::string::npos)
      << report.findings[0].message;
}

/// A thin plate, and another one of a material of its own, in one contact.
Report two_sides(double thin, double thick, std::int64_t material) {
  RuleDeck deck;
  deck.shell_part(1, thin).shell_part(2, thick, material);
  deck.plate(1, 1, 3, 3, Vector(0, 0, 0), 4, 4).plate(101, 2, 3, 3, Vector(0, 0, 20), 4, 4);
  return run_rule("GC420", deck.contact(2, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3"));
}

TEST(ContactTimestep, PairsOfDifferentMass) {
  const double run = 0.9 * 4 * std::sqrt(rho * 0.91 / young);
  // Side B is four times as heavy: m M / (m + M) = 0.8 m for both.
  const double pair = stable(0.2, 1) * std::sqrt(0.8);
  ASSERT_LT(pair, run);
  ASSERT_GT(stable(0.2, 1), run);
  const Report report = two_sides(0.2, 0.8, 1);
  ASSERT_EQ(report.findings.size(), 2U);
  for (const Finding& f : report.findings)
    EXPECT_NE(f.message.find(fmt::format("contact springs are stable below a step of {:.3E}", pair)), std::string::npos)
        << f.message;
  EXPECT_EQ(listed(two_sides(0.2, 0.8, 2)), 0U);  // a rigid side does not swing
}

TEST(ContactTimestep, ReportsWhatTheSolverPrints) {
  const Report report = run_rule("GC420", plate(1));
  ASSERT_TRUE(report.predicted);
  ASSERT_EQ(report.predicted->surface_timesteps.size(), 1U);
  const SurfaceTimestep& side = report.predicted->surface_timesteps[0];
  EXPECT_NEAR(side.timestep, std::sqrt(rho * std::sqrt(32.0) / (0.8 * bulk)), 1e-12);  // m / (2 k), k = 0.1 K A / d
  EXPECT_EQ(side.node, 1);
  EXPECT_EQ(side.part, 1);
  EXPECT_EQ(side.type, "13");
  EXPECT_EQ(report.predicted->contact_timestep, side.timestep);
  EXPECT_NEAR(report.predicted->element_timestep, 4 * std::sqrt(rho * 0.91 / young), 1e-12);
  EXPECT_FALSE(run_rule("GC411", plate(1)).predicted);
}

// Eroding contacts with ECDT = 0 lower the step themselves.
TEST(ContactTimestep, ErodingOnesWithEcdtOnly) {
  RuleDeck deck;
  deck.shell_part(1, 0.1).plate(1, 1, 3, 3, Vector(0, 0, 0), 4, 4);
  deck.contact(2, "ERODING_SINGLE_SURFACE", "0,0,5", "0.\n1.,1.\n1,1\n");
  EXPECT_EQ(listed(run_rule("GC420", deck)), 0U);
  deck.raw("CONTROL_CONTACT", "\n,,,,,,1\n");
  EXPECT_EQ(listed(run_rule("GC420", deck)), 1U);
}

}  // namespace
}  // namespace gapcheck::audit_test::contact_timestep_test
