#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "solver/contact/contact_forces.hpp"
#include "solver/loss/bodies.hpp"
#include "solver/loss/flight.hpp"
#include "solver/loss/meetings.hpp"

namespace gapcheck::solver {

/// A meeting with the spring that the run puts there.
struct Impact {
  NodePass pass;
  Meeting meeting;
  NodeIndex node;
  model::SegmentNodes corners;
  PartIndex part = none<PartIndex>, other_part = none<PartIndex>;  ///< of the node, of the segment
  ContactSprings::Spring spring;
  double release = 0;  ///< depth at which the contact lets the node go
  double contact_distance = 0;
  [[nodiscard]] double time() const { return meeting.contact.time; }
  [[nodiscard]] double speed() const { return meeting.contact.speed(); }
  /// How much a node may come closer in one step: 0.8 of the contact distance, and less than what releases it.
  [[nodiscard]] double way_of_one_step() const;

  // What judge_impacts() finds out.
  std::size_t group = 0;            ///< those between two bodies have one number
  double mobility = 0;              ///< 1 / mass that the spring stops, alone or with those of its group
  bool together = false;            ///< the springs of its group that meet first stop one mass
  bool first = false;               ///< it meets at the time of its group's first ones
  std::optional<double> margin;     ///< release over depth, where both move as one mass
  std::optional<double> alone;      ///< the same of the node's own mass, where they do not
  std::optional<double> low, high;  ///< bounds of it
  std::string_view reason;          ///< why it is not exact or not known; empty: it is exact
};

/// What the judgement needs to know about the run.
struct ImpactScene {
  const ConnectedBodies& bodies;
  const Flight& flight;
  const State& state;
  double step = 0;               ///< of the run
  std::set<std::uint32_t> busy;  ///< bodies that contacts act on from the start on
};

/// Judges all impacts of a run, group by group.
void judge_impacts(const ImpactScene& scene, std::vector<Impact>& impacts);

}  // namespace gapcheck::solver
