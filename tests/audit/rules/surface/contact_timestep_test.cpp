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
