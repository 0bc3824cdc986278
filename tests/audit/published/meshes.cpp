#include "audit/published/cases.hpp"

namespace gapcheck::audit_test::published_meshes {
namespace {

RuleDeck in_contact(RuleDeck deck) { return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0"); }

/// One shell with these corners.
RuleDeck quadrilateral(const std::array<Vector, 4>& corners) {
  RuleDeck deck;
  deck.shell_part(1, 0.5);
  for (int i = 0; i < 4; ++i) deck.node(1 + i, corners[i]);
  return in_contact(deck.shell(1, 1, {1, 2, 3, 4}));
}

/// Two halves of one part, joined or only beside each other.
RuleDeck halves(bool joined) {
  RuleDeck deck;
  deck.shell_part(1, 1);
  if (joined) return in_contact(deck.plate(1, 1, 4, 4, Vector(0, 0, 0), 5, 5));
  return in_contact(deck.plate(1, 1, 2, 4, Vector(0, 0, 0), 5, 5).plate(101, 1, 2, 4, Vector(10, 0, 0), 5, 5));
}

/// A segment set of a tool and the tool's shells: two triangles where the set has a quad, or the quad.
RuleDeck tool(bool split) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 5), 5, 5);
  deck.node(101, {0, 0, 0}).node(102, {10, 0, 0}).node(103, {10, 10, 0}).node(104, {0, 10, 0});
  if (split)
    deck.shell(101, 2, {101, 102, 103}).shell(102, 2, {101, 103, 104});
  else
    deck.shell(101, 2, {101, 102, 103, 104});
  deck.raw("SET_SEGMENT", "4\n101,102,103,104\n");
  return deck.contact(3, "AUTOMATIC_SURFACE_TO_SURFACE", "1,4,3,0");
}

/// A brick, its lower and upper faces in the order of the manual or exchanged.
RuleDeck brick(bool inside_out) {
  RuleDeck deck;
  deck.solid_part(1);
  for (int k = 0; k < 2; ++k)
    deck.node(1 + 4 * k, {0, 0, 1.0 * k})
        .node(2 + 4 * k, {1, 0, 1.0 * k})
        .node(3 + 4 * k, {1, 1, 1.0 * k})
        .node(4 + 4 * k, {0, 1, 1.0 * k});
  using Nodes = std::array<std::int64_t, 8>;
  return in_contact(deck.solid(1, 1, inside_out ? Nodes{5, 6, 7, 8, 1, 2, 3, 4} : Nodes{1, 2, 3, 4, 5, 6, 7, 8}));
}

}  // namespace

std::vector<PublishedCase> cases() {
  const Vector a(0, 0, 0), b(10, 0, 0), c(10, 10, 0), d(0, 10, 0);
  return {
      {"GC504", "shell 1 of part 1 is warped by 30.5 degrees", quadrilateral({a, b, Vector(10, 10, 4), d}),
       quadrilateral({a, b, Vector(10, 10, 1), d})},
      {"GC505", "shell 1 of part 1 crosses itself (bow-tie)", quadrilateral({a, b, d, c}), quadrilateral({a, b, c, d})},
      {"GC507", "nodes 3 and 101 of part 1 are at the same place", halves(false), halves(true)},
      {"GC509", "segment 101 102 103 104 is not a face", tool(true), tool(false)},
      {"GC510", "solid 1 of part 1 is turned inside out", brick(true), brick(false)},
      {"GC511", "shell 1 of part 1 is 5.77 times as large as shell 3", two_densities(0.3), two_densities(5)},
  };
}

}  // namespace gapcheck::audit_test::published_meshes
