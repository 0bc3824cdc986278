#include <algorithm>

#include "base/parallel.hpp"
#include "base/quad.hpp"
#include "contact/mesh/faces.hpp"
#include "contact/pair/pair.hpp"

namespace gapcheck::contact {
namespace {

const std::array<NodeIndex, 8>& nodes_of_solid(const Segments& s, const model::Mesh& mesh, std::size_t i) {
  const auto& elements = s.element_kind[i] == model::ElementKind::solid ? mesh.solids : mesh.thick_shells;
  return elements.nodes[s.element[i]];
}

/// Largest distance of the element's nodes behind the facet's plane.
double reach_behind(const model::SegmentNodes& n, const std::array<NodeIndex, 8>& element,
                    const std::vector<Vector>& x) {
  const Vector normal = quad_normal(n, x).stableNormalized();
  const Vector centre = (x[n[0].value] + x[n[1].value] + x[n[2].value] + x[n[3].value]) / 4;
  double reach = 0;
  for (const NodeIndex node : element) reach = std::max(reach, normal.dot(centre - x[node.value]));
  return reach;
}

}  // namespace

double solid_depth(const Segments& s, const model::Mesh& mesh, std::size_t i, const std::vector<Vector>& x) {
  const double a = area(s.nodes[i], x);
  return a > 0 ? volume(nodes_of_solid(s, mesh, i), x) / a : 0;
}

SolidExtents solid_extents(const Segments& s, const model::Mesh& mesh, const std::vector<std::uint32_t>& bodies,
                           const std::vector<Vector>& x) {
  SolidExtents solids;
  if (std::find(s.kind.begin(), s.kind.end(), SegmentKind::solid) == s.kind.end()) return solids;
  solids.depth.resize(s.size());
  solids.extent.resize(s.size());
  // All shells are one body, as in a surface without solids.
  solids.body.assign(s.size(), static_cast<std::uint32_t>(bodies.size()));
  parallel_for(s.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (s.kind[i] != SegmentKind::solid) continue;
      solids.body[i] = bodies[s.nodes[i][0].value];
      solids.depth[i] = solid_depth(s, mesh, i, x);
      solids.extent[i] = reach_behind(s.nodes[i], nodes_of_solid(s, mesh, i), x);
    }
  });
  return solids;
}

}  // namespace gapcheck::contact
