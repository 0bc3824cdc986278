#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/definition/friction.hpp"
#include "contact/pair/candidates.hpp"
#include "contact/pair/node_contact.hpp"
#include "contact/pair/side_scene.hpp"
#include "solver/constraint/constraint_solve.hpp"

namespace gapcheck::solver {

/// One side's nodes against the other side's segments of a constraint contact, on coordinates set from outside.
/// lib/contact decides which segment a node contacts and what happens to it.
class ConstraintPass {
 public:
  /// `x`: the coordinates used by every call; initial ones at construction. All references must outlive it.
  ConstraintPass(const model::Model& model, ContactIndex contact, const contact::ContactSurfaces& surfaces,
                 bool exchanged, const contact::CandidateSearch& search, const contact::TiedPairs& ties,
                 const std::vector<bool>& movable, const std::vector<Vector>& x);
  ConstraintPass(const ConstraintPass&) = delete;
  ConstraintPass& operator=(const ConstraintPass&) = delete;

  /// Global search, valid until anything has come closer to anything else by `margin`.
  void find_candidates(double margin);

  struct Move {
    NodeIndex node;
    Vector way;
  };
  /// Nodes that are now behind the surface, and how they return to it. Nodes that are too deep are released; with
  /// IGNORE a depth is forgiven.
  [[nodiscard]] std::vector<Move> find_moves();

  /// A node that is behind a segment.
  struct Hit {
    SlotIndex slot;
    double depth = 0;              ///< beyond what is forgiven
    SurfaceConstraint constraint;  ///< without depth and slip
    double area = 0;               ///< of the segment
    model::FrictionLaw friction;
  };
  /// Nodes that are behind the surface and not released, ascending by slot.
  [[nodiscard]] std::vector<Hit> find_hits();

  /// Takes over what a pass on other surfaces of the same contact remembers about its nodes.
  void continue_from(const ConstraintPass& before);
  /// Forgets everything; the contact is not active.
  void deactivate();
  [[nodiscard]] std::uint64_t released() const;
  [[nodiscard]] bool exchanged() const { return exchanged_; }
  [[nodiscard]] const contact::SideScene& side() const { return side_; }
  /// Adds the nodes that are released.
  void add_released(std::vector<ContactNode>& nodes) const;

 private:
  struct Memory {
    contact::NodeContact contact;
    SegmentIndex segment;
    double penetration = 0;
  };
  struct Meeting;
  [[nodiscard]] Meeting find_meeting(SlotIndex slot, std::span<const contact::Candidate> candidates) const;
  [[nodiscard]] Hit hit_of(SlotIndex slot, const Meeting& meeting) const;

  const model::Model& model_;
  contact::SideScene side_;
  const contact::PairScene& scene_;
  contact::Exclusions exclusions_;
  contact::PairRules rules_;
  contact::Friction friction_;
  const contact::CandidateSearch& search_;
  const std::vector<bool>& movable_;
  bool exchanged_;
  double default_tolerance_ = -1;
  contact::CandidateTable candidates_;
  std::vector<Memory> memory_;  // by slot
};

}  // namespace gapcheck::solver
