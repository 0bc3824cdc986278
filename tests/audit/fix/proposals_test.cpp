#include "audit/fix/proposals.hpp"

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"
#include "audit/run.hpp"

namespace gapcheck::audit_test::proposals_test {
namespace {

TEST(Proposals, NamesThicknessExclusionAndIgnore) {
  const FixRun run = fix_text(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}));
  ASSERT_EQ(run.report().proposals.size(), 1u);
  const FixProposal& p = run.report().proposals[0];
  EXPECT_EQ(p.part, 1);
  EXPECT_EQ(p.other_part, 2);
  EXPECT_EQ(p.penetrations, 32u);
  EXPECT_NEAR(p.thickness, 0.7, 1e-12);
  ASSERT_EQ(p.alternatives.size(), 5u);
  EXPECT_NE(p.alternatives[0].text.find("SST = 0.7"), std::string::npos);
  EXPECT_NE(p.alternatives[1].text.find("OPTT = 0.7"), std::string::npos);
  EXPECT_NE(p.alternatives[2].text.find("T1 … T4 = 0.7 in section 1, T1 … T4 = 0.7 in section 2"), std::string::npos);
  EXPECT_NE(p.alternatives[4].text.find("IGNORE = 1"), std::string::npos);
}

// The cards do what they promise when they are put into the deck.
TEST(Proposals, TheExclusionEndsThePenetrations) {
  std::string text = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7});
  const FixRun run = fix_text(text);
  text.insert(text.find("*END"), run.report().proposals.at(0).alternatives.at(3).card);
  audit::AuditOptions options;
  options.select = {"GC101"};
  EXPECT_TRUE(run_text(text, options).report.penetrations.empty());
}

TEST(Proposals, TheModelReadsTheCardOfIgnore) {
  std::string text = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7});
  const FixRun run = fix_text(text);
  text.insert(text.find("*END"), "\n\n" + run.report().proposals.at(0).alternatives.at(4).card);  // behind A and B
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(text, "deck.k", {}, diagnostics);
  const auto model = model::read_model(deck.value(), diagnostics);
  ASSERT_TRUE(model.ok() && !diagnostics.has_errors());
  EXPECT_EQ(model.value().contacts.at(0).ignore, 1);
}

TEST(Proposals, IgnoreOnlyWhereTheTypeReadsIt) {
  const auto proposed = [](const std::string& keyword, const std::string& cards) {
    std::string text = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7});
    text.erase(text.find("*CONTACT"));
    text += "*CONTROL_CONTACT\n       0.1       0.0         0         1         1\n";
    const FixRun run = fix_text(text + "*CONTACT_" + keyword + "\n" + cards + "\n\n*END\n");
    EXPECT_EQ(run.report().proposals.size(), 1u) << keyword;
    for (const FixProposal& p : run.report().proposals)
      for (const FixAlternative& a : p.alternatives)
        if (a.text.find("IGNORE") != std::string::npos) return true;
    return false;
  };
  const std::string all = "         0         0         5\n", parts = "         1         2         3         3\n";
  EXPECT_TRUE(proposed("AUTOMATIC_SINGLE_SURFACE", all));
  EXPECT_FALSE(proposed("SINGLE_SURFACE", all));
  EXPECT_TRUE(proposed("AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", parts));
  EXPECT_FALSE(proposed("ONE_WAY_SURFACE_TO_SURFACE", parts));
  EXPECT_FALSE(proposed("FORMING_ONE_WAY_SURFACE_TO_SURFACE", parts));
}

TEST(Proposals, NoThicknessHelpsNextToTheSurface) {
  const FixRun run = fix_text(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.01}));
  ASSERT_EQ(run.report().proposals.size(), 1u);
  EXPECT_EQ(run.report().proposals[0].thickness, 0);
}

}  // namespace
}  // namespace gapcheck::audit_test::proposals_test
