#include "model/read/links.hpp"

#include <fstream>

#include "model/read.hpp"

namespace gapcheck::model::links_test {
namespace {

/// The links of a deck, and what was said while they were read.
struct ReadLinks {
  Links links;
  std::string text;
  std::size_t warnings = 0;
};

ReadLinks read_links_of(const std::string& text) {
  Diagnostics model_diagnostics, diagnostics;
  const auto deck = keyword::read_deck_text(text, "a.k", {}, model_diagnostics);
  EXPECT_TRUE(deck.ok());
  const auto model = read_model(deck.value(), model_diagnostics);
  EXPECT_FALSE(model_diagnostics.has_errors());
  ReadLinks read{read_links(deck.value(), model.value(), diagnostics), "", 0};
  for (const Diagnostic& d : diagnostics.sorted()) {
    read.text += d.file + ":" + std::to_string(d.line) + ": " + d.message + "\n";
    ++read.warnings;
  }
  return read;
}

TEST(Links, NodeSets) {
  const ReadLinks read =
      read_links_of(nodes_text(5) +
                    "*SET_NODE_LIST\n4\n1,3,5\n*CONSTRAINED_NODE_SET\n         4         7\n4,3,0.5\n"
                    "*CONSTRAINED_NODE_SET_ID\n77\n4,4\n");
  EXPECT_EQ(read.text, "");
  ASSERT_EQ(read.links.joined.size(), 3u);
  EXPECT_EQ(read.links.joined[0].kind, NodeLink::Kind::node_set);
  EXPECT_EQ(read.links.joined[0].freedoms, 7);
  EXPECT_EQ(read.links.joined[0].nodes.size(), 3u);
  EXPECT_EQ(read.links.joined[0].failure_time, 0);
  EXPECT_EQ(read.links.joined[1].freedoms, 4);
  EXPECT_EQ(read.links.joined[1].failure_time, 0.5);
  EXPECT_EQ(read.links.joined[1].id, 0);
  EXPECT_EQ(read.links.joined[2].id, 77);
  EXPECT_EQ(read.links.joined[2].freedoms, 3);
}

TEST(Links, Rivets) {
  const ReadLinks read = read_links_of(nodes_text(5) +
                                       "*CONSTRAINED_RIVET\n1,2\n         3         5        2.\n"
                                       "*CONSTRAINED_RIVET_ID\n8\n4,5\n");
  EXPECT_EQ(read.text, "");
  ASSERT_EQ(read.links.joined.size(), 3u);
  EXPECT_EQ(read.links.joined[0].kind, NodeLink::Kind::rivet);
  EXPECT_EQ(read.links.joined[1].nodes, (std::vector{NodeIndex{2}, NodeIndex{4}}));
  EXPECT_EQ(read.links.joined[1].failure_time, 2);
  EXPECT_EQ(read.links.joined[2].id, 8);
  EXPECT_EQ(read.links.joined[2].place.line, 12u);
}

TEST(Links, HangingNodes) {
  const ReadLinks read =
      read_links_of(nodes_text(5) + "*CONSTRAINED_ADAPTIVITY\n         3         1         5\n4,2,1\n");
  EXPECT_EQ(read.text, "");
  ASSERT_EQ(read.links.hanging.size(), 2u);
  EXPECT_EQ(read.links.hanging[0].node, NodeIndex{2});
  EXPECT_EQ(read.links.hanging[0].between[1], NodeIndex{4});
  EXPECT_EQ(read.links.hanging[1].between[0], NodeIndex{1});
}

TEST(Links, WhatIsNotThereIsNamed) {
  const ReadLinks read = read_links_of(nodes_text(2) +
                                       "*CONSTRAINED_NODE_SET\n9,1\n*CONSTRAINED_RIVET\n1,9\n"
                                       "*CONSTRAINED_ADAPTIVITY\n1,2,9\n8,1,2\n");
  EXPECT_TRUE(read.links.joined.empty());
  EXPECT_TRUE(read.links.hanging.empty());
  EXPECT_EQ(read.warnings, 4u) << read.text;
}

// Ids move with their includes, and times come in the model's unit.
TEST(Links, Includes) {
  const std::string path = testing::TempDir() + "link_include.k";
  std::ofstream(path) << nodes_text(3) << "*SET_NODE_LIST\n4\n1,3\n*CONSTRAINED_NODE_SET\n4,7,5.\n"
                      << "*CONSTRAINED_RIVET\n1,2,5.\n*CONSTRAINED_ADAPTIVITY\n2,1,3\n";
  const ReadLinks read =
      read_links_of(nodes_text(5) + "*INCLUDE_TRANSFORM\n" + path + "\n100,,,,10\n,,\n1.,0.001,1.\n\n");
  EXPECT_EQ(read.text, "");
  ASSERT_EQ(read.links.joined.size(), 2u);
  EXPECT_EQ(read.links.joined[0].nodes, (std::vector{NodeIndex{5}, NodeIndex{7}}));
  EXPECT_NEAR(read.links.joined[0].failure_time, 0.005, 1e-15);
  EXPECT_EQ(read.links.joined[1].nodes, (std::vector{NodeIndex{5}, NodeIndex{6}}));
  EXPECT_NEAR(read.links.joined[1].failure_time, 0.005, 1e-15);
  ASSERT_EQ(read.links.hanging.size(), 1u);
  EXPECT_EQ(read.links.hanging[0].node, NodeIndex{6});
}

TEST(Links, Keywords) {
  EXPECT_TRUE(is_link("CONSTRAINED_RIVET"));
  EXPECT_TRUE(is_link("CONSTRAINED_NODE_SET_ID"));
  EXPECT_TRUE(is_link("CONSTRAINED_ADAPTIVITY"));
  EXPECT_FALSE(is_link("CONSTRAINED_NODE_INTERPOLATION"));
  EXPECT_FALSE(is_link("CONSTRAINED_RIVETS"));
}

}  // namespace
}  // namespace gapcheck::model::links_test
