// What the table of contact kinds says, against what the rules make of it and what the manual prints.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "contact/definition/contact_type.hpp"
#include "model/contact/contact_cards.hpp"

namespace gapcheck::contact::contact_kinds_test {
namespace {

using model::ContactKind;

ContactType type_of(const ContactKind& kind) {
  model::Contact contact;
  set_name("CONTACT_" + std::string(kind.name), contact);
  return classify(contact);
}

std::string search_words(Treatment treatment) {
  switch (treatment) {
    case Treatment::one_way:
      return "one-way";
    case Treatment::two_way:
      return "two-way";
    case Treatment::single_surface:
      return "single surface";
    case Treatment::none:
      return "";
  }
  return "?";
}

std::string surface_words(const ContactType& type) {
  if (type.family == Family::old || type.family == Family::forming) return "oriented";
  return type.family == Family::automatic || type.family == Family::constraint ? "two-sided" : "";
}

std::string audit_words(const ContactKind& kind, const ContactType& type) {
  if (type.only_edges()) return "edges alone (GC109)";
  if (type.pairing == Pairing::nodes) return type.edges ? "nodes in segments, edges (GC109)" : "nodes in segments";
  if (type.family == Family::tied) return "ties";
  return kind.can(Ability::interference) ? "no: the overlap is meant" : "no";
}

std::string run_words(const ContactKind& kind) {
  switch (kind.method) {
    case model::RunMethod::none:
      return "no";
    case model::RunMethod::penalty:
      return "penalty";
    case model::RunMethod::constraint:
      return "constraint";
    case model::RunMethod::tie:
      return "tie";
    case model::RunMethod::tiebreak:
      return kind.code == ContactCode::general ? "no" : "tie, then penalty";
    case model::RunMethod::transducer:
      return "measures";
  }
  return "?";
}

/// The table of docs/contact.md: a row for all keywords of a code that are treated alike.
std::string table() {
  std::vector<std::string> order;
  std::vector<std::pair<std::string, std::string>> rows;  // what is equal, the keywords
  for (const ContactKind& kind : model::contact_kinds()) {
    const ContactType type = type_of(kind);
    const std::string equal = search_words(type.treatment) + " | " + surface_words(type) + " | " +
                              audit_words(kind, type) + " | " + run_words(kind);
    const std::string code = "| " + type.printed() + " | ";
    auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return one.first == code + "@" + equal; });
    if (row == rows.end()) row = rows.insert(rows.end(), {code + "@" + equal, ""});
    row->second += (row->second.empty() ? "" : ", ") + std::string(kind.name);
  }
  std::string text =
      "| code | keyword (after `*CONTACT_`) | search | surfaces | audit | run |\n|---|---|---|---|---|---|\n";
  for (const auto& [equal, keywords] : rows) {
    const std::size_t cut = equal.find('@');
    text += equal.substr(0, cut) + keywords + " | " + equal.substr(cut + 1) + " |\n";
  }
  return text;
}

TEST(ContactKinds, TheManualPrintsThem) {
  std::ifstream file(std::string(GAPCHECK_ROOT) + "/docs/contact.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::string begin = "<!-- kinds: begin -->\n", end = "<!-- kinds: end -->";
  const std::size_t first = page.find(begin), last = page.find(end);
  ASSERT_NE(first, std::string::npos);
  ASSERT_LT(first, last);
  EXPECT_EQ(page.substr(first + begin.size(), last - first - begin.size()), table());
}

TEST(ContactKinds, NamesAreThereOnceAndSurviveParsing) {
  std::set<std::string_view> names;
  for (const ContactKind& kind : model::contact_kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_EQ(model::parse_contact_name("CONTACT_" + std::string(kind.name) + "_MPP_ID").kind, &kind) << kind.name;
  }
  EXPECT_GE(names.size(), 80U);
}

TEST(ContactKinds, EachSaysWhatTheRunDoes) {
  for (const ContactKind& kind : model::contact_kinds()) {
    EXPECT_EQ(kind.method == model::RunMethod::none, !kind.not_run.empty()) << kind.name;
    if (kind.method == model::RunMethod::tie || kind.method == model::RunMethod::tiebreak) {
      EXPECT_TRUE(kind.ties()) << kind.name;
    }
    // What it is after its ties have failed is a kind that keeps surfaces apart.
    if (kind.after_tie.empty()) continue;
    const ContactKind* after = model::find_contact_kind(kind.after_tie);
    ASSERT_NE(after, nullptr) << kind.name;
    EXPECT_EQ(after->method, model::RunMethod::penalty) << kind.name;
    EXPECT_FALSE(after->ties()) << kind.name;
  }
}

TEST(ContactKinds, PrintedCodesLeadBackToTheirKeyword) {
  for (const ContactKind& kind : model::contact_kinds()) {
    const std::string code = model::printed(kind.code, kind.offset), keyword = model::keyword_of_printed(code);
    ASSERT_FALSE(keyword.empty()) << code;
    const ContactKind* common = model::find_contact_kind(keyword);
    if (kind.automatic_tiebreak()) continue;  // they print the code of types 8 and 9
    ASSERT_NE(common, nullptr) << code << ' ' << keyword;
    EXPECT_EQ(model::printed(common->code, common->offset), code) << keyword;
  }
  EXPECT_EQ(model::keyword_of_printed("a3"), "AUTOMATIC_SURFACE_TO_SURFACE");
  EXPECT_EQ(model::keyword_of_printed("o6"), "TIED_NODES_TO_SURFACE_OFFSET");
  EXPECT_EQ(model::keyword_of_printed("*"), "MORTAR");
  for (const char* unknown : {"", "?", "99", "x3", "a", "o"})
    EXPECT_EQ(model::keyword_of_printed(unknown), "") << unknown;
}

/// Types with a card of their own as the manual lists them (contact rules, section 11; *CONTACT, card 4).
TEST(ContactKinds, MandatoryFourthCards) {
  for (const ContactKind& kind : model::contact_kinds()) {
    const auto has = [&](std::string_view word) { return kind.name.find(word) != std::string_view::npos; };
    const bool fourth = has("ERODING") || has("INTERFERENCE") || has("TIEBREAK") || has("DRAWBEAD") ||
                        has("CONSTRAINT_") || has("RIGID_") || has("COMPOSITE") || has("LUBRICATION") ||
                        has("CONTRACTION_JOINT") || has("TIED_WELD") || kind.name == "AUTOMATIC_SINGLE_SURFACE_TIED";
    EXPECT_EQ(model::type_card(kind.cards) != nullptr, fourth) << kind.name;
  }
}

}  // namespace
}  // namespace gapcheck::contact::contact_kinds_test
