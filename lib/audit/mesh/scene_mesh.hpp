#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "audit/mesh/elements_in_contact.hpp"
#include "model/model.hpp"
#include "records/report.hpp"

namespace gapcheck::audit {

/// How much of a mesh a scene may hold.
struct SceneLimits {
  std::size_t faces = 150'000;
  std::size_t outline_edges = 40'000;
  std::uint32_t rings = 4;     ///< faces around the nodes of a finding, ring by ring
  std::size_t whole = 60'000;  ///< a mesh with at most that many faces is there as a whole
};

/// The faces around the nodes and elements of the findings, taken ring by ring in the order of depth, one contact after
/// the other in turn, until the limit; all faces of a small mesh; and the outline of the whole mesh. What has no finite
/// coordinates is left out. `in_contact` has the contact thicknesses; without it they are 0. Linear in the size of the
/// mesh, deterministic.
[[nodiscard]] SceneMesh scene_mesh(const model::Model& model, const Report& report, const SceneLimits& limits = {},
                                   const ElementsInContact* in_contact = nullptr);

// Parts of the above, for tests.

/// A face of the mesh as SceneMesh has them, but with positions of nodes.
struct SceneFace {
  std::array<std::uint32_t, 4> nodes{};
  PartIndex part = none<PartIndex>;
  std::int64_t element = 0;
  float thickness = 0;
};

/// Where most nodes are: between the 2nd and the 98th hundredth along each axis, with as much room around as that box
/// is long, so that a stray node does not make the picture empty.
struct SceneFrame {
  Vector origin = Vector::Zero();  ///< the median
  Vector low = Vector::Zero(), high = Vector::Zero();
  [[nodiscard]] bool holds(const Vector& x) const {
    return (x.array() >= low.array()).all() && (x.array() <= high.array()).all();
  }
};
[[nodiscard]] SceneFrame scene_frame(std::span<const Vector> x);

/// Edges of one face only or of more than two, edges between parts, sharp edges (over 30 degrees) and beams: fills
/// outline_points, outline and outline_left_out. Above `limit` edges their ends are merged on a grid, as coarse as it
/// takes. Edges with an end outside the frame are only counted.
void add_outline(const std::vector<SceneFace>& faces, std::span<const Vector> x, const SceneFrame& frame,
                 std::size_t limit, SceneMesh& scene);

}  // namespace gapcheck::audit
