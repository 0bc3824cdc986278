#include "lsp/card_order.hpp"

#include <gtest/gtest.h>

namespace gapcheck::app::lsp {
namespace {

/// The names of the cards of the first lines, "-" where none is known.
std::string cards(const std::string& name, std::vector<std::string_view> rows, std::size_t count) {
  const CardOrder order = card_order(name, keyword::Format::standard, rows);
  std::string names;
  for (std::size_t i = 0; i < count; ++i) {
    const keyword::CardLayout* card = order.at(i);
    names += (i > 0 ? " " : "") + (card == nullptr ? std::string("-") : card->fields.front().name);
  }
  return names;
}

TEST(LspCardOrder, KeywordsOfAllKinds) {
  EXPECT_EQ(cards("PART", {}, 4), "title pid title pid");
  EXPECT_EQ(cards("PART_CONTACT", {}, 4), "title pid fs title");
  EXPECT_EQ(cards("SET_NODE_LIST_TITLE", {}, 4), "title sid nodes nodes");
  EXPECT_EQ(cards("SET_SEGMENT", {}, 3), "sid n1 n1");
  EXPECT_EQ(cards("SECTION_SHELL", {}, 4), "secid t1 secid t1");
  EXPECT_EQ(cards("SECTION_SHELL_TITLE", {}, 4), "title secid t1 -");
  EXPECT_EQ(cards("SECTION_BEAM", {"         1         2"}, 3), "secid a -");
  EXPECT_EQ(cards("DEFINE_CURVE_TITLE", {}, 4), "title lcid a1 a1");
  EXPECT_EQ(cards("MAT_ELASTIC", {}, 1), "mid");
  EXPECT_EQ(cards("MAT_OF_A_LAW_TO_COME_TITLE", {}, 3), "title mid -");
  EXPECT_EQ(cards("NODE", {}, 2), "nid nid");
  EXPECT_EQ(cards("ELEMENT_SOLID", {"       1       1"}, 3), "eid n1 eid");
  EXPECT_EQ(cards("ELEMENT_SOLID", {"       1       1       1       2"}, 2), "eid eid");
  EXPECT_EQ(cards("BOUNDARY_SPC_SET_ID", {}, 4), "id nsid id nsid");
  EXPECT_EQ(cards("NO_SUCH_KEYWORD", {}, 1), "-");
  EXPECT_EQ(cards("", {}, 1), "-");
}

TEST(LspCardOrder, Contacts) {
  EXPECT_EQ(cards("CONTACT_AUTOMATIC_SINGLE_SURFACE", {}, 5), "surfa fs sfsa soft penmax");
  EXPECT_EQ(cards("CONTACT_AUTOMATIC_SINGLE_SURFACE_MPP_ID", {"1", "2", "&"}, 5), "cid ignore mpp2 surfa fs");
  EXPECT_EQ(cards("CONTACT_AUTOMATIC_SINGLE_SURFACE_MPP", {"1", "2"}, 2), "ignore surfa");
  EXPECT_EQ(cards("CONTACT_ERODING_SINGLE_SURFACE", {}, 5), "surfa fs sfsa isym soft");
  const std::vector<std::string_view> cohesive{"1", "2", "3", "        14"};
  EXPECT_EQ(cards("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", cohesive, 7),
            "surfa fs sfsa option g1c_0 g2c_0 soft");
  EXPECT_EQ(cards("CONTACT_OF_A_TYPE_TO_COME", {}, 1), "-");
}

TEST(LspCardOrder, AnotherLawIsAnotherMaterial) {
  EXPECT_EQ(layout_of("MAT_ELASTIC_OF_ANOTHER_LAW"), nullptr);
  ASSERT_NE(layout_of("MAT_ELASTIC_TITLE"), nullptr);
  EXPECT_EQ(layout_of("MAT_ELASTIC_TITLE")->name, "MAT_ELASTIC");
}

}  // namespace
}  // namespace gapcheck::app::lsp
