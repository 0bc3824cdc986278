// Several files of one run: ranks, messag and d3hsp, files that are given twice or missing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include "fixtures.hpp"
#include "read.hpp"
#include "results/log/write_messag.hpp"

namespace gapcheck::results::solver_log_files_test {
namespace {

/// Records spread over ranks, with repeats, against a set.
TEST(SolverLogFiles, MergingIsThatOfASet) {
  const Folder folder("merge");
  std::mt19937 random(9);
  std::set<std::tuple<std::int64_t, double, std::int64_t, std::int64_t>> expected;
  std::vector<std::string> paths;
  for (int rank = 0; rank < 4; ++rank) {
    Report report;
    for (std::int64_t id : {5, 3, 9}) report.contacts.emplace_back().id = id;
    for (int i = 0; i < 400; ++i) {
      Penetration p;
      p.contact = static_cast<std::uint32_t>(random() % 3);
      p.node = 1 + static_cast<std::int64_t>(random() % 20);
      p.segment_number = 1 + static_cast<std::uint32_t>(random() % 3);
      p.segment = {1, 2, 3, 4};
      p.depth = 0.25 * static_cast<double>(1 + random() % 3);
      p.contact_distance = 1;
      report.penetrations.push_back(p);
      expected.emplace(report.contacts[p.contact].id, -p.depth, p.node, p.segment_number);
    }
    paths.push_back(folder.write(fmt::format("mes{:04}", rank), write_messag(report)));
  }
  Diagnostics diagnostics;
  const auto result = read_solver_logs(paths, {}, diagnostics);
  ASSERT_TRUE(result);
  std::vector<std::tuple<std::int64_t, double, std::int64_t, std::int64_t>> found;
  for (const Penetration& p : result.value().penetrations)
    found.emplace_back(result.value().contacts[p.contact].id, -p.depth, p.node, p.segment_number);
  EXPECT_EQ(found, std::vector(expected.begin(), expected.end()));
}

/// One rank's file: its own records, some that its neighbour prints as well, a count.
std::string rank_file(int rank) {
  std::string text = " MPP execution with       8 procs\n expanding   memory to 1\n";
  for (int node : {10 * rank, 10 * rank + 1, 10 * (rank + 1)})
    text += fixtures::tie("50136 (XXX+136)", "Tracked node is not constrained since it is\n     too far from segment.",
                          "tracked", 5, node + 1, 3);
  text += fmt::format(" \n       {} initial penetrations were found for interface          2\n", rank);
  text += " \n *** Warning 30131 (INI+131)\n     total number of massless nodes = 69\n \n";
  return text;
}

TEST(SolverLogFiles, EightRanksAreMergedInAnyOrder) {
  const Folder folder("ranks");
  std::vector<std::string> paths;
  for (int rank = 0; rank < 8; ++rank) paths.push_back(folder.write(fmt::format("mes{:04}", rank), rank_file(rank)));
  for (int round = 0; round < 2; ++round) {
    Diagnostics diagnostics;
    const auto result = read_solver_logs(paths, {}, diagnostics);
    ASSERT_TRUE(result);
    const Report& report = result.value();
    EXPECT_FALSE(diagnostics.has_errors());
    EXPECT_EQ(report.tie_failures.size(), 17u);  // 2 of each rank, and the last one's third
    EXPECT_EQ(contact_of(report, 5)->untied, 17u);
    EXPECT_EQ(contact_of(report, 2)->reported_penetrations, 28u);
    ASSERT_EQ(report.run->messages.size(), 1u);
    EXPECT_EQ(report.run->messages[0].count, 1u);
    EXPECT_TRUE(report.run->mpp);
    EXPECT_EQ(report.run->ranks, 8u);
    std::reverse(paths.begin(), paths.end());
  }
}

TEST(SolverLogFiles, MessagAndD3hspOfOneRunCountOnce) {
  const Folder folder("twice");
  const std::string both = fixtures::smp_penetrations +
                           " \n *** Warning 60303 (IMP+303)\n     Using IGAP=1 may result in zero contact forces.\n \n"
                           "       3 initial penetrations were found for interface          2\n";
  const std::string messag = folder.write("messag", both),
                    d3hsp = folder.write("d3hsp", fixtures::d3hsp_contacts + both);
  for (const auto& paths :
       {std::vector{messag}, std::vector{messag, d3hsp}, std::vector{d3hsp, messag}, std::vector{d3hsp}}) {
    Diagnostics diagnostics;
    const auto result = read_solver_logs(paths, {}, diagnostics);
    ASSERT_TRUE(result);
    const Report& report = result.value();
    EXPECT_EQ(contact_ids(report), (std::vector<std::int64_t>{7, 3, 12, 1, 2}));
    EXPECT_EQ(report.penetrations.size(), 2u);
    EXPECT_EQ(contact_of(report, 2)->reported_penetrations, 3u);
    ASSERT_EQ(report.run->messages.size(), 1u);
    EXPECT_EQ(report.run->messages[0].count, 1u);
  }
}

// So does the screen's output, by what it says when the input is read.
TEST(SolverLogFiles, TheScreenRepeatsTheMessag) {
  const Folder folder("screen");
  const std::string both = fixtures::smp_penetrations +
                           "       3 initial penetrations were found for interface          2\n"
                           "       4 initial penetrations were found for interface          5\n";
  const std::string messag = folder.write("messag", " expanding   memory to 1\n" + both),
                    screen = folder.write("run.log", "\n input of data is completed\n" + both);
  for (const auto& paths :
       {std::vector{messag}, std::vector{messag, screen}, std::vector{screen, messag}, std::vector{screen}}) {
    Diagnostics diagnostics;
    const auto result = read_solver_logs(paths, {}, diagnostics);
    ASSERT_TRUE(result);
    EXPECT_EQ(result.value().penetrations.size(), 2U);
    EXPECT_EQ(contact_of(result.value(), 2)->reported_penetrations, 3U);
    EXPECT_EQ(contact_of(result.value(), 5)->reported_penetrations, 4U);
  }
}

// Each rank searches its own segments for a node on their border.
TEST(SolverLogFiles, ANodeThatOneRankDoesNotFindCountsOnce) {
  const Folder folder("border");
  const std::string head = " MPP execution with       2 procs\n expanding   memory to 1\n";
  const auto not_found = [](int node) {
    return fixtures::tie("50135 (XXX+135)", "Tracked node is not constrained since it is\n     not found on a segment.",
                         "tracked", 5, node);
  };
  const std::string far =
      fixtures::tie("50136 (XXX+136)", "Tracked node is not constrained since it is\n     too far from segment.",
                    "tracked", 5, 13, 3);
  const std::vector<std::string> paths{folder.write("mes0000", head + not_found(13) + not_found(14)),
                                       folder.write("mes0001", head + far + not_found(14))};
  Diagnostics diagnostics;
  const auto result = read_solver_logs(paths, {}, diagnostics);
  ASSERT_TRUE(result);
  const Report& report = result.value();
  ASSERT_EQ(report.tie_failures.size(), 2U);
  EXPECT_EQ(report.tie_failures[0].node, 13);
  EXPECT_EQ(report.tie_failures[0].reason, TieReason::too_far);
  EXPECT_EQ(report.tie_failures[1].node, 14);
  EXPECT_EQ(contact_of(report, 5)->untied, 2U);
}

TEST(SolverLogFiles, D3hspBesideGivesTitlesAndNoRecords) {
  const Folder folder("beside");
  const std::string messag = folder.write("messag", " expanding   memory to 1\n");
  folder.write("d3hsp", fixtures::d3hsp_contacts + fixtures::smp_penetrations);
  Diagnostics diagnostics;
  const auto found = read_solver_logs({messag}, {}, diagnostics);
  ASSERT_TRUE(found);
  EXPECT_EQ(contact_ids(found.value()), (std::vector<std::int64_t>{7, 3, 12}));
  EXPECT_TRUE(found.value().penetrations.empty());
  LogOptions options;
  options.d3hsp = folder.write("other", "  Contact summary \n\n        1          44    a 3 Named\n\n ***\n");
  const auto named = read_solver_logs({messag}, options, diagnostics);
  ASSERT_TRUE(named);
  EXPECT_EQ(contact_ids(named.value()), (std::vector<std::int64_t>{44}));
  EXPECT_FALSE(diagnostics.has_errors());
}

TEST(SolverLogFiles, SameFileTwiceIsReadOnce) {
  const Folder folder("same");
  const std::string messag =
      folder.write("messag", "       3 initial penetrations were found for interface          2\n");
  Diagnostics diagnostics;
  const auto result = read_solver_logs({messag, messag}, {}, diagnostics);
  ASSERT_TRUE(result);
  EXPECT_EQ(result.value().contacts.at(0).reported_penetrations, 3u);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.sorted().size(), 1u);
}

TEST(SolverLogFiles, FilesThatCannotBeOpened) {
  const Folder folder("missing");
  Diagnostics diagnostics;
  EXPECT_FALSE(read_solver_logs({folder.file("none")}, {}, diagnostics).ok());
  EXPECT_FALSE(read_solver_logs({}, {}, diagnostics).ok());
  EXPECT_FALSE(diagnostics.has_errors());
  const std::string messag = folder.write("messag", fixtures::smp_penetrations);
  const auto half = read_solver_logs({folder.file("none"), messag}, {}, diagnostics);
  ASSERT_TRUE(half);
  EXPECT_EQ(half.value().penetrations.size(), 2u);
  EXPECT_TRUE(diagnostics.has_errors());
}

// Only a part of a long log is in memory at a time.
TEST(SolverLogFiles, ALongFileIsReadAsItsText) {
  const Folder folder("long");
  Report report;
  report.contacts.emplace_back().id = 5;
  std::string text;
  for (int i = 0; text.size() < 30'000'000; ++i) {
    Penetration p;
    p.node = 1 + i;
    p.segment = {1, 2, 3, 4};
    p.depth = 0.25;
    p.contact_distance = 1;
    report.penetrations.assign(1, p);
    text += write_messag(report);
    if (i % 7 == 0) text += "       9 t 1.0000E-01 dt 1.0E-03 write d3plot file\n" + std::string(3000, ' ') + "\n";
  }
  Diagnostics diagnostics, expected_diagnostics;
  const auto file = read_solver_logs({folder.write("messag", text)}, {}, diagnostics);
  const Report expected = read_solver_log_text(text, "messag", {}, expected_diagnostics);
  ASSERT_TRUE(file);
  ASSERT_EQ(file.value().penetrations.size(), expected.penetrations.size());
  for (std::size_t i = 0; i < expected.penetrations.size(); ++i) {
    EXPECT_EQ(file.value().penetrations[i].node, expected.penetrations[i].node);
    EXPECT_EQ(file.value().penetrations[i].depth, expected.penetrations[i].depth);
    EXPECT_EQ(file.value().penetrations[i].line, expected.penetrations[i].line);
  }
  EXPECT_EQ(diagnostics.sorted().size(), expected_diagnostics.sorted().size());
}

}  // namespace
}  // namespace gapcheck::results::solver_log_files_test
