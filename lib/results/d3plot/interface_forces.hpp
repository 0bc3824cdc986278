#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace gapcheck::results {

// The contents of an interface force database (intfor): the segments of contact surfaces, and what acts on them.

/// One side of a contact.
struct InterfaceSurface {
  std::int64_t contact = 0;
  std::size_t side = 0;  ///< 0: A, 1: B
  std::string title;     ///< of the contact
};

struct InterfaceMesh {
  std::string title;
  std::vector<std::int64_t> node_ids;
  std::vector<std::array<double, 3>> coordinates;  ///< beside node_ids
  std::vector<InterfaceSurface> surfaces;
  std::vector<std::array<std::uint32_t, 4>> segments;  ///< positions in node_ids; a triangle repeats the third one
  std::vector<std::uint32_t> surface_of;               ///< beside segments: position in `surfaces`
};

/// What a contact does to one segment.
struct SegmentForce {
  double pressure = 0;  ///< normal force over area; pressing is positive
  double shear = 0;     ///< tangential force over area
  /// Its components along the local axes: r leads from the middle of edge 4-1 to that of edge 2-3, s is normal to it.
  double shear_r = 0, shear_s = 0;
  std::array<std::array<double, 3>, 4> force{};  ///< on its corners
};

/// All segments at one time; arrays beside those of the mesh.
struct InterfaceForces {
  double time = 0;
  std::vector<std::array<double, 3>> coordinates, velocities;
  std::vector<SegmentForce> segments;
};

}  // namespace gapcheck::results
