#pragma once
#include <fmt/format.h>

#include <string>

#include "solver/structure_of.hpp"

namespace gapcheck::solver {

/// Constant velocities of an element's nodes: (a x + shear y, b y, c z).
struct Stretch {
  double a = 0, b = 0, c = 0, shear = 0;
};

/// Motion of the first `nodes` nodes of brick_bar(1, …) or plate(1, 1, …) with sides of 1; curve 99. Shells are held
/// against turning.
inline std::string stretching(const Stretch& s, bool solid) {
  std::string text = "*DEFINE_CURVE\n99\n0.,1.\n1e6,1.\n";
  for (int id = 1; id <= (solid ? 8 : 4); ++id) {
    const int x = (id - 1) % 2, y = (id - 1) / 2 % 2, z = (id - 1) / 4;
    for (const auto& [freedom, v] : {std::pair(1, s.a * x + s.shear * y), {2, s.b * y}, {3, s.c * z}})
      text += v == 0 ? fmt::format("*BOUNDARY_SPC_NODE\n{},0,{},{},{}\n", id, freedom == 1 ? 1 : 0,
                                   freedom == 2 ? 1 : 0, freedom == 3 ? 1 : 0)
                     : fmt::format("*BOUNDARY_PRESCRIBED_MOTION_NODE\n{},{},0,99,{}\n", id, freedom, v);
    if (!solid) text += fmt::format("*BOUNDARY_SPC_NODE\n{},0,0,0,0,1,1,1\n", id);
  }
  return text;
}

/// A cube of side 1 as part 1 whose nodes move so until `end`; `cards`: material 1 and whatever else.
inline std::string stretched_cube(const std::string& cards, const Stretch& s, double end, int elform = 1,
                                  int equation_of_state = 0) {
  return brick_bar(1, {1, 1, 1}) +
         fmt::format("*SECTION_SOLID\n1,{}\n*PART\np\n1,1,1,{}\n*CONTROL_TERMINATION\n{}\n", elform, equation_of_state,
                     end) +
         cards + stretching(s, true);
}

/// A square of side 1 and thickness 0.1 with three layers, likewise.
inline std::string stretched_square(const std::string& cards, const Stretch& s, double end, int elform = 2) {
  return plate(1, 1, {1, 1, 0}) +
         fmt::format("*SECTION_SHELL\n1,{},,3\n0.1\n*PART\np\n1,1,1\n*CONTROL_TERMINATION\n{}\n", elform, end) + cards +
         stretching(s, false);
}

}  // namespace gapcheck::solver
