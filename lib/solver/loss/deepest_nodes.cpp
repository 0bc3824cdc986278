#include "solver/loss/deepest_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "contact/search/box_pairs.hpp"

namespace gapcheck::solver {
namespace {

/// Segments that are as far away as the node's own do not count.
constexpr double slack = 1 - 1e-3;

/// The nodes of one pass where they are deepest, seen from the bodies whose segments they press on.
class DeepestNodes {
 public:
  DeepestNodes(const ImpactScene& scene, const std::vector<Impact>& impacts) : scene_(scene), impacts_(impacts) {}

  void add(std::size_t position) {
    const Impact& impact = impacts_[position];
    const contact::PairScene& pairs = pairs_of(position);
    const double deepest = std::min(impact.release / *impact.margin, impact.release);
    Vector point = pairs.position(impact.meeting.slot) + scene_.flight.way(impact.node, impact.time()) -
                   scene_.flight.way(impact.corners[0], impact.time()) - deepest * impact.meeting.contact.normal;
    const double apart = std::abs(impact.contact_distance - deepest) * slack;
    contact::Bounds box;
    box.add(point);
    list_.push_back({position, point, apart});
    boxes_.push_back(contact::grown(box, apart));
  }

  /// Adds the groups of those to which another segment of the body is nearer, so that that one counts there.
  void find_other_faces(std::set<std::size_t>& groups) const {
    const contact::PairScene& pairs = pairs_of(list_.front().impact);
    std::vector<contact::Bounds> segments(pairs.segments.size());
    for (const SegmentIndex s : positions<SegmentIndex>(segments.size()))
      if (!pairs.passive(s) && !pairs.line(s))
        for (const Vector& corner : pairs.facet(s).x) segments[s.value].add(corner);
    std::mutex mutex;
    contact::for_each_box_pair(boxes_, segments, [&](std::uint32_t a, std::uint32_t b) {
      const Impact& impact = impacts_[list_[a].impact];
      const SegmentIndex s{b};
      if (s == impact.meeting.segment) return;
      if (scene_.bodies.of(pairs.segments.nodes[b][0]) != scene_.bodies.of(impact.corners[0])) return;
      if (impact.pass.pass->pairs().rule_of(impact.meeting.slot, s) != contact::PairRule::counts) return;
      if (!(geometry::closest_point(pairs.facet(s), list_[a].point).squared_distance < list_[a].apart * list_[a].apart))
        return;
      const std::scoped_lock lock(mutex);
      groups.insert(impact.group);
    });
  }

 private:
  struct DeepestNode {
    std::size_t impact;
    Vector point;
    double apart;  ///< from the segment
  };
  [[nodiscard]] const contact::PairScene& pairs_of(std::size_t position) const {
    return impacts_[position].pass.pass->pairs().scene();
  }
  const ImpactScene& scene_;
  const std::vector<Impact>& impacts_;
  std::vector<DeepestNode> list_;
  std::vector<contact::Bounds> boxes_;
};

}  // namespace

std::set<std::size_t> groups_that_leave_faces(const ImpactScene& scene, const std::vector<Impact>& impacts) {
  std::map<const ContactPass*, DeepestNodes> by_pass;
  for (std::size_t i = 0; i < impacts.size(); ++i)
    if (impacts[i].margin) by_pass.try_emplace(impacts[i].pass.pass, scene, impacts).first->second.add(i);
  std::set<std::size_t> groups;
  for (const auto& [pass, nodes] : by_pass) nodes.find_other_faces(groups);
  return groups;
}

}  // namespace gapcheck::solver
