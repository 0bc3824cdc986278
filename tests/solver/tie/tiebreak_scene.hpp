#pragma once
#include <fmt/format.h>

#include <string>

namespace gapcheck::solver::tiebreak_scene {

inline constexpr double half_thickness = 0.05;

/// Node 5 of mass 1 in touch with the middle of a held shell of 1 by 1, tied by `contact` (keyword, card 4). `drive`:
/// what moves the node; curve 1 is `curve`.
inline std::string node_on_shell(const std::string& keyword, const std::string& card, const std::string& drive,
                                 const std::string& curve, double end) {
  return fmt::format(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.5,0.5,{}\n*ELEMENT_SHELL\n1,1,1,2,3,4\n"
      "*ELEMENT_MASS\n5,5,1.\n*PART\np\n1,1,1\n*SECTION_SHELL\n1,2\n0.1\n*MAT_ELASTIC\n1,1.,1000.,0.25\n"
      "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n2,0,1,1,1,1,1,1\n3,0,1,1,1,1,1,1\n4,0,1,1,1,1,1,1\n"
      "*SET_NODE_LIST\n1\n5\n*CONTACT_{}\n1,1,4,3\n0.\n1.,1.\n{}\n*DEFINE_CURVE\n1\n{}{}"
      "*CONTROL_TERMINATION\n{}\n",
      half_thickness, keyword, card, curve, drive, end);
}

inline const std::string old_type = "TIEBREAK_NODES_TO_SURFACE", automatic = "AUTOMATIC_NODES_TO_SURFACE_TIEBREAK";

}  // namespace gapcheck::solver::tiebreak_scene
