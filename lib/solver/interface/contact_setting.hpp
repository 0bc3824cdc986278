#pragma once
#include <vector>

#include "contact/pair/tied_pairs.hpp"
#include "contact/search/search.hpp"
#include "solver/interface/contact_spring.hpp"
#include "solver/interface/contact_state.hpp"

namespace gapcheck::solver {

/// What contacts with the same side share.
struct SharedTables {
  contact::NeighbourCache neighbours;
  StiffnessCache stiffness;
};

/// What all passes of a run share. All references must outlive them.
struct ContactSetting {
  const model::Model& model;
  const ContactMasses& masses;
  const contact::CandidateSearch& search;
  const contact::TiedPairs& ties;
  const std::vector<bool>& movable;  ///< by node: the shooting-node logic may move it
  SharedTables& shared;
  std::vector<ShotNode>* shot = nullptr;  ///< gets the nodes that are moved, in that order; null: nobody asks
};

}  // namespace gapcheck::solver
