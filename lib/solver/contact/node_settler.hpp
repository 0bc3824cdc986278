#pragma once
#include "contact/definition/friction.hpp"
#include "contact/pair/node_contact.hpp"
#include "solver/contact/node_rule.hpp"
#include "solver/contact/pass_block.hpp"
#include "solver/contact/push_list.hpp"
#include "solver/contact/segment_finder.hpp"
#include "solver/contact/tracked_pairs.hpp"
#include "solver/interface/contact_setting.hpp"

namespace gapcheck::solver {

/// Applies the rule of a contact to a tracked node whose position relative to the segments is known: updates its memory
/// and its spring.
class NodeSettler {
 public:
  /// `contact`: position in Model::contacts. All references must outlive it.
  NodeSettler(const ContactSetting& setting, ContactIndex contact, TrackedPairs& pairs, NodeRule& rule);

  /// Sets the state of the node at a place for this cycle. Adds its force to `pushes`, and its work, move and counts to
  /// `block`.
  void settle_node(std::size_t place, NodeMeeting& meeting, const State& state, PassBlock& block, PushList& pushes);

  /// Call after the nodes of a cycle: from the next one on they may have been followed.
  void end_cycle() { fresh_ = false; }
  /// The contact is not active: what penetrates when it becomes active is found suddenly.
  void forget() { fresh_ = true; }
  void continue_from(const NodeSettler& before) { fresh_ = before.fresh_; }
  /// No cycle has ended since the contact has become active.
  [[nodiscard]] bool fresh() const { return fresh_; }

 private:
  [[nodiscard]] contact::NodeEncounter encounter_of(SlotIndex slot, const NodeMeeting& meeting, TrackedNode& tracked,
                                                    const State& state) const;
  /// Whether the segment had the node in sight in the cycle before.
  [[nodiscard]] bool was_followed(SlotIndex slot, SegmentIndex segment, const State& state) const;
  /// Makes it the link at the closest point, without forces.
  void set_link(const SegmentContact& contact, SegmentLink& link) const;
  /// Parameters of the node's spring; its link must be set.
  [[nodiscard]] LinkSpring law_of(SlotIndex slot, const TrackedNode& tracked, const Vector& velocity) const;

  const model::Mesh& mesh_;
  const std::vector<bool>& movable_;
  TrackedPairs& pairs_;
  const contact::PairScene& scene_;
  NodeRule& rule_;
  contact::Friction friction_;
  bool fresh_ = true;  ///< no cycle since the contact has become active
};

}  // namespace gapcheck::solver
