// Repairs are written into decks, and the audit finds in these decks what the plan says.
#include "audit/repair/repair_plan.hpp"

#include "audit/fix/plates.hpp"
#include "audit/repair/run_repairs.hpp"

namespace gapcheck::audit_test::repair_plan_test {
namespace {

/// A deck with plates, and contacts of one's own.
template <class... Plates>
std::string with_contacts(const std::string& contacts, const Plates&... plates) {
  return "*KEYWORD\n" + elastic_steel + (plates.deck() + ...) + contacts + "*END\n";
}

std::vector<std::string> ids(const RepairPair& pair) {
  std::vector<std::string> list;
  for (const Repair& repair : pair.repairs) list.push_back(repair.id);
  std::sort(list.begin(), list.end());
  return list;
}

TEST(RepairPlan, ListsAndRanksAllKinds) {
  RepairRun run(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}));
  const RepairPlan plan = run.plan();
  ASSERT_EQ(plan.pairs.size(), 1u);
  const RepairPair& pair = plan.pairs[0];
  EXPECT_EQ(pair.penetrations, 32u);
  EXPECT_NEAR(pair.deepest, 0.3, 1e-12);
  EXPECT_NEAR(pair.contact_distance, 1, 1e-12);
  EXPECT_EQ(ids(pair),
            (std::vector<std::string>{"1-exclude", "1-ignore", "1-move", "1-optt", "1-sections", "1-sst", "1-tie"}));
  for (const Repair& repair : pair.repairs) EXPECT_TRUE(repair.outcome.solves()) << repair.id;
  // Each plate moves by half of the penetration; all else gives away 0.3 or the whole contact.
  EXPECT_EQ(pair.repairs[0].kind, RepairKind::move);
  EXPECT_NEAR(pair.repairs[0].cost, 0.15, 0.01);
  EXPECT_NEAR(repair_of(pair, RepairKind::part_thickness).cost, 0.3, 1e-4);
  EXPECT_NEAR(repair_of(pair, RepairKind::contact_thickness).cost, 0.3, 1e-4);
  EXPECT_NEAR(repair_of(pair, RepairKind::ignore).cost, 0.3, 1e-12);
  EXPECT_EQ(repair_of(pair, RepairKind::ignore).outcome.forgiven, 32u);
  EXPECT_EQ(repair_of(pair, RepairKind::tie).cost, 1);
  EXPECT_EQ(plan.best(), std::vector<std::string>{"1-move"});
}

// What the plan says of each repair is what the audit finds in the deck that is written.
TEST(RepairPlan, TheAuditOfTheWrittenDeckAgrees) {
  const std::string original = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}, Plate{.id = 3, .z = 1.6});
  RepairRun run(original);
  const RepairPlan plan = run.plan();
  ASSERT_EQ(plan.pairs.size(), 2u);
  for (const RepairPair& pair : plan.pairs)
    for (const Repair& repair : pair.repairs) {
      const std::string text = run.text({repair.id});
      EXPECT_EQ(penetrations_of(text, pair.parts), repair.outcome.left) << repair.id;
      // Without the contact of parts 1 and 2 the nodes between them are found in part 3.
      const RepairPair& other = plan.pairs[pair.number == 1 ? 1 : 0];
      const std::size_t elsewhere = penetrations_of(text, other.parts);
      EXPECT_EQ(repair.outcome.added, elsewhere > other.penetrations ? elsewhere - other.penetrations : 0) << repair.id;
      EXPECT_EQ(repair.outcome.solves(), repair.outcome.left + repair.outcome.added == 0) << repair.id;
      EXPECT_NE(text, original) << repair.id;
    }
}

// Segments (SOFT = 2) and mortar contacts: nodes move as in others, and a thickness helps.
TEST(RepairPlan, PenetrationsOfSegments) {
  for (const std::string& contact :
       {std::string(
            "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n         1\n         0         0         5\n\n\n         2\n"),
        std::string("*CONTACT_AUTOMATIC_SINGLE_SURFACE_MORTAR_ID\n         1\n         0         0         5\n\n\n")}) {
    RepairRun run(with_contacts(contact, Plate{.id = 1}, Plate{.id = 2, .z = 0.7}));
    const RepairPlan plan = run.plan();
    ASSERT_EQ(plan.pairs.size(), 1u) << contact;
    EXPECT_EQ(ids(plan.pairs[0]), (std::vector<std::string>{"1-exclude", "1-move", "1-optt", "1-sst", "1-tie"}));
    audit::AuditOptions options;
    options.select = {"GC107", "GC108"};
    EXPECT_GT(plan.penetrating, 0u);
    for (const Repair& repair : plan.pairs[0].repairs) {
      EXPECT_EQ(run_text(run.text({repair.id}), options).report.penetrations.empty(), repair.outcome.left == 0)
          << contact << repair.id;
    }
    EXPECT_EQ(plan.best(), std::vector<std::string>{"1-move"}) << contact;
  }
}

// Nodes too far from their segment: a negative SST ties them all, and all that were tied before.
TEST(RepairPlan, ATieThatReachesFarther) {
  const std::string tie =
      "*CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET_ID\n         3\n         2         1         3         3\n\n"
      "        1.        1.        0.        0.\n";
  RepairRun run(with_contacts(tie, Plate{.id = 1}, Plate{.id = 2, .z = 1.5}));
  const RepairPlan plan = run.plan();
  ASSERT_EQ(plan.pairs.size(), 1u);
  const RepairPair& pair = plan.pairs[0];
  EXPECT_TRUE(pair.of_ties);
  EXPECT_EQ(plan.too_far, 16u);
  EXPECT_EQ(pair.penetrations, 16u);
  EXPECT_NEAR(pair.deepest, 1.5, 1e-12);
  EXPECT_NEAR(pair.contact_distance, 1.2, 1e-12);
  ASSERT_EQ(ids(pair), std::vector<std::string>{"1-reach"});
  EXPECT_TRUE(pair.repairs[0].outcome.solves());
  EXPECT_TRUE(plan.best().empty());
  const std::string text = run.text({"1-reach"});
  EXPECT_NE(text.find("        1.        1.      -1.5        0.\n"), std::string::npos) << text.substr(text.find(tie));
  EXPECT_EQ(run_text(text).report.contacts.at(0).ties, 16u);
  EXPECT_EQ(run_text(text).report.contacts.at(0).untied, 0u);
}

// What stays without force is not solved, unless a repair says so.
TEST(RepairPlan, IgnoreInTheDeckIsNoSolution) {
  const std::string contact =
      "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n         1\n         0         0         5\n\n\n\n\n         1         "
      "1\n";
  RepairRun run(with_contacts(contact, Plate{.id = 1}, Plate{.id = 2, .z = 0.7}));
  audit::FixOptions locked;
  locked.locks = {{false, 1, 2}};
  const RepairPlan plan = run.plan(locked);
  ASSERT_EQ(plan.pairs.size(), 1u);
  EXPECT_EQ(repair_of(plan.pairs[0], RepairKind::move).outcome.left, 32u);
  EXPECT_TRUE(repair_of(plan.pairs[0], RepairKind::part_thickness).outcome.solves());
  EXPECT_EQ(repair_of(plan.pairs[0], RepairKind::ignore).id, "");
  const auto nothing = run.apply({});
  ASSERT_TRUE(nothing.ok());
  EXPECT_EQ(nothing.value().report.after(), 32u);
  EXPECT_FALSE(nothing.value().report.complete());
}

TEST(RepairPlan, ContactsWithTheSameIdAreRefused) {
  RepairRun run(with_contacts(single_surface + single_surface, Plate{.id = 1}, Plate{.id = 2, .z = 0.7}));
  const auto applied = run.apply({"1-sst"});
  ASSERT_FALSE(applied.ok());
  EXPECT_NE(applied.error().message.find("another contact has the id 1"), std::string::npos) << applied.error().message;
}

// Nobody but the user can say that parts are meant to be joined.
TEST(RepairPlan, TheBestNeverJoinsOrSeparatesParts) {
  // No thickness helps so near to the mid-surface, and both parts are rigid, so that their nodes cannot move.
  std::string text = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.01});
  text.replace(text.find("*MAT_ELASTIC"), 12, "*MAT_RIGID");
  text.insert(text.find("*PART"), "\n\n");
  const RepairPlan plan = RepairRun(text).plan();
  ASSERT_EQ(plan.pairs.size(), 1u);
  EXPECT_TRUE(repair_of(plan.pairs[0], RepairKind::exclude).outcome.solves());
  EXPECT_FALSE(repair_of(plan.pairs[0], RepairKind::move).outcome.solves());
  EXPECT_TRUE(plan.best().empty());
}

// Listed repairs are what the plan tries and what is applied, line by line; none moves nodes.
TEST(RepairPlan, ListedRepairsAreThoseThatAreApplied) {
  std::string original = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}, Plate{.id = 3, .z = 1.6});
  original.insert(original.find("*PART"), "*PARAMETER\nRthick          1.\n");
  constexpr std::string_view section = "*SECTION_SHELL\n         1         2\n";
  original.replace(original.find(section) + section.size(), 10, "    &thick");
  RepairRun run(original);
  const RepairPlan listed = run.listed(), plan = run.plan();
  ASSERT_EQ(listed.pairs.size(), 2u);
  EXPECT_EQ(listed.penetrating, plan.penetrating);
  EXPECT_EQ(listed.trials, 0u);
  std::size_t written = 0, refused = 0;
  for (std::size_t i = 0; i < listed.pairs.size(); ++i) {
    EXPECT_FALSE(listed.pairs[i].tried);
    EXPECT_EQ(listed.pairs[i].repairs.size() + 1, plan.pairs[i].repairs.size());
    for (const Repair& repair : listed.pairs[i].repairs) {
      ASSERT_NE(repair.kind, RepairKind::move);
      const auto applied = run.apply({repair.id});
      EXPECT_EQ(applied.ok(), repair.outcome.refused.empty()) << repair.id;
      refused += applied.ok() ? 0 : 1;
      if (!applied) continue;
      ++written;
      const std::vector<RepairLine>& lines = applied.value().report.lines;
      ASSERT_EQ(repair.lines.size(), lines.size()) << repair.id;
      for (std::size_t k = 0; k < lines.size(); ++k) {
        EXPECT_EQ(repair.lines[k].line, lines[k].line) << repair.id;
        EXPECT_EQ(repair.lines[k].before, lines[k].before) << repair.id;
        EXPECT_EQ(repair.lines[k].after, lines[k].after) << repair.id;
      }
    }
  }
  EXPECT_GE(written, 6u);
  EXPECT_GE(refused, 1u) << "T1 of a section is a parameter";
}

TEST(RepairPlan, OnlyCardsAreTriedWhereNobodyMovesNodes) {
  RepairRun run(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}));
  const RepairPlan plan = run.plan({}, audit::Tried::cards);
  ASSERT_EQ(plan.pairs.size(), 1u);
  EXPECT_EQ(repair_of(plan.pairs[0], RepairKind::move).id, "");
  EXPECT_TRUE(repair_of(plan.pairs[0], RepairKind::part_thickness).outcome.solves());
  EXPECT_EQ(plan.trials, 6u);
}

TEST(RepairPlan, OnlyLinesOfTheRepairChange) {
  const std::string original = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7});
  RepairRun run(original);
  std::string expected = original;
  expected.replace(expected.find("         5\n\n\n") + 11, 2, "\n                           0.7\n");
  EXPECT_EQ(run.text({"1-sst"}), expected);
  // Card C comes behind A and B.
  expected = original;
  expected.replace(expected.find("         5\n\n\n") + 11, 2, "\n\n         0\n        0.\n         1         1\n");
  EXPECT_EQ(run.text({"1-ignore"}), expected);
}

TEST(RepairPlan, SeveralRepairsTogether) {
  RepairRun run(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}, Plate{.id = 3, .z = 1.6}));
  const std::string text = run.text({"1-optt", "2-optt"});
  EXPECT_EQ(penetrations_of(text), 0u);
  // Part 2 is in both pairs and takes the smaller thickness.
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(text, "deck.k", {}, diagnostics);
  const auto model = model::read_model(deck.value(), diagnostics);
  ASSERT_TRUE(model.ok() && !diagnostics.has_errors());
  for (const model::Part& part : model.value().parts) {
    ASSERT_TRUE(part.contact) << part.id.value;
    EXPECT_NEAR(part.contact->optt, part.id.value == 3 ? 0.9 : 0.7, 0.101) << part.id.value;
  }
  EXPECT_NEAR(model.value().parts[1].contact->optt, model.value().parts[0].contact->optt, 1e-12);
}

TEST(RepairPlan, ATieHoldsTheNodesAndEndsTheContact) {
  RepairRun run(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}));
  const std::string text = run.text({"1-tie"});
  EXPECT_NE(text.find("*CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET_ID\n"), std::string::npos);
  const AuditRun audited = run_text(text);
  EXPECT_EQ(audited.report.contacts.at(1).ties, 16u);
  EXPECT_EQ(penetrations_of(text), 0u);
}

// Nodes beside the other part are not meant; nodes that penetrate and are not held are counted.
TEST(RepairPlan, ATieMustHoldThePenetratingNodes) {
  const RepairPlan wide = RepairRun(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7, .nx = 6})).plan();
  ASSERT_EQ(wide.pairs.size(), 1u);
  EXPECT_TRUE(repair_of(wide.pairs[0], RepairKind::tie).outcome.solves());
  // The contact thickness reaches farther than a tie.
  const std::string contact =
      "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n         1\n         0         0         5\n\n"
      "        1.        1.        4.        0.\n";
  const std::string text = with_contacts(contact, Plate{.id = 1}, Plate{.id = 2, .z = 2});
  RepairRun run(text);
  const RepairPlan far = run.plan();
  ASSERT_EQ(far.pairs.size(), 1u);
  const Repair tie = repair_of(far.pairs[0], RepairKind::tie);
  EXPECT_EQ(tie.outcome.untied, 16u);
  EXPECT_FALSE(tie.outcome.solves());
  EXPECT_EQ(run_text(run.text({tie.id})).report.contacts.at(1).ties, 0u);
}

TEST(RepairPlan, SidesOfOneWayContactsChangePlaces) {
  // Only the middle nodes of the small plate are tracked; the large plate has none above it.
  const std::string contact =
      "*CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_ID\n         7\n         2         1         3         3\n\n"
      "       1.0       2.0       0.0       0.0\n";
  const std::string original = with_contacts(contact, Plate{.id = 1, .nx = 1, .ny = 1},
                                             Plate{.id = 2, .z = 0.7, .x = 1, .y = 1, .nx = 1, .ny = 1});
  RepairRun run(original);
  const RepairPlan plan = run.plan();
  ASSERT_EQ(plan.pairs.size(), 1u);
  const Repair swap = repair_of(plan.pairs[0], RepairKind::swap);
  ASSERT_EQ(swap.id, "1-swap");
  const std::string text = run.text({"1-swap"});
  EXPECT_NE(text.find("         1         2         3         3\n"), std::string::npos);
  EXPECT_NE(text.find("       2.0       1.0       0.0       0.0\n"), std::string::npos);
  EXPECT_EQ(penetrations_of(text), swap.outcome.left);
}

TEST(RepairPlan, NoSwapWhereASideNamesNodesOrBothAreTracked) {
  for (const char* contact : {"*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n         2         1         3         3\n\n\n",
                              "*SET_NODE_LIST\n         4\n      2001      2002      2006\n"
                              "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n         4         1         4         3\n\n\n"}) {
    const RepairPlan plan = RepairRun(with_contacts(contact, Plate{.id = 1}, Plate{.id = 2, .z = 0.7})).plan();
    ASSERT_EQ(plan.pairs.size(), 1u) << contact;
    EXPECT_EQ(repair_of(plan.pairs[0], RepairKind::swap).id, "") << contact;
  }
}

// Only a corner of the large shell is in the way of part 2. With the sides exchanged the nodes of part 3, which the
// contact had never looked at, are in it too.
TEST(RepairPlan, ARepairThatHurtsElsewhereDoesNotSolve) {
  const std::string large =
      "*PART\nlarge\n         1         1         1\n*SECTION_SHELL\n         1         2\n"
      "        1.        1.        1.        1.\n*NODE\n"
      "    1001            -10.            -10.              0.\n    1002             10.            -10.              "
      "0.\n"
      "    1003             10.             10.              0.\n    1004            -10.             10.              "
      "0.\n"
      "*ELEMENT_SHELL\n    1001       1    1001    1002    1003    1004\n";
  const std::string contact =
      "*CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_ID\n         7\n         1         5         3         2\n\n\n"
      "*SET_PART\n         5\n         2         3\n";
  RepairRun run("*KEYWORD\n" + elastic_steel + large +
                Plate{.id = 2, .z = 0.7, .x = -12, .y = -12, .nx = 1, .ny = 1}.deck() +
                Plate{.id = 3, .z = 0.7, .nx = 1, .ny = 1}.deck() + contact + "*END\n");
  const RepairPlan plan = run.plan();
  ASSERT_EQ(plan.pairs.size(), 1u);
  EXPECT_EQ(plan.pairs[0].penetrations, 1u);
  const Repair swap = repair_of(plan.pairs[0], RepairKind::swap);
  EXPECT_EQ(swap.outcome.left, 1u);
  EXPECT_EQ(swap.outcome.added, 4u);
  EXPECT_FALSE(swap.outcome.solves());
  EXPECT_EQ(penetrations_of(run.text({"1-swap"})), 5u);
}

TEST(RepairPlan, CardsThatCannotBeWrittenAreNamed) {
  std::string text = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7});
  text.insert(text.find("*PART"), "*PARAMETER\nRsst            0.\n");
  text.replace(text.find("         5\n\n\n") + 11, 1, "       1.0       1.0      &sst\n");
  RepairRun run(text);
  const RepairPlan plan = run.plan();
  ASSERT_EQ(plan.pairs.size(), 1u);
  // The contact has its cards 1, 2 (with the parameter, where it means nothing) and 3.
  EXPECT_TRUE(repair_of(plan.pairs[0], RepairKind::contact_thickness).outcome.refused.empty());
  std::string third = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7});
  third.insert(third.find("*PART"), "*PARAMETER\nRsst            0.\n");
  third.replace(third.find("         5\n\n\n") + 12, 1, "       1.0       1.0      &sst\n");
  const RepairPlan refused = RepairRun(third).plan();
  ASSERT_EQ(refused.pairs.size(), 1u);
  const Repair sst = repair_of(refused.pairs[0], RepairKind::contact_thickness);
  EXPECT_NE(sst.outcome.refused.find("&sst is a parameter"), std::string::npos) << sst.outcome.refused;
  EXPECT_FALSE(sst.outcome.solves());
  EXPECT_EQ(refused.pairs[0].repairs.back().id, "1-sst") << "what is impossible comes last";
}

TEST(RepairPlan, UnknownIdsAreErrors) {
  RepairRun run(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}));
  for (const char* id : {"2-move", "1-", "move", "1-swap", ""}) EXPECT_FALSE(run.apply({id}).ok()) << id;
}

TEST(RepairPlan, NothingToRepair) {
  const RepairPlan plan = RepairRun(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 5})).plan();
  EXPECT_TRUE(plan.pairs.empty());
  EXPECT_EQ(plan.trials, 0u);
  EXPECT_TRUE(plan.best().empty());
}

TEST(RepairPlan, PairsBeyondTheLimitAreListed) {
  std::string plates;
  for (int i = 0; i < 22; ++i) {
    plates += Plate{.id = 2 * i + 1, .x = 100.0 * i, .nx = 1, .ny = 1}.deck();
    plates += Plate{.id = 2 * i + 2, .z = 0.7, .x = 100.0 * i, .nx = 1, .ny = 1}.deck();
  }
  RepairRun run("*KEYWORD\n" + elastic_steel + plates + single_surface + "*END\n");
  const RepairPlan plan = run.plan();
  ASSERT_EQ(plan.pairs.size(), 22u);
  EXPECT_TRUE(plan.pairs[audit::most_repaired_pairs - 1].tried);
  EXPECT_FALSE(plan.pairs[audit::most_repaired_pairs].tried);
  ASSERT_EQ(plan.notes.size(), 1u);
  EXPECT_EQ(plan.best().size(), audit::most_repaired_pairs);
}

}  // namespace
}  // namespace gapcheck::audit_test::repair_plan_test
