// matsum as arrays: rows are times, columns parts.
#include "api/part_history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <gapcheck/read_run.hpp>
#include <gapcheck/run.hpp>
#include <string>

#include "api/new_folder.hpp"

namespace gapcheck::api_test::part_history_test {
namespace {

results::PartState state(std::int64_t part, double internal) {
  results::PartState made;
  made.part = part;
  made.internal = internal;
  made.momentum = {internal, 0, -internal};
  return made;
}

TEST(ApiPartHistory, RowsAreTimesAndColumnsParts) {
  results::PartHistory history;
  history.titles = {{7, "seven"}, {9, "not there"}};
  history.states = {{0, {state(3, 1), state(7, 2)}}, {1, {state(7, 4), state(3, 3)}}, {2, {state(7, 6)}}};
  const auto arrays = api::part_arrays(history);
  ASSERT_TRUE(arrays.has_value());
  EXPECT_EQ(arrays->part, (std::vector<std::int64_t>{3, 7}));
  EXPECT_EQ(arrays->title, (std::vector<std::string>{"", "seven"}));
  EXPECT_EQ(arrays->times, (std::vector{0.0, 1.0, 2.0}));
  ASSERT_EQ(arrays->internal.size(), 6u);
  EXPECT_EQ(std::vector(arrays->internal.begin(), arrays->internal.begin() + 4), (std::vector{1.0, 2.0, 3.0, 4.0}));
  EXPECT_TRUE(std::isnan(arrays->internal[4])) << "part 3 has no third state";
  EXPECT_EQ(arrays->internal[5], 6);
  ASSERT_EQ(arrays->momentum.size(), 18u);
  EXPECT_EQ(arrays->momentum[3 * 3 + 2], -4) << "z of part 7 at the second time";
  EXPECT_FALSE(api::part_arrays({}).has_value());
}

TEST(ApiPartHistory, ARestartTakesThePlaceOfWhatItRepeats) {
  results::PartHistory history;
  history.states = {
      {0, {state(1, 1)}}, {1, {state(1, 2)}}, {2, {state(1, 3)}}, {1, {state(1, 20)}}, {3, {state(1, 30)}}};
  const auto arrays = api::part_arrays(history);
  ASSERT_TRUE(arrays.has_value());
  EXPECT_EQ(arrays->times, (std::vector{0.0, 1.0, 3.0}));
  EXPECT_EQ(arrays->internal, (std::vector{1.0, 20.0, 30.0}));
}

TEST(ApiPartHistory, TextAndBinoutSayTheSame) {
  const NewFolder folder;
  const std::string deck =
      folder.file("deck.k", content(data("workshop/rebound_reference.k")).insert(9, "*DATABASE_MATSUM\n0.01\n"));
  const std::string out = folder / "out";
  api::RunOptions options;
  options.binout = true;
  options.until = 0.05;
  const auto run = api::run_deck(deck, out, options);
  ASSERT_TRUE(run.ok()) << run.error().message;
  const auto as_text = api::read_run({out});
  ASSERT_TRUE(as_text.ok() && as_text.value().parts.has_value());
  ASSERT_TRUE(std::filesystem::remove(out + "/matsum"));
  const auto as_binout = api::read_run({out});
  ASSERT_TRUE(as_binout.ok() && as_binout.value().parts.has_value());
  const api::PartHistory &text = *as_text.value().parts, &binout = *as_binout.value().parts;
  EXPECT_EQ(text.part, binout.part);
  ASSERT_EQ(text.times.size(), binout.times.size());
  EXPECT_GT(text.times.size(), 3u);
  double largest = 0;
  for (const auto member : {&api::PartHistory::times, &api::PartHistory::internal, &api::PartHistory::kinetic,
                            &api::PartHistory::hourglass, &api::PartHistory::momentum, &api::PartHistory::velocity}) {
    ASSERT_EQ((text.*member).size(), (binout.*member).size());
    for (std::size_t i = 0; i < (text.*member).size(); ++i) {
      // The text has five digits.
      EXPECT_NEAR((text.*member)[i], (binout.*member)[i], 5.1e-5 * std::abs((binout.*member)[i]));
      if (member == &api::PartHistory::kinetic) largest = std::max(largest, (binout.*member)[i]);
    }
  }
  EXPECT_GT(largest, 0) << "something moves";
}

}  // namespace
}  // namespace gapcheck::api_test::part_history_test
