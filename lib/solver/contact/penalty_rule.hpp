#pragma once
#include "contact/pair/release.hpp"
#include "solver/contact/node_rule.hpp"
#include "solver/contact/tracked_pairs.hpp"

namespace gapcheck::solver {

/// The rule of SOFT = 0 and 1. Stiffness, release and history are those of lib/contact. INTERFERENCE contacts have no
/// history: no node is moved or forgiven, and the curves LCID2, in dynamic relaxation LCID1, scale the stiffness over
/// time.
class PenaltyRule final : public NodeRule {
 public:
  /// All references must outlive it.
  PenaltyRule(const ContactSetting& setting, const TrackedPairs& pairs)
      : scene_(pairs.scene()),
        springs_(setting.model, pairs.side(), setting.masses,
                 pairs.exchanged() ? scene_.contact.sfm : scene_.contact.sfs,
                 pairs.exchanged() || !pairs.two_sided() ? scene_.contact.sfs : scene_.contact.sfm,
                 setting.shared.stiffness),
        interference_(scene_.type.can(contact::Ability::interference)) {
    const auto curve_of = [&](std::int64_t id) {
      const auto curve = setting.model.curves.find(id);
      return interference_ && curve != setting.model.curves.end() ? &curve->second : nullptr;
    };
    growth_ = curve_of(scene_.contact.interference_curve);
    growth_in_relaxation_ = curve_of(scene_.contact.interference_curve_relaxation);
  }

  [[nodiscard]] bool keeps_initial_memory() const override { return !interference_; }
  void set_timestep(double timestep) override { springs_.set_timestep(timestep); }
  bool begin_cycle(const State& state) override {
    if (growth_ == nullptr && growth_in_relaxation_ == nullptr) return false;
    const model::Curve* const curve = state.relaxing ? growth_in_relaxation_ : growth_;
    const double now = curve != nullptr ? curve->at(state.time / curve->abscissa_time) : 1;
    factor_ = {known_ ? factor_.now : now, now};
    const bool changed = !known_ || factor_.before != now;
    known_ = true;
    return changed;
  }
  [[nodiscard]] SpringGrowth growth() const override { return factor_; }
  void forget() override { known_ = false; }
  [[nodiscard]] ContactSprings::Spring spring(SlotIndex slot, SegmentIndex segment) const override {
    ContactSprings::Spring spring = springs_(slot, segment);
    spring.stiffness *= factor_.now;
    return spring;
  }
  [[nodiscard]] double release_depth(SlotIndex slot, SegmentIndex segment) const override {
    return contact::release_depth(scene_, slot, segment);
  }
  [[nodiscard]] contact::NodeAction decide_action(contact::NodeContact& memory,
                                                  const contact::NodeEncounter& encounter) const override {
    return interference_ ? contact::advance_interference(memory, encounter)
                         : contact::advance(memory, scene_.settings, encounter);
  }

 private:
  const contact::PairScene& scene_;
  ContactSprings springs_;
  bool interference_;
  /// Of the stiffness over time; null: none.
  const model::Curve *growth_ = nullptr, *growth_in_relaxation_ = nullptr;
  SpringGrowth factor_;  ///< its values
  bool known_ = false;   ///< the value is that of an earlier cycle
};

}  // namespace gapcheck::solver
