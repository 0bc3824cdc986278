#include "audit/published/cases.hpp"

namespace gapcheck::audit_test::published_thicknesses {
namespace {

/// Two plates of shells above each other; lines from card 3's SST on.
RuleDeck pair_of_plates(double t, double gap, const std::string& keyword, const std::string& thickness = "0.,0.") {
  RuleDeck deck;
  deck.shell_part(1, t).shell_part(2, t).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.plate(101, 2, 2, 2, Vector(0, 0, gap), 5, 5);
  return deck.contact(1, keyword, "1,2,3,3", "0.\n1.,1.," + thickness + "\n");
}

/// A part with two mesh densities, 5 and 2, and a thickness of 3, with SSTHK.
RuleDeck two_densities(int ssthk) {
  RuleDeck deck;
  deck.shell_part(1, 3).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 1, 5, 5, Vector(40, 0, 0), 2, 2);
  deck.raw("CONTROL_CONTACT", fmt::format("0.1,0.0,2,0,1,0,1,0\n0,0,10,0,4.0,{},0,0\n", ssthk));
  return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
}

/// Bricks of 2 and shells of 1.5 in one contact; what stands on card B.
RuleDeck bricks_and_shells(const std::string& card_b) {
  RuleDeck deck;
  deck.solid_part(1).block(1, 1, 2, 1, 1, Vector(0, 0, 0), Vector(2, 2, 2));
  deck.shell_part(2, 1.5).plate(101, 2, 1, 1, Vector(0, 0, 50), 20, 20);
  return deck.contact(3, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", "0.\n1.,1.\n0\n" + card_b + "\n");
}

/// A part whose mesh is fine at one place, in a single-surface contact with the default of SSTHK.
RuleDeck fine_at_one_place(double fine) {
  RuleDeck deck;
  deck.shell_part(1, 2).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 1, 5, 5, Vector(40, 0, 0), fine, fine);
  return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
}

/// Two parts of thickness 1 with common nodes; OPTT of the second one, or of both.
RuleDeck optt_of(bool both) {
  RuleDeck deck;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) deck.node(1 + 3 * j + i, Vector(10 * i, 10 * j, 0));
  deck.shell(1, 1, {1, 2, 5, 4}).shell(2, 1, {2, 3, 6, 5}).shell(3, 2, {4, 5, 8, 7}).shell(4, 2, {5, 6, 9, 8});
  deck.raw("SECTION_SHELL", "1,2,0.833,5\n1.\n");
  deck.raw("PART_CONTACT", fmt::format("one\n1,1,1\n0.,0.,0.,0.,{}\n", both ? "2.5" : "0."));
  deck.raw("PART_CONTACT", "two\n2,1,1\n0.,0.,0.,0.,2.5\n");
  return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
}

}  // namespace

std::vector<PublishedCase> cases() {
  const std::string automatic = "AUTOMATIC_SURFACE_TO_SURFACE";
  RuleDeck seen = pair_of_plates(1, 3, "SURFACE_TO_SURFACE");
  return {
      {"GC301", "SST = 1 where the elements have 0.25: 9 of 9 penetrations exist only by it",
       pair_of_plates(0.25, 0.5, automatic, "1.,1."), pair_of_plates(0.25, 0.5, automatic)},
      {"GC302", "25 elements count only 0.4 of their shortest edge as thickness, shell 101 the least: 0.8 of 2",
       fine_at_one_place(2), fine_at_one_place(5)},
      {"GC303", "the contact thickness of 4 elements is below 0.5", pair_of_plates(0.1, 9, automatic),
       pair_of_plates(0.5, 9, automatic)},
      {"GC307", "share nodes with part 2, and a node counts its largest thickness: shell 1 has 1 (element thickness)",
       optt_of(false), optt_of(true)},
      {"GC304", "3 (element thickness) and an edge of 2;", two_densities(1), two_densities(0)},
      {"GC305", "ignores thickness (SHLTHK = 0): 8 shells, up to 1 thick", seen,
       seen.raw("CONTROL_CONTACT", "0.1,0.0,0,1,1,0,1,0\n")},
      {"GC306", "at a depth of 0.4, where the thinnest shells hold to 1.2", bricks_and_shells("0."),
       bricks_and_shells("0.,0,0,0,0,0,1.")},
  };
}

}  // namespace gapcheck::audit_test::published_thicknesses
