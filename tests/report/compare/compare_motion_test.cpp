#include "report/compare/compare_motion.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "results/d3plot/d3plot_write.hpp"

namespace gapcheck::report::compare_motion_test {
namespace {

namespace fs = std::filesystem;
using results::D3plot;
using results::D3plotState;
using results::D3plotStates;
using results::D3plotWriter;

/// Two squares of parts 7 and 9, four nodes each, and a node of no element.
D3plot mesh(bool reversed = false) {
  D3plot plot;
  plot.title = "motion";
  plot.word_bytes = 8;
  for (std::int64_t i = 0; i < 9; ++i) {
    const std::int64_t at = reversed ? 8 - i : i;
    plot.node_ids.push_back(100 + at);
    plot.coordinates.push_back({static_cast<double>(at % 2), static_cast<double>(at / 2), 0});
  }
  const auto place = [&](std::uint32_t i) { return reversed ? 8 - i : i; };
  for (const std::uint32_t first : {0u, 4u}) {
    plot.shells.ids.push_back(first + 1);
    plot.shells.nodes.push_back({place(first), place(first + 1), place(first + 3), place(first + 2)});
    plot.shells.parts.push_back(first == 0 ? 7 : 9);
  }
  return plot;
}

class MotionOfNodes : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("gapcheck_motion_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// A run whose nodes move by move(id, time) in z.
  template <class Move>
  D3plotStates run(const std::string& name, const std::vector<double>& times, const Move& move, bool reversed = false,
                   int word_bytes = 8) {
    const D3plot plot = mesh(reversed);
    const std::string path = (folder_ / name).string();
    results::D3plotWriteSettings settings;
    settings.word_bytes = word_bytes;
    auto writer = D3plotWriter::create(path, plot, {{7, "a"}, {9, "b"}}, settings);
    EXPECT_TRUE(writer) << (writer ? "" : writer.error().message);
    for (const double time : times) {
      D3plotState state;
      state.time = time;
      state.parts.resize(2);
      state.coordinates = plot.coordinates;
      for (std::size_t i = 0; i < plot.node_ids.size(); ++i) state.coordinates[i][2] += move(plot.node_ids[i], time);
      state.velocities.resize(plot.node_ids.size());
      state.shells.resize(2);
      state.shell_points.resize(6);
      const Status status = writer.value().append(state);
      EXPECT_TRUE(status.ok()) << (status.ok() ? "" : status.error().message);
    }
    auto states = D3plotStates::open(path);
    EXPECT_TRUE(states) << (states ? "" : states.error().message);
    return std::move(states).value();
  }

  fs::path folder_;
};

double still(std::int64_t, double) { return 0; }
double up(std::int64_t, double time) { return 2 * time; }

TEST_F(MotionOfNodes, EqualRunsHaveNoDistance) {
  const auto a = run("a", {0, 1, 2}, up), b = run("b", {0, 1, 2}, up, true);
  const MotionComparison motion = compare_motion(a, b, 1e-3);
  EXPECT_EQ(motion.times, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(motion.largest_displacement, 4);
  ASSERT_EQ(motion.parts.size(), 3u) << "7, 9 and the node of no element";
  EXPECT_EQ(motion.differ, 0u);
  for (const PartMotion& part : motion.parts) EXPECT_EQ(part.largest_distance, 0) << part.part;
}

// B's states lie between A's: a node that moves evenly is at the same place all the same.
TEST_F(MotionOfNodes, OtherTimesAreInterpolated) {
  const auto a = run("a", {0, 0.5, 1, 2, 4}, up), b = run("b", {0.25, 0.75, 3}, up);
  const MotionComparison motion = compare_motion(a, b, 1e-3);
  EXPECT_EQ(motion.times, (std::vector<double>{0.5, 1, 2}));
  EXPECT_EQ(motion.differ, 0u);
  EXPECT_NEAR(motion.parts[0].largest_distance, 0, 1e-14);
  EXPECT_EQ(motion.end_first, 4);
  EXPECT_EQ(motion.end_second, 3);
}

// In part 9 node 105 runs away with t², the other three with a quarter of it: largest and mean by hand.
TEST_F(MotionOfNodes, LargestAndMeanPartByPart) {
  const auto away = [](std::int64_t id, double time) {
    return id < 104 || id == 108 ? up(id, time) : up(id, time) + (id == 105 ? 1 : 0.25) * time * time;
  };
  const auto a = run("a", {0, 1, 2}, up), b = run("b", {0, 1, 2}, away, true);
  const MotionComparison motion = compare_motion(a, b, 1e-3);
  EXPECT_EQ(motion.differ, 1u);
  const PartMotion& part = motion.parts[0];
  EXPECT_EQ(part.part, 9);
  EXPECT_TRUE(part.differs);
  EXPECT_EQ(part.nodes, 4u);
  EXPECT_EQ(part.node, 105);
  EXPECT_EQ(part.time, 2);
  EXPECT_DOUBLE_EQ(part.largest_distance, 4);
  EXPECT_EQ(part.largest, (std::vector<double>{0, 1, 4}));
  EXPECT_EQ(part.mean, (std::vector<double>{0, 1.75 / 4, 7.0 / 4}));
  EXPECT_DOUBLE_EQ(motion.largest_displacement, 8);
  EXPECT_FALSE(compare_motion(a, b, 0.51).parts[0].differs);
}

TEST_F(MotionOfNodes, RoundingOfSinglePrecisionIsNoDistance) {
  const auto tiny = [](std::int64_t, double time) { return 1e-7 * time; };
  const auto a = run("a", {0, 1}, tiny), b = run("b", {0, 1}, still, false, 4), c = run("c", {0, 1}, still);
  EXPECT_EQ(compare_motion(a, b, 1e-3).differ, 0u);
  EXPECT_EQ(compare_motion(a, c, 1e-3).differ, 3u) << "both are in double precision";
}

TEST_F(MotionOfNodes, ARunThatBlowsUp) {
  const auto bad = [](std::int64_t id, double time) {
    return id == 101 && time > 0 ? std::numeric_limits<double>::quiet_NaN() : up(id, time);
  };
  const auto a = run("a", {0, 1}, up), b = run("b", {0, 1}, bad);
  const MotionComparison motion = compare_motion(a, b, 1e-3);
  ASSERT_EQ(motion.times.size(), 2u);
  EXPECT_EQ(motion.differ, 1u);
  EXPECT_TRUE(motion.parts[0].not_numbers);
  EXPECT_EQ(motion.parts[0].part, 7);
}

TEST_F(MotionOfNodes, NothingInCommon) {
  const auto a = run("a", {0, 1}, up), b = run("b", {2, 3}, up);
  EXPECT_TRUE(compare_motion(a, b, 1e-3).times.empty());
  EXPECT_EQ(compare_motion(a, b, 1e-3).differ, 0u);
}

TEST_F(MotionOfNodes, ADatabaseThatCannotBeRead) {
  fs::create_directories(folder_ / "one");
  fs::create_directories(folder_ / "two");
  Diagnostics none;
  EXPECT_FALSE(compare_motion((folder_ / "one").string(), (folder_ / "two").string(), 1e-3, none));
  EXPECT_TRUE(none.sorted().empty()) << "no d3plot is nothing to talk about";
  for (const char* name : {"one", "two"}) std::ofstream(folder_ / name / "d3plot") << "no database";
  Diagnostics said;
  EXPECT_FALSE(compare_motion((folder_ / "one").string(), (folder_ / "two").string(), 1e-3, said));
  ASSERT_EQ(said.sorted().size(), 2u);
  EXPECT_EQ(said.sorted()[0].severity, Severity::warning);
  EXPECT_NE(said.sorted()[0].message.find("motion of nodes is not compared"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::report::compare_motion_test
