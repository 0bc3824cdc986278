#include "keyword/highest_ids.hpp"

#include "support.hpp"

namespace gapcheck::keyword::highest_ids_test {
namespace {

std::pair<std::int64_t, std::int64_t> highest(const std::string& text) {
  const TextDeck deck(text);
  HighestIds ids;
  ids.update(deck.deck);
  EXPECT_EQ(reports(deck.diagnostics), "");
  return {ids.node(), ids.element()};
}

std::int64_t element(const std::string& text) { return highest("*ELEMENT_" + text).second; }

TEST(HighestIds, NodesOfAllBlocks) {
  EXPECT_EQ(highest("*NODE\n       7     1.0\n$ 99\n\n      12     50.\n*NODE\n3,99,99\n"), std::pair(12L, 0L));
  EXPECT_EQ(highest("*TITLE\n99\n*SET_NODE\n99\n99\n"), std::pair(0L, 0L));
  std::string many = "*NODE\n";
  for (int i = 1; i < 100000; ++i) many += std::to_string(i * 7919 % 100003) + ",0.\n";
  EXPECT_EQ(highest(many).first, 100002);
}

TEST(HighestIds, ElementsWithoutFurtherLines) {
  for (const char* family : {"SHELL", "TSHELL", "BEAM", "MASS", "DISCRETE", "PLOTEL", "SEATBELT"})
    EXPECT_EQ(element(std::string(family) + "\n       5      99      99\n       8       1      99\n"), 8) << family;
  for (const char* family : {"SPH", "DISCRETE_SPHERE", "SEATBELT_RETRACTOR", "BEAM_PULLEY", "TRIM", "MASS_PART"})
    EXPECT_EQ(element(std::string(family) + "\n      99      99      99\n"), 0) << family;
}

TEST(HighestIds, LinesOfThicknessAreNoElements) {
  EXPECT_EQ(element("SHELL_THICKNESS\n       5       1       1       2       3       4\n      99.       99.\n"), 5);
  EXPECT_EQ(element("SHELL_BETA_OFFSET\n5,1,1,2,3,4\n99.\n98\n6,1,1,2,3,4\n99.\n98\n"), 6);
  EXPECT_EQ(element("SHELL_THICKNESS\n5,1,1,2,3,4,5,6,7,8\n99.\n98.\n"), 5) << "middle nodes have a thickness";
  EXPECT_EQ(element("SHELL_COMPOSITE\n5,1,1,2,3,4\n99,1.5,0.,,98,1.5\n97,0.7\n6,1,1,2,3,4\n"), 6);
  EXPECT_EQ(element("BEAM_ORIENTATION\n5,1,1,2\n99,99,99\n"), 5);
  EXPECT_EQ(element("INERTIA\n5,1\n99.\n"), 5);
}

TEST(HighestIds, SolidsHaveTheirNodesInTheSameLineOrBehind) {
  EXPECT_EQ(element("SOLID\n       5       1\n      91      92      93      94      95      96      97      98\n"
                    "       6       1\n      91      92      93      94      95      96      97      98\n"),
            6);
  EXPECT_EQ(element("SOLID\n       5       1      91      92      93      94\n       6       1      91      92\n"), 6);
  EXPECT_EQ(element("SOLID_H20\n5,1\n91,92,93\n94,95\n6,1\n91\n92\n"), 6);
  EXPECT_EQ(element("SOLID_ORTHO\n5,1,91,92,93,94\n95.\n96.\n6,1,91,92,93,94\n97.\n98.\n"), 6);
}

TEST(HighestIds, UpdatingAgainChangesNothing) {
  TextDeck deck("*NODE\n5\n");
  HighestIds ids;
  ids.update(deck.deck);
  ids.update(deck.deck);
  EXPECT_EQ(ids.node(), 5);
}

}  // namespace
}  // namespace gapcheck::keyword::highest_ids_test
