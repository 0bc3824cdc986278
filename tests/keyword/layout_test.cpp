#include "keyword/layout.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

#include "base/embedded.hpp"

namespace gapcheck::embedded {
extern const std::span<const Text> keyword_layouts;
}

namespace gapcheck::keyword::layout_test {
namespace {

const Field& field(std::string_view keyword, std::string_view card, std::string_view name) {
  const CardLayout& layout = card_layout(keyword, card);
  const std::size_t index = layout.index(name);
  EXPECT_NE(index, CardLayout::npos) << keyword << " " << card << " " << name;
  return layout.fields[index == CardLayout::npos ? 0 : index];
}

TEST(Layout, KnowsNodes) {
  const CardLayout& node = card_layout("NODE", "card1");
  ASSERT_EQ(node.fields.size(), 6u);
  EXPECT_EQ(node.fields[0].name, "nid");
  EXPECT_EQ(node.fields[0].id, IdKind::node);
  EXPECT_EQ(node.fields[1].column, 8);
  EXPECT_EQ(node.fields[1].width, 16);
  EXPECT_EQ(node.fields[1].type, FieldType::real);
  EXPECT_EQ(node.fields[5].column, 64);
}

TEST(Layout, IdsTakeTheOffsetOfTheirKind) {
  const std::vector<std::tuple<const char*, const char*, const char*, IdKind>> expected{
      {"ELEMENT_SHELL", "card1", "eid", IdKind::element},
      {"ELEMENT_SHELL", "card1", "pid", IdKind::part},
      {"ELEMENT_SHELL", "card1", "n8", IdKind::node},
      {"ELEMENT_SOLID", "card1", "eid", IdKind::element},
      {"ELEMENT_SOLID", "card2", "n10", IdKind::node},
      {"ELEMENT_SOLID", "card1_legacy", "pid", IdKind::part},
      {"ELEMENT_SOLID", "card1_legacy", "n1", IdKind::node},
      {"ELEMENT_MASS", "card1", "nid", IdKind::node},
      {"PART", "card1.2", "pid", IdKind::part},
      {"PART", "card1.2", "secid", IdKind::other},
      {"PART", "card1.2", "mid", IdKind::material},
      {"PART", "card1.2", "eosid", IdKind::material},
      {"SECTION_SHELL", "card1", "secid", IdKind::other},
      {"SECTION_SHELL", "card1", "nip", IdKind::plain},
      {"MAT_ELASTIC", "card1", "mid", IdKind::material},
      {"HOURGLASS", "card1", "hgid", IdKind::other},
      {"SET_NODE_LIST", "card1", "sid", IdKind::set},
      {"SET_NODE_LIST", "card2", "nodes", IdKind::node},
      {"SET_NODE_ADD", "card2", "nodes", IdKind::set},
      {"SET_PART_LIST", "card2", "parts", IdKind::part},
      {"SET_SHELL_ADD", "card2", "shells", IdKind::set},
      {"SET_NODE_LIST_GENERATE", "card2", "b2beg", IdKind::node},
      {"SET_PART_GENERAL", "card2", "e1", IdKind::plain},
      {"DEFINE_CURVE", "card1", "lcid", IdKind::function},
      {"DEFINE_BOX", "card1", "boxid", IdKind::define},
      {"DEFINE_TRANSFORMATION", "card1", "tranid", IdKind::define},
      {"CONTACT", "ID", "cid", IdKind::other},
      {"CONTACT", "card1", "surfa", IdKind::plain},
      {"CONTACT", "card1", "saboxid", IdKind::define},
      {"CONSTRAINED_NODAL_RIGID_BODY", "card1", "pid", IdKind::part},
  };
  for (const auto& [keyword, card, name, kind] : expected)
    EXPECT_EQ(field(keyword, card, name).id, kind) << keyword << " " << card << " " << name;
}

TEST(Layout, ArraysAreExpanded) {
  const CardLayout& nodes = card_layout("SET_NODE_LIST", "card2");
  ASSERT_EQ(nodes.fields.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(nodes.fields[i].name, "nodes");
    EXPECT_EQ(nodes.fields[i].column, 10 * i);
  }
}

TEST(Layout, ContactsHaveTheNewNames) {
  for (const char* keyword : {"CONTACT_AUTOMATIC_SINGLE_SURFACE", "CONTACT_TIED_SURFACE_TO_SURFACE", "CONTACT"})
    for (const auto& [card, name] : std::vector<std::pair<const char*, const char*>>{
             {"card1", "surfbtyp"}, {"card1", "sbpr"}, {"card3", "sast"}, {"card3", "sfsbt"}, {"C", "ignore"}})
      EXPECT_NE(card_layout(keyword, card).index(name), CardLayout::npos) << keyword << " " << name;
}

TEST(Layout, GeneralContactHasEveryCard) {
  const KeywordLayout* contact = find_layout("CONTACT");
  ASSERT_NE(contact, nullptr);
  for (const CardLayout& card : contact->cards) EXPECT_FALSE(card.fields.empty()) << card.name;
  EXPECT_EQ(field("CONTACT", "C", "flangl").column, 60);
  EXPECT_EQ(field("CONTACT", "G", "shloff").column, 10);
  EXPECT_EQ(field("CONTACT", "TIEBREAK", "option").column, 0);
}

TEST(Layout, FindsKeywordBehindOptions) {
  EXPECT_EQ(find_layout_of("CONTACT_AUTOMATIC_SINGLE_SURFACE_ID_MPP")->name, "CONTACT_AUTOMATIC_SINGLE_SURFACE");
  EXPECT_EQ(find_layout_of("SECTION_SHELL_TITLE")->name, "SECTION_SHELL");
  EXPECT_EQ(find_layout_of("NO_SUCH_KEYWORD"), nullptr);
  EXPECT_EQ(find_layout_of(""), nullptr);
  EXPECT_EQ(find_layout("NODE_"), nullptr);
}

TEST(Layout, EveryLayoutIsWellFormed) {
  std::size_t keywords = 0;
  for (const auto& text : embedded::keyword_layouts) {
    std::istringstream lines{std::string(text.content)};
    for (std::string line; std::getline(lines, line);) {
      if (line.empty() || line.starts_with("#")) continue;
      std::istringstream words(line);
      std::string verb, name;
      words >> verb >> name;
      EXPECT_TRUE(verb == "fields" || verb == "card" || verb == "kind") << line;
      if (verb != "card") continue;
      ++keywords;
      const KeywordLayout* layout = find_layout(name);
      ASSERT_NE(layout, nullptr) << name;
      for (const CardLayout& card : layout->cards) {
        EXPECT_FALSE(card.fields.empty()) << name << " " << card.name;
        std::size_t end = 0;
        for (const Field& f : card.fields) {
          EXPECT_GE(f.column, end) << name << " " << card.name << " " << f.name;
          EXPECT_GT(f.width, 0) << name << " " << card.name << " " << f.name;
          end = static_cast<std::size_t>(f.column) + f.width;
        }
        EXPECT_LE(end, 512u) << name << " " << card.name;
      }
    }
  }
  EXPECT_GT(keywords, 800u);
}

/// Every field list and card that a line of the table refers to must exist: a mistyped name would give an empty card.
TEST(Layout, CorrectionsTouchSomething) {
  std::set<std::string> lists, keywords;
  for (const auto& text : embedded::keyword_layouts) {
    std::istringstream lines{std::string(text.content)};
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string verb, name, word;
      words >> verb >> name;
      if (verb == "fields") lists.insert(name);
      if (verb == "card") {
        keywords.insert(name);
        while (words >> word) {
          const auto target = word.substr(word.find('=') + 1);
          const auto slash = target.find('/');
          if (slash == std::string::npos) {
            EXPECT_TRUE(lists.contains(target)) << line;
          } else {
            EXPECT_TRUE(keywords.contains(target.substr(0, slash))) << line;
          }
        }
      }
      if (verb == "kind" && !name.ends_with("*")) {
        EXPECT_TRUE(keywords.contains(name)) << line;
      }
    }
  }
}

/// What the sources ask of card_layout() and next_card() must be in the table; the call cannot report it to a user.
TEST(Layout, EveryUseInTheSourcesExists) {
  const std::regex call(R"re((?:card_layout|next_card)\(([^()]*"[^()]*)\))re"), literal(R"re("([^"]*)")re");
  std::size_t uses = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(GAPCHECK_ROOT "/lib")) {
    if (entry.path().extension() != ".cpp") continue;
    std::ostringstream content;
    content << std::ifstream(entry.path()).rdbuf();
    const std::string text = content.str();
    for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it) {
      const std::string arguments = (*it)[1];
      std::vector<std::string> before, behind;  // literals of the keyword and of the card
      const auto comma = arguments.rfind(',');
      for (std::sregex_iterator word(arguments.begin(), arguments.end(), literal); word != end; ++word)
        (static_cast<std::size_t>(word->position()) < comma ? before : behind).push_back((*word)[1]);
      for (const auto& keyword : before)
        for (const auto& card : behind) {
          ++uses;
          const KeywordLayout* layout = find_layout(keyword);
          EXPECT_TRUE(layout != nullptr && layout->card(card) != nullptr)
              << entry.path() << ": " << keyword << " " << card;
        }
    }
  }
  EXPECT_GT(uses, 100u);
}

TEST(Layout, FirstUseFromManyThreads) {
  std::vector<std::thread> threads;
  std::vector<const KeywordLayout*> found(8);
  for (auto& slot : found) threads.emplace_back([&slot] { slot = find_layout("ELEMENT_SHELL"); });
  for (auto& thread : threads) thread.join();
  ASSERT_NE(found.front(), nullptr);
  EXPECT_EQ(found.front()->name, "ELEMENT_SHELL");
  for (const auto* layout : found) EXPECT_EQ(layout, found.front());
}

}  // namespace
}  // namespace gapcheck::keyword::layout_test
