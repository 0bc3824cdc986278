#include "keyword/parameters.hpp"

#include <cmath>
#include <random>

#include "support.hpp"

namespace gapcheck::keyword::parameters_test {
namespace {

double number(const ParameterValue* value) {
  if (value == nullptr) return std::nan("");
  if (const auto* integer = std::get_if<std::int64_t>(value)) return static_cast<double>(*integer);
  return std::get<double>(*value);
}

TEST(Parameters, AreVisibleFromTheirDefinitionOn) {
  Parameters parameters;
  parameters.define("thk", 1.5, Parameters::global, 3);
  parameters.define("THK", 2.5, Parameters::global, 7);
  EXPECT_EQ(parameters.find("thk", 0, 3), nullptr);
  EXPECT_EQ(number(parameters.find("Thk", 0, 4)), 1.5);
  EXPECT_EQ(number(parameters.find("thk", 0, 7)), 1.5);
  EXPECT_EQ(number(parameters.find("thk", 0, 8)), 2.5);
  EXPECT_EQ(parameters.find("other", 0, 8), nullptr);
}

TEST(Parameters, InnermostScopeFirst) {
  Parameters parameters;
  const auto main = parameters.add_scope(Parameters::global);
  const auto inner = parameters.add_scope(main), sibling = parameters.add_scope(main);
  parameters.define("a", 1.0, Parameters::global, 0);
  parameters.define("a", 2.0, inner, 1);
  parameters.define("a", 3.0, Parameters::global, 2);
  EXPECT_EQ(number(parameters.find("a", inner, 9)), 2);
  EXPECT_EQ(number(parameters.find("a", sibling, 9)), 3);
  EXPECT_EQ(number(parameters.find("a", main, 2)), 1);
}

/// The same against a plain list of all definitions.
TEST(Parameters, AgreeWithAPlainList) {
  std::mt19937 random(7);
  struct Entry {
    std::string name;
    std::uint32_t scope, order;
    double value;
  };
  for (int round = 0; round < 50; ++round) {
    Parameters parameters;
    std::vector<std::uint32_t> parents{0};
    for (int i = 0; i < 6; ++i) {
      const auto parent = static_cast<std::uint32_t>(random() % parents.size());
      parents.push_back(parent);
      EXPECT_EQ(parameters.add_scope(parent), parents.size() - 1);
    }
    std::vector<Entry> entries;
    for (std::uint32_t order = 0; order < 40; ++order) {
      entries.push_back({std::string(1, static_cast<char>('a' + random() % 3)),
                         static_cast<std::uint32_t>(random() % parents.size()), order, 0.5 * order});
      parameters.define(entries.back().name, entries.back().value, entries.back().scope, order);
    }
    for (int query = 0; query < 100; ++query) {
      const std::string name(1, static_cast<char>('a' + random() % 4));
      const auto scope = static_cast<std::uint32_t>(random() % parents.size());
      const auto order = static_cast<std::uint32_t>(random() % 41);
      const Entry* expected = nullptr;
      for (auto s = scope;; s = parents[s]) {
        for (const Entry& entry : entries)
          if (entry.name == name && entry.scope == s && entry.order < order) expected = &entry;
        if (expected != nullptr || s == 0) break;
      }
      const auto* found = parameters.find(name, scope, order);
      ASSERT_EQ(found != nullptr, expected != nullptr);
      if (found != nullptr) {
        EXPECT_EQ(std::get<double>(*found), expected->value);
      }
    }
  }
}

TEST(Parameters, ReadFromDecks) {
  TextDeck deck("*KEYWORD\n*PARAMETER\n$ comment\n" + pair("Rthk", "1.5") + pair("I   n", "7") + "\n" +
                pair("r fac", "1.5-3") + pair("c  text", "hello") +
                "\n*PARAMETER\nR free, 2.5, I j, 3\n"
                "*PARAMETER_EXPRESSION\nR twice   2*thk\nI m       n*3-&j\nR later   twice + sqrt(16)\n*END\n");
  const auto& parameters = deck.deck.parameters();
  const auto value = [&](const char* name) { return number(parameters.find(name, 0, 100)); };
  EXPECT_EQ(value("thk"), 1.5);
  EXPECT_EQ(value("N"), 7);
  EXPECT_EQ(value("fac"), 1.5e-3);
  EXPECT_EQ(value("free"), 2.5);
  EXPECT_EQ(value("twice"), 3);
  EXPECT_EQ(value("m"), 18);
  EXPECT_EQ(value("later"), 7);
  EXPECT_EQ(std::get<std::string>(*parameters.find("text", 0, 100)), "hello");
  EXPECT_EQ(reports(deck.diagnostics), "");
}

/// The value of `t` behind these lines, and what is reported.
std::pair<double, std::string> value_behind(const std::string& lines) {
  TextDeck deck("*KEYWORD\n" + lines + "*NODE\n*END\n");
  const auto* value = deck.deck.parameters().find("t", 0, 1000);
  return {value == nullptr ? -1 : number(value), reports(deck.diagnostics)};
}

TEST(Parameters, LinesWithoutANameContinueAnExpression) {
  const std::string blank(10, ' '), head = "*PARAMETER_EXPRESSION\nR t       ";
  EXPECT_EQ(value_behind(head + "1.0\n" + blank + "+1.0\n"), std::pair(2.0, std::string()));
  EXPECT_EQ(value_behind(head + "1.0+\n" + blank + "max(2.0,\n$ comment\n" + blank + "5.0)\nR u       t\n"),
            std::pair(6.0, std::string()));
  EXPECT_EQ(value_behind("*PARAMETER_EXPRESSION\nR t,1.0\n,+1.0\n"), std::pair(2.0, std::string()));
  EXPECT_NE(value_behind("*PARAMETER_EXPRESSION\n" + blank + "1.0\n" + "R t       2.\n")
                .second.find(
                    "deck.k:3: *PARAMETER_EXPRESSION: the line continues an expression, but there is none before it"),
            std::string::npos);
}

TEST(Parameters, OfSeveralDefinitionsDflagTellsWhichOneCounts) {
  const std::string one = "*PARAMETER\nR t, 1.\n", two = "*PARAMETER\nR T, 2.\n";
  const auto [value, report] = value_behind(one + two);
  EXPECT_EQ(value, 1);
  EXPECT_NE(
      report.find("deck.k:5: *PARAMETER: the parameter \"T\" is defined again with another value; the first value "
                  "counts"),
      std::string::npos)
      << report;
  const auto with = [&](int flag) {
    return value_behind("*PARAMETER_DUPLICATION\n" + std::to_string(flag) + "\n" + one + two);
  };
  EXPECT_EQ(with(0), with(1)) << "the default";
  EXPECT_EQ(with(1).first, 1);
  EXPECT_EQ(with(2).first, 2);
  EXPECT_NE(with(2).second.find("the new value counts"), std::string::npos);
  EXPECT_EQ(with(3).first, 1);
  EXPECT_NE(with(3).second.find("DFLAG = 3 of *PARAMETER_DUPLICATION forbids it"), std::string::npos);
  EXPECT_EQ(with(4), std::pair(2.0, std::string()));
  EXPECT_EQ(with(5), std::pair(1.0, std::string()));
  EXPECT_NE(with(6).second.find("DFLAG = 6 is not one of 1 to 5"), std::string::npos);
  EXPECT_EQ(value_behind("*PARAMETER_MUTABLE\nR t, 1.\n" + two), std::pair(2.0, std::string()));
  EXPECT_EQ(value_behind(one + one), std::pair(1.0, std::string())) << "the same value again";
}

TEST(Parameters, LocalOnesStayInTheirFileAndItsIncludes) {
  const TemporaryDirectory directory;
  directory.write("inner.k", "*PARAMETER_LOCAL\n" + pair("R a", "2") + "\n*PARAMETER\n" + pair("R shared", "5") +
                                 "\n*INCLUDE\nleaf.k\n");
  directory.write("leaf.k", "*NODE\n*END\n");
  const auto main = directory.write("main.k", "*KEYWORD\n*PARAMETER\n" + pair("R a", "1") +
                                                  "\n*INCLUDE\ninner.k\n*ELEMENT_SHELL\n*INCLUDE\nleaf.k\n*END\n");
  Diagnostics diagnostics;
  const auto deck = read_deck(main, {}, diagnostics);
  ASSERT_TRUE(deck.ok());
  std::vector<double> a_at_nodes, shared;
  for (const Block& block : deck.value().blocks())
    if (block.name == "NODE" || block.name == "ELEMENT_SHELL") {
      a_at_nodes.push_back(number(deck.value().parameters().find("a", block.scope, block.order)));
      shared.push_back(number(deck.value().parameters().find("shared", block.scope, block.order)));
    }
  EXPECT_EQ(a_at_nodes, (std::vector<double>{2, 1, 1}));
  EXPECT_EQ(shared, (std::vector<double>{5, 5, 5}));
  EXPECT_EQ(reports(diagnostics), "");
}

TEST(Parameters, GivenValuesReplaceThoseOfTheDeck) {
  Diagnostics diagnostics;
  ReadOptions options;
  options.parameters = {"THK = 2.5", "n=7", "name=front", "new=1e3", "c=4"};
  const auto deck = read_deck_text("*PARAMETER\n" + pair("R thk", "1.5") + pair("I n", "3") + pair("C name", "rear") +
                                       pair("C c", "x") + "\n*PARAMETER_EXPRESSION\nR twice   2*thk\n" +
                                       "*PARAMETER_LOCAL\n" + pair("R thk", "9.") + "\n*NODE\n",
                                   "deck.k", options, diagnostics);
  ASSERT_TRUE(deck.ok());
  const auto& parameters = deck.value().parameters();
  const Block& node = deck.value().blocks().back();
  const auto value = [&](const char* name) { return parameters.find(name, node.scope, node.order); };
  EXPECT_EQ(number(value("thk")), 2.5);
  EXPECT_EQ(number(value("twice")), 5);
  EXPECT_EQ(std::get<std::int64_t>(*value("n")), 7);
  EXPECT_EQ(std::get<std::string>(*value("name")), "front");
  EXPECT_EQ(std::get<std::string>(*value("c")), "4") << "a text stays one";
  EXPECT_EQ(number(value("new")), 1000) << "the deck need not define it";
  EXPECT_EQ(reports(diagnostics), "");
}

TEST(Parameters, GivenValuesMustFit) {
  Diagnostics diagnostics;
  ReadOptions options;
  options.parameters = {"n=2.5", "r=abc", "used=1", "Unused=1", "broken", "=3", "x="};
  const auto deck = read_deck_text("*PARAMETER\n" + pair("I n", "3") + pair("R r", "1.") + "\n*NODE\n   &used\n",
                                   "deck.k", options, diagnostics);
  ASSERT_TRUE(deck.ok());
  CardReader reader(deck.value(), deck.value().blocks().back(), diagnostics);
  EXPECT_EQ(reader.next(card_layout("NODE", "card1")).integer("nid"), 1);
  warn_of_unused_parameters(deck.value(), diagnostics);
  const std::string all = reports(diagnostics);
  EXPECT_EQ(count_errors(diagnostics), 5u) << all;
  for (const char* part : {"deck.k:2: *PARAMETER: the parameter \"n\" is a number (for type I a whole one)",
                           "the parameter \"r\" is a number", "'broken' is not of the form NAME=VALUE", "'=3' is not",
                           "'x=' is not", "--param unused: the deck neither defines nor uses this parameter"})
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
  EXPECT_EQ(number(deck.value().parameters().find("n", 0, 9)), 3);
}

TEST(Parameters, WhatFollowsFromAMissingOneIsNotReported) {
  TextDeck deck("*PARAMETER_EXPRESSION\nR twice   2*thk\nI n       twice+1\n*PARAMETER\n" + pair("R other", "&twice") +
                "\n*NODE\n&twice  &n\n&other  2*&other\n");
  CardReader reader = deck.reader("NODE");
  const Card card = reader.next(card_layout("NODE", "card1"));
  EXPECT_EQ(card.integer("nid", 5), 5);
  EXPECT_EQ(card.real("x", 5), 5);
  EXPECT_EQ(reader.next(card_layout("NODE", "card1")).integer("nid", 5), 5);
  EXPECT_EQ(reports(deck.diagnostics),
            "deck.k:2: *PARAMETER_EXPRESSION: the parameter \"thk\" is not defined before it is used; define it with "
            "*PARAMETER, or give it with --param thk=VALUE\n");
}

TEST(Parameters, FaultsAreReportedWithTheirLine) {
  TextDeck deck("*KEYWORD\n*PARAMETER\n" + pair("X bad", "1") + "\nR nothing\n" + pair("R text", "abc") +
                "\n*PARAMETER_EXPRESSION\nR e       "
                "1/0\n*END\n");
  const std::string all = reports(deck.diagnostics);
  for (const char* part : {"deck.k:3: ", "R, I or C", "deck.k:4: ", "has no value", "deck.k:5: ", "\"abc\"",
                           "deck.k:7: ", "divides by zero"})
    EXPECT_NE(all.find(part), std::string::npos) << part << " in\n" << all;
}

}  // namespace
}  // namespace gapcheck::keyword::parameters_test
