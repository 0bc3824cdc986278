#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"
#include "results/d3plot/interface_forces.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// The segments of the contact sides that SAPR and SBPR name, and the forces on them for the interface force database.
/// A force on a point of a segment acts on that segment; one on a node is distributed to the side's segments at that
/// node by their areas. So the forces on all segments of a side add up to that of rcforc, less what acts on nodes
/// without a segment.
class InterfacePlot {
 public:
  InterfacePlot(const Run& run, contact::SurfaceStore& surfaces);

  /// Without segments there is nothing to write.
  [[nodiscard]] const results::InterfaceMesh& mesh() const { return mesh_; }
  [[nodiscard]] results::InterfaceForces state(const Run& run) const;

 private:
  /// One side of a contact: its segments in the mesh, found by their corners and by one of them.
  struct Surface {
    ContactIndex contact;
    bool side_b = false;
    std::size_t first = 0, end = 0;
    std::map<model::SegmentNodes, std::uint32_t> by_corners;  ///< sorted corners
    std::map<NodeIndex, std::vector<std::uint32_t>> by_node;
  };
  struct Geometry;
  class Distribution;

  void add_surface(const model::Model& model, ContactIndex contact, bool side_b, const contact::Segments& segments);

  results::InterfaceMesh mesh_;
  std::vector<NodeIndex> nodes_;                 ///< beside mesh_.node_ids
  std::vector<model::SegmentNodes> corners_;     ///< beside mesh_.segments
  std::map<NodeIndex, std::uint32_t> position_;  ///< of a node in nodes_
  std::vector<Surface> surfaces_;
};

}  // namespace gapcheck::solver
