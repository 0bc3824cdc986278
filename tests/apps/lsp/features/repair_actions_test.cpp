#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "apps/lsp/features_deck.hpp"
#include "lsp/repair_job.hpp"

namespace gapcheck::app::lsp {
namespace {

/// Repairs come with the findings that they are for, each once, as long as the files are as they were.
TEST_F(LspFeatures, RepairActions) {
  DeckRepairs repairs;
  repairs.files = {{"./main.k", {path("main.k"), {}}}, {"./parts.k", {path("parts.k"), {}}}};
  RepairPair& pair = repairs.plan.pairs.emplace_back();
  pair.parts = {3, 1, 2};
  const auto add = [&](RepairKind kind, const char* text, std::vector<RepairLine> lines) {
    Repair& repair = pair.repairs.emplace_back();
    repair.kind = kind;
    repair.text = text;
    repair.lines = std::move(lines);
  };
  add(RepairKind::contact_thickness, "SST = 0.7",
      {{"./main.k", 14, "                              &t+2*&t", "                           0.7"}});
  add(RepairKind::exclude, "no contact",
      {{"./main.k", 18, "*END", "*A\n$  B\n         1         2\n*END"}, {"./parts.k", 1, "*PART", "*PART_CONTACT"}});
  add(RepairKind::sections, "cannot be written", {});
  LineFinding finding{1, Severity::warning, "GC101", "deep", 3};
  finding.repair = audit::RepairTarget{audit::RepairTarget::Kind::penetrations, {3, 1, 2}};
  std::vector<LineFinding> findings{finding, finding, {2, Severity::note, "GC421", "other"}};
  std::string changed;
  const auto offered = [&](std::uint32_t first, std::uint32_t behind) {
    const ChangeableFile changeable = [&](const ReadFile& file, std::span<const FixedLine> lines) {
      EXPECT_FALSE(lines.empty());
      return file.path == changed ? LinesAt{} : LinesAt{uri_of(file.path), file.path == path("main.k")};
    };
    return ask(*parts_,
               [&](const Question& q) { return repair_actions(q, findings, first, behind, repairs, changeable); });
  };
  const json all = offered(0, 5);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0]["title"], "SST = 0.7: 0.7");
  EXPECT_EQ(all[0]["kind"], "quickfix");
  const json edit = {
      {"range", {{"start", {{"line", 13}, {"character", 0}}}, {"end", {{"line", 13}, {"character", 37}}}}},
      {"newText", "                           0.7"}};
  json changes = json::object();
  changes[uri("main.k")].push_back(edit);
  EXPECT_EQ(all[0]["edit"]["changes"], changes);
  EXPECT_EQ(all[1]["title"], "no contact: *A | 1 2 | *PART_CONTACT");
  EXPECT_EQ(all[1]["edit"]["changes"][uri("main.k")][0]["newText"], "*A\n$  B\n         1         2\n*END");
  EXPECT_GT(all[1]["edit"]["changes"][uri("parts.k")][0]["range"]["end"]["character"], 1000) << "not open: to its end";
  EXPECT_TRUE(offered(2, 9).empty());
  EXPECT_TRUE(offered(0, 1).empty());
  changed = path("parts.k");
  ASSERT_EQ(offered(1, 2).size(), 1U);
  EXPECT_EQ(offered(1, 2)[0]["title"], "SST = 0.7: 0.7");
  changed = path("main.k");
  EXPECT_TRUE(offered(1, 2).empty());
}

TEST_F(LspFeatures, LinesChangeOnlyWhereFilesAreAsTheyWere) {
  const auto file = [&](const std::string& name) {
    return ReadFile{path(name), FileBytes::begin(path(name)).value().stamp()};
  };
  const ReadFile main = file("main.k"), parts = file("parts.k");
  const std::vector<FixedLine> line{{17, "*END", ""}}, other{{17, "*ENDE", ""}};
  EXPECT_EQ(workspace_.changeable(main, line).uri, uri("main.k"));
  EXPECT_TRUE(workspace_.changeable(main, line).open);
  EXPECT_EQ(workspace_.changeable(main, other).uri, "") << "another text of the editor";
  main_->changed = true;
  EXPECT_EQ(workspace_.changeable(main, line).uri, "");
  workspace_.close(uri("parts.k"));
  EXPECT_EQ(workspace_.changeable(parts, other).uri, uri("parts.k"));
  EXPECT_FALSE(workspace_.changeable(parts, other).open);
  write("parts.k", "*END\n");
  EXPECT_EQ(workspace_.changeable(parts, other).uri, "");
  EXPECT_EQ(workspace_.changeable({path("gone.k"), {}}, {}).uri, "");
}

}  // namespace
}  // namespace gapcheck::app::lsp
