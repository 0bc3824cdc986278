#pragma once
#include <cstdint>
#include <vector>

#include "contact/search/box_pairs.hpp"
#include "solver/contact/contact_forces.hpp"
#include "solver/contact/contact_pass.hpp"
#include "solver/loss/flight.hpp"
#include "solver/loss/time_of_contact.hpp"

namespace gapcheck::solver {

/// One pass of a run over the nodes of a contact.
struct NodePass {
  ContactIndex contact;
  const ContactInterface* interface = nullptr;
  const ContactPass* pass = nullptr;
};
/// All of them, also those that have waited for something to be near; after the first force evaluation.
[[nodiscard]] std::vector<NodePass> node_passes(ContactForces& contacts);

/// A tracked node and the segment that it meets first.
struct Meeting {
  SlotIndex slot;
  SegmentIndex segment;
  TimeOfContact contact;
};

/// Work that the search did and left out.
struct MeetingCounters {
  std::uint64_t still = 0;       ///< pairs of groups of nodes and segments with one motion: they cannot meet
  std::uint64_t candidates = 0;  ///< pairs of a node and a segment whose swept boxes meet
  std::uint64_t steps = 0;       ///< closest points that their times of contact took
  std::uint64_t undecided = 0;   ///< pairs whose time of contact was not found
  std::uint64_t begun = 0;       ///< nodes that are nearer than the contact distance from the start on
};

/// The first meeting of each tracked node of a pass up to a time, ascending by slot. Nodes and segments are gathered by
/// their motion; swept boxes, in the frame of each group of nodes, leave the candidates. Looks less far ahead, and
/// shortens `until`, where these are too many.
[[nodiscard]] std::vector<Meeting> find_meetings(const TrackedPairs& pairs, const Flight& flight, double& until,
                                                 MeetingCounters& counters,
                                                 contact::BoxSearch search = contact::BoxSearch::tree);

/// When and how one tracked node meets one segment.
[[nodiscard]] TimeOfContact meet_segment(const TrackedPairs& pairs, const Flight& flight, SlotIndex slot,
                                         SegmentIndex segment, double until);

}  // namespace gapcheck::solver
