#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "../stopwatch.hpp"
#include "contact/search/box_pairs.hpp"
#include "contact/search/search.hpp"
#include "geometry/decide.hpp"
#include "scene.hpp"

namespace gapcheck::bench {

[[nodiscard]] inline geometry::Facet facet_of(const Scene& scene, std::size_t quad) {
  geometry::Facet facet;
  for (std::size_t i = 0; i < 4; ++i) facet.x[i] = scene.nodes[scene.quads[quad][i]];
  return facet;
}

/// Boxes of the quads, grown by the contact distance.
[[nodiscard]] inline std::vector<contact::Bounds> quad_boxes(const Scene& scene) {
  std::vector<contact::Bounds> boxes(scene.quads.size());
  for (std::size_t q = 0; q < boxes.size(); ++q) {
    for (const std::uint32_t node : scene.quads[q]) boxes[q].add(scene.nodes[node]);
    boxes[q] = contact::grown(boxes[q], scene.bound);
  }
  return boxes;
}

/// Bucket grid, then the closest point of every candidate; with `certified` also its proven decision, which alone says
/// whether the pair counts.
template <bool certified>
Found run_gapcheck(const Scene& scene) {
  Found found;
  Stopwatch watch;
  const auto boxes = quad_boxes(scene);
  found.distances.assign(scene.points.size(), std::numeric_limits<double>::infinity());
  found.build_seconds = watch.lap();
  contact::make_bucket_grid()->run(scene.points, boxes, [&](std::uint32_t quad, std::span<const std::uint32_t> points) {
    const geometry::Facet facet = facet_of(scene, quad);
    found.pairs += points.size();
    for (const std::uint32_t i : points) {
      const auto closest = geometry::closest_point(facet, scene.points[i]);
      if constexpr (certified) {
        const auto mode = geometry::Mode::filtered;
        if (!geometry::decide(facet, scene.points[i], scene.bound, mode, &closest).closer) continue;
      }
      found.distances[i] = std::min(found.distances[i], closest.squared_distance);
    }
  });
  for (double& distance : found.distances) distance = std::sqrt(distance);
  found.query_seconds = watch.lap();
  return found;
}

/// Bucket grid alone.
inline Found run_bucket_grid(const Scene& scene) {
  Found found;
  Stopwatch watch;
  const auto boxes = quad_boxes(scene);
  found.build_seconds = watch.lap();
  contact::make_bucket_grid()->run(
      scene.points, boxes, [&](std::uint32_t, std::span<const std::uint32_t> points) { found.pairs += points.size(); });
  found.query_seconds = watch.lap();
  return found;
}

/// Pairs of boxes, the points being boxes without extent.
inline Found run_box_pairs(const Scene& scene) {
  Found found;
  Stopwatch watch;
  const auto boxes = quad_boxes(scene);
  std::vector<contact::Bounds> points(scene.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i].add(scene.points[i]);
  found.build_seconds = watch.lap();
  contact::for_each_box_pair(boxes, points, [&](std::uint32_t, std::uint32_t) { ++found.pairs; });
  found.query_seconds = watch.lap();
  return found;
}

}  // namespace gapcheck::bench
