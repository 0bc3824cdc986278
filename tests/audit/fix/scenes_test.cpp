// The scenes of data/fix: what is left of each, and that nothing else got worse.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "audit/fix/plates.hpp"
#include "audit/fix/run_fix.hpp"
#include "contact/surface/segment_quality.hpp"
#include "geometry/intersect.hpp"

namespace gapcheck::audit_test::scenes_test {
namespace {

const std::string folder = GAPCHECK_ROOT "/data/fix/";

struct Expected {
  double most = 0;                         ///< movement of any node, at most
  std::uint64_t nodes = 0, crossings = 0;  ///< left; where crossings are, at most
  HoldReason reason = HoldReason::none;    ///< of nodes that are left
};

/// By hand: a sheet whose end is r below another has to come up by r and the thickness 1, shared by both.
const std::map<std::string, Expected> scenes{
    {"block_in_block", {0.75}},  // 0.7 deep
    {"block_in_sheet", {1.5}},   // 0.9 deep, half a thickness
    {"bolt", {0.25}},            // 0.1
    {"cables", {0.35}},          // 0.3; most of it by the ends that are nearest
    {"corner", {2.5}},           // 0.9; most of it by one node of the plate, beside the corner
    {"crossed_05", {1.9}},       // 0.9
    {"crossed_15", {2.0}},       // 1.0
    {"crossed_30", {2.0}},       // 1.0
    {"crossed_45", {2.5}},       // 1.5
    {"crossed_60", {2.5}},       // 1.5
    {"crossed_90", {2.5}},       // 1.5
    {"crossed_aside", {2.0}},    // 1.0
    {"crumpled", {2.0}},         // two folds, about 0.5
    {"dome", {2.3}},             // 1.3
    {"fixed_sheets", {0, 18, 8, HoldReason::constrained}},    // nothing may move
    {"foam", {0.45}},                                         // 0.4
    {"gears", {0.45}},                                        // 0.2
    {"ground", {0.35}},                                       // 0.2, and the sheet's 0.1
    {"hooked", {1.1, 4, 14}},                                 // neither sheet is divided
    {"mortar", {0.4}},                                        // 0.4, of one node alone in the middle
    {"one_way", {1.7 * 1.2}},                                 // 0.7
    {"plates", {0.3}},                                        // 0.3
    {"press_fit", {0.3}},                                     // 0.15 and the polygons' sagitta
    {"sandwich", {0.75}},                                     // 0.2 three times
    {"soft_2", {0.3}},                                        // as press_fit
    {"t_joint", {0.45}},                                      // 0.4
    {"three_sheets", {2.7}},                                  // 1.75 below the upper one
    {"through", {1.5, 18, 54}},                               // the tube is 40 deep
    {"welded_stack", {0.3, 15, 0, HoldReason::constrained}},  // the welds hold their nodes
};

/// Shells without a common node whose triangles pass through each other, each against each.
std::size_t crossing_shells(const model::Model& model) {
  const auto& shells = model.mesh.shells.nodes;
  const auto& x = model.mesh.nodes.x;
  geometry::DecisionCounters counters;
  const auto triangles = [&](const auto& n) {
    std::vector<geometry::Triangle> list{{x[n[0].value], x[n[1].value], x[n[2].value]}};
    if (n[2] != n[3]) list.push_back({x[n[0].value], x[n[2].value], x[n[3].value]});
    return list;
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < shells.size(); ++i)
    for (std::size_t j = i + 1; j < shells.size(); ++j) {
      bool shared = false, cross = false;
      for (const NodeIndex a : shells[i])
        for (const NodeIndex b : shells[j]) shared |= a == b;
      if (shared) continue;
      for (const auto& p : triangles(shells[i]))
        for (const auto& q : triangles(shells[j]))
          cross |= geometry::triangles_cross(p, q, geometry::Mode::exact, counters);
      count += cross ? 1 : 0;
    }
  return count;
}

void expect_sound(const model::Model& before, const model::Model& after) {
  const auto& x = after.mesh.nodes.x;
  for (std::size_t i = 0; i < before.mesh.shells.size(); ++i) {
    const auto& n = before.mesh.shells.nodes[i];
    const auto normal = [&](const std::vector<Vector>& at) {
      return Vector((at[n[2].value] - at[n[0].value]).cross(at[n[3].value] - at[n[1].value]));
    };
    ASSERT_GT(normal(before.mesh.nodes.x).dot(normal(x)), 0);
    ASSERT_EQ(contact::segment_quality(n, x).fault, contact::SegmentFault::none);
  }
  for (const auto& n : before.mesh.solids.nodes) ASSERT_GT(contact::solid_quality(n, x).worst_corner, 0);
}

std::string unchanged(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class FixScene : public testing::TestWithParam<std::string> {};

TEST_P(FixScene, IsFreeOrSaysWhyNot) {
  const Expected& expected = scenes.at(GetParam());
  const FixRun run = fix_file(folder + GetParam() + ".k");
  ASSERT_EQ(run.errors, 0u);
  const FixReport& report = run.report();
  const bool parted = expected.crossings == 0;
  EXPECT_LE(report.unfixed.size(), expected.nodes);
  EXPECT_LE(report.crossings_after, expected.crossings);
  EXPECT_EQ(report.crossings_after > 0, !parted);
  if (parted) {
    EXPECT_EQ(report.unfixed.size(), expected.nodes);
  }
  EXPECT_LE(report.largest_move, expected.most);
  EXPECT_EQ(complete(report), expected.nodes == 0 && expected.crossings == 0);
  if (expected.reason != HoldReason::none) {
    for (const UnfixedNode& node : report.unfixed) EXPECT_EQ(node.reason, expected.reason) << node.node;
  }
  std::uint64_t pairs = 0;
  for (const LeftCrossing& c : report.crossings) {
    pairs += c.pairs;
    EXPECT_FALSE(c.why.empty());
  }
  EXPECT_EQ(pairs, report.crossings_after);
  // The written deck, read and judged again.
  const FixReport again = fix_text(run.text).report();
  EXPECT_EQ(penetrating_before(again), penetrating_after(report));
  EXPECT_EQ(again.crossings_before, report.crossings_after);
  const model::Model before = model_of(unchanged(folder + GetParam() + ".k")), after = model_of(run.text);
  expect_sound(before, after);
  if (after.mesh.solids.size() == 0 && after.mesh.shells.size() < 1000 && expected.crossings == 0) {
    EXPECT_EQ(crossing_shells(after), 0u);
    EXPECT_EQ(crossing_shells(before) > 0, report.crossings_before > 0);
  }
}

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const auto& [name, expected] : scenes) list.push_back(name);
  return list;
}
INSTANTIATE_TEST_SUITE_P(All, FixScene, testing::ValuesIn(names()), [](const auto& scene) { return scene.param; });

TEST(FixScenes, EveryDeckIsExpected) {
  std::set<std::string> decks;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) decks.insert(entry.path().stem().string());
  const auto list = names();
  EXPECT_EQ(decks, std::set<std::string>(list.begin(), list.end()));
}

TEST(FixScenes, WithoutUntanglingNodesKeepTheirSides) {
  audit::FixOptions options;
  options.untangle = false;
  const FixReport report = fix_file(folder + "crossed_30.k", options).report();
  EXPECT_EQ(report.crossings_after, report.crossings_before);
  ASSERT_EQ(report.crossings.size(), 1u);
  EXPECT_EQ(report.crossings[0].pairs, 8u);
}

/// As make_fix_scenes.py writes it: ten layers of 49 x 20 shells, 0.42 apart, and shells upright in the folds.
std::string airbag() {
  constexpr int layers = 10, nx = 49, ny = 20, columns = layers * (nx + 1) + 1;
  std::string text = "*KEYWORD\n" + elastic_steel +
                     "*PART\nbag\n         1         1         1\n*SECTION_SHELL\n         1         2\n"
                     "       0.5       0.5       0.5       0.5\n*NODE\n";
  const auto node = [&](int i, int j) { return 1 + j * columns + i; };
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i < columns; ++i) {
      const int layer = i / (nx + 1), at = i % (nx + 1);
      text += fmt::format("{:8}{:16}{:16}{:16.8f}\n", node(i, j), 2.0 * (layer % 2 == 0 ? at : nx - at), 2.0 * j,
                          0.42 * layer);
    }
  text += "*ELEMENT_SHELL\n";
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i + 1 < columns; ++i)
      text += fmt::format("{:8}{:8}{:8}{:8}{:8}{:8}\n", 1 + j * (columns - 1) + i, 1, node(i, j), node(i + 1, j),
                          node(i + 1, j + 1), node(i, j + 1));
  return text + single_surface + "*END\n";
}

TEST(FixScenes, FoldedBag) {
  const FixRun run = fix_text(airbag());
  EXPECT_EQ(run.report().contacts.at(0).before.penetrations, 10500u);
  EXPECT_TRUE(complete(run.report()));
  EXPECT_LE(run.report().largest_move, 0.45);  // five layers on each side, 0.08 each
  EXPECT_EQ(fix_text(run.text).report().contacts.at(0).before.penetrations, 0u);
  expect_sound(model_of(airbag()), model_of(run.text));
}

TEST(FixScenes, SegmentsOfSoft2CrossAsWell) {
  std::string text = unchanged(folder + "crossed_30.k");
  const std::string contact = "         0         0         5\n\n\n";
  ASSERT_NE(text.find(contact), std::string::npos);
  text.replace(text.find(contact), contact.size(), "         0         0         5\n\n\n         2\n");
  const FixRun run = fix_text(text);
  EXPECT_EQ(run.report().crossings_before, 8u);
  EXPECT_EQ(run.report().crossings_after, 0u);
  EXPECT_TRUE(run.report().contacts.at(0).by_segments);
}

TEST(FixScenes, WhatCannotBePartedIsNamed) {
  const FixReport hooked = fix_file(folder + "hooked.k").report();
  ASSERT_EQ(hooked.crossings.size(), 1u);
  EXPECT_FALSE(hooked.crossings[0].why.empty());
  EXPECT_EQ(hooked.crossings[0].part, 1);
  EXPECT_EQ(hooked.crossings[0].other_part, 2);
  const FixReport fixed = fix_file(folder + "fixed_sheets.k").report();
  ASSERT_FALSE(fixed.crossings.empty());
  EXPECT_EQ(fixed.crossings[0].why, words(HoldReason::constrained));
}

}  // namespace
}  // namespace gapcheck::audit_test::scenes_test
