#pragma once
#include <embree3/rtcore.h>

#include <cmath>
#include <limits>

#include "../stopwatch.hpp"
#include "../work_precision/triangle.hpp"
#include "scene.hpp"

namespace gapcheck::bench {

/// What Embree's callback sees: the mesh in float, and the nearest triangle so far.
struct EmbreeQuery {
  const float* vertices;
  const unsigned* indices;
  float squared_distance;
};

inline bool look_at_triangle(RTCPointQueryFunctionArguments* arguments) {
  auto& query = *static_cast<EmbreeQuery*>(arguments->userPtr);
  const Eigen::Vector3f at(arguments->query->x, arguments->query->y, arguments->query->z);
  const unsigned* corners = query.indices + 3 * arguments->primID;
  const auto corner = [&](int i) -> Eigen::Vector3f {
    return Eigen::Map<const Eigen::Vector3f>(query.vertices + 3 * corners[i]) - at;
  };
  const float squared = squared_distance_of_triangle<Eigen::Vector3f>(corner(0), corner(1), corner(2));
  if (!(squared < query.squared_distance)) return false;
  query.squared_distance = squared;
  const float distance = std::sqrt(squared);
  if (!(distance < arguments->query->radius)) return false;
  arguments->query->radius = distance;
  return true;  // the radius has shrunk
}

/// Embree's point query on the triangles, in float; the closest point of a triangle is the caller's own code.
template <bool within_bound>
Found run_embree(const Scene& scene) {
  Found found;
  Stopwatch watch;
  const RTCDevice device = rtcNewDevice("threads=1");
  const RTCScene tree = rtcNewScene(device);
  const RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const auto triangles = scene.triangles();
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), scene.nodes.size()));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(unsigned), triangles.size()));
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    Eigen::Map<Eigen::Vector3f>(vertices + 3 * i) = scene.nodes[i].cast<float>();
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) std::copy_n(triangles[t].data(), 3, indices + 3 * t);
  rtcSetGeometryPointQueryFunction(mesh, look_at_triangle);
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(tree, mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(tree);
  found.distances.reserve(scene.points.size());
  found.build_seconds = watch.lap();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const Vector& x : scene.points) {
    EmbreeQuery best{vertices, indices, infinity};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    const Eigen::Vector3f at = x.cast<float>();
    RTCPointQuery query{at.x(), at.y(), at.z(), 0, within_bound ? static_cast<float>(scene.bound) : infinity};
    rtcPointQuery(tree, &query, &context, nullptr, &best);
    found.distances.push_back(std::sqrt(best.squared_distance));
  }
  found.query_seconds = watch.lap();
  rtcReleaseScene(tree);
  rtcReleaseDevice(device);
  return found;
}

}  // namespace gapcheck::bench
