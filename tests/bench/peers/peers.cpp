// gapcheck's search and closest point beside other libraries on the same meshes and points, on one thread; writes JSON.
// What they find is compared before it is timed. usage: gapcheck_peers [N] [ROUNDS]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "base/parallel.hpp"
#include "cgal_boxes_peer.hpp"
#include "cgal_tree_peer.hpp"
#include "embree_peer.hpp"
#include "fcl_peer.hpp"
#include "gapcheck_peer.hpp"

namespace gapcheck::bench {
namespace {

/// The first one is what the others' ratios refer to; so is the first that gives candidates only.
std::vector<Peer> all_peers() {
  return {{"gapcheck: bucket grid and closest point", true, false, 1e-12, run_gapcheck<false>},
          {"the same with certified decisions", true, false, 1e-12, run_gapcheck<true>},
          {"CGAL AABB_tree, closest point", false, false, 1e-12, run_cgal_tree},
          {"Embree point query within the contact distance, float", true, false, 1e-3, run_embree<true>},
          {"Embree point query, float", false, false, 1e-3, run_embree<false>},
          {"FCL distance", false, false, 1e-9, run_fcl},
          {"gapcheck: bucket grid, candidates", true, true, 0, run_bucket_grid},
          {"gapcheck: box pairs, candidates", true, true, 0, run_box_pairs},
          {"CGAL Box_intersection_d, candidates", true, true, 0, run_cgal_boxes}};
}

/// The plate is flat and its edges are straight, so the distance is that from a rectangle.
double true_distance(const Scene& scene, const Vector& x) {
  const Vector nearest = x.cwiseMax(scene.nodes.front()).cwiseMin(scene.nodes.back());
  return (x - nearest).norm();
}

/// Largest error of the distances; negative if something within the contact distance was not found.
double largest_error(const Scene& scene, const Peer& peer, const Found& found) {
  double largest = 0;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const double expected = true_distance(scene, scene.points[i]);
    const bool outside = peer.only_within_bound && expected > scene.bound - peer.tolerance;
    if (outside) continue;
    if (!std::isfinite(found.distances[i])) return -1;
    largest = std::max(largest, std::abs(found.distances[i] - expected));
  }
  return largest;
}

/// Pairs of points and quads whose grown boxes contain them, counted one by one.
std::uint64_t true_pairs(const Scene& scene) {
  Found found;
  const auto boxes = quad_boxes(scene);
  std::vector<contact::Bounds> points(scene.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[i].add(scene.points[i]);
  const auto count = [&](std::uint32_t, std::uint32_t) { ++found.pairs; };
  contact::for_each_box_pair(boxes, points, count, contact::BoxSearch::brute_force);
  return found.pairs;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// True if every program finds what is there; says what is wrong.
bool compare(const Scene& scene, const std::string& where, std::vector<double>& errors) {
  std::uint64_t boxes = 0;
  for (const Peer& peer : all_peers()) {
    const Found found = peer.run(scene);
    if (peer.candidates_only) {
      errors.push_back(0);
      if (boxes == 0) boxes = found.pairs;
      if (found.pairs == boxes) continue;
      fmt::print(stderr, "{}: {} finds {} pairs instead of {}\n", where, peer.name, found.pairs, boxes);
      return false;
    }
    errors.push_back(largest_error(scene, peer, found));
    if (errors.back() >= 0 && errors.back() <= peer.tolerance) continue;
    fmt::print(stderr, "{}: {} is off by {} (negative: misses a point)\n", where, peer.name, errors.back());
    return false;
  }
  return true;
}

int measure_scene(int n, Points points, int rounds, const char* separator) {
  // Small enough for brute force: the counts that the large scene can only compare with each other.
  const Scene small = make_scene(30, points);
  if (run_box_pairs(small).pairs != true_pairs(small) || run_cgal_boxes(small).pairs != true_pairs(small)) {
    fmt::print(stderr, "{}: pairs of boxes are missing\n", name(points));
    return 2;
  }
  const Scene scene = make_scene(n, points);
  std::vector<double> errors;
  if (!compare(scene, name(points), errors)) return 2;
  const std::vector<Peer> peers = all_peers();
  std::vector<std::vector<double>> build(peers.size()), query(peers.size()), ratio(peers.size());
  std::vector<std::uint64_t> pairs(peers.size());
  for (int round = 0; round < rounds; ++round) {
    double first = 0;
    for (std::size_t i = 0; i < peers.size(); ++i) {
      const Found found = peers[i].run(scene);
      const double total = found.build_seconds + found.query_seconds;
      if (i == 0 || (peers[i].candidates_only && !peers[i - 1].candidates_only)) first = total;
      build[i].push_back(found.build_seconds);
      query[i].push_back(found.query_seconds);
      ratio[i].push_back(total / first);
      pairs[i] = found.pairs;
    }
  }
  fmt::print("{}\n{{\"points\": \"{}\", \"quads\": {}, \"count\": {}, \"peers\": [", separator, name(points),
             scene.quads.size(), scene.points.size());
  for (std::size_t i = 0; i < peers.size(); ++i) {
    const auto [low, high] = std::minmax_element(ratio[i].begin(), ratio[i].end());
    fmt::print(
        "{}\n  {{\"name\": \"{}\", \"candidates_only\": {}, \"build\": {}, \"query\": {}, \"ratio\": {}, "
        "\"ratio_low\": {}, \"ratio_high\": {}, \"error\": {}, \"pairs\": {}}}",
        i > 0 ? "," : "", peers[i].name, peers[i].candidates_only, median(build[i]), median(query[i]), median(ratio[i]),
        *low, *high, errors[i], pairs[i]);
  }
  fmt::print("]}}");
  return 0;
}

}  // namespace
}  // namespace gapcheck::bench

int main(int argc, char** argv) {
  const int n = argc > 1 ? std::atoi(argv[1]) : 300, rounds = argc > 2 ? std::atoi(argv[2]) : 7;
  if (argc > 3 || n < 1 || n > 2000 || rounds < 1 || rounds > 1000) {
    std::fputs("usage: gapcheck_peers [N] [ROUNDS]   (a plate of N x N quads, N from 1 to 2000)\n", stderr);
    return 2;
  }
  const gapcheck::JobLimit one_thread(1);
  fmt::print("{{\"rounds\": {}, \"scenes\": [", rounds);
  const char* separator = "";
  for (const auto points : gapcheck::bench::all_points) {
    if (const int status = gapcheck::bench::measure_scene(n, points, rounds, separator); status != 0) return status;
    separator = ",";
  }
  fmt::print("]}}\n");
  return 0;
}
