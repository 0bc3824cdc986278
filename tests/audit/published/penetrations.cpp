#include "audit/published/cases.hpp"

namespace gapcheck::audit_test::published_penetrations {
namespace {

const std::string all_parts = "0,0,5,0";

/// Two plates of 2 x 2 shells of 10 x 10, the second one shifted by this vector; `t`: thickness of both.
RuleDeck two_plates(double t, const Vector& shift) {
  RuleDeck deck;
  deck.shell_part(1, t).shell_part(2, t).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  return deck.plate(101, 2, 2, 2, shift, 10, 10);
}

/// A plate and a shell that stands on it or passes through it, its lower edge at this height.
RuleDeck standing_shell(double height) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  deck.node(101, {4, 3, height}).node(102, {4, 8, height}).node(103, {4, 8, height + 8}).node(104, {4, 3, height + 8});
  return deck.shell(101, 2, {101, 102, 103, 104}).contact(1, "AUTOMATIC_SINGLE_SURFACE", all_parts);
}

/// A bar of bricks in a block of concrete, or, if `beside`, next to it.
RuleDeck bar_in_block(bool beside) {
  RuleDeck deck;
  deck.solid_part(1).solid_part(2).block(1, 1, 3, 3, 3, Vector(0, 0, 0), Vector(50, 50, 50));
  deck.block(1001, 2, 1, 1, 10, Vector(beside ? 200 : 71, 71, 20), Vector(8, 8, 11));
  return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", all_parts);
}

/// Segments 0.07 long and a contact distance of 1, as in the run; a node beside the edge, at this parametric
/// coordinate.
RuleDeck beside_an_edge(double parameter) {
  RuleDeck deck;
  deck.shell_part(1, 0.01).plate(1, 1, 3, 3, Vector(0, 0, 0), 0.07, 0.07);
  deck.node(50, Vector(0.21 + (parameter - 1) * 0.035, 0.1, 0.2)).raw("SET_NODE_LIST", "7\n50\n");
  return deck.contact(1, "AUTOMATIC_NODES_TO_SURFACE", "7,1,4,3", "0.\n1.,1.,1.,1.\n");
}

/// A cube of 10 whose lowest nodes are at z = 1, and a floor.
RuleDeck cube_over_floor(double floor) {
  RuleDeck deck;
  deck.solid_part(1).block(1, 1, 1, 1, 1, Vector(0, 0, 1), Vector(10, 10, 10));
  return deck.raw("RIGIDWALL_PLANAR", fmt::format("0\n0.,0.,{},0.,0.,{},0.5\n", floor, floor + 1));
}

/// A node between two sheets: it is moved out of the upper one and lands in the lower one.
RuleDeck sandwich(double high) {
  RuleDeck deck;
  for (int part = 1; part <= 3; ++part) deck.shell_part(part, 1);
  deck.plate(1, 1, 3, 3, Vector(0, 0, 0), 4, 4).plate(101, 2, 1, 1, Vector(4.5, 4.5, 0.7), 4, 4);
  deck.plate(201, 3, 3, 3, Vector(0, 0, high), 4, 4).raw("SET_PART_LIST", "1\n1,3\n");
  return deck.contact(7, "AUTOMATIC_NODES_TO_SURFACE", "2,1,3,2", "0.\n1.,1.\n0\n");
}

/// A block shrunk onto another one: curve 1 for dynamic relaxation from 0 to 1, curve 2 for the run.
RuleDeck shrink_fit(const std::string& keyword, double overlap) {
  RuleDeck deck;
  deck.solid_part(1).solid_part(2).block(1, 1, 3, 3, 1, Vector(0, 0, 0), Vector(4, 4, 4));
  deck.block(201, 2, 1, 1, 1, Vector(4, 4, 4 - overlap), Vector(4, 4, 4));
  deck.raw("DEFINE_CURVE", "1,1\n0.,0.\n0.001,1.\n0.01,1.\n").raw("DEFINE_CURVE", "2\n0.,1.\n1.,1.\n");
  const bool interference = keyword.ends_with("INTERFERENCE");
  return deck.contact(3, keyword, "2,1,3,3", interference ? "0.\n1.,1.\n1,2\n" : "0.\n1.,1.\n");
}

/// A thin brick over a plate; the tie's node set holds its upper nodes.
RuleDeck brick_tied_upside_down(const std::string& nodes) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  deck.solid_part(2).block(101, 2, 1, 1, 1, Vector(3, 4, 0.3), Vector(2, 2, 0.2));
  return deck.raw("SET_NODE_LIST", "7\n" + nodes + "\n").contact(3, "TIED_NODES_TO_SURFACE", "7,1,4,3");
}

RuleDeck with_contact(RuleDeck deck, const std::string& keyword, const std::string& cards = "0.\n1.,1.\n") {
  return deck.contact(1, keyword, all_parts, cards);
}

}  // namespace

std::vector<PublishedCase> cases() {
  const std::string general = "AUTOMATIC_GENERAL", single = "AUTOMATIC_SINGLE_SURFACE", soft_2 = "0.\n1.,1.\n2\n";
  return {
      {"GC103", "shell 1 (part 1) and shell 101 (part 2) cross along 5, from (4, 3, 0) to (4, 8, 0)",
       standing_shell(-4), standing_shell(1)},
      {"GC104", "the edge 3-6 of shell 2 (part 1) and the edge 101-102 of shell 101 (part 2) cross at (20, 5, 0)",
       with_contact(two_plates(1, {15, 5, 0}), general), with_contact(two_plates(1, {15, 5, 1}), general)},
      {"GC105", "10 solids of part 2 (from solid 1001 on) lie wholly inside part 1", bar_in_block(false),
       bar_in_block(true)},
      {"GC106", "node 50 of part 0 is 0.7987 inside element 6", beside_an_edge(1.654), beside_an_edge(1.281)},
      {"GC107", "node 5 of part 1 is 0.3 inside element 101: kept",
       with_contact(two_plates(1, {2, 3, 0.7}), single, soft_2),
       with_contact(two_plates(1, {2, 3, 1}), single, soft_2)},
      {"GC108", "node 5 of part 1 is 0.3 inside element 101: kept",
       with_contact(two_plates(1, {2, 3, 0.7}), "AUTOMATIC_SINGLE_SURFACE_MORTAR"),
       with_contact(two_plates(1, {2, 3, 1}), "AUTOMATIC_SINGLE_SURFACE_MORTAR")},
      {"GC109", "node 3 of part 1 is 0.4 inside element 101: forced",
       with_contact(two_plates(1, {15, 5, 0.6}), general), with_contact(two_plates(1, {15, 5, 1}), general)},
      {"GC110", "is 0.5 deep in rigid wall 1", cube_over_floor(1.5), cube_over_floor(0)},
      {"GC112",
       "node 101 (part 2), moved by 0.350099 out of element 205 (part 3), lands 0.650099 inside the contact distance 1 "
       "of element 5",
       sandwich(1.3506), sandwich(3)},
      {"GC113",
       "8 nodes up to 0.02 deep (node 22); in dynamic relaxation the springs grow with curve 1 from 0 to 1 at t = "
       "0.001, in the run they are scaled by 1 all the time (curve 2)",
       shrink_fit("SURFACE_TO_SURFACE_INTERFERENCE", 0.02), shrink_fit("SURFACE_TO_SURFACE", 0)},
      {"GC114", "solid 101 is turned inside out", brick_tied_upside_down("105,106,107,108"),
       brick_tied_upside_down("101,102,103,104")},
  };
}

}  // namespace gapcheck::audit_test::published_penetrations
