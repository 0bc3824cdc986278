#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "solver/element/beam_elements.hpp"
#include "solver/element/shell_elements.hpp"
#include "solver/element/solid_elements.hpp"
#include "solver/rigid/rigid_bodies.hpp"
#include "solver/state/constraints.hpp"
#include "solver/state/state.hpp"
#include "solver/thick/thick_shell_elements.hpp"

namespace gapcheck::solver {

/// Elements, masses and constraints of a structure at rest or in motion at time 0.
struct Structure {
  State state;
  ShellElements shells;
  SolidElements solids;
  BeamElements beams;
  ThickShellElements thick_shells;
  RigidBodies rigid;
  Constraints constraints;                         ///< of nodes outside rigid bodies
  std::map<std::int64_t, std::size_t> body_of_id;  ///< rigid bodies by the ids of their parts or nodal rigid bodies
  double added_mass = 0;                           ///< by mass scaling
  // Ids as in the deck, for messages.
  std::vector<std::int64_t> node_id, shell_id, solid_id, beam_id, thick_shell_id;
};

}  // namespace gapcheck::solver
