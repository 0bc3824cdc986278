#include "contact/tie/record_tie.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "contact/scene.hpp"

namespace gapcheck::contact::record_tie_test {
namespace {

/// Node 2 of contact 3 (from 0) near segment 7.
struct Judged : Scene {
  JudgedNode node;
  Judged() {
    const PartIndex plate = part(41, 1);
    Scene::node({0, 0, 0});
    Scene::node({1, 2, 3});
    model.mesh.nodes.line = {11, 12};
    this->node.contact = ContactIndex{3};
    this->node.node = NodeIndex{1};
    this->node.part = plate;
    this->node.segment = SegmentIndex{7};
    this->node.reason = TieReason::too_far;
    this->node.distance = 2.5;
    this->node.allowed = 0.75;
    this->node.diagonal = 14;
    this->node.node_thickness = 0.5;
    this->node.segment_thickness = 1.5;
    this->node.by_node_set = true;
  }
  [[nodiscard]] TieFailure record() const { return record_tie(node, model); }
};

TEST(RecordTie, OfANodeOverASegment) {
  const Judged judged;
  const TieFailure failure = judged.record();
  EXPECT_EQ(failure.contact, 3U);
  EXPECT_EQ(failure.node, 2);
  EXPECT_EQ(failure.part, 41);
  EXPECT_EQ(failure.segment_number, 8U);
  EXPECT_EQ(failure.distance, 2.5);
  EXPECT_EQ(failure.allowed, 0.75);
  EXPECT_EQ(failure.segment_size, 14);
  EXPECT_EQ(failure.thickness, 2);
  EXPECT_EQ(failure.reason, TieReason::too_far);
  EXPECT_TRUE(failure.by_node_set);
  EXPECT_EQ(failure.position, Vector(1, 2, 3));
  EXPECT_EQ(failure.line, 12U);
}

TEST(RecordTie, WhatIsNotKnownIsNegativeOrZero) {
  Judged judged;
  judged.node.segment = none<SegmentIndex>;
  judged.node.part = none<PartIndex>;
  judged.node.reason = TieReason::not_found;
  judged.node.by_node_set = false;
  judged.model.mesh.nodes.x[1].y() = std::numeric_limits<double>::quiet_NaN();
  const TieFailure failure = judged.record();
  EXPECT_EQ(failure.part, 0);
  EXPECT_EQ(failure.segment_number, 0U);
  EXPECT_LT(failure.distance, 0);
  EXPECT_LT(failure.allowed, 0);
  EXPECT_LT(failure.segment_size, 0);
  EXPECT_LT(failure.thickness, 0);
  EXPECT_FALSE(failure.by_node_set);
  EXPECT_FALSE(failure.position.has_value());
}

TEST(RecordTie, AThicknessOfOneSideAloneIsNone) {
  Judged judged;
  judged.node.node_thickness = 0;
  EXPECT_LT(judged.record().thickness, 0);
  judged.node.node_thickness = 0.5;
  judged.node.segment_thickness = 0;
  EXPECT_LT(judged.record().thickness, 0);
}

}  // namespace
}  // namespace gapcheck::contact::record_tie_test
