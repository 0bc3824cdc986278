#include "audit/published/cases.hpp"

namespace gapcheck::audit_test::published_surfaces {
namespace {

/// The workshop's plates, red with E = 210 GPa and blue with a hundredth of it.
RuleDeck red_and_blue(const std::string& cards) {
  RuleDeck deck;
  deck.raw("MAT_ELASTIC", "7,7.85e-9,2100.,0.3\n").shell_part(1, 1).shell_part(2, 1, 7);
  deck.plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 2, 2, 2, Vector(0, 0, 9), 5, 5);
  return deck.contact(3, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3", cards);
}

/// A plate of 2 x 2 shells above another one; one shell of it may be turned round.
RuleDeck oriented(bool turned) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 1, 1, Vector(1, 1, 9), 8, 8);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) deck.node(101 + 3 * j + i, {5.0 * i, 5.0 * j, 0});
  deck.shell(201, 2, {101, 102, 105, 104}).shell(202, 2, {102, 103, 106, 105}).shell(203, 2, {104, 105, 108, 107});
  using Nodes = std::vector<std::int64_t>;
  deck.shell(204, 2, turned ? Nodes{105, 108, 109, 106} : Nodes{105, 106, 109, 108});
  deck.raw("DEFINE_CURVE", "1,1\n0.,0.\n0.01,1.\n").raw("DEFINE_CURVE", "2\n0.,1.\n1.,1.\n");
  return deck.contact(6, "SURFACE_TO_SURFACE_INTERFERENCE", "1,2,3,3", "0.\n1.,1.\n1,2\n");
}

/// A coarse plate (edges of 4) and a fine one (2), one-way.
RuleDeck one_way(const std::string& card1) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 3, 3, Vector(0, 0, 0), 4, 4);
  return deck.plate(101, 2, 6, 6, Vector(0, 0, 9), 2, 2).contact(8, "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", card1);
}

/// A block coated with null shells of this Young's modulus, and a plate.
RuleDeck null_coat(const std::string& young) {
  RuleDeck deck;
  deck.raw("MAT_NULL", "7,1.0e-9,0,0,0,0," + young + ",0.3\n").raw("MAT_LOW_DENSITY_FOAM", "4,5.e-11,50.");
  deck.shell_part(1, 1).shell_part(2, 0.5, 7).solid_part(3, 4).plate(1, 1, 2, 2, Vector(0, 0, 9), 5, 5);
  deck.block(101, 3, 1, 1, 1, Vector(0, 0, 0), Vector(10, 10, 5)).shell(501, 2, {105, 106, 108, 107});
  return deck.contact(3, "AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3");
}

/// Thin shells; the contact's springs are those of bulk modulus and size, whatever the mass.
RuleDeck thin_shells(double t, const std::string& sfs = "1.") {
  RuleDeck deck;
  deck.shell_part(1, t).plate(1, 1, 3, 3, Vector(0, 0, 0), 4, 4);
  return deck.contact(2, "AUTOMATIC_SINGLE_SURFACE", "0,0,5", "0.\n" + sfs + "," + sfs + "\n1\n");
}

/// Plates 1 … count, 10 above each other.
RuleDeck stack(int count) {
  RuleDeck deck;
  for (int p = 1; p <= count; ++p) deck.shell_part(p, 1).plate(100 * p, p, 1, 1, Vector(0, 0, 10.0 * p), 5, 5);
  return deck;
}

RuleDeck pair_by_pair(int contacts) {
  RuleDeck deck = stack(contacts + 1);
  for (int i = 1; i <= contacts; ++i)
    deck.contact(i, "AUTOMATIC_SURFACE_TO_SURFACE", fmt::format("{},{},3,3", i, i + 1), "0.2\n1.,1.\n");
  return deck;
}

RuleDeck contact_in_contact(const std::string& more) {
  RuleDeck deck = stack(3);
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5").contact(2, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3");
  return more.empty() ? deck : deck.raw("CONTACT_EXCLUDE_INTERACTION", more);
}

}  // namespace

std::vector<PublishedCase> cases() {
  return {
      {"GC410", "is 100 times as stiff as part 2", red_and_blue("0.\n1.,1.\n"), red_and_blue("0.\n1.,1.\n1\n")},
      {"GC411", "SOFSCL = 0.4 with SOFT = 1", red_and_blue("0.\n1.,1.\n1,0.4\n"),
       red_and_blue("0.\n1.e-12,1.e-12\n1,0.4\n")},
      {"GC416", "side B, part 2: 1 segment", oriented(true), oriented(false)},
      {"GC417", "2 times finer than the tracked side A (mean edges 2 and 4)", one_way("1,2,3,3"), one_way("2,1,3,3")},
      {"GC418", "side A has no stiffness: its only segment is of materials with E = 0 (first: part 2, *MAT_NULL 7)",
       null_coat("0."), null_coat("50.")},
      {"GC420", "contact springs are stable below a step of 5.037E-07 (node 1), but the run's step is 6.640E-07",
       thin_shells(0.1), thin_shells(1)},
      {"GC420", "scale SFS by 0.0", thin_shells(1, "100."), thin_shells(1, "1.")},
      {"GC422", "are in contact 1 already", contact_in_contact(""), contact_in_contact("9,1\n1,2,3,3\n")},
      {"GC425", "5 contacts (1, 2, 3, 4, 5) with the same settings hold 6 parts", pair_by_pair(5),
       stack(6).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5", "0.2\n1.,1.\n")},
  };
}

}  // namespace gapcheck::audit_test::published_surfaces
