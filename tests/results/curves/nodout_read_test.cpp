#include <gtest/gtest.h>

#include <cmath>

#include "results/curves/nodout.hpp"
#include "results/said.hpp"

namespace gapcheck::results::nodout_read_test {
namespace {

// Values that touch, three-digit exponents, i9 and i10 for the node.
const std::string touching =
    R"( n o d a l   p r i n t   o u t   f o r   t i m e  s t e p       2                              ( at time 0.1000000E+00 )

 nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel      x-accl      y-accl      z-accl      x-coor      y-coor      z-coor
        6   0.0000E+00  0.0000E+00 -1.5000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00 -1.5000E+00  0.0000E+00 -3.0000E+00
        7   0.0000E+00  0.0000E+00 -1.5000-145  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00 -1.5000-145  0.0000E+00 -3.0000E+00
1200000000 -4.08233E-11-5.95949E-05-4.61685E-14-3.15410E-08-3.25501E-02-6.88246E-11-6.47259E-06-6.67967E+00-1.41236E-08-2.74317E-05-7.89994E+00-7.74020E-07
)";

TEST(ReadNodout, ValuesMayTouch) {
  Diagnostics diagnostics;
  const NodeHistory history = read_nodout(touching, "nodout", diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  ASSERT_EQ(history.states.size(), 1u);
  EXPECT_EQ(history.states[0].time, 0.1);
  EXPECT_EQ(history.states[0].cycle, 2u);
  const auto& nodes = history.states[0].nodes;
  ASSERT_EQ(nodes.size(), 3u);
  EXPECT_EQ(nodes[0].displacement, Vector(0, 0, -1.5));
  EXPECT_EQ(nodes[0].position, Vector(-1.5, 0, -3));
  EXPECT_EQ(nodes[1].displacement, Vector(0, 0, -1.5e-145));
  EXPECT_EQ(nodes[2].node, 1200000000);
  EXPECT_EQ(nodes[2].velocity, Vector(-3.1541e-8, -3.25501e-2, -6.88246e-11));
  EXPECT_EQ(nodes[2].position, Vector(-2.74317e-5, -7.89994, -7.7402e-7));
}

std::vector<NodeState> two_nodes() {
  NodeState a, b;
  a.node = 1100002;
  a.displacement = {-4.08233e-11, 5.95949e-5, 4.61685e-14};
  a.velocity = {-3.1541e-8, 3.25501e-2, 6.88246e-11};
  a.acceleration = {-6.47259e-6, 6.67967, 1.41236e-8};
  a.position = {2.74317e-5, -7.89994, 7.7402e-7};
  b.node = 5;
  b.angular_velocity = {-1e-120, -2e-120, 3};
  return {a, b};
}

TEST(ReadNodout, IsReadBack) {
  Diagnostics diagnostics;
  const NodeHistory history =
      read_nodout(nodout_header({"t", "p"}, {{1100002, ""}, {5, "tip"}}) + nodout_text(1, 0, two_nodes()) +
                      nodout_text(24, 4.8730101e-3, two_nodes()),
                  "nodout", diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  ASSERT_EQ(history.titles.size(), 2u);
  ASSERT_EQ(history.states.size(), 2u);
  EXPECT_EQ(history.states[1].time, 4.8730101e-3);
  EXPECT_EQ(history.states[1].cycle, 24u);
  ASSERT_EQ(history.states[1].nodes.size(), 2u) << "two blocks, one state";
  EXPECT_EQ(history.states[1].nodes[0].displacement, two_nodes()[0].displacement);
  EXPECT_EQ(history.states[1].nodes[0].acceleration, two_nodes()[0].acceleration);
  EXPECT_EQ(history.states[1].nodes[1].angular_velocity, two_nodes()[1].angular_velocity);
}

TEST(ReadNodout, FilesThatAreCutOff) {
  const std::string text = nodout_text(1, 0, two_nodes()) + nodout_text(24, 4.8730101e-3, two_nodes());
  Diagnostics row, number;
  const std::size_t last = text.rfind('\n', text.size() - 2) + 1;
  EXPECT_EQ(read_nodout(text.substr(0, last), "nodout", row).states.size(), 1u);
  EXPECT_NE(said(row).find("a state ends before it is complete"), std::string::npos);
  std::string damaged = touching;
  damaged.replace(damaged.find("-1.5000E+00"), 11, "***********");
  const NodeHistory history = read_nodout(damaged + "  no row at all\n", "nodout", number);
  EXPECT_EQ(said(number), "error 4: a number cannot be read and is left out, and so it is in 1 more places\n");
  ASSERT_EQ(history.states.size(), 1u);
  EXPECT_TRUE(std::isnan(history.states[0].nodes[0].displacement.z()));
}

TEST(ReadNodout, FilesThatWerePutTogether) {
  const std::string states = nodout_text(1, 0, two_nodes()) + nodout_text(24, 4.8730101e-3, two_nodes());
  for (const std::string& header : {nodout_header({"t", "p"}, {{5, "tip"}}), std::string(" t\n      p\n\n")})
    for (const char* between : {"", "\n"}) {
      Diagnostics diagnostics;
      const NodeHistory history = read_nodout(header + states + between + header + states, "nodout", diagnostics);
      EXPECT_EQ(said(diagnostics), "");
      ASSERT_EQ(history.states.size(), 4u);
      for (const NodeStates& state : history.states) EXPECT_EQ(state.nodes.size(), 2u);
    }
}

TEST(ReadNodout, ALegendWithoutEnd) {
  const std::string begin = "{BEGIN LEGEND}\n Entity #        Title\n        5     tip\n";
  Diagnostics diagnostics, twice, writing;
  const NodeHistory history = read_nodout("title\n" + begin + "\n" + touching, "nodout", diagnostics);
  EXPECT_EQ(said(diagnostics).find("error 2: the legend has no {END LEGEND}"), 0u) << said(diagnostics);
  ASSERT_EQ(history.titles.size(), 1u);
  EXPECT_EQ(history.titles[0].title, "tip");
  ASSERT_EQ(history.states.size(), 1u);
  EXPECT_EQ(history.states[0].nodes.size(), 3u);
  EXPECT_EQ(read_nodout(begin + begin + "{END LEGEND}\n" + touching, "nodout", twice).titles.size(), 2u);
  EXPECT_EQ(read_nodout(begin, "nodout", writing).titles.size(), 1u);
  EXPECT_EQ(said(writing), "warning 1: the file ends inside its legend: the run may still be writing it\n");
}

}  // namespace
}  // namespace gapcheck::results::nodout_read_test
