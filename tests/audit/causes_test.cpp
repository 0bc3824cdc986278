#include <algorithm>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::causes_test {
namespace {

/// The findings of an audit that stand by themselves.
std::vector<Finding> causes_of(const Report& report) {
  std::vector<Finding> roots;
  std::copy_if(report.findings.begin(), report.findings.end(), std::back_inserter(roots),
               [](const Finding& f) { return f.cause == 0; });
  return roots;
}

Report audited(const std::string& text) { return run_text(text).report; }

const std::string contact = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,2,2\n0.\n1.,1.\n";

TEST(Causes, ElementsAloneAreAPieceOfADeck) {
  std::string text = "*KEYWORD\n*ELEMENT_SHELL\n";
  for (int i = 1; i <= 20; ++i) text += fmt::format("{},1,{},{},{},{}\n", i, i, i + 1, i + 2, i + 3);
  const Report report = audited(text + "*END\n");
  const std::vector<Finding> roots = causes_of(report);
  ASSERT_EQ(roots.size(), 1U);
  EXPECT_EQ(roots[0].id, "GC502");
  EXPECT_EQ(roots[0].severity, Severity::error);
  EXPECT_EQ(roots[0].message,
            "this is a piece of a deck, which defines no nodes and no parts: audit the file that includes it");
  EXPECT_EQ(roots[0].line, 3U) << "the first shell";
  EXPECT_GT(report.findings.size(), 10U);
  for (const Finding& f : report.findings) EXPECT_TRUE(f.key == roots[0].key || f.cause == roots[0].key) << f.message;
}

TEST(Causes, AContactAloneToo) {
  const std::vector<Finding> roots = causes_of(audited("*KEYWORD\n" + contact + "*END\n"));
  ASSERT_EQ(roots.size(), 1U);
  EXPECT_EQ(roots[0].id, "GC502");
  EXPECT_EQ(roots[0].contact, 0);
}

TEST(Causes, ATemplateWithoutNumbersOfSetsToo) {
  const Report report = audited("*KEYWORD\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n\n0.\n1.,1.\n*END\n");
  const std::vector<Finding> roots = causes_of(report);
  ASSERT_EQ(roots.size(), 1U);
  EXPECT_EQ(roots[0].id, "GC503");
  EXPECT_EQ(report.findings.size(), 3U) << "both sides are empty";
}

TEST(Causes, NodesWithoutPartsToo) {
  const std::string mesh = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n*ELEMENT_SHELL\n1,7,1,2,3,3\n";
  const std::vector<Finding> roots = causes_of(audited("*KEYWORD\n" + mesh + "*END\n"));
  ASSERT_EQ(roots.size(), 1U);
  EXPECT_EQ(roots[0].message, "this is a piece of a deck, which defines no parts: audit the file that includes it");
}

TEST(Causes, AWholeDeckHasItsMistakesOneByOne) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.contact(2, "AUTOMATIC_SINGLE_SURFACE", "9,0,3,0").contact(3, "AUTOMATIC_SINGLE_SURFACE", "8,0,3,0");
  const Report report = audited(deck.text());
  const auto unknown = std::count_if(report.findings.begin(), report.findings.end(),
                                     [](const Finding& f) { return f.id == "GC502" && f.cause == 0; });
  EXPECT_EQ(unknown, 2);
}

TEST(Causes, AMissingIncludeComesFirst) {
  const Report report = audited("*KEYWORD\n*INCLUDE\nno_such_file.k\n" + contact + "*END\n");
  const std::vector<Finding> roots = causes_of(report);
  ASSERT_EQ(roots.size(), 1U);
  EXPECT_EQ(roots[0].id, "GC901");
}

}  // namespace
}  // namespace gapcheck::audit_test::causes_test
