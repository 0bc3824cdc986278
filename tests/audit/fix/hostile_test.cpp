// Decks that a correction must survive.
#include <fmt/format.h>

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"

namespace gapcheck::audit_test::hostile_test {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

const Plate lower{.id = 1}, upper{.id = 2, .z = 0.7};

TEST(FixHostile, ParametersStayAndTheOtherSideMoves) {
  std::string nodes = upper.nodes();
  for (std::size_t at = 0; (at = nodes.find("             0.7", at)) != std::string::npos;)
    nodes.replace(at, 16, "              &h");
  const std::string text = "*KEYWORD\n*PARAMETER\nR h              0.7\n" + elastic_steel + lower.deck() +
                           replaced(upper.deck(), upper.nodes(), nodes) + single_surface + "*END\n";
  const FixRun run = fix_text(text);
  EXPECT_TRUE(complete(run.report()));
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i <= 3; ++i) {
      EXPECT_EQ(run.moved(upper.node(i, j)), nullptr);
      EXPECT_NEAR(run.move(lower.node(i, j)).z(), -1.002 * 0.3, 1e-6);
    }
  ASSERT_FALSE(run.report().notes.empty());
  EXPECT_NE(run.report().notes[0].find("&h is a parameter"), std::string::npos);
}

TEST(FixHostile, NodesDefinedTwiceStay) {
  const std::string again = fmt::format("*NODE\n{:8}{:16}{:16}{:16}\n", upper.node(1, 1), 5, 5, 0.7);
  const FixRun run =
      fix_text("*KEYWORD\n" + elastic_steel + lower.deck() + upper.deck() + again + single_surface + "*END\n");
  EXPECT_EQ(run.moved(upper.node(1, 1)), nullptr);
}

TEST(FixHostile, HugeCoordinatesAndMissingThings) {
  for (const std::string bad : {"1e30", "-1e30", "1e300", "nan", "inf", "x"}) {
    const std::string line = fmt::format("{:8}{:16}{:16}{:16}\n", upper.node(3, 3), 15.0, 15.0, 0.7);
    const std::string text = replaced(plates_deck(lower, upper), line,
                                      fmt::format("{:8}{:16}{:16}{:>16}\n", upper.node(3, 3), 15.0, 15.0, bad));
    const FixRun run = fix_text(text);
    // A coordinate that is not a number, or too large for a double, is an error in the deck; 1e30 is only far away.
    const bool readable = bad.ends_with("1e30");
    EXPECT_EQ(run.errors, readable ? 0u : 1u) << bad;
    if (readable) {
      EXPECT_EQ(run.moved(upper.node(3, 3)), nullptr) << bad;
    }
    for (const MovedNode& m : run.report().moved) EXPECT_TRUE(m.to.allFinite()) << bad;
  }
  EXPECT_TRUE(fix_text("*KEYWORD\n*END\n").report().moved.empty());
  EXPECT_TRUE(fix_text("*KEYWORD\n" + single_surface + "*END\n").report().moved.empty());
  EXPECT_TRUE(fix_text("*KEYWORD\n" + lower.deck() +
                       "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n        77        78         2         2\n\n\n*END\n")
                  .report()
                  .moved.empty());
}

TEST(FixHostile, NodesInOnePlace) {
  // Both plates in one plane: every node lies on the other plate, and nothing tells the sides apart.
  const Plate same{.id = 2};
  const FixRun run = fix_text(plates_deck(lower, same));
  EXPECT_LE(run.report().crossings_after, run.report().crossings_before);
  for (const MovedNode& m : run.report().moved) EXPECT_TRUE(m.to.allFinite());
}

TEST(FixHostile, EndsWithinItsWork) {
  const FixRun whole = fix_text(plates_deck(lower, upper));
  ASSERT_TRUE(complete(whole.report()));
  EXPECT_FALSE(whole.report().cut_short);
  audit::FixOptions options;
  options.untangle = false;
  options.work = 1;
  const FixRun run = fix_text(plates_deck(lower, upper), options);
  EXPECT_TRUE(run.report().cut_short);
  EXPECT_FALSE(complete(run.report()));
  EXPECT_EQ(run.report().unfixed.size(), 32u);
  ASSERT_FALSE(run.report().notes.empty());
  EXPECT_NE(run.report().notes[0].find("ended after 1 round"), std::string::npos) << run.report().notes[0];
  EXPECT_NE(run.report().notes[0].find("32 nodes remain"), std::string::npos);
  options.work = 10'000'000'000;
  options.rounds = 1;
  EXPECT_TRUE(fix_text(plates_deck(lower, upper), options).report().cut_short);
}

TEST(FixHostile, FreeFormatAndLongLines) {
  std::string text = plates_deck(lower, upper);
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i <= 3; ++i)
      text = replaced(text, fmt::format("{:8}{:16}{:16}{:16}\n", upper.node(i, j), 5.0 * i, 5.0 * j, 0.7),
                      fmt::format("{}, {} ,{},0.7, 0\n", upper.node(i, j), 5.0 * i, 5.0 * j));
  const FixRun run = fix_text(text);
  EXPECT_TRUE(complete(run.report()));
  EXPECT_NE(run.text.find(fmt::format("{}, 5 ,5,0.8503", upper.node(1, 1))), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::audit_test::hostile_test
