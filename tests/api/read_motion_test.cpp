// The states of a d3plot as arrays: those of the rooms, and of a motion that is known.
#include <gtest/gtest.h>

#include <gapcheck/read_motion.hpp>
#include <gapcheck/run.hpp>
#include <string>

#include "api/new_folder.hpp"
#include "results/d3plot/d3plot_states.hpp"

namespace gapcheck::api_test::read_motion_test {
namespace {

TEST(ApiReadMotion, StatesAreThoseOfTheRooms) {
  const NewFolder folder;
  ASSERT_TRUE(api::run_deck(data("two_plates.k"), folder.path()).ok());
  const auto expected = results::D3plotStates::open(folder / "d3plot");
  ASSERT_TRUE(expected.ok());
  ASSERT_GT(expected.value().size(), 1u);
  for (const std::string& path : {folder.path(), folder / "d3plot"}) {
    const auto motion = api::read_motion(path);
    ASSERT_TRUE(motion.ok()) << motion.error().message;
    EXPECT_EQ(motion.value().node, expected.value().mesh().node_ids);
    EXPECT_EQ(motion.value().times, expected.value().times());
    const std::size_t n = motion.value().node.size();
    ASSERT_EQ(n, 32u);
    ASSERT_EQ(motion.value().start.size(), 3 * n);
    ASSERT_EQ(motion.value().positions.size(), 3 * n * expected.value().size());
    ASSERT_EQ(motion.value().velocities.size(), motion.value().positions.size());
    for (std::size_t t = 0; t < expected.value().size(); ++t) {
      const results::D3plotState state = expected.value().read(t);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_EQ(motion.value().positions[(t * n + i) * 3 + k], state.coordinates[i][k]);
          EXPECT_EQ(motion.value().velocities[(t * n + i) * 3 + k], state.velocities[i][k]);
        }
    }
    EXPECT_EQ(motion.value().start[3 * 5], 5) << "node 1006";
  }
}

TEST(ApiReadMotion, ChosenStates) {
  const NewFolder folder;
  ASSERT_TRUE(api::run_deck(data("two_plates.k"), folder.path()).ok());
  const auto all = api::read_motion(folder.path());
  ASSERT_TRUE(all.ok());
  const std::size_t last = all.value().times.size() - 1, row = 3 * all.value().node.size();
  const auto some = api::read_motion(folder.path(), {.states = {last, 0}, .velocities = false});
  ASSERT_TRUE(some.ok());
  EXPECT_EQ(some.value().times, (std::vector<double>{all.value().times[last], all.value().times[0]}));
  ASSERT_EQ(some.value().positions.size(), 2 * row);
  EXPECT_TRUE(some.value().velocities.empty());
  for (std::size_t i = 0; i < row; ++i) {
    EXPECT_EQ(some.value().positions[i], all.value().positions[last * row + i]);
    EXPECT_EQ(some.value().positions[row + i], all.value().positions[i]);
  }
  const auto none = api::read_motion(folder.path(), {.states = {0, last + 1}});
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.error().message.find("states: there is no state"), std::string::npos) << none.error().message;
}

TEST(ApiReadMotion, WhatIsNoPlotIsAnError) {
  const NewFolder folder;
  for (const std::string& path :
       {folder / "none", folder.path(), folder.file("empty", ""), folder.file("text", "*KEYWORD\n*END\n"),
        folder.file("zeros", std::string(10000, '\0')), data("two_plates.k")}) {
    const auto motion = api::read_motion(path);
    ASSERT_FALSE(motion.ok()) << path;
    EXPECT_FALSE(motion.error().message.empty());
    EXPECT_TRUE(motion.error().file.starts_with(path)) << motion.error().file;
  }
}

}  // namespace
}  // namespace gapcheck::api_test::read_motion_test
