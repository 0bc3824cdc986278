#include "solver/loss/meetings.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "contact/search/nearest_boxes.hpp"

namespace gapcheck::solver {
namespace {

/// Motions beyond these share one group, which is searched without a frame of its own.
constexpr std::size_t most_groups = 32;
/// More candidates than these mean that the search looks too far ahead.
constexpr std::uint64_t sweep_limit = 20'000'000;
constexpr std::size_t mixed = most_groups;

/// A node and a segment whose swept boxes meet.
using SweptCandidate = std::pair<std::uint32_t, std::uint32_t>;

/// Nodes or segments by their motion.
struct MotionGroups {
  std::vector<std::vector<std::uint32_t>> members{most_groups + 1};
  std::vector<NodeIndex> like = std::vector<NodeIndex>(most_groups + 1, none<NodeIndex>);  ///< a node of each motion
};

/// Numbers motions; those beyond the first `most_groups` are mixed.
class MotionNumbers {
 public:
  explicit MotionNumbers(const Flight& flight) : flight_(flight) {}
  [[nodiscard]] std::size_t of(NodeIndex node) {
    const Vector& v = flight_.base(node);
    const auto [at, added] = numbers_.try_emplace(Key{v.x(), v.y(), v.z(), flight_.course(node)}, numbers_.size());
    return std::min(at->second, mixed);
  }

 private:
  using Key = std::tuple<double, double, double, std::uint32_t>;
  const Flight& flight_;
  std::map<Key, std::size_t> numbers_;
};

contact::Bounds sum_of(const contact::Bounds& a, const contact::Bounds& b) {
  contact::Bounds sum;
  sum.low = a.low + b.low;
  sum.high = a.high + b.high;
  return sum;
}

/// The search for the candidates of one pass.
class SweptSearch {
 public:
  SweptSearch(const TrackedPairs& pairs, const Flight& flight, contact::BoxSearch search)
      : pairs_(pairs), scene_(pairs.scene()), flight_(flight), search_(search) {
    MotionNumbers numbers(flight);
    for (std::uint32_t slot = 0; slot < scene_.nodes.size(); ++slot) {
      const NodeIndex node = scene_.nodes.node[slot];
      if (!flight.known(node)) continue;
      add(nodes_, numbers.of(node), slot, node);
    }
    for (std::uint32_t s = 0; s < scene_.segments.size(); ++s) {
      const model::SegmentNodes& corners = scene_.segments.nodes[s];
      if (!std::ranges::all_of(corners, [&](NodeIndex corner) { return flight.known(corner); })) continue;
      const bool alike = std::ranges::all_of(corners, [&](NodeIndex c) { return flight.alike(corners[0], c); });
      add(segments_, alike ? numbers.of(corners[0]) : mixed, s, corners[0]);
    }
    for (const double half : scene_.nodes.half) largest_half_ = std::max(largest_half_, half);
  }

  /// Nothing: there are too many.
  [[nodiscard]] std::optional<std::vector<SweptCandidate>> candidates(double until, MeetingCounters& counters) {
    found_.clear();
    count_ = 0;
    std::uint64_t still = 0;
    for (std::size_t g = 0; g <= mixed; ++g)
      for (std::size_t h = 0; h <= mixed; ++h) {
        if (nodes_.members[g].empty() || segments_.members[h].empty()) continue;
        if (g == h && g != mixed)
          ++still;
        else if (!search_groups(g, h, until))
          return std::nullopt;
      }
    counters.still += still;
    std::ranges::sort(found_);
    return std::move(found_);
  }

 private:
  static void add(MotionGroups& groups, std::size_t group, std::uint32_t member, NodeIndex node) {
    if (groups.members[group].empty()) groups.like[group] = node;
    groups.members[group].push_back(member);
  }

  [[nodiscard]] bool search_groups(std::size_t g, std::size_t h, double until) {
    const std::vector<std::uint32_t>&nodes = nodes_.members[g], &segments = segments_.members[h];
    // The frame moves with the nodes: then they are points.
    std::optional<contact::Bounds> frame;
    if (g != mixed) frame = flight_.ways(nodes_.like[g], until);
    std::vector<contact::Bounds> points(nodes.size()), boxes(segments.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const SlotIndex slot{nodes[i]};
      points[i].add(scene_.position(slot));
      if (!frame) points[i] = sum_of(points[i], flight_.ways(scene_.nodes.node[slot.value], until));
    }
    for (std::size_t i = 0; i < segments.size(); ++i) boxes[i] = sweep(SegmentIndex{segments[i]}, g, until);
    if (search_ == contact::BoxSearch::tree && crowded_sweep(nodes, boxes)) return false;
    contact::for_each_box_pair(
        points, boxes,
        [&](std::uint32_t a, std::uint32_t b) {
          take({nodes[a], segments[b]});
        },
        search_);
    return count_ <= sweep_limit;
  }

  [[nodiscard]] bool crowded_sweep(const std::vector<std::uint32_t>& nodes,
                                   const std::vector<contact::Bounds>& boxes) const {
    std::vector<Vector> places;
    places.reserve(nodes.size());
    for (const std::uint32_t slot : nodes) places.push_back(scene_.position(SlotIndex{slot}));
    return contact::crowded(places, boxes);
  }

  /// The box of a segment and its contact distance on all its way, in the frame of a group of nodes.
  [[nodiscard]] contact::Bounds sweep(SegmentIndex segment, std::size_t group, double until) const {
    const model::SegmentNodes& corners = scene_.segments.nodes[segment.value];
    const geometry::Facet facet = scene_.facet(segment);
    contact::Bounds box;
    for (std::size_t i = 0; i < 4; ++i) {
      const contact::Bounds way =
          group == mixed ? flight_.ways(corners[i], until) : relative_ways(corners[i], nodes_.like[group], until);
      box.add(facet.x[i] + way.low);
      box.add(facet.x[i] + way.high);
    }
    // Sums of ways and of coordinates round; the reach has room for that.
    const double rounding = 1e-12 * (box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs())).maxCoeff();
    return contact::grown(box, largest_half_ + scene_.segments.half[segment.value] + rounding);
  }

  [[nodiscard]] contact::Bounds relative_ways(NodeIndex node, NodeIndex frame, double until) const {
    contact::Bounds way;
    if (flight_.course(node) == flight_.course(frame)) {
      way.add(Vector::Zero());
      way.add((flight_.base(node) - flight_.base(frame)) * until);
      return way;
    }
    const contact::Bounds a = flight_.ways(node, until), b = flight_.ways(frame, until);
    way.low = a.low - b.high;
    way.high = a.high - b.low;
    return way;
  }

  void take(SweptCandidate candidate) {
    const SlotIndex slot{candidate.first};
    const SegmentIndex segment{candidate.second};
    const model::SegmentNodes& corners = scene_.segments.nodes[segment.value];
    const NodeIndex node = scene_.nodes.node[slot.value];
    if (scene_.passive(segment) || contact::is_corner(corners, node)) return;
    if (std::ranges::all_of(corners, [&](NodeIndex corner) { return flight_.alike(node, corner); })) return;
    if (++count_ > sweep_limit) return;
    const std::scoped_lock lock(mutex_);
    found_.push_back(candidate);
  }

  const TrackedPairs& pairs_;
  const contact::PairScene& scene_;
  const Flight& flight_;
  contact::BoxSearch search_;
  MotionGroups nodes_, segments_;
  double largest_half_ = 0;
  std::mutex mutex_;
  std::atomic<std::uint64_t> count_{0};
  std::vector<SweptCandidate> found_;
};

/// False if the straight way of the node, seen from a segment that moves as a whole, is never inside the segment's box
/// up to a time.
bool may_meet(const TrackedPairs& pairs, const Flight& flight, SlotIndex slot, SegmentIndex segment, double until) {
  const contact::PairScene& scene = pairs.scene();
  const NodeIndex node = scene.nodes.node[slot.value];
  const model::SegmentNodes& corners = scene.segments.nodes[segment.value];
  if (flight.course(node) != flight.course(corners[0])) return true;
  if (!std::ranges::all_of(corners, [&](NodeIndex corner) { return flight.alike(corners[0], corner); })) return true;
  contact::Bounds box;
  for (const Vector& corner : scene.facet(segment).x) box.add(corner);
  const Vector from = scene.position(slot), velocity = flight.base(node) - flight.base(corners[0]);
  constexpr double rounding = 1e-9;
  const double size = std::max((box.high - box.low).maxCoeff(), (from - box.low).cwiseAbs().maxCoeff());
  const double reach = scene.nodes.half[slot.value] + scene.segments.half[segment.value] + rounding * size;
  double first = 0, last = until;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.low[axis] - reach - from[axis], high = box.high[axis] + reach - from[axis];
    if (velocity[axis] == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    const double a = low / velocity[axis], b = high / velocity[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return !(first > last);
}

/// The first of one node's candidates.
std::optional<Meeting> first_meeting(const TrackedPairs& pairs, const Flight& flight,
                                     std::span<const SweptCandidate> candidates, double until,
                                     MeetingCounters& counters) {
  std::optional<Meeting> first;
  bool begun = false;
  for (const auto& [s, segment] : candidates) {
    const SlotIndex slot{s};
    const SegmentIndex at{segment};
    if (pairs.rule_of(slot, at) != contact::PairRule::counts) continue;
    const double end = first ? first->contact.time : until;
    if (!may_meet(pairs, flight, slot, at, end)) continue;
    const TimeOfContact contact = meet_segment(pairs, flight, slot, at, end);
    counters.steps += contact.steps;
    counters.undecided += contact.kind == TimeOfContact::Kind::undecided;
    begun = begun || contact.kind == TimeOfContact::Kind::begun;
    if (contact.kind != TimeOfContact::Kind::met || !(contact.speed() > 0)) continue;
    if (!first || contact.time < first->contact.time) first = Meeting{slot, at, contact};
  }
  counters.begun += begun;
  // What a node is in at the start decides about it; start tells what happens there.
  return begun ? std::nullopt : first;
}

}  // namespace

std::vector<NodePass> node_passes(ContactForces& contacts) {
  std::vector<NodePass> list;
  for (std::size_t i = 0; i < contacts.states().size(); ++i) {
    ContactInterface& interface = contacts.interface(i);
    interface.begin_passes();
    for (const ContactPass* const pass : interface.node_passes())
      list.push_back({contacts.states()[i].contact, &interface, pass});
  }
  return list;
}

TimeOfContact meet_segment(const TrackedPairs& pairs, const Flight& flight, SlotIndex slot, SegmentIndex segment,
                           double until) {
  const contact::PairScene& scene = pairs.scene();
  // Oriented segments are met from their front.
  if (scene.oriented(segment) && contact::measure_pair(scene, slot, segment).distance < 0) return {};
  MovingPair pair;
  pair.facet = scene.facet(segment);
  pair.point = scene.position(slot);
  pair.node = scene.nodes.node[slot.value];
  pair.corners = scene.segments.nodes[segment.value];
  pair.line = scene.line(segment);
  pair.contact_distance = scene.nodes.half[slot.value] + scene.segments.half[segment.value];
  pair.counts = [&](const geometry::ClosestPoint& closest) {
    if (pair.line) return std::abs(closest.free_s) <= 1.5;
    return closest.in_band && !scene.beyond_square_edge(segment, closest);
  };
  return time_of_contact(flight, pair, until);
}

std::vector<Meeting> find_meetings(const TrackedPairs& pairs, const Flight& flight, double& until,
                                   MeetingCounters& counters, contact::BoxSearch search) {
  SweptSearch swept(pairs, flight, search);
  std::optional<std::vector<SweptCandidate>> candidates = swept.candidates(until, counters);
  // As far as the start alone the boxes are those of a contact search.
  for (int i = 0; i < 40 && !candidates; ++i) candidates = swept.candidates(until /= 2, counters);
  if (!candidates) candidates.emplace();
  counters.candidates += candidates->size();
  std::vector<std::size_t> first_of_slot;
  for (std::size_t i = 0; i < candidates->size(); ++i)
    if (i == 0 || (*candidates)[i].first != (*candidates)[i - 1].first) first_of_slot.push_back(i);
  first_of_slot.push_back(candidates->size());
  std::vector<std::optional<Meeting>> found(first_of_slot.size() - 1);
  std::vector<MeetingCounters> work(found.size());
  parallel_for(found.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      found[i] = first_meeting(
          pairs, flight, std::span(*candidates).subspan(first_of_slot[i], first_of_slot[i + 1] - first_of_slot[i]),
          until, work[i]);
  });
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < found.size(); ++i) {
    counters.steps += work[i].steps;
    counters.undecided += work[i].undecided;
    counters.begun += work[i].begun;
    if (found[i]) meetings.push_back(*found[i]);
  }
  return meetings;
}

}  // namespace gapcheck::solver
