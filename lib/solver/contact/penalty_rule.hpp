#pragma once
#include "contact/pair/release.hpp"
#include "solver/contact/node_rule.hpp"
#include "solver/contact/tracked_pairs.hpp"

namespace gapcheck::solver {

/// The rule of SOFT = 0 and 1. Stiffness, release and history are those of lib/contact.
class PenaltyRule final : public NodeRule {
 public:
  /// All references must outlive it.
  PenaltyRule(const ContactSetting& setting, const TrackedPairs& pairs)
      : scene_(pairs.scene()),
        springs_(setting.model, pairs.side(), setting.masses,
                 pairs.exchanged() ? scene_.contact.sfm : scene_.contact.sfs,
                 pairs.exchanged() || !pairs.two_sided() ? scene_.contact.sfs : scene_.contact.sfm,
                 setting.shared.stiffness) {}

  [[nodiscard]] bool keeps_initial_memory() const override { return true; }
  void set_timestep(double timestep) override { springs_.set_timestep(timestep); }
  [[nodiscard]] ContactSprings::Spring spring(SlotIndex slot, SegmentIndex segment) const override {
    return springs_(slot, segment);
  }
  [[nodiscard]] double release_depth(SlotIndex slot, SegmentIndex segment) const override {
    return contact::release_depth(scene_, slot, segment);
  }
  [[nodiscard]] contact::NodeAction decide_action(contact::NodeContact& memory,
                                                  const contact::NodeEncounter& encounter) const override {
    return contact::advance(memory, scene_.settings, encounter);
  }

 private:
  const contact::PairScene& scene_;
  ContactSprings springs_;
};

}  // namespace gapcheck::solver
