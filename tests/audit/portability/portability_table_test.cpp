// Each row of portability.txt is about things that exist, and has its source.
#include "audit/portability/portability_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "keyword/layout.hpp"
#include "model/contact/contact_kind.hpp"

namespace gapcheck::audit::portability_table_test {
namespace {

/// The fields of the cards that a comparison looks at.
std::set<std::string, std::less<>> card_fields() {
  std::set<std::string, std::less<>> names;
  const keyword::KeywordLayout* contact = keyword::find_layout("CONTACT");
  if (contact == nullptr) return names;
  for (const keyword::CardLayout& card : contact->cards)
    for (const keyword::Field& field : card.fields) names.insert(field.name);
  return names;
}

/// The walk over the cards of a contact passes at most one card of the type's own.
bool has_one_card_at_most(model::TypeCards cards) {
  using enum model::TypeCards;
  const auto several = {tiebreak, tiebreak_damping, tiebreak_user, tied_weld, draw_bead, draw_bead_initialize};
  return std::find(several.begin(), several.end(), cards) == several.end();
}

TEST(PortabilityTable, EveryRowIsUnderstoodAndHasItsSource) {
  const PortabilityTable& table = portability_table();
  EXPECT_TRUE(table.faults.empty()) << table.faults.front();
  ASSERT_FALSE(table.programs.empty());
  const auto fields = card_fields();
  for (const OtherProgram& program : table.programs) {
    EXPECT_TRUE(program.source.starts_with("https://")) << program.name;
    EXPECT_TRUE(program.option_source.starts_with("https://")) << program.name;
    std::set<std::string_view> kinds;
    for (const ReadKind& row : program.kinds) {
      EXPECT_TRUE(kinds.insert(row.name).second) << row.name << " has two rows";
      EXPECT_TRUE(row.source.starts_with("https://") && row.source.find(' ') == std::string::npos) << row.name;
      const model::ContactKind* kind = model::find_contact_kind(row.name);
      ASSERT_NE(kind, nullptr) << row.name;
      EXPECT_TRUE(has_one_card_at_most(kind->cards)) << row.name;
      for (const std::string_view field : row.fields) EXPECT_TRUE(fields.contains(field)) << row.name << ' ' << field;
      for (const std::string_view field : row.other_meaning)
        EXPECT_NE(std::find(row.fields.begin(), row.fields.end(), field), row.fields.end()) << row.name << ' ' << field;
    }
  }
  for (const auto& [field, value] : table.defaults) EXPECT_TRUE(fields.contains(field) && value != 0) << field;
  for (const auto& [field, name] : table.names) EXPECT_TRUE(fields.contains(field)) << field;
}

TEST(PortabilityTable, WhatIsNotUnderstoodIsKept) {
  for (const char* row :
       {"reads SPOTWELD | surfa | https://x", "option ID | https://x", "program X", "program | y",
        "program X | y\nreads SPOTWELD | surfa", "program X | y\nreads | surfa | z",
        "program X | y\nreads SPOTWELD | | z", "program X | y\noption | z", "default dt", "default dt x", "called sast",
        "called sast SST again", "default dt 1\ndefault dt 2", "something else"})
    EXPECT_EQ(read_portability_table(row).faults.size(), 1U) << row;
  const PortabilityTable table = read_portability_table(
      "# a comment\n\nprogram  A program | its manual\n  option ID MPP | page 3\nreads SPOTWELD TIED_NODES_TO_SURFACE |"
      " fs  sast! | page 4\ndefault dt 1e20\ncalled sast SST");
  EXPECT_TRUE(table.faults.empty()) << table.faults.front();
  ASSERT_EQ(table.programs.size(), 1U);
  const OtherProgram& program = table.programs.front();
  EXPECT_EQ(program.name, "A program");
  EXPECT_EQ(program.source, "its manual");
  EXPECT_EQ(program.options, (std::vector<std::string_view>{"ID", "MPP"}));
  EXPECT_EQ(program.option_source, "page 3");
  ASSERT_NE(program.find("TIED_NODES_TO_SURFACE"), nullptr);
  EXPECT_EQ(program.find("TIED_NODES_TO_SURFACE")->fields, (std::vector<std::string_view>{"fs", "sast"}));
  EXPECT_EQ(program.find("SPOTWELD")->other_meaning, std::vector<std::string_view>{"sast"});
  EXPECT_EQ(program.find("SPOTWELD")->source, "page 4");
  EXPECT_EQ(program.find("SURFACE_TO_SURFACE"), nullptr);
  EXPECT_EQ(table.defaults.at("dt"), 1e20);
  EXPECT_EQ(table.name_of("sast"), "SST");
  EXPECT_EQ(table.name_of("sofscl"), "SOFSCL");
}

}  // namespace
}  // namespace gapcheck::audit::portability_table_test
