#include "contact/pair/nearer_segments.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "contact/search/box_pairs.hpp"

namespace gapcheck::contact {
namespace {

/// Boxes of the oriented segments, grown by `reach`; the others are empty.
template <class Reach>
std::vector<Bounds> oriented_boxes(const PairScene& scene, const Reach& reach) {
  std::vector<Bounds> boxes(scene.segments.size());
  for (const SegmentIndex s : positions<SegmentIndex>(boxes.size())) {
    if (!scene.oriented(s)) continue;
    Bounds box;
    for (const Vector& corner : scene.facet(s).x) box.add(corner);
    boxes[s.value] = grown(box, reach(s));
  }
  return boxes;
}

}  // namespace

void add_nearer_segments(const PairScene& scene, const PairFilter& allowed, const std::vector<Hit>& hits,
                         std::vector<Hit>& measured) {
  // By slot: how far it is behind the farthest of its segments.
  std::vector<double> deepest(scene.nodes.size(), 0);
  for (const Hit& hit : hits) deepest[hit.slot.value] = std::max(deepest[hit.slot.value], -hit.distance);
  std::vector<SlotIndex> slots;
  std::vector<Bounds> around;
  for (const SlotIndex slot : positions<SlotIndex>(deepest.size())) {
    if (!(deepest[slot.value] > 0)) continue;
    Bounds box;
    box.add(scene.position(slot));
    slots.push_back(slot);
    around.push_back(grown(box, deepest[slot.value]));
  }
  if (slots.empty()) return;
  tbb::enumerable_thread_specific<std::vector<Hit>> found;
  for_each_box_pair(around, oriented_boxes(scene, [](SegmentIndex) { return 0.0; }),
                    [&](std::uint32_t a, std::uint32_t b) {
                      const SlotIndex slot = slots[a];
                      const SegmentIndex segment{b};
                      if (is_corner(scene.segments.nodes[b], scene.nodes.node[slot.value])) return;
                      const PairResult pair = measure_pair(scene, slot, segment);
                      if (!(std::abs(pair.distance) < deepest[slot.value]) || !allowed(slot, segment, false)) return;
                      found.local().push_back({slot, segment, pair.distance, pair.in_band});
                    });
  for (const std::vector<Hit>& some : found) measured.insert(measured.end(), some.begin(), some.end());
}

std::vector<double> nearby_behind(const PairScene& scene) {
  std::vector<double> own(scene.segments.size(), 0);
  bool any = false;
  for (const SegmentIndex s : positions<SegmentIndex>(own.size())) {
    own[s.value] = scene.behind(s);
    any = any || scene.oriented(s);
  }
  if (!any) return {};
  // A node lies within the one's distance of both.
  const std::vector<Bounds> boxes = oriented_boxes(scene, [](SegmentIndex) { return 0.0; }),
                            looks = oriented_boxes(scene, [&](SegmentIndex s) { return 2 * own[s.value]; });
  std::vector<double> nearby = own;
  std::mutex mutex;
  for_each_box_pair(looks, boxes, [&](std::uint32_t far, std::uint32_t near) {
    if (!(own[far] > own[near])) return;
    const std::lock_guard lock(mutex);
    nearby[near] = std::max(nearby[near], own[far]);
  });
  return nearby;
}

}  // namespace gapcheck::contact
