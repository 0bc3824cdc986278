#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/pair/candidates.hpp"
#include "contact/definition/friction.hpp"
#include "contact/pair/node_contact.hpp"
#include "contact/pair/side_scene.hpp"
#include "solver/constraint/constraint_solve.hpp"

namespace gapcheck::solver {

/// One side's nodes against the other side's segments of a constraint contact, on coordinates that others set. Which
/// segment a node meets, and what becomes of it, is decided by lib/contact.
class ConstraintPass {
 public:
  /// `x`: the coordinates that count whenever something is asked for; of the start when it is built. All references
  /// must outlive it.
  ConstraintPass(const model::Model& model, std::uint32_t contact, const contact::ContactSurfaces& surfaces,
                 bool exchanged, const contact::CandidateSearch& search, const contact::TiedPairs& ties,
                 const std::vector<bool>& movable, const std::vector<Vector>& x);
  ConstraintPass(const ConstraintPass&) = delete;
  ConstraintPass& operator=(const ConstraintPass&) = delete;

  /// Global search, good until anything has come closer to anything else by `margin`.
  void search(double margin);

  struct Move {
    NodeIndex node;
    Vector way;
  };
  /// Nodes that are behind the surface now, and how they come back onto it. What is too deep is released; with IGNORE a
  /// depth is forgiven.
  [[nodiscard]] std::vector<Move> inside();

  /// A node that is behind a segment.
  struct Hit {
    std::uint32_t slot = 0;
    double depth = 0;              ///< beyond what is forgiven
    SurfaceConstraint constraint;  ///< without depth and slip
    double area = 0;               ///< of the segment
    model::FrictionLaw friction;
  };
  /// Nodes that are behind the surface and not released, ascending by slot.
  [[nodiscard]] std::vector<Hit> hits();

  /// Takes over what a pass on other surfaces of the same contact remembers of its nodes.
  void carry_over(const ConstraintPass& before);
  /// Forgets all; the contact is not active.
  void rest();
  [[nodiscard]] std::uint64_t released() const;
  [[nodiscard]] bool exchanged() const { return exchanged_; }
  [[nodiscard]] const contact::SideScene& side() const { return side_; }
  /// Adds the nodes that are released.
  void add_released(std::vector<ContactNode>& nodes) const;

 private:
  struct Memory {
    contact::NodeContact contact;
    std::uint32_t segment = 0;
    double penetration = 0;
  };
  struct Meeting;
  [[nodiscard]] Meeting meet(std::uint32_t slot, std::span<const contact::Candidate> candidates) const;
  [[nodiscard]] Hit hit(std::uint32_t slot, const Meeting& meeting) const;

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
