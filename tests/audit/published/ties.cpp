#include "audit/published/cases.hpp"

namespace gapcheck::audit_test::published_ties {
namespace {

const std::string plain_cards = "0.\n1.,1.\n";

/// A plate of 2 x 2 shells (20 x 20, part 1) and above it, at this height, six nodes that stand over its edge and six
/// over it, in sets 7 (all) and 8 (those over it).
RuleDeck row_of_nodes(const std::string& set, const std::string& cards = plain_cards, double height = 0.5) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  for (int i = 0; i < 6; ++i) deck.node(13 + i, {23, 2.0 + 3 * i, height}).node(113 + i, {17, 2.0 + 3 * i, height});
  deck.raw("SET_NODE_LIST", "7\n13,14,15,16,17,18,113,114\n115,116,117,118\n");
  deck.raw("SET_NODE_LIST", "8\n113,114,115,116,117,118\n");
  return deck.contact(1, "TIED_NODES_TO_SURFACE", set + ",1,4,3", cards);
}

/// Two plates of shells, 1 thick, `gap` apart, the upper one inside the outline of the lower one.
RuleDeck glued_plates(const std::string& keyword, double gap, int lower = 1, int upper = 1) {
  RuleDeck deck;
  deck.shell_part(1, 1, lower).shell_part(2, 1, upper).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  deck.plate(101, 2, 2, 2, Vector(1, 1, gap), 9, 9);
  return deck.contact(1, keyword, "2,1,3,3");
}

/// Nodes of one set between two plates, each near enough to tie to both; the second tie is of this type.
RuleDeck third_sheet(const std::string& second, const std::string& cards = plain_cards) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 1, 1, Vector(0, 0, 0), 10, 10);
  deck.plate(11, 2, 1, 1, Vector(0, 0, 0.4), 10, 10).node(50, {3, 4, 0.2}).node(51, {6, 4, 0.2});
  deck.raw("SET_NODE_LIST", "7\n50,51\n").contact(3, "TIED_NODES_TO_SURFACE", "7,1,4,3");
  return deck.contact(4, second, "7,2,4,3", cards);
}

/// The rib of shells of the workshop's joint: its lower edge (51 to 53) stands on a plate.
RuleDeck rib(const std::string& keyword) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  for (int i = 0; i < 3; ++i) deck.node(51 + i, {3.0 + 6 * i, 5, 0}).node(61 + i, {3.0 + 6 * i, 5, 10});
  deck.shell(51, 2, {51, 52, 62, 61}).shell(52, 2, {52, 53, 63, 62});
  return deck.raw("SET_NODE_LIST", "7\n51,52,53\n").contact(1, keyword, "7,1,4,3");
}

/// Small bricks above one face of 20 x 20: 0.05 of its diagonal reaches farther than an edge of theirs.
RuleDeck small_on_large(const std::string& card3) {
  RuleDeck deck;
  deck.solid_part(1).solid_part(2).block(1, 1, 1, 1, 1, Vector(0, 0, -20), Vector(20, 20, 20));
  deck.block(101, 2, 2, 2, 1, Vector(5, 5, 0.8), Vector(1, 1, 1));
  return deck.contact(1, "TIED_SURFACE_TO_SURFACE", "2,1,3,3", "0.\n" + card3 + "\n");
}

/// A plate that stands on another one, tied by its part or by the node set of its lower edge; its second row of nodes
/// is near the joint.
RuleDeck standing_plate(const std::string& card1) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  const double z[] = {0, 2, 30};
  for (int row = 0; row < 3; ++row)
    for (int i = 0; i < 3; ++i) deck.node(51 + 10 * row + i, {3.0 + 6 * i, 5, z[row]});
  for (int row = 0; row < 2; ++row)
    for (std::int64_t n = 51 + 10 * row; n < 53 + 10 * row; ++n) deck.shell(n, 2, {n, n + 1, n + 11, n + 10});
  return deck.raw("SET_NODE_LIST", "7\n51,52,53\n").contact(1, "TIED_SHELL_EDGE_TO_SURFACE", card1);
}

/// Blocks of one material with edges of 4 and of 2, tied face to face, card 1 of the contact.
RuleDeck coarse_and_fine(const std::string& card1) {
  RuleDeck deck;
  deck.solid_part(1).solid_part(2).block(1, 1, 3, 3, 1, Vector(0, 0, 0), Vector(4, 4, 4));
  deck.block(101, 2, 6, 6, 1, Vector(0, 0, -2), Vector(2, 2, 2));
  return deck.contact(8, "TIED_SURFACE_TO_SURFACE", card1);
}

/// A plate glued onto a shell set that looks down or up.
RuleDeck glue_line(bool down) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 1, 1, Vector(1, 1, 1), 8, 8);
  deck.node(101, {0, 0, 0}).node(102, {10, 0, 0}).node(103, {10, 10, 0}).node(104, {0, 10, 0});
  deck.shell(101, 2,
             down ? std::vector<std::int64_t>{101, 104, 103, 102} : std::vector<std::int64_t>{101, 102, 103, 104});
  deck.raw("SET_SHELL_LIST", "9\n101\n");
  return deck.contact(6, "TIEBREAK_SURFACE_TO_SURFACE", "1,9,3,1", "0.\n1.,1.\n1.,1.\n");
}

}  // namespace

std::vector<PublishedCase> cases() {
  const std::string to_surface = "TIED_SURFACE_TO_SURFACE", edge = "TIED_SHELL_EDGE_TO_SURFACE";
  return {
      {"GC201", "node 13 of part 0: notfound", row_of_nodes("7"), row_of_nodes("8")},
      {"GC202", "offset, 0.5 where", glued_plates(edge + "_OFFSET", 0.5), glued_plates(edge + "_BEAM_OFFSET", 0.5)},
      {"GC203", "2 nodes (50, 51) cannot be tied: contact 3, which comes first in the deck, constrains them already",
       third_sheet("TIED_NODES_TO_SURFACE"), third_sheet("TIED_NODES_TO_SURFACE", "0.\n1.,1.\n\n\n\n\n0,0,1\n")},
      {"GC204", "sep, 0.5 where", glued_plates(to_surface, 0.5), glued_plates(to_surface + "_OFFSET", 0.5)},
      {"GC205", "type 6 ties 3 nodes of shells or beams by their translations alone", rib("TIED_NODES_TO_SURFACE"),
       rib(edge)},
      {"GC206", "9 nodes of rigid part 2", glued_plates(to_surface, 0.5, 1, 2),
       glued_plates(to_surface + "_OFFSET", 0.5, 1, 2)},
      {"GC207", "ties over 0.8 ", small_on_large("1.,1."), small_on_large("1.,1.,-1.")},
      {"GC208", "SST = -4 would tie", row_of_nodes("8", plain_cards, 3), row_of_nodes("8", "0.\n1.,1.,-4.\n", 3)},
      {"GC209", "of 6 nodes near the reference surface 3 stay untied", standing_plate("2,1,3,3"),
       standing_plate("7,1,4,3")},
      {"GC210", "MST = -4.5 is negative and SST = 0.001 is not", row_of_nodes("8", "0.\n1.,1.,0.001,-4.5\n"),
       row_of_nodes("8", "0.\n1.,1.,-4.5,0.001\n")},
      {"GC211", "2 times finer than the tracked side A (mean edges 2 and 4)", coarse_and_fine("1,2,3,3"),
       coarse_and_fine("2,1,3,3")},
      {"GC212", "the segment looks away from the 4 nodes tied there", glue_line(true), glue_line(false)},
  };
}

}  // namespace gapcheck::audit_test::published_ties
