#pragma once
#include <limits>
#include <vector>

#include "base/diagnostic.hpp"
#include "solver/contact/node_rule.hpp"
#include "solver/contact/tracked_pairs.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// The force of RIGID types on a node over its penetration, by curves. Source: LS-DYNA Keyword User's Manual, Vol. I,
/// *CONTACT, card 4 of RIGID types.
struct CurveForce {
  const model::Curve* loading = nullptr;    ///< LCID
  const model::Curve* unloading = nullptr;  ///< UNLCID; nullptr: none
  const model::Curve* damping = nullptr;    ///< LCDC; nullptr: none
  double unloading_stiffness = 0;           ///< US; 0: back along the curve
  double damping_scale = 1;                 ///< DSF
  /// At a depth, the deepest so far in this contact. On the way back the force falls with US, not below UNLCID or zero.
  [[nodiscard]] double at(double depth, double deepest) const;
  /// Damping constant at a speed of penetration.
  [[nodiscard]] double damping_at(double closing) const;
};

/// The rule of RIGID types: every penetration gives force at once, by curves; nothing is moved, forgiven or released.
class CurveRule final : public NodeRule {
 public:
  /// All references must outlive it.
  CurveRule(const ContactSetting& setting, const TrackedPairs& pairs);

  [[nodiscard]] bool keeps_initial_memory() const override { return false; }
  [[nodiscard]] bool has_memory() const override { return true; }
  void set_timestep(double /*timestep*/) override {}
  [[nodiscard]] ContactSprings::Spring spring(SlotIndex /*slot*/, SegmentIndex /*segment*/) const override {
    return {};
  }
  [[nodiscard]] double release_depth(SlotIndex /*slot*/, SegmentIndex /*segment*/) const override {
    return std::numeric_limits<double>::infinity();
  }
  void bring_back(SlotIndex slot, SegmentContact* contact) override {
    if (contact == nullptr) deepest_[slot.value] = 0;
  }
  [[nodiscard]] contact::NodeAction decide_action(contact::NodeContact& memory,
                                                  const contact::NodeEncounter& encounter) const override {
    return contact::advance_interference(memory, encounter);
  }
  void bend(SlotIndex slot, double depth, double closing, LinkSpring& law) override;
  void continue_from(const NodeRule& before) override;
  void forget() override { deepest_.assign(deepest_.size(), 0); }

 private:
  CurveForce force_;
  std::vector<double> area_;     ///< by slot; 1 where the curve gives forces
  std::vector<double> deepest_;  ///< by slot, since it last was outside
};

/// Whether the type's force is that of a curve.
[[nodiscard]] bool acts_by_curve(const model::Contact& contact);
/// Why a RIGID contact is not calculated; empty if it is.
[[nodiscard]] std::string_view curve_not_calculated(const model::Contact& contact);
/// Curves that are missing or of no use, and values that contradict each other.
[[nodiscard]] SolverStatus check_curve_contact(const model::Model& model, const model::Contact& contact);

}  // namespace gapcheck::solver
