#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/vector.hpp"

namespace gapcheck::bench {

/// A flat plate of n x n quads with sides of 5 at height 0, and points to be held against it.
struct Scene {
  std::vector<Vector> nodes;
  std::vector<std::array<std::uint32_t, 4>> quads;
  std::vector<Vector> points;
  double bound = 1;  ///< contact distance
  /// The quads cut in two; on a flat plate that is the same surface.
  [[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangles() const;
};

/// Where the points lie.
enum class Points : std::uint8_t {
  plate,  ///< nodes of a second plate 0.7 above, shifted by 0.3 and 0.4 of an element
  slab,   ///< anywhere over the plate, at most two contact distances away
  cube,   ///< anywhere in the cube around the plate
};
inline constexpr Points all_points[] = {Points::plate, Points::slab, Points::cube};
[[nodiscard]] std::string name(Points points);

/// (n + 1)² points in all cases, by a fixed seed.
[[nodiscard]] Scene make_scene(int n, Points points);

/// What one program found and how long it took.
struct Found {
  double build_seconds = 0, query_seconds = 0;
  std::vector<double> distances;  ///< by point; infinite where nothing was found
  std::uint64_t pairs = 0;        ///< candidates; 0: the program does not tell
};

/// One program at work on a scene, on one thread.
struct Peer {
  std::string name;
  bool only_within_bound = false;  ///< looks no farther than the contact distance
  bool candidates_only = false;    ///< gives pairs of boxes, no distances
  double tolerance = 0;            ///< that its distances may be off
  Found (*run)(const Scene& scene) = nullptr;
};

}  // namespace gapcheck::bench
