#include "audit/fix/joined_nodes.hpp"

#include <cstdint>
#include <set>

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"

namespace gapcheck::audit_test::joined_nodes_test {
namespace {

// Two plates of thickness 1 that are 0.7 apart; 1.2 apart at a free corner of the upper one.
const Plate lower{.id = 1}, upper{.id = 2, .z = 0.7};

std::string deck_with(const std::string& more) {
  return "*KEYWORD\n" + elastic_steel + lower.deck() + upper.deck() + single_surface + more + "*END\n";
}

std::string row(std::int64_t a, std::int64_t b) { return fmt::format("{:10}{:10}\n", a, b); }

/// The nodes of both plates one above the other at (i, j).
struct Couple {
  std::int64_t below, above;
  Couple(int i, int j) : below(lower.node(i, j)), above(upper.node(i, j)) {}
};
const Couple middle(1, 1);

struct Read {
  model::Model model;
  audit::JoinedNodes joined;
  audit::UnreadConstraints unread;
  [[nodiscard]] NodeIndex node(std::int64_t id) const { return NodeIndex{*model.mesh.nodes.lookup.find(id)}; }
  [[nodiscard]] bool together(std::int64_t a, std::int64_t b) const {
    return joined.leader(node(a)) == joined.leader(node(b));
  }
};

Read read(const std::string& more) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(deck_with(more), "deck.k", {}, diagnostics);
  auto model = model::read_model(deck.value(), diagnostics);
  EXPECT_TRUE(model.ok() && !diagnostics.has_errors());
  const model::Links links = model::read_links(deck.value(), model.value(), diagnostics);
  audit::JoinedNodes joined(model.value(), links.joined);
  auto unread = audit::unread_constraints(deck.value(), model.value());
  return {std::move(model).value(), std::move(joined), std::move(unread)};
}

TEST(JoinedNodes, AreThoseOfWeldsRivetsAndSets) {
  const Read r = read("*CONSTRAINED_SPOTWELD\n" + row(1001, 2001) + "*CONSTRAINED_RIVET\n" + row(2001, 2002) +
                      "*SET_NODE_LIST\n         9\n" + row(1010, 2010) + "*CONSTRAINED_NODE_SET\n" + row(9, 7));
  EXPECT_TRUE(r.together(1001, 2002));
  EXPECT_TRUE(r.together(1010, 2010));
  EXPECT_FALSE(r.together(1001, 1010));
  EXPECT_FALSE(r.together(1003, 1004));
  EXPECT_EQ(r.joined.leaders().size(), 2u);
  EXPECT_EQ(r.joined.followers(r.node(1001)).size(), 3u);
  EXPECT_TRUE(r.joined.followers(r.node(1003)).empty());
  EXPECT_TRUE(r.joined.by_keyword(r.node(2002)));
  EXPECT_TRUE(r.unread.held.empty());
}

TEST(JoinedNodes, AreThoseOfWeldElements) {
  const std::string beam =
      "*PART\nweld\n         7         7         7\n*SECTION_BEAM\n         7         9\n"
      "        1.        1.        0.        0.\n*MAT_SPOTWELD\n         7   7.85e-9  210000.       0.3\n"
      "*ELEMENT_BEAM\n" +
      fmt::format("{:8}{:8}{:8}{:8}{:8}\n", 90001, 7, middle.below, middle.above, 0);
  const Read r = read(beam);
  EXPECT_TRUE(r.together(middle.below, middle.above));
  EXPECT_FALSE(r.joined.by_keyword(r.node(middle.above)));
}

TEST(JoinedNodes, NothingIsJoinedWithoutThem) {
  const Read r = read("");
  EXPECT_TRUE(r.joined.leaders().empty());
  EXPECT_EQ(r.joined.leader(NodeIndex{3}), NodeIndex{3});
  EXPECT_FALSE(r.joined.by_keyword(NodeIndex{3}));
}

TEST(JoinedNodes, KeywordsThatNobodyReadsHoldTheirNodes) {
  const Read r =
      read("*CONSTRAINED_TIED_NODES_FAILURE\n" + row(1001, 2001) + "*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED\n" +
           row(1002, 2002) + "*BOUNDARY_SLIDING_PLANE\n" + row(1003, 2003));
  EXPECT_EQ(r.unread.keywords, (std::vector<std::string>{"CONSTRAINED_TIED_NODES_FAILURE"}));
  EXPECT_EQ(r.unread.unknown, (std::vector<std::string>{"BOUNDARY_SLIDING_PLANE"}));
  ASSERT_FALSE(r.unread.held.empty());
  EXPECT_EQ(r.unread.held[r.node(2001).value], 1);
  EXPECT_EQ(r.unread.held[r.node(1002).value], 0);
}

/// What every keyword of the list promises of a correction: both nodes move alike or not at all.
TEST(JoinedNodes, MoveTogether) {
  const std::string set = "*SET_NODE_LIST\n         9\n" + row(middle.below, middle.above);
  const std::string beam =
      "*PART\nweld\n         7         7         7\n*SECTION_BEAM\n         7         9\n"
      "        1.        1.        0.        0.\n*MAT_SPOTWELD\n         7   7.85e-9  210000.       0.3\n"
      "*ELEMENT_BEAM\n" +
      fmt::format("{:8}{:8}{:8}{:8}{:8}\n", 90001, 7, middle.below, middle.above, 0);
  const std::vector<std::string> keywords{"*CONSTRAINED_SPOTWELD\n" + row(middle.below, middle.above),
                                          "*CONSTRAINED_RIVET\n" + row(middle.below, middle.above),
                                          set + "*CONSTRAINED_NODE_SET\n" + row(9, 3),
                                          set + "*CONSTRAINED_GENERALIZED_WELD_SPOT\n         9\n\n",
                                          set + "*CONSTRAINED_NODAL_RIGID_BODY\n        77         0         9\n",
                                          set + "*CONSTRAINED_TIED_NODES_FAILURE\n         9\n",
                                          beam};
  for (const std::string& keyword : keywords) {
    const FixRun run = fix_text(deck_with(keyword));
    EXPECT_LT((run.move(middle.below) - run.move(middle.above)).norm(), 1e-6) << keyword;
    EXPECT_GT(run.report().moved.size(), 4u) << keyword;
    EXPECT_FALSE(complete(run.report())) << keyword;
    bool named = false;
    for (const UnfixedNode& node : run.report().unfixed) {
      if (node.node != middle.below && node.node != middle.above) continue;
      named = true;
      EXPECT_TRUE(node.reason == HoldReason::constrained || node.reason == HoldReason::rigid)
          << keyword << name(node.reason);
    }
    EXPECT_TRUE(named) << keyword;
  }
}

TEST(JoinedNodes, WeldsMayBeFree) {
  audit::FixOptions options;
  options.free_welds = true;
  for (const std::string keyword : {"*CONSTRAINED_SPOTWELD\n", "*CONSTRAINED_RIVET\n"}) {
    const FixRun run = fix_text(deck_with(keyword + row(middle.below, middle.above)), options);
    EXPECT_TRUE(complete(run.report())) << keyword;
    EXPECT_NEAR((run.move(middle.above) - run.move(middle.below)).z(), 1.002 * 0.3, 1e-6) << keyword;
    const bool noted = std::any_of(run.report().notes.begin(), run.report().notes.end(),
                                   [](const std::string& note) { return note.starts_with("1 spot welds"); });
    EXPECT_EQ(noted, keyword == "*CONSTRAINED_SPOTWELD\n");
  }
  const std::string set = "*SET_NODE_LIST\n         9\n" + row(middle.below, middle.above);
  EXPECT_FALSE(complete(fix_text(deck_with(set + "*CONSTRAINED_NODE_SET\n         9         7\n"), options).report()));
}

TEST(JoinedNodes, AWeldHoldsNoMoreThanItsSurroundings) {
  // A weld in the middle of two larger plates: what is not next to it comes free.
  const Plate below{.id = 1, .nx = 8, .ny = 8}, above{.id = 2, .z = 0.7, .nx = 8, .ny = 8};
  const FixRun run = fix_text("*KEYWORD\n" + elastic_steel + below.deck() + above.deck() + single_surface +
                              "*CONSTRAINED_SPOTWELD\n" + row(below.node(4, 4), above.node(4, 4)) + "*END\n");
  std::set<std::int64_t> unfixed;
  for (const UnfixedNode& node : run.report().unfixed) unfixed.insert(node.node);
  EXPECT_EQ(unfixed, (std::set<std::int64_t>{below.node(4, 4), above.node(4, 4)}));
}

TEST(JoinedNodes, WhatHoldsOneHoldsAll) {
  // The rivet joins a corner of the upper plate to a distant node that is locked.
  const Plate far{.id = 3, .z = 50};
  audit::FixOptions options;
  options.locks = {{false, 3, 3}};
  const FixRun run = fix_text("*KEYWORD\n" + elastic_steel + lower.deck() + upper.deck() + far.deck() + single_surface +
                                  "*CONSTRAINED_RIVET\n" + row(upper.node(0, 0), far.node(0, 0)) + "*END\n",
                              options);
  EXPECT_EQ(run.moved(upper.node(0, 0)), nullptr);
  EXPECT_TRUE(complete(run.report()));
  EXPECT_NEAR(run.move(lower.node(0, 0)).z(), -1.002 * 0.3, 1e-3);
}

TEST(JoinedNodes, AFollowerGoesAlong) {
  const Plate far{.id = 3, .z = 50};
  const FixRun run = fix_text("*KEYWORD\n" + elastic_steel + lower.deck() + upper.deck() + far.deck() + single_surface +
                              "*CONSTRAINED_RIVET\n" + row(upper.node(0, 0), far.node(0, 0)) + "*END\n");
  EXPECT_TRUE(complete(run.report()));
  // Two corners against one: the lower plate's goes two thirds of the way.
  EXPECT_NEAR(run.move(far.node(0, 0)).z(), 1.002 * 0.1, 1e-3);
  EXPECT_NEAR(run.move(lower.node(0, 0)).z(), -1.002 * 0.2, 1e-3);
  EXPECT_LT((run.move(far.node(0, 0)) - run.move(upper.node(0, 0))).norm(), 1e-6);
}

TEST(JoinedNodes, HangingNodesStayInTheMiddle) {
  const std::int64_t a = upper.node(0, 0), hanging = upper.node(1, 0), b = upper.node(2, 0);
  const FixRun run = fix_text(deck_with(fmt::format("*CONSTRAINED_ADAPTIVITY\n{:10}{:10}{:10}\n", hanging, a, b)));
  EXPECT_TRUE(complete(run.report()));
  EXPECT_GT(run.move(a).norm(), 0.01);
  EXPECT_LT((run.move(hanging) - (run.move(a) + run.move(b)) / 2).norm(), 1e-5);
}

TEST(JoinedNodes, PrescribedMotionsHoldTheirNodes) {
  const std::string curve =
      "*DEFINE_CURVE\n         1\n\n                 0.0                 0.0\n                 1.0                 "
      "1.0\n";
  const std::string set = "*SET_NODE_LIST\n         9\n" + row(lower.node(1, 1), upper.node(2, 2));
  for (const std::string& motion :
       {"*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + fmt::format("{:10}         3         2         1\n", upper.node(2, 2)),
        set + "*BOUNDARY_PRESCRIBED_MOTION_SET\n         9         3         2         1\n",
        set + "*BOUNDARY_SPC_SET\n         9         0         1         1         1\n"}) {
    const FixRun run = fix_text(deck_with(curve + motion));
    EXPECT_EQ(run.moved(upper.node(2, 2)), nullptr) << motion;
    EXPECT_FALSE(run.report().moved.empty()) << motion;
  }
}

TEST(JoinedNodes, ExtraNodesOfRigidBodiesAreHeld) {
  const std::string rigid =
      "*MAT_RIGID\n         5   7.85e-9  210000.       0.3\n*PART\nrigid\n         5         1         5\n";
  const FixRun run = fix_text(deck_with(rigid + "*CONSTRAINED_EXTRA_NODES_NODE\n" + row(5, middle.above)));
  EXPECT_EQ(run.moved(middle.above), nullptr);
  EXPECT_TRUE(complete(run.report()));
}

}  // namespace
}  // namespace gapcheck::audit_test::joined_nodes_test
