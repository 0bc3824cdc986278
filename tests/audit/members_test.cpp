#include "audit/members.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "keyword/deck.hpp"
#include "run.hpp"

namespace gapcheck::audit::members_test {
namespace {

constexpr const char* data = GAPCHECK_ROOT "/data/";

AuditOptions with_members() {
  AuditOptions options;
  options.members = true;
  return options;
}

std::vector<Finding> of_rule(const Report& report, const std::string& id) {
  std::vector<Finding> list;
  std::copy_if(report.findings.begin(), report.findings.end(), std::back_inserter(list),
               [&](const Finding& f) { return f.id == id; });
  return list;
}

/// A row of `count` unit squares along x, each crossed by an upright one; shells 1, 3, 5 … and 2, 4, 6 …
std::string crossing_squares(int count) {
  std::string text =
      "*KEYWORD\n*PART\nflat\n1,1,1\n*PART\nupright\n2,1,1\n*SECTION_SHELL\n1\n.01,.01,.01,.01\n*MAT_ELASTIC\n"
      "1,1.,1.,0.3\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,0,0\n\n\n";
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  int node = 1;
  for (int i = 0; i < count; ++i) {
    const double x = 2 * i;
    const double flat[4][3] = {{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0}};
    const double upright[4][3] = {{x + .5, .25, -.5}, {x + .5, .75, -.5}, {x + .5, .75, .5}, {x + .5, .25, .5}};
    for (const auto& corners : {flat, upright}) {
      shells += std::to_string((node + 3) / 4) + "," + (corners == flat ? "1" : "2");
      for (int k = 0; k < 4; ++k) {
        nodes += std::to_string(node);
        for (int axis = 0; axis < 3; ++axis) nodes += "," + std::to_string(corners[k][axis]);
        nodes += "\n";
        shells += "," + std::to_string(node++);
      }
      shells += "\n";
    }
  }
  return text + nodes + shells + "*END\n";
}

TEST(Members, BothElementsOfEveryCrossing) {
  const Report report = audit_test::run_text(crossing_squares(30), with_members()).report;
  const auto findings = of_rule(report, "GC103");
  ASSERT_EQ(findings.size(), 11U);
  std::set<std::array<std::int64_t, 4>> segments;
  for (const Finding& finding : findings) {
    EXPECT_EQ(finding.members.segments.size(), 2 * finding.count);
    segments.insert(finding.members.segments.begin(), finding.members.segments.end());
  }
  EXPECT_EQ(segments.size(), 60U) << "the line that counts the rest lists it";
  EXPECT_TRUE(segments.contains({237, 238, 239, 240}));
}

TEST(Members, NothingUnlessAskedFor) {
  const Report report = audit_test::run_text(crossing_squares(30)).report;
  EXPECT_EQ(of_rule(report, "GC103").size(), 11U);
  for (const Finding& finding : report.findings) {
    EXPECT_TRUE(finding.members.nodes.empty());
    EXPECT_TRUE(finding.members.segments.empty());
  }
}

TEST(Members, ChangeNothingElse) {
  std::size_t decks = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data)) {
    if (entry.path().extension() != ".k") continue;
    ++decks;
    EXPECT_EQ(audit_test::dump(audit_test::run_file(entry.path()).report),
              audit_test::dump(audit_test::run_file(entry.path(), with_members()).report));
  }
  EXPECT_GT(decks, 20U);
}

TEST(Members, ElementsThatFindingsName) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(
      "*KEYWORD\n*PART\n\n1,1,1\n*PART\n\n2,1,1\n*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.,0.,1.\n"
      "6,1.,0.,1.\n7,1.,1.,1.\n8,0.,1.,1.\n*ELEMENT_SHELL\n10,1,1,2,3,4\n*ELEMENT_SOLID\n10,2,1,2,3,4,5,6,7,8\n"
      "*ELEMENT_BEAM\n12,1,1,7\n*END\n",
      "deck.k", {}, diagnostics);
  const model::Model model = model::read_model(deck.value(), diagnostics).value();
  std::vector<Finding> findings(5);
  findings[0].element = 10;
  findings[1].element = findings[2].element = 10;
  findings[1].element_part = 1;
  findings[2].element_part = 2;
  findings[3].element = 12;
  findings[4].element = 99;
  add_named_elements(model, findings);
  using Segment = std::array<std::int64_t, 4>;
  EXPECT_EQ(findings[0].members.segments.size(), 7U) << "which of the two is not said";
  EXPECT_EQ(findings[1].members.segments, (std::vector<Segment>{{1, 2, 3, 4}}));
  EXPECT_EQ(findings[2].members.segments.size(), 6U);
  EXPECT_EQ(findings[3].members.segments, (std::vector<Segment>{{1, 7, 7, 7}}));
  EXPECT_TRUE(findings[4].members.segments.empty());
}

}  // namespace
}  // namespace gapcheck::audit::members_test
