#include "contact/pair/node_contact.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace gapcheck::contact::node_contact_test {
namespace {

using State = NodeContact::State;

NodeEncounter inside(double penetration, double release = 1) { return {true, true, penetration, release, true}; }
const NodeEncounter outside{};

ContactSettings ignore(std::int64_t value, std::int64_t snlog = 0) {
  ContactSettings settings;
  settings.ignore = value;
  settings.snlog = snlog;
  return settings;
}

TEST(NodeContact, ShootingNodeIsMovedThenForcedAndMovedAgainAfterItHasLeft) {
  NodeContact node;
  EXPECT_EQ(advance(node, ignore(0), inside(0.1)), NodeAction::move);
  EXPECT_EQ(advance(node, ignore(0), inside(0.05)), NodeAction::force);
  EXPECT_EQ(node.forgiven, 0);
  EXPECT_EQ(advance(node, ignore(0), outside), NodeAction::none);
  EXPECT_EQ(advance(node, ignore(0), inside(0.02)), NodeAction::move);
}

// What a segment had in sight is neither moved nor forgiven; its force starts with the first overlap.
TEST(NodeContact, FollowedNodesAreInOrdinaryContact) {
  NodeEncounter followed = inside(0.1);
  followed.followed = true;
  for (const std::int64_t value : {0, 1, 2})
    for (const std::int64_t snlog : {0, 1}) {
      NodeContact node;
      EXPECT_EQ(advance(node, ignore(value, snlog), followed), NodeAction::force);
      EXPECT_EQ(node.forgiven, 0);
      EXPECT_EQ(node.state, State::touching);
      EXPECT_EQ(advance(node, ignore(value, snlog), inside(0.2)), NodeAction::force);
      EXPECT_EQ(node.forgiven, 0);
    }
  NodeContact deep;
  followed.release_depth = 0.05;
  EXPECT_EQ(advance(deep, ignore(0), followed), NodeAction::none);
  EXPECT_EQ(deep.state, State::released);
}

TEST(NodeContact, BaselineOfSegmentsIsWhatIsFoundSuddenly) {
  NodeContact node;
  EXPECT_EQ(advance_from_baseline(node, inside(0.1), 0), NodeAction::force);
  EXPECT_EQ(node.forgiven, 0.1);
  node = {};
  NodeEncounter followed = inside(0.1);
  followed.followed = true;
  EXPECT_EQ(advance_from_baseline(node, followed, 0), NodeAction::force);
  EXPECT_EQ(node.forgiven, 0);
}

TEST(NodeContact, DprfacIsAShareOrACurve) {
  model::Model model;
  model.curves[0].points = {{0, 0.5}, {1, 0.5}};
  model.curves[4].points = {{0, 0.25}, {1, 0.75}};
  model::Contact contact;
  const auto reduction = [&](double dprfac, double time) {
    contact.dprfac = dprfac;
    return baseline_reduction(model, contact, time);
  };
  EXPECT_EQ(reduction(0.1, 0), 0.1);
  EXPECT_EQ(reduction(7, 0), 1) << "more than everything";
  EXPECT_EQ(reduction(0, 0), 0) << "none, and no curve";
  EXPECT_EQ(reduction(-4, 0), 0.25);
  EXPECT_EQ(reduction(-4, 0.5), 0.5);
  EXPECT_EQ(reduction(-5, 0), 0) << "not defined";
  EXPECT_EQ(reduction(-1e300, 0), 0);
  model.curves[4].points = {{0, -1}, {1, 3}};
  EXPECT_EQ(reduction(-4, 0), 0);
  EXPECT_EQ(reduction(-4, 1), 1);
}

// What is left of the baseline: the smaller of it and the depth, less the share.
TEST(NodeContact, BaselineShrinksByTheShare) {
  NodeContact node;
  EXPECT_EQ(advance_from_baseline(node, inside(0.8), 0.25), NodeAction::force);
  EXPECT_EQ(node.forgiven, 0.8);
  EXPECT_EQ(advance_from_baseline(node, inside(0.9), 0.25), NodeAction::force);
  EXPECT_DOUBLE_EQ(node.forgiven, 0.6);
  EXPECT_EQ(advance_from_baseline(node, inside(0.4), 0.25), NodeAction::force);
  EXPECT_DOUBLE_EQ(node.forgiven, 0.3);
  EXPECT_EQ(advance_from_baseline(node, outside, 0.25), NodeAction::none);
  EXPECT_EQ(node.forgiven, 0);
  EXPECT_EQ(node.state, State::apart);
}

TEST(NodeContact, InSightIsApartByLessThanTheZone) {
  EXPECT_TRUE(was_followed(1.0, 1, 1, 0));
  EXPECT_TRUE(was_followed(1.999, 1, 1, 0));
  EXPECT_FALSE(was_followed(2.0, 1, 1, 0));      // jumped in from beyond
  EXPECT_FALSE(was_followed(0.9, 1, 1, 1e-9));   // was inside, beside the segment
  EXPECT_FALSE(was_followed(-0.1, 0, 1, 1e-9));  // was behind
  EXPECT_TRUE(was_followed(-1e-17, 0, 1, 1e-9));
}

TEST(NodeContact, NodesThatCannotBeMovedAreForced) {
  NodeContact node;
  NodeEncounter fixed = inside(0.1);
  fixed.movable = false;
  EXPECT_EQ(advance(node, ignore(0), fixed), NodeAction::force);
}

TEST(NodeContact, SnlogForcesAtOnce) {
  NodeContact node;
  EXPECT_EQ(advance(node, ignore(0, 1), inside(0.1)), NodeAction::force);
  EXPECT_EQ(node.forgiven, 0);
}

// The forgiven depth follows the penetration downwards only, and is forgotten outside.
TEST(NodeContact, IgnoreForgivesWhatWasThere) {
  for (const std::int64_t value : {1, 2}) {
    NodeContact node;
    EXPECT_EQ(advance(node, ignore(value, 1), inside(0.3)), NodeAction::force);
    EXPECT_EQ(node.forgiven, 0.3);
    EXPECT_EQ(advance(node, ignore(value), inside(0.5)), NodeAction::force);
    EXPECT_EQ(node.forgiven, 0.3);
    EXPECT_EQ(advance(node, ignore(value), inside(0.1)), NodeAction::force);
    EXPECT_EQ(node.forgiven, 0.1);
    EXPECT_EQ(advance(node, ignore(value), inside(0.2)), NodeAction::force);
    EXPECT_EQ(node.forgiven, 0.1);
    EXPECT_EQ(advance(node, ignore(value), outside), NodeAction::none);
    EXPECT_EQ(node.forgiven, 0);
    EXPECT_EQ(node.state, State::apart);
  }
}

// Too deep at any time: released until it has left the whole zone, also where it is in no band.
TEST(NodeContact, ReleasedUntilOutOfTheZone) {
  for (const std::int64_t value : {0, 1}) {
    NodeContact node{State::touching, 0};
    EXPECT_EQ(advance(node, ignore(value), inside(1.0)), NodeAction::force);  // not deeper than the limit
    EXPECT_EQ(advance(node, ignore(value), inside(1.0 + 1e-15)), NodeAction::none);
    EXPECT_EQ(node.state, State::released);
    EXPECT_EQ(advance(node, ignore(value), inside(0.1)), NodeAction::none);
    EXPECT_EQ(advance(node, ignore(value), {false, true, 0, 0, true}), NodeAction::none);
    EXPECT_EQ(node.state, State::released);
    EXPECT_EQ(advance(node, ignore(value), outside), NodeAction::none);
    EXPECT_EQ(advance(node, ignore(value), inside(0.1)), value == 0 ? NodeAction::move : NodeAction::force);
  }
}

TEST(NodeContact, NeverReleasedWithoutALimit) {
  NodeContact node;
  const double never = std::numeric_limits<double>::infinity();
  EXPECT_EQ(advance(node, ignore(0, 1), inside(1e300, never)), NodeAction::force);
}

}  // namespace
}  // namespace gapcheck::contact::node_contact_test
