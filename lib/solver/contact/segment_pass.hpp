#pragma once
#include <cstdint>
#include <vector>

#include "solver/contact/contact_pass.hpp"

namespace gapcheck::solver {

/// Segment-based contact (SOFT = 2): the corners of one side's segments in the other side's segments; both ways make
/// all corners of each pair. Every segment gives each of its corners its share of the pair's stiffness, so the node's
/// spring follows its part of the surface. What is deep at the start is the baseline; nothing is moved or released, and
/// a node that has passed a shell is still pushed back to where it came from.
class SegmentPass : public ContactPass {
 public:
  SegmentPass(const ContactSetting& setting, std::uint32_t contact, const contact::ContactSurfaces& surfaces,
              bool exchanged, const std::vector<Vector>& x);

  void remember(const Penetration& /*record*/, const contact::NodeContact& /*memory*/) override {}
  void set_timestep(double timestep) override;
  double update(State& state, double used, ContactCounters& counters) override;
  void carry_over(InterfacePass& before, const State& state, ContactState& result) override;
  void rest(const State& state, ContactState& result) override;

 protected:
  [[nodiscard]] ContactSprings::Spring spring(std::uint32_t slot, std::uint32_t segment) const override;
  [[nodiscard]] double release_depth(std::uint32_t slot, std::uint32_t segment) const override;
  void orient(std::uint32_t slot, Contact* contact) override;
  [[nodiscard]] contact::NodeAction advance(contact::NodeContact& memory,
                                            const contact::NodeEncounter& encounter) const override;

 private:
  /// A segment at a tracked node: mass, and scale over its number of corners.
  struct Own {
    double mass = 0, share = 0;
  };
  /// Where a tracked node was when last seen in the zone.
  struct Side {
    static constexpr std::uint32_t unknown = 0xffffffffu;
    Vector direction = Vector::Zero();  ///< from the segment to the node; zero: it was outside
    std::uint32_t segment = unknown;
  };
  /// Whether a node in `direction` of a segment is on the other side of the surface than it was.
  [[nodiscard]] bool passed(const Side& before, std::uint32_t segment, const Vector& direction) const;
  const model::Model& model_;
  const std::vector<double>& node_mass_;
  std::vector<std::uint32_t> start_;  // by slot: position in own_
  std::vector<Own> own_;
  std::vector<double> mass_;  // by segment
  std::vector<Side> side_;    // by slot
  double timestep_ = 0, reduction_ = 0;
  bool first_ = true;  ///< no cycle since the contact has become active
};

}  // namespace gapcheck::solver
