#pragma once
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>

#include "../stopwatch.hpp"
#include "scene.hpp"

namespace gapcheck::bench {

/// CGAL's AABB_tree on the triangles (GPL), with plain doubles, its fastest kernel.
inline Found run_cgal_tree(const Scene& scene) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
  const auto point = [](const Vector& x) { return Kernel::Point_3(x.x(), x.y(), x.z()); };
  Found found;
  Stopwatch watch;
  Triangles triangles;
  for (const auto& t : scene.triangles()) {
    triangles.emplace_back(point(scene.nodes[t[0]]), point(scene.nodes[t[1]]), point(scene.nodes[t[2]]));
  }
  Tree tree(triangles.cbegin(), triangles.cend());
  tree.build();
  tree.accelerate_distance_queries();
  found.distances.reserve(scene.points.size());
  found.build_seconds = watch.lap();
  for (const Vector& x : scene.points) {
    const Kernel::Point_3 query = point(x);
    found.distances.push_back(std::sqrt(CGAL::squared_distance(query, tree.closest_point(query))));
  }
  found.query_seconds = watch.lap();
  return found;
}

}  // namespace gapcheck::bench
