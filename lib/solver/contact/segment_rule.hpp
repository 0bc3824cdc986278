#pragma once
#include <cstdint>
#include <vector>

#include "solver/contact/node_rule.hpp"
#include "solver/contact/tracked_pairs.hpp"

namespace gapcheck::solver {

/// The rule of segment-based contact (SOFT = 2): the corners of one side's segments in the other side's segments; both
/// ways make all corners of each pair. Every segment gives each of its corners its share of the pair's stiffness, so
/// the node's spring follows its share of the surface; segments that do not face the other one, such as the sides of a
/// block beside the face that it stands on, give less or nothing. A pair keeps the spring that it began with. The
/// initial depth is the baseline; nothing is moved or released, and a node that has passed a shell is still pushed back
/// to where it came from.
class SegmentRule final : public NodeRule {
 public:
  /// All references must outlive it.
  SegmentRule(const ContactSetting& setting, const TrackedPairs& pairs);

  [[nodiscard]] bool keeps_initial_memory() const override { return false; }
  void set_timestep(double timestep) override { timestep_ = timestep; }
  bool begin_cycle(const State& state) override;
  [[nodiscard]] ContactSprings::Spring spring(SlotIndex slot, SegmentIndex segment) const override;
  [[nodiscard]] double release_depth(SlotIndex slot, SegmentIndex segment) const override;
  void bring_back(SlotIndex slot, SegmentContact* contact) override;
  [[nodiscard]] contact::NodeAction decide_action(contact::NodeContact& memory,
                                                  const contact::NodeEncounter& encounter) const override;
  void continue_from(const NodeRule& before) override;
  void forget() override;

 private:
  /// A segment at a tracked node: mass, and scale over its number of corners. None: the node has no segment.
  struct Own {
    SegmentIndex segment = none<SegmentIndex>;
    double mass = 0, share = 0;
  };
  /// How much a segment at a node faces the other side's segment with this normal: 1 if it looks at it, 0 across.
  [[nodiscard]] double facing(SegmentIndex own, const Vector& normal) const;
  /// Where a tracked node was when last in the zone.
  struct Side {
    Vector direction = Vector::Zero();          ///< from the segment to the node; zero: it was outside
    SegmentIndex segment = none<SegmentIndex>;  ///< none: not known
  };
  /// Whether a node in `direction` of a segment is on the other side of the surface than it was.
  [[nodiscard]] bool passed(const Side& before, SegmentIndex segment, const Vector& direction) const;

  const model::Model& model_;
  const contact::PairScene& scene_;
  const contact::Segments& own_segments_;
  const std::vector<double>& node_mass_;
  std::vector<std::uint32_t> start_;  // by slot: position in own_
  std::vector<Own> own_;
  std::vector<double> mass_;  // by segment
  std::vector<Side> side_;    // by slot
  double timestep_ = 0, reduction_ = 0;
};

}  // namespace gapcheck::solver
