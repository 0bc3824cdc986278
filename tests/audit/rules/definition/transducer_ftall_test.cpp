#include "audit/rules/rule_deck.hpp"
#include "contact/tie/transducers.hpp"

namespace gapcheck::audit_test::transducer_ftall_test {
namespace {

/// Four plates (parts 1 to 4), an automatic contact and two transducers; sets: 11 = {1, 2}, 12 = {1}; node sets 21 of
/// part 1 and 22 of part 2.
RuleDeck transducers(const std::string& first, const std::string& second) {
  RuleDeck deck;
  for (int part = 1; part <= 4; ++part)
    deck.shell_part(part, 1).plate(100 * part, part, 1, 1, Vector(0, 0, 9.0 * part), 5, 5);
  deck.raw("SET_PART_LIST", "11\n1,2\n").raw("SET_PART_LIST", "12\n1\n");
  deck.raw("SET_NODE_LIST", "21\n100,101\n").raw("SET_NODE_LIST", "22\n200\n");
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0").contact(2, "FORCE_TRANSDUCER_PENALTY", first);
  return deck.contact(3, "FORCE_TRANSDUCER_PENALTY", second);
}

Report run(const RuleDeck& deck) { return run_rule("GC413", deck); }

TEST(TransducerFtall, TwoThatShareBothSides) {
  const Report report = run(transducers("1,3,3,3", "11,3,2,3"));
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].contact, 3);
  EXPECT_TRUE(report.findings[0].message.starts_with("transducer 3 measures forces that transducer 2 measures too"));
  EXPECT_EQ(listed(run(transducers("1,3,3,3", "3,12,3,2"))), 1U);  // crosswise
  EXPECT_EQ(listed(run(transducers("1,3,3,3", "11,4,2,3"))), 0U);  // one side only
  EXPECT_EQ(listed(run(transducers("1,3,3,3", "2,3,3,3"))), 0U);
  EXPECT_EQ(listed(run(transducers("1,0,3,0", "11,0,2,0"))), 0U);  // with one surface each
}

TEST(TransducerFtall, NodesAgainstElements) {
  EXPECT_EQ(listed(run(transducers("21,3,4,3", "11,3,2,3"))), 1U);
  EXPECT_EQ(listed(run(transducers("22,3,4,3", "12,3,2,3"))), 0U);
}

TEST(TransducerFtall, BeamsCountAsWell) {
  RuleDeck deck = transducers("1,5,3,3", "2,5,3,3");
  EXPECT_EQ(listed(run(deck)), 0U);
  RuleDeck beams = transducers("5,1,3,3", "5,12,3,2");
  beams.raw("PART", "rod\n5,5,1\n").raw("SECTION_BEAM", "5,1\n1.,1.,0.,0.\n");
  beams.raw("NODE", "501,0.,0.,0.\n502,9.,0.,0.\n").raw("ELEMENT_BEAM", "1,5,501,502\n");
  EXPECT_EQ(listed(run(beams)), 1U);
}

/// What the report says of transducers that were not looked at.
std::string left_out(const Report& report) {
  std::string text;
  for (const auto& [name, value] : report.statistics)
    if (name == "not looked at") text += value;
  return text;
}

TEST(TransducerFtall, MoreThanCanBeComparedAreNamed) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 1, 1, Vector(0, 0, 0), 5, 5);
  deck.plate(101, 2, 1, 1, Vector(0, 0, 9), 5, 5).contact(1000, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  const int most = static_cast<int>(contact::max_transducers);
  for (int i = 1; i <= most; ++i) deck.contact(i, "FORCE_TRANSDUCER_PENALTY", "1,2,3,3");
  EXPECT_EQ(left_out(run(deck)), "");
  const Report more = run(deck.contact(most + 1, "FORCE_TRANSDUCER_PENALTY", "1,2,3,3"));
  EXPECT_EQ(left_out(more), fmt::format("GC413: 1 of {} force transducers", most + 1));
  std::uint64_t all = 0;
  for (const Finding& f : more.findings) all += f.count;
  EXPECT_EQ(all, contact::max_transducers - 1) << "all that are compared measure what the first one does";
}

TEST(TransducerFtall, FtallSettlesIt) {
  const RuleDeck both = transducers("1,3,3,3", "11,3,2,3");
  RuleDeck with = both, without = both;
  EXPECT_EQ(listed(run(with.raw("CONTROL_CONTACT", "\n\n\n\n\n,,,,1\n"))), 0U);
  EXPECT_EQ(listed(run(without.raw("CONTROL_CONTACT", "\n\n\n\n\n,,,,0\n"))), 1U);
}

TEST(TransducerFtall, ASecondSurfaceNeedsPenaltyAndAnAutomaticContact) {
  const auto single = [](const std::string& contact, const std::string& transducer) {
    RuleDeck deck;
    deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 1, 1, Vector(0, 0, 0), 5, 5);
    deck.plate(101, 2, 1, 1, Vector(0, 0, 9), 5, 5);
    return listed(run(deck.contact(1, contact, "1,2,3,3").contact(2, transducer, "1,2,3,3")));
  };
  EXPECT_EQ(single("AUTOMATIC_SURFACE_TO_SURFACE", "FORCE_TRANSDUCER_PENALTY"), 0U);
  EXPECT_EQ(single("AUTOMATIC_SURFACE_TO_SURFACE", "FORCE_TRANSDUCER_CONSTRAINT"), 1U);
  EXPECT_EQ(single("SURFACE_TO_SURFACE", "FORCE_TRANSDUCER_PENALTY"), 1U);
}

}  // namespace
}  // namespace gapcheck::audit_test::transducer_ftall_test
