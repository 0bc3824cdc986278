#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/vector.hpp"

namespace gapcheck {

/// What a picture of findings needs from a mesh: the faces around the findings and a coarse outline of the whole, in
/// single precision, with a bounded size for any mesh.
struct SceneMesh {
  using Point = std::array<float, 3>;  ///< relative to `origin`, finite
  /// Faces of one part, consecutively.
  struct Part {
    std::int64_t id = 0;
    std::string title;
    std::uint32_t first_face = 0, faces = 0;
  };
  Vector origin = Vector::Zero();  ///< in the deck's coordinates
  std::vector<Part> parts;
  std::vector<Point> points;              ///< no two parts share one
  std::vector<std::int64_t> point_nodes;  ///< beside points: ids of their nodes
  /// Positions of points; triangles repeat the last one, beams are two points with the second one three times,
  /// particles one point four times.
  std::vector<std::array<std::uint32_t, 4>> faces;
  std::vector<std::int64_t> face_elements;  ///< beside faces: ids of their elements
  std::vector<float> face_thickness;        ///< beside faces: contact thickness, the largest of all contacts; 0: none
  std::vector<Point> outline_points;
  std::vector<std::array<std::uint32_t, 2>> outline;  ///< positions of outline points
  std::uint64_t model_faces = 0;       ///< shells, outer faces of solids and thick shells, beams, particles of the mesh
  std::uint64_t outline_left_out = 0;  ///< edges far away from the rest
  bool faces_cut = false;              ///< the limit left out faces around findings
  std::vector<std::pair<std::int64_t, Vector>> nodes;  ///< nodes of findings that have no point of their own, by id
};

}  // namespace gapcheck
