// Decks are run as the command line runs them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <gapcheck/run.hpp>
#include <limits>
#include <string>

#include "api/new_folder.hpp"

namespace gapcheck::api_test::run_test {
namespace {

namespace fs = std::filesystem;

TEST(ApiRun, RunsToItsEnd) {
  const NewFolder folder;
  const auto run = api::run_deck(data("two_plates.k"), folder / "out");
  ASSERT_TRUE(run.ok()) << run.error().message;
  EXPECT_EQ(run.value().end, api::RunEnd::time);
  EXPECT_TRUE(run.value().failure.empty());
  EXPECT_GE(run.value().state.time, 0.001);
  EXPECT_EQ(run.value().state.energy_ratio, 1);
  ASSERT_EQ(run.value().state.contacts.size(), 1u);
  EXPECT_EQ(run.value().state.contacts[0].id, 1);
  EXPECT_EQ(run.value().plotted_states, 21u);
  for (const std::string& name : run.value().files) EXPECT_TRUE(fs::exists(folder / ("out/" + name))) << name;
  EXPECT_GE(run.value().files.size(), 5u);
}

TEST(ApiRun, Binout) {
  const NewFolder folder;
  api::RunOptions options;
  options.cycles = 1;
  ASSERT_TRUE(api::run_deck(data("two_plates.k"), folder / "out", options).ok());
  EXPECT_FALSE(fs::exists(folder / "out/binout0000"));
  options.binout = true;
  const auto run = api::run_deck(data("two_plates.k"), folder / "out", options);
  ASSERT_TRUE(run.ok()) << run.error().message;
  EXPECT_TRUE(fs::exists(folder / "out/binout0000"));
  EXPECT_TRUE(fs::exists(folder / "out/glstat"));
  EXPECT_EQ(std::count(run.value().files.begin(), run.value().files.end(), "binout0000"), 1);
}

TEST(ApiRun, ReplacesOnlyItsOwnResults) {
  const NewFolder folder;
  api::RunOptions options;
  options.cycles = 1;
  fs::create_directories(folder / "out");
  fs::copy_file(data("two_plates.k"), folder / "out/glstat");
  const std::string deck = content(folder / "out/glstat");
  const auto foreign = api::run_deck(data("two_plates.k"), folder / "out", options);
  ASSERT_FALSE(foreign.ok());
  EXPECT_NE(foreign.error().message.find("out/glstat is not a result of gapcheck"), std::string::npos);
  options.replace_foreign = true;
  const auto itself = api::run_deck(folder / "out/glstat", folder / "out", options);
  ASSERT_FALSE(itself.ok());
  EXPECT_NE(itself.error().message.find("out/glstat is a file of the deck"), std::string::npos);
  EXPECT_EQ(content(folder / "out/glstat"), deck);
  EXPECT_TRUE(api::run_deck(data("two_plates.k"), folder / "out", options).ok());
  EXPECT_NE(content(folder / "out/glstat"), deck);
  options.replace_foreign = false;
  EXPECT_TRUE(api::run_deck(data("two_plates.k"), folder / "out", options).ok());
}

TEST(ApiRun, IsWatchedAndStopped) {
  const NewFolder folder;
  api::RunOptions options;
  std::vector<std::uint64_t> cycles;
  double kinetic = -1;
  options.watch = [&](const api::RunState& state) {
    cycles.push_back(state.cycle);
    kinetic = state.kinetic;
    EXPECT_EQ(state.contacts.size(), 1u);
    EXPECT_GT(state.step, 0);
    return state.cycle < 5;
  };
  const auto run = api::run_deck(data("workshop/rebound_half.k"), folder / "out", options);
  ASSERT_TRUE(run.ok()) << run.error().message;
  EXPECT_EQ(run.value().end, api::RunEnd::stopped);
  EXPECT_EQ(cycles, (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(run.value().state.cycle, 6u);
  EXPECT_EQ(run.value().state.kinetic, kinetic);
  EXPECT_GT(kinetic, 0);
  EXPECT_NE(content(folder / "out/messag").find("t e r m i n a t i o n"), std::string::npos);
}

TEST(ApiRun, DoesNotDependOnThreads) {
  const NewFolder folder;
  api::RunOptions options;
  options.cycles = 50;
  options.jobs = 1;
  const auto one = api::run_deck(data("workshop/push_shell_shell.k"), folder / "one", options);
  options.jobs = 0;
  const auto all = api::run_deck(data("workshop/push_shell_shell.k"), folder / "all", options);
  ASSERT_TRUE(one.ok() && all.ok());
  EXPECT_EQ(one.value().end, api::RunEnd::cycles);
  EXPECT_EQ(one.value().state.cycle, 50u);
  EXPECT_EQ(one.value().state.total, all.value().state.total);
  EXPECT_EQ(content(folder / "one/glstat"), content(folder / "all/glstat"));
}

TEST(ApiRun, WhatIsNotCalculatedIsAnError) {
  const NewFolder folder;
  std::string text = content(data("two_plates.k"));
  text.insert(text.rfind("*END"), "*CONTROL_ADAPTIVE\n       0.1\n");
  const std::string deck = folder.file("adaptive.k", text);
  const auto refused = api::run_deck(deck, folder / "out");
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().file, deck);
  EXPECT_GT(refused.error().line, 0u);
  EXPECT_NE(refused.error().message.find("is not supported"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "out"));
  api::RunOptions options;
  options.ignore_unsupported = true;
  options.cycles = 2;
  const auto run = api::run_deck(deck, folder / "out", options);
  ASSERT_TRUE(run.ok()) << run.error().message;
  ASSERT_FALSE(run.value().diagnostics.empty());
  EXPECT_NE(run.value().diagnostics[0].message.find("is left out"), std::string::npos);
}

TEST(ApiRun, WhatCannotBeRunIsAnError) {
  const NewFolder folder;
  const auto message = [&](const std::string& deck, const std::string& directory = "out",
                           const api::RunOptions& options = {}) {
    const auto run = api::run_deck(deck, folder / directory, options);
    return run.ok() ? std::string("accepted") : run.error().message;
  };
  EXPECT_NE(message(folder / "none.k").find("cannot be opened"), std::string::npos);
  EXPECT_NE(message(folder.path()).find("is a directory"), std::string::npos);
  EXPECT_NE(message(folder.file("empty.k", "")).find("is empty"), std::string::npos);
  EXPECT_NE(message(folder.file("open.k", "*KEYWORD\n*NODE\n1,0.,0.,0.\n*END\n")).find("ENDTIM"), std::string::npos);
  const std::string taken = folder.file("taken", "");
  EXPECT_NE(message(data("two_plates.k"), "taken").find("cannot be created"), std::string::npos) << taken;
  api::RunOptions options;
  options.until = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message(data("two_plates.k"), "out", options), "until: nan is not a number of 0 or more");
}

}  // namespace
}  // namespace gapcheck::api_test::run_test
