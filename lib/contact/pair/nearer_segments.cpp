#include "contact/pair/nearer_segments.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "base/parallel.hpp"
#include "base/quad.hpp"
#include "contact/search/box_pairs.hpp"

namespace gapcheck::contact {
namespace {

/// Boxes of the oriented segments, grown by `reach`; the others are empty.
template <class Reach>
std::vector<Bounds> oriented_boxes(const PairScene& scene, const Reach& reach) {
  std::vector<Bounds> boxes(scene.segments.size());
  parallel_for(boxes.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto s = to_index<SegmentIndex>(i);
      if (!scene.oriented(s)) continue;
      Bounds box;
      for (const Vector& corner : scene.facet(s).x) box.add(corner);
      boxes[i] = grown(box, reach(s));
    }
  });
  return boxes;
}

/// By slot: its hit with the nearest oriented segment; null: none.
std::vector<const Hit*> nearest_oriented(const PairScene& scene, const std::vector<Hit>& hits) {
  std::vector<const Hit*> nearest(scene.nodes.size(), nullptr);
  for (const Hit& hit : hits) {
    const Hit*& known = nearest[hit.slot.value];
    if (scene.oriented(hit.segment) && (known == nullptr || std::abs(hit.distance) < std::abs(known->distance)))
      known = &hit;
  }
  return nearest;
}

/// By slot: how far it is behind the farthest of its segments that may still be the nearest of its body.
std::vector<double> deepest_hits(const PairScene& scene, const std::vector<Hit>& hits,
                                 const std::vector<const Hit*>& nearest) {
  std::vector<double> deepest(scene.nodes.size(), 0);
  for (const Hit& hit : hits) {
    if (!(-hit.distance > deepest[hit.slot.value])) continue;
    const Hit& near = *nearest[hit.slot.value];
    // Segments along which the node only slides may not count.
    const bool another = nearer_of_body(scene, hit, near) && !scene.slides(near.slot, near.segment, near.distance);
    if (!another) deepest[hit.slot.value] = -hit.distance;
  }
  return deepest;
}

/// True if the plane of a facet's diagonals shows that it is not nearer to a point than a distance.
bool farther_by_plane(const geometry::Facet& facet, const Vector& query, double distance) {
  const Vector normal = quad_normal(facet.x);
  double low = std::numeric_limits<double>::infinity(), high = -low, size = 0;
  for (const Vector& corner : facet.x) {
    const Vector from = corner - query;
    const double height = normal.dot(from);
    low = std::min(low, height);
    high = std::max(high, height);
    size = std::max(size, from.cwiseAbs().maxCoeff());
  }
  const double least = std::max(low, -high), needed = distance * (1 + 1e-9) + 1e-12 * size;
  return least > 0 && least * least > needed * needed * normal.squaredNorm();
}

}  // namespace

bool nearer_of_body(const PairScene& scene, const Hit& hit, const Hit& other) {
  const auto body = [&](const Hit& of) { return scene.solids.empty() ? 0 : scene.solids.body[of.segment.value]; };
  return body(other) == body(hit) && std::abs(hit.distance) > std::abs(other.distance) * (1 + equally_near);
}

std::vector<Hit> nearer_segments(const PairScene& scene, const PairFilter& allowed, const std::vector<Hit>& hits) {
  if (std::none_of(hits.begin(), hits.end(), [](const Hit& hit) { return std::signbit(hit.distance); })) return {};
  const std::vector<const Hit*> nearest = nearest_oriented(scene, hits);
  const std::vector<double> deepest = deepest_hits(scene, hits, nearest);
  std::vector<SlotIndex> slots;
  std::vector<Bounds> around;
  for (const SlotIndex slot : positions<SlotIndex>(deepest.size())) {
    if (!(deepest[slot.value] > 0)) continue;
    Bounds box;
    box.add(scene.position(slot));
    slots.push_back(slot);
    around.push_back(grown(box, deepest[slot.value]));
  }
  if (slots.empty()) return {};
  tbb::enumerable_thread_specific<std::vector<Hit>> found;
  for_each_box_pair(around, oriented_boxes(scene, [](SegmentIndex) { return 0.0; }),
                    [&](std::uint32_t a, std::uint32_t b) {
                      const SlotIndex slot = slots[a];
                      const SegmentIndex segment{b};
                      if (is_corner(scene.segments.nodes[b], scene.nodes.node[slot.value])) return;
                      if (nearest[slot.value]->segment == segment) return;  // choose_hit() knows it already
                      if (farther_by_plane(scene.facet(segment), scene.position(slot), deepest[slot.value])) return;
                      const PairResult pair = measure_pair(scene, slot, segment);
                      if (!(std::abs(pair.distance) < deepest[slot.value]) || !allowed(slot, segment, false)) return;
                      found.local().push_back({slot, segment, pair.distance, pair.in_band});
                    });
  std::vector<Hit> measured;
  for (const std::vector<Hit>& some : found) measured.insert(measured.end(), some.begin(), some.end());
  return measured;
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
