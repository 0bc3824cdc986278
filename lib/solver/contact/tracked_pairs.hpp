#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/quad.hpp"
#include "contact/pair/candidates.hpp"
#include "contact/pair/node_contact.hpp"
#include "contact/pair/side_scene.hpp"
#include "geometry/near_place.hpp"
#include "solver/interface/contact_link.hpp"
#include "solver/interface/contact_setting.hpp"
#include "solver/interface/contact_spring.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// The spring between a tracked node and a segment.
struct SegmentLink : LinkForce {
  SegmentIndex segment;
  bool on_face = false;  ///< `s`, `t` lie inside the segment: the next cycle may start there
  double s = 0, t = 0;
  std::array<double, 4> weights{};  ///< of the segment's corners
};

/// Data of a node and a segment that change little from one search to the next: they follow from thickness, mass and
/// the size of elements.
struct PairData {
  SegmentIndex segment = none<SegmentIndex>;  ///< none: not known
  double release_depth = 0;
  ContactSprings::Spring spring;
};

/// State of one tracked node from cycle to cycle, once it has touched something.
struct TrackedNode {
  contact::NodeContact memory;
  bool active = false;  ///< `link` carries a force
  double penetration = 0;
  /// Until this much is used up no other candidate than the rivals counts instead of the segment of `link`.
  double lead = 0;
  PairData pair;  ///< with the segment of the last penetration
  SegmentLink link;
  std::vector<std::uint32_t> rivals;         ///< candidates that may soon count, by number
  std::vector<geometry::NearPlace> nearest;  ///< by candidate, when the pair was decided; empty: not known
  /// The energy of the spring.
  [[nodiscard]] double stored() const { return active ? link.stored(penetration - memory.forgiven) : 0; }
  [[nodiscard]] bool released() const { return memory.state == contact::NodeContact::State::released; }
  /// Neither a force nor a memory: as if it had never touched anything.
  [[nodiscard]] bool at_rest() const { return !active && memory.state == contact::NodeContact::State::apart; }
};

/// The state of one of several tracked nodes.
struct KnownNode {
  SlotIndex slot;
  TrackedNode state;
};

/// Velocities of a tracked node and of a segment's corners.
struct PairVelocities {
  Vector node;
  std::array<Vector, 4> corners;
  /// Of the segment's point with these weights.
  [[nodiscard]] Vector of_segment(const std::array<double, 4>& weights) const {
    return (weights[0] * corners[0] + weights[1] * corners[1]) + (weights[2] * corners[2] + weights[3] * corners[3]);
  }
};

/// One side's nodes and the other side's segments of one contact: the pairs that may come into contact, and the state
/// of each tracked node. Nodes are numbered by slot (position in the side's tracked nodes). Those that need a check
/// have a place: first the nodes with candidates, by ascending slot, then the lost ones, which have a memory or a force
/// but no candidates. Most nodes of most contacts touch nothing, so only those that have done so have a state.
class TrackedPairs {
 public:
  /// `contact`: position in Model::contacts. `exchanged`: side B's nodes against side A's segments. `x` must be the
  /// coordinates of every later state. All references must outlive it.
  TrackedPairs(const ContactSetting& setting, ContactIndex contact, const contact::ContactSurfaces& surfaces,
               bool exchanged, const std::vector<Vector>& x);
  TrackedPairs(const TrackedPairs&) = delete;
  TrackedPairs& operator=(const TrackedPairs&) = delete;

  [[nodiscard]] const contact::SideScene& side() const { return side_; }
  [[nodiscard]] const contact::PairScene& scene() const { return scene_; }
  /// Why a node and a segment are never in contact, or that they may be.
  [[nodiscard]] contact::PairRule rule_of(SlotIndex slot, SegmentIndex segment) const { return rules_(slot, segment); }
  [[nodiscard]] bool two_sided() const { return surfaces_.two_sided(); }
  [[nodiscard]] bool exchanged() const { return exchanged_; }

  /// Sets what the initialisation did to a node; records of the other side are skipped.
  void set_memory(const Penetration& record, const contact::NodeContact& memory);
  /// Global search; wakes all nodes. Returns the number of candidates.
  std::size_t find_candidates(const contact::CandidateSearch& search, double margin, contact::SweepCounters& sweep);

  /// Number of places with candidates, and of all places.
  [[nodiscard]] std::size_t near_places() const { return candidates_.slots().size(); }
  [[nodiscard]] std::size_t places() const { return near_places() + lost_.size(); }
  [[nodiscard]] SlotIndex slot_at(std::size_t place) const {
    return place < near_places() ? candidates_.slots()[place] : lost_[place - near_places()];
  }
  /// None for lost nodes.
  [[nodiscard]] std::span<contact::Candidate> candidates_at(std::size_t place) {
    return place < near_places() ? candidates_.of(place) : std::span<contact::Candidate>{};
  }
  /// Removes the places of lost nodes. They need only one check: nodes far from everything lose their memory.
  void clear_lost() { lost_.clear(); }

  /// Nothing is to be checked at a place with candidates until this much of the margin is used up; 0 at other places.
  [[nodiscard]] double sleep(std::size_t place) const { return place < sleep_.size() ? sleep_[place] : 0; }
  void set_sleep(std::size_t place, double until) {
    if (place < sleep_.size()) sleep_[place] = until;
  }

  /// The state of a node; of one at rest where it has none.
  [[nodiscard]] const TrackedNode& node(SlotIndex slot) const {
    static const TrackedNode resting;
    const TrackedNode* known = nodes_[slot.value].get();
    return known != nullptr ? *known : resting;
  }
  /// Null where it has none.
  [[nodiscard]] TrackedNode* known(SlotIndex slot) { return nodes_[slot.value].get(); }
  /// Gives it one if it has none. For different nodes this may be called on several threads.
  [[nodiscard]] TrackedNode& touch(SlotIndex slot) {
    std::unique_ptr<TrackedNode>& node = nodes_[slot.value];
    if (!node) node = std::make_unique<TrackedNode>();
    return *node;
  }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

  [[nodiscard]] double greatest_reach() const { return greatest_reach_; }
  /// Distance from a segment beyond which it does not affect the node.
  [[nodiscard]] double reach(SlotIndex slot, SegmentIndex s) const {
    return scene_.oriented(s) ? greatest_reach_ : scene_.nodes.half[slot.value] + scene_.segments.half[s.value];
  }
  [[nodiscard]] double segment_area(SegmentIndex segment) const {
    return quad_normal(scene_.facet(segment).x).norm() / 2;
  }
  [[nodiscard]] PairVelocities velocities(SlotIndex slot, SegmentIndex segment, const State& state) const {
    const model::SegmentNodes& n = scene_.segments.nodes[segment.value];
    return {state.v[scene_.nodes.node[slot.value].value],
            {state.v[n[0].value], state.v[n[1].value], state.v[n[2].value], state.v[n[3].value]}};
  }
  /// Adds half a step of work of a node's present force.
  void add_work(SlotIndex slot, const State& state, LinkWork& work) const {
    const SegmentLink& link = node(slot).link;
    const PairVelocities speeds = velocities(slot, link.segment, state);
    work.add(link, speeds.node, speeds.of_segment(link.weights), state.dt);
  }

  /// Takes over memories, and links whose segments still exist, from other surfaces of the same contact. Returns the
  /// slots of `before`, ascending, whose force ends.
  [[nodiscard]] std::vector<SlotIndex> continue_from(const TrackedPairs& before);
  /// The nodes that have a state, without what only saves decisions.
  [[nodiscard]] std::vector<KnownNode> known_nodes() const;
  /// Continues with these nodes and the candidates of `other`, which has the same sides and has decided pairs since.
  void continue_as(const TrackedPairs& other, std::span<const KnownNode> nodes);
  /// Springs and release depths are computed again.
  void forget_pair_data();
  /// Forgets the memory of all nodes and ends their forces.
  void reset_nodes();

 private:
  const model::Mesh& mesh_;
  const contact::ContactSurfaces& surfaces_;
  contact::SideScene side_;
  const contact::PairScene& scene_;
  contact::Exclusions exclusions_;
  contact::PairRules rules_;
  bool exchanged_;
  double greatest_reach_ = 0;
  contact::CandidateTable candidates_;
  std::vector<std::unique_ptr<TrackedNode>> nodes_;  // by slot
  std::vector<double> sleep_;                        // by place with candidates
  std::vector<SlotIndex> lost_;                      // slots with a memory but without candidates since the search
};

}  // namespace gapcheck::solver
