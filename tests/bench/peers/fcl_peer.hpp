#pragma once
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/distance.h>

#include <memory>

#include "../stopwatch.hpp"
#include "scene.hpp"

namespace gapcheck::bench {

/// FCL's distance between two models of triangles; the point is a triangle whose corners coincide.
inline Found run_fcl(const Scene& scene) {
  using Model = fcl::BVHModel<fcl::RSSd>;
  Found found;
  Stopwatch watch;
  const auto mesh = std::make_shared<Model>();
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : scene.triangles()) triangles.emplace_back(t[0], t[1], t[2]);
  mesh->beginModel(static_cast<int>(triangles.size()), static_cast<int>(scene.nodes.size()));
  mesh->addSubModel(scene.nodes, triangles);
  mesh->endModel();
  const auto point = std::make_shared<Model>();
  point->beginModel();
  point->addTriangle(Vector::Zero(), Vector::Zero(), Vector::Zero());
  point->endModel();
  found.distances.reserve(scene.points.size());
  found.build_seconds = watch.lap();
  for (const Vector& x : scene.points) {
    fcl::Transform3d at = fcl::Transform3d::Identity();
    at.translation() = x;
    const fcl::DistanceRequestd request;
    fcl::DistanceResultd result;
    found.distances.push_back(
        fcl::distance<double>(mesh.get(), fcl::Transform3d::Identity(), point.get(), at, request, result));
  }
  found.query_seconds = watch.lap();
  return found;
}

}  // namespace gapcheck::bench
