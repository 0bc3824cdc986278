#pragma once
#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/box_intersection_d.h>

#include "gapcheck_peer.hpp"

namespace gapcheck::bench {

/// CGAL's Box_intersection_d on the same grown boxes and the points as boxes without extent (GPL).
inline Found run_cgal_boxes(const Scene& scene) {
  using Box = CGAL::Box_intersection_d::Box_d<double, 3>;
  Found found;
  Stopwatch watch;
  std::vector<Box> boxes, points;
  for (contact::Bounds b : quad_boxes(scene)) boxes.emplace_back(b.low.data(), b.high.data());
  for (Vector x : scene.points) points.emplace_back(x.data(), x.data());
  found.build_seconds = watch.lap();
  CGAL::box_intersection_d(boxes.begin(), boxes.end(), points.begin(), points.end(),
                           [&](const Box&, const Box&) { ++found.pairs; });
  found.query_seconds = watch.lap();
  return found;
}

}  // namespace gapcheck::bench
