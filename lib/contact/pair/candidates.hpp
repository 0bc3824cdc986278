#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/pair/closest_segment.hpp"
#include "contact/pair/pair_rules.hpp"

namespace gapcheck::contact {

/// A segment that a tracked node may come to penetrate.
struct Candidate {
  /// Where the node is relative to the contact distance while the pair rests.
  enum class Zone : std::uint8_t {
    outside,  ///< farther away
    inside,   ///< nearer, but the projection lies out of the segment's band
    unknown,  ///< either, and the projection lies out of the band
  };
  SegmentIndex segment;
  Zone zone = Zone::outside;
  /// Until nodes and segments have moved this far towards each other since the search, the pair need not be checked.
  double wake = 0;
  /// Less what they have moved since the search: the two are at least that far apart.
  double apart = 0;
};

/// Result of a global search, valid until tracked nodes and segments have come closer by `margin`: for each tracked
/// node the segments that it may penetrate by then. Nodes far from everything have no entry and cost nothing.
class CandidateTable {
 public:
  /// Searches on the scene's present coordinates; replaces earlier results.
  void search(const PairScene& scene, const PairRules& rules, const CandidateSearch& search, double margin,
              SweepCounters& counters);
  /// Tracked nodes with candidates, ascending.
  [[nodiscard]] std::span<const SlotIndex> slots() const { return slots_; }
  /// Candidates of slots()[i], by segment ascending.
  [[nodiscard]] std::span<Candidate> of(std::size_t i) {
    return {candidates_.data() + start_[i], candidates_.data() + start_[i + 1]};
  }
  [[nodiscard]] std::size_t size() const { return candidates_.size(); }

 private:
  std::vector<SlotIndex> slots_;
  std::vector<std::uint32_t> start_{0};
  std::vector<Candidate> candidates_;
};

}  // namespace gapcheck::contact
