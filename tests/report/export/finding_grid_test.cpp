#include "report/export/finding_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/sample.hpp"

namespace gapcheck::report::finding_grid_test {
namespace {

std::optional<Vector> nowhere(std::int64_t) { return std::nullopt; }

const std::vector<double>& numbers(const std::vector<VtuArray>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const VtuArray& a) { return a.name == name; });
  EXPECT_NE(found, list.end()) << name;
  return found->values;
}

const std::vector<std::int64_t>& ids(const std::vector<VtuIds>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const VtuIds& a) { return a.name == name; });
  EXPECT_NE(found, list.end()) << name;
  return found->values;
}

/// Two shells, 500 of part 2 and 500 of part 3, with six nodes; node 14 is one of them.
ElementMesh two_shells() {
  ElementMesh mesh;
  mesh.node_ids = {22124, 22164, 22165, 22125, 14, 99};
  mesh.x = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {10, 20, 0.1}, {2, 0, 0}};
  mesh.corners = {0, 1, 2, 3, 1, 5, 2, 2};
  mesh.ends = {4, 8};
  mesh.element_ids = {500, 500};
  mesh.part_ids = {2, 3};
  mesh.contact_ids = {7, 0};
  mesh.thickness = {1.5, 0};
  return mesh;
}

std::size_t point_of(const VtuGrid& grid, std::int64_t node) {
  const auto& nodes = ids(grid.point_ids, "node");
  return static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
}

TEST(FindingGrid, RecordsAtNodesAndElements) {
  Report report = sample_report();
  report.mesh = two_shells();
  const VtuGrid grid = finding_grid(report, nowhere);
  ASSERT_EQ(grid.points.size(), 8U) << "nodes 15 and 16 are in no element";
  EXPECT_EQ(grid.types, (std::vector<VtuCell>{VtuCell::quad, VtuCell::triangle, VtuCell::vertex, VtuCell::vertex}));
  EXPECT_EQ(ids(grid.cell_ids, "part"), (std::vector<std::int64_t>{2, 3, 1, 0}));
  EXPECT_EQ(ids(grid.cell_ids, "contact"), (std::vector<std::int64_t>{7, 0, 0, 0}));
  EXPECT_EQ(ids(grid.cell_ids, "rule"), (std::vector<std::int64_t>{102, 0, 0, 0}))
      << "the other 500 is of another part";
  EXPECT_EQ(numbers(grid.cell_data, "depth"), (std::vector<double>{0.9, 0, 0, 0}));
  EXPECT_EQ(numbers(grid.cell_data, "thickness"), (std::vector<double>{1.5, 0, 0, 0}));
  const std::size_t deep = point_of(grid, 14), moved = point_of(grid, 16), other = point_of(grid, 99);
  EXPECT_EQ(numbers(grid.point_data, "depth")[deep], 0.9);
  EXPECT_NEAR(numbers(grid.point_data, "remaining")[deep], 0.1, 1e-12);
  EXPECT_TRUE(std::isnan(numbers(grid.point_data, "remaining")[other]));
  EXPECT_EQ(ids(grid.point_ids, "contact")[deep], 7);
  EXPECT_EQ(ids(grid.point_ids, "outcome")[deep], 1 + static_cast<int>(Outcome::released));
  EXPECT_EQ(ids(grid.point_ids, "rule")[deep], 102);
  EXPECT_EQ(ids(grid.point_ids, "rule")[moved], 101);
  EXPECT_NEAR(numbers(grid.point_data, "way_out")[3 * deep + 2], 0.9, 1e-12);
  EXPECT_NEAR(numbers(grid.point_data, "way_out")[3 * moved + 2], 0.3, 1e-12);
  EXPECT_EQ(ids(grid.point_ids, "outcome")[other], 0);
}

TEST(FindingGrid, WhereNodesGo) {
  Report report = sample_report();
  report.mesh = two_shells();
  const auto names = [](const VtuGrid& grid) {
    return std::count_if(grid.point_data.begin(), grid.point_data.end(),
                         [](const VtuArray& a) { return a.name == "move"; });
  };
  EXPECT_EQ(names(finding_grid(report, nowhere)), 0) << "nothing moves";
  report.moves = {{14, Vector(10, 20.5, 0.1)}, {22164, Vector(1, 0, -2)}, {30000, Vector(1, 1, 1)}};
  const VtuGrid grid = finding_grid(report, nowhere);
  const std::vector<double>& move = numbers(grid.point_data, "move");
  ASSERT_EQ(move.size(), 3 * grid.points.size());
  const std::size_t a = point_of(grid, 14), b = point_of(grid, 22164), still = point_of(grid, 99);
  EXPECT_EQ(std::vector(move.begin() + 3 * a, move.begin() + 3 * a + 3), (std::vector<double>{0, 0.5, 0}));
  EXPECT_EQ(std::vector(move.begin() + 3 * b, move.begin() + 3 * b + 3), (std::vector<double>{0, 0, -2}));
  EXPECT_EQ(std::vector(move.begin() + 3 * still, move.begin() + 3 * still + 3), (std::vector<double>{0, 0, 0}));
}

TEST(FindingGrid, TheDeepestOfANode) {
  Report report = sample_report();
  for (Penetration& record : report.penetrations) record.node = 14;
  report.penetrations[1].depth = 0.95;
  report.penetrations[1].contact = 1;
  const VtuGrid grid = finding_grid(report, nowhere);
  ASSERT_EQ(grid.points.size(), 1U);
  EXPECT_EQ(numbers(grid.point_data, "depth")[0], 0.95);
  EXPECT_EQ(ids(grid.point_ids, "contact")[0], 2);
  EXPECT_EQ(ids(grid.point_ids, "rule")[0], 102) << "the rule that comes first";
}

TEST(FindingGrid, TiesAndFindings) {
  Report report = sample_report();
  report.penetrations.clear();
  report.mesh = two_shells();
  report.tie_failures.push_back({.contact = 1, .node = 22164, .reason = TieReason::not_found});
  report.tie_failures.push_back(
      {.contact = 1, .node = 777, .part = 9, .reason = TieReason::sep, .position = Vector(1, 2, 3)});
  report.tie_failures.push_back({.contact = 1, .node = 778});
  Finding crossed = make_finding("GC103", "crossed-elements", "");
  crossed.element = 500;
  crossed.element_part = 3;
  report.findings.push_back(crossed);
  Finding node = make_finding("GC507", "duplicate-nodes", "");
  node.node = 99;
  report.findings.push_back(node);
  const VtuGrid grid = finding_grid(report, nowhere);
  EXPECT_EQ(ids(grid.point_ids, "outcome")[point_of(grid, 22164)], 11 + static_cast<int>(TieReason::not_found));
  EXPECT_EQ(ids(grid.point_ids, "rule")[point_of(grid, 777)], 204) << "sep: moved";
  EXPECT_EQ(ids(grid.point_ids, "rule")[point_of(grid, 99)], 507);
  EXPECT_EQ(ids(grid.cell_ids, "rule"), (std::vector<std::int64_t>{0, 103, 0}));
  ASSERT_EQ(grid.words.size(), 3U);
  EXPECT_EQ(grid.words[2].values, (std::vector<std::string>{"1 findings at nodes: their position is not known"}));
  EXPECT_EQ(grid.words[1].values[11 - 5], "11 sep");
}

TEST(FindingGrid, NothingAtAll) {
  const VtuGrid grid = finding_grid({}, nowhere);
  EXPECT_TRUE(grid.points.empty());
  EXPECT_TRUE(grid.types.empty());
  EXPECT_FALSE(vtu(grid).empty());
}

TEST(FindingGrid, WhatIsNoNumberIsNoDepth) {
  Report report = sample_report();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  report.penetrations[0].depth = nan;
  report.penetrations[0].contact = 99;
  report.penetrations[1].original = {nan, 0, 0};
  report.penetrations[2].depth = std::numeric_limits<double>::infinity();
  report.penetrations[2].segment = {std::numeric_limits<std::int64_t>::min(), 0, -1, 5};
  const VtuGrid grid = finding_grid(report, nullptr);
  ASSERT_EQ(grid.points.size(), 2U);
  EXPECT_EQ(numbers(grid.point_data, "depth"), (std::vector<double>{0, 0}));
  EXPECT_EQ(ids(grid.point_ids, "contact"), (std::vector<std::int64_t>{0, 7}));
}

TEST(FindingGrid, ArraysAreAsLongAsTheGrid) {
  for (unsigned seed = 1; seed < 5; ++seed) {
    Report report = random_report(300, 3, seed);
    report.mesh = two_shells();
    const VtuGrid grid = finding_grid(report, nowhere);
    EXPECT_GT(grid.points.size(), 4U);
    EXPECT_FALSE(grid.point_data.empty() || grid.point_ids.empty() || grid.cell_data.empty() || grid.cell_ids.empty());
    for (const VtuArray& array : grid.point_data) EXPECT_EQ(array.values.size(), array.components * grid.points.size());
    for (const VtuIds& array : grid.point_ids) EXPECT_EQ(array.values.size(), grid.points.size());
    for (const VtuArray& array : grid.cell_data) EXPECT_EQ(array.values.size(), grid.types.size());
    for (const VtuIds& array : grid.cell_ids) EXPECT_EQ(array.values.size(), grid.types.size());
  }
}

}  // namespace
}  // namespace gapcheck::report::finding_grid_test
