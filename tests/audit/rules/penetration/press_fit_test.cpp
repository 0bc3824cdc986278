#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::press_fit_test {
namespace {

/// 2 x 2 bricks of 4 x 4 x 4 on 5 x 5 of them, `overlap` deep in their upper face; contact 7 with these lines after
/// card 1.
RuleDeck blocks(double overlap, const std::string& keyword, const std::string& cards) {
  RuleDeck deck;
  deck.solid_part(1).solid_part(2);
  deck.block(1, 1, 5, 5, 1, Vector(0, 0, 0), Vector(4, 4, 4));
  deck.block(201, 2, 2, 2, 1, Vector(6, 6, 4 - overlap), Vector(4, 4, 4));
  deck.raw("DEFINE_CURVE", "5\n0.,0.\n0.002,1.\n0.01,1.\n");
  return deck.contact(7, keyword, "2,1,3,3", cards);
}

const std::string fit = "ONE_WAY_SURFACE_TO_SURFACE_INTERFERENCE";

// K = 175000, so a spring has 0.1 K A^2 / V = 70000. Nine nodes of 700 each on a face of 8 x 8.
TEST(PressFit, SaysWhatWillPress) {
  const Report report = run_rule("GC113", blocks(0.01, fit, "0.\n1.,1.\n0,5\n"));
  ASSERT_EQ(report.findings.size(), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.severity, Severity::note);
  EXPECT_EQ(f.contact, 7);
  EXPECT_EQ(f.count, 9U);
  EXPECT_NEAR(f.penetration, 0.01, 1e-12);
  EXPECT_EQ(f.part, 2);
  EXPECT_EQ(f.element_part, 1);
  EXPECT_EQ(f.message,
            "an intended overlap: 9 nodes up to 0.01 deep (node 201); the springs grow with curve 5 from 0 to 1 at "
            "t = 0.002; until the parts give way, the springs press with up to 6300, a mean pressure of 98.44");
}

// The lower face of a wedge is a triangle of 8, which its nodes share; V = 32, so its spring has 0.1 K A^2 / V = 35000.
TEST(PressFit, Triangles) {
  RuleDeck deck;
  deck.solid_part(1).solid_part(2).block(1, 1, 5, 5, 1, Vector(0, 0, 0), Vector(4, 4, 4));
  deck.node(201, {9, 9, 3.99}).node(202, {13, 9, 3.99}).node(203, {9, 13, 3.99});
  deck.node(204, {9, 9, 7.99}).node(205, {13, 9, 7.99}).node(206, {9, 13, 7.99});
  deck.solid(200, 2, {201, 202, 205, 204, 203, 203, 206, 206}).raw("DEFINE_CURVE", "5\n0.,0.\n0.002,1.\n0.01,1.\n");
  const Report report = run_rule("GC113", deck.contact(7, fit, "2,1,3,3", "0.\n1.,1.\n4,5\n"));
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].count, 3U);
  EXPECT_NE(report.findings[0].message.find("press with up to 1050, a mean pressure of 131.2"), std::string::npos)
      << report.findings[0].message;
}

TEST(PressFit, ScalesWithItsSprings) {
  const Report report = run_rule("GC113", blocks(0.02, fit, "0.\n3.,2.\n4,5\n"));  // the weaker side counts
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_NE(report.findings[0].message.find("press with up to 2.52e+04, a mean pressure of 393.8"), std::string::npos)
      << report.findings[0].message;
}

TEST(PressFit, NamesWhatIsWrongWithTheCurve) {
  const auto words = [](const std::string& card4) {
    const Report report = run_rule("GC113", blocks(0.01, fit, "0.\n1.,1.\n" + card4));
    return report.findings.empty() ? std::string() : report.findings[0].message;
  };
  EXPECT_NE(words("4\n").find("curve 4 scales the springs in dynamic relaxation only"), std::string::npos);
  EXPECT_NE(words("0,0\n").find("no curve (LCID1, LCID2)"), std::string::npos);
  EXPECT_NE(words("0,4\n").find("the springs are scaled by curve 4, which is not in the deck"), std::string::npos);
}

// The usual pair: LCID1 grows in dynamic relaxation, LCID2 keeps the springs in the run.
TEST(PressFit, CurvesOfDynamicRelaxationAndOfTheRun) {
  RuleDeck deck = blocks(0.01, fit, "0.\n1.,1.\n5,6\n");
  const Report report = run_rule("GC113", deck.raw("DEFINE_CURVE", "6\n0.,1.\n1.,1.\n"));
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_NE(report.findings[0].message.find("in dynamic relaxation the springs grow with curve 5 from 0 to 1 at t = "
                                            "0.002, in the run they are scaled by 1 all the time (curve 6);"),
            std::string::npos)
      << report.findings[0].message;
}

TEST(PressFit, NothingToPress) {
  const Report report = run_rule("GC113", blocks(-0.5, fit, "0.\n1.,1.\n4,5\n"));
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].message.rfind("no node overlaps", 0), 0U) << report.findings[0].message;
}

TEST(PressFit, IsNoPenetrationAndThatOfOthersNoFit) {
  EXPECT_EQ(listed(run_rule("GC101", blocks(0.01, fit, "0.\n1.,1.\n4,5\n"))), 0U);
  const RuleDeck plain = blocks(0.01, "ONE_WAY_SURFACE_TO_SURFACE", "0.\n1.,1.\n");
  EXPECT_EQ(listed(run_rule("GC113", plain)), 0U);
  EXPECT_EQ(listed(run_rule("GC101", plain)), 9U);
}

}  // namespace
}  // namespace gapcheck::audit_test::press_fit_test
