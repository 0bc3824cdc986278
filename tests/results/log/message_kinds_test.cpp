#include "results/log/message_kinds.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/embedded.hpp"

namespace gapcheck::embedded {
extern const std::span<const Text> message_kinds;
}

namespace gapcheck::results::message_kinds_test {
namespace {

/// Name of the kind of a block with this header rest and text; "" where there is none.
std::string kind_of(const MessageKinds& kinds, const std::string& header, const std::string& text) {
  const std::string bytes = " *** Warning " + header + "\n     " + text + "\n";
  Lines lines(bytes);
  MessageBlock block;
  read_message_block(lines, block);
  const MessageKind* kind = kinds.find(block);
  return kind == nullptr ? "" : kind->name;
}

TEST(MessageKinds, BuiltInTableHasNoFaults) {
  ASSERT_EQ(embedded::message_kinds.size(), 1u);
  Diagnostics diagnostics;
  MessageKinds kinds;
  kinds.add(embedded::message_kinds[0].content, "message_kinds.txt", diagnostics);
  EXPECT_TRUE(diagnostics.sorted().empty());
}

TEST(MessageKinds, ByNumber) {
  const MessageKinds kinds;
  EXPECT_EQ(kind_of(kinds, "40565 (SOL+565)", "any text"), "initial-penetration");
  EXPECT_EQ(kind_of(kinds, "50135", "any text"), "tied-not-found");
  EXPECT_EQ(kind_of(kinds, "60303", "any text"), "implicit-gap-flag");
  EXPECT_EQ(kind_of(kinds, "99999", "any text"), "");
}

TEST(MessageKinds, ByWordsOverLineBreaksAndCase) {
  const MessageKinds kinds;
  EXPECT_EQ(kind_of(kinds, "41234", "Tracked node is not\n     constrained since it would\n     Shorten a beam."),
            "tied-too-short");
  EXPECT_EQ(kind_of(kinds, "41235", "Slave node is not constrained since it is\n     a rigid node."),
            "tied-rigid-node");
  EXPECT_EQ(kind_of(kinds, "41236", "tied interface #   = 3\n     segment with any rigid node"), "tied-rigid-segment");
  EXPECT_EQ(kind_of(kinds, "41237", "Slave node is not constrained since it is\n     too far from segment."),
            "tied-too-far");
}

TEST(MessageKinds, SayWhereTheirWordsAreAssumed) {
  MessageKinds kinds;
  Diagnostics diagnostics;
  kinds.add("kind guess\nwords would stretch\nwording assumed\nkind seen\nwords would bend\nwording known\n", "my.txt",
            diagnostics);
  EXPECT_EQ(diagnostics.sorted().size(), 1u) << "the wording is assumed, or there is no such line";
  const auto assumed = [&](const std::string& text) {
    const std::string bytes = " *** Warning\n     " + text + "\n";
    Lines lines(bytes);
    MessageBlock block;
    read_message_block(lines, block);
    const MessageKind* kind = kinds.find(block);
    return kind != nullptr && kind->assumed;
  };
  EXPECT_TRUE(assumed("it would stretch"));
  EXPECT_TRUE(assumed("Penetrating node is too far below segment"));
  EXPECT_FALSE(assumed("Slave node is not constrained since it is too far from segment."));
}

TEST(MessageKinds, UsersEntriesComeFirst) {
  MessageKinds kinds;
  Diagnostics diagnostics;
  kinds.add("kind mine\ncodes 40565\nwords special\nkind weld\ncodes 70001\nrecord tie short\nnode weld node\n",
            "my.txt", diagnostics);
  EXPECT_TRUE(diagnostics.sorted().empty());
  EXPECT_EQ(kind_of(kinds, "40565", "a special case"), "mine");
  EXPECT_EQ(kind_of(kinds, "40565", "a plain case"), "initial-penetration");
  EXPECT_EQ(kind_of(kinds, "70001", "text"), "weld");
}

TEST(MessageKinds, FaultsNameFileAndLine) {
  const std::vector<std::pair<std::string, std::uint32_t>> faults{{"codes 1\n", 1},
                                                                  {"kind a\ncodes x\n", 2},
                                                                  {"kind a\ncodes 1\nrecord tie nowhere\n", 3},
                                                                  {"kind a\ncodes 1\nfoo\n", 3},
                                                                  {"kind a\nwords &\n", 2},
                                                                  {"# c\n\nkind\n", 3},
                                                                  {"kind a\nrecord cut\n", 1},
                                                                  {"kind a\ncodes 1\nrecord nothing\n", 3}};
  for (const auto& [text, line] : faults) {
    MessageKinds kinds;
    Diagnostics diagnostics;
    kinds.add(text, "my.txt", diagnostics);
    const auto found = diagnostics.sorted();
    const auto is_there = [at = line](const Diagnostic& d) { return d.file == "my.txt" && d.line == at; };
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), is_there)) << text;
  }
}

TEST(MessageKinds, LabelsOfAnEntryAndOfAll) {
  MessageKinds kinds;
  Diagnostics diagnostics;
  kinds.add("node the node\nkind a\ncodes 1\nkind b\ncodes 2\nnode other | third\n", "my.txt", diagnostics);
  const auto labels = [&](const std::string& code, const char* label) {
    const std::string bytes = " *** Warning " + code + "\n     x\n";
    Lines lines(bytes);
    MessageBlock block;
    read_message_block(lines, block);
    return kinds.find(block)->label_of(label) == MessageKind::node;
  };
  EXPECT_TRUE(labels("1", "the node"));
  EXPECT_FALSE(labels("1", "slave node #"));
  EXPECT_TRUE(labels("2", "third"));
  EXPECT_FALSE(labels("2", "the node"));
  EXPECT_TRUE(labels("40538", "slave node #"));
  for (const char* label :
       {"Tracked  node   #", "surfa node #", "surfb node #", "since it is found nowhere. slave node #"})
    EXPECT_TRUE(labels("40538", label)) << label;
  for (const char* label : {"snode #", "slave node # of", "original coordinates of slave", ""})
    EXPECT_FALSE(labels("40538", label)) << label;
}

}  // namespace
}  // namespace gapcheck::results::message_kinds_test
