// Runs are read as the command line reads them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <gapcheck/read_run.hpp>
#include <gapcheck/run.hpp>
#include <string>

#include "api/new_folder.hpp"
#include "report/write/writers.hpp"
#include "results/log/solver_log.hpp"

namespace gapcheck::api_test::read_run_test {
namespace {

std::string fixture(const std::string& name) {
  return (std::filesystem::path(GAPCHECK_ROOT) / "tests/apps/fixtures" / name).string();
}

TEST(ApiReadRun, ALogGivesWhatTheRoomsGive) {
  Diagnostics diagnostics;
  const auto internal = results::read_solver_logs({fixture("smp/messag")}, {}, diagnostics);
  const auto result = api::read_run({fixture("smp/messag")});
  ASSERT_TRUE(internal.ok() && result.ok());
  const api::Report& report = result.value();
  EXPECT_EQ(report.source, "messag");
  EXPECT_EQ(report.contacts.size(), 5u);
  ASSERT_EQ(report.penetrations.size(), internal.value().penetrations.size());
  EXPECT_GT(report.penetrations.size(), 0u);
  for (std::size_t i = 0; i < report.penetrations.size(); ++i) {
    EXPECT_EQ(report.penetrations.node[i], internal.value().penetrations[i].node);
    EXPECT_EQ(report.penetrations.depth[i], internal.value().penetrations[i].depth);
  }
  EXPECT_EQ(report.ties.size(), internal.value().tie_failures.size());
  ASSERT_TRUE(report.run.has_value());
  EXPECT_EQ(report.run->version, "smp d R13");
  EXPECT_EQ(report.run->termination, api::SolverRun::Termination::normal);
  EXPECT_EQ(report.run->rigidwalls.size(), 2u);
  EXPECT_EQ(report.run->timesteps.surfaces.size(), 3u);
  EXPECT_EQ(report.run->messages.size(), internal.value().run->messages.size());
}

TEST(ApiReadRun, ADirectoryStandsForItsLogs) {
  const auto directory = api::read_run({fixture("mpp")});
  const auto files = api::read_run({fixture("mpp/mes0000"), fixture("mpp/mes0001")});
  ASSERT_TRUE(directory.ok() && files.ok());
  EXPECT_EQ(directory.value().penetrations.size(), files.value().penetrations.size());
  EXPECT_TRUE(directory.value().run->mpp);
  const auto note = [](const api::Diagnostic& each) { return each.severity == api::Severity::note; };
  EXPECT_TRUE(std::any_of(directory.value().diagnostics.begin(), directory.value().diagnostics.end(), note))
      << "what was not judged";
  EXPECT_TRUE(std::none_of(files.value().diagnostics.begin(), files.value().diagnostics.end(), note));
}

TEST(ApiReadRun, OptionsPick) {
  api::RunReadOptions options;
  options.contacts = {1};
  const auto one = api::read_run({fixture("smp/messag")}, options);
  ASSERT_TRUE(one.ok());
  for (const std::uint32_t contact : one.value().penetrations.contact) EXPECT_EQ(one.value().contacts[contact].id, 1);
  options = {};
  options.ptol = 1e30;
  const auto none = api::read_run({fixture("smp/messag")}, options);
  ASSERT_TRUE(none.ok());
  EXPECT_LT(none.value().penetrations.size(), api::read_run({fixture("smp/messag")}).value().penetrations.size());
}

TEST(ApiReadRun, WhatCannotBeReadIsAnError) {
  const NewFolder folder;
  const auto message = [](const std::vector<std::string>& paths, const api::RunReadOptions& options = {}) {
    const auto report = api::read_run(paths, options);
    return report.ok() ? std::string("accepted") : report.error().message;
  };
  EXPECT_NE(message({}).find("no file is given"), std::string::npos);
  EXPECT_NE(message({folder / "none"}).find("cannot be opened"), std::string::npos);
  EXPECT_NE(message({folder.path()}).find("no messag"), std::string::npos);
  // An empty file is read: the report is not complete and says so.
  const auto empty = api::read_run({folder.file("empty", "")});
  ASSERT_TRUE(empty.ok());
  EXPECT_FALSE(empty.value().complete);
  ASSERT_FALSE(empty.value().diagnostics.empty());
  EXPECT_NE(empty.value().diagnostics.front().message.find("is empty"), std::string::npos);
  api::RunReadOptions options;
  options.select = {"GC101"};
  EXPECT_EQ(message({fixture("smp/messag")}, options), "select: 'GC101' is not a rule on runs");
  options = {};
  options.rtol = -2;
  EXPECT_EQ(message({fixture("smp/messag")}, options), "rtol: -2 is not a number of 0 or more");
  options = {};
  options.d3plot = folder / "d3plot";
  EXPECT_NE(message({fixture("smp/messag")}, options).find("cannot be opened"), std::string::npos);
}

TEST(ApiReadRun, ARunOfOurOwnHasPartsAndCurves) {
  const NewFolder folder;
  api::RunOptions settings;
  settings.cycles = 20;
  const std::string out = folder / "out";
  ASSERT_TRUE(api::run_deck(data("two_plates.k"), out, settings).ok());
  const auto report = api::read_run({out});
  ASSERT_TRUE(report.ok());
  ASSERT_EQ(report.value().penetrations.size(), 18u);
  EXPECT_EQ(report.value().penetrations.part[0], 1) << "from the d3plot";
  const auto curves = api::read_curves(out);
  ASSERT_TRUE(curves.ok());
  EXPECT_TRUE(curves.value().complete);
  const auto found = std::find_if(curves.value().curves.begin(), curves.value().curves.end(),
                                  [](const api::Curve& curve) { return curve.name == "glstat kinetic energy"; });
  ASSERT_NE(found, curves.value().curves.end());
  EXPECT_EQ(found->file, "glstat");
  EXPECT_GT(found->times.size(), 1u);
  EXPECT_EQ(found->times.size(), found->values.size());
  EXPECT_FALSE(api::read_curves(folder / "nowhere").ok());
}

TEST(ApiReadRun, CurvesHaveThoseOfParts) {
  const NewFolder folder;
  api::RunOptions settings;
  settings.until = 0.02;
  const std::string deck =
      folder.file("deck.k", content(data("workshop/rebound_reference.k")).insert(9, "*DATABASE_MATSUM\n0.01\n"));
  ASSERT_TRUE(api::run_deck(deck, folder / "out", settings).ok());
  const auto curves = api::read_curves(folder / "out");
  const auto run = api::read_run({folder / "out"});
  ASSERT_TRUE(curves.ok() && run.ok() && run.value().parts.has_value());
  const api::PartHistory& parts = *run.value().parts;
  const std::string name = "matsum part " + std::to_string(parts.part[0]) + " kinetic energy";
  const auto found = std::find_if(curves.value().curves.begin(), curves.value().curves.end(),
                                  [&](const api::Curve& curve) { return curve.name == name; });
  ASSERT_NE(found, curves.value().curves.end());
  EXPECT_EQ(found->quantity, "energy");
  ASSERT_EQ(found->times, parts.times);
  for (std::size_t t = 0; t < found->values.size(); ++t)
    EXPECT_EQ(found->values[t], parts.kinetic[t * parts.part.size()]);
}

TEST(ApiReadRun, TheCallerMayStopIt) {
  const NewFolder folder;
  std::string log = content(fixture("smp/messag"));
  for (int line = 0; line < 10'000; ++line) log += " a line without a meaning\n";
  const std::string path = folder.file("messag", log);
  api::RunReadOptions options;
  int asked = 0;
  options.watch = [&asked] { return ++asked > 0; };
  ASSERT_TRUE(api::read_run({path}, options).ok());
  EXPECT_GT(asked, 9);
  asked = 0;
  options.watch = [&asked] { return ++asked < 5; };
  const auto stopped = api::read_run({path}, options);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().message, "the reading was stopped");
  EXPECT_EQ(asked, 5);
}

}  // namespace
}  // namespace gapcheck::api_test::read_run_test
