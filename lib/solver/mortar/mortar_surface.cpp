#include "solver/mortar/mortar_surface.hpp"

#include <algorithm>
#include <cmath>

#include "base/quad.hpp"
#include "contact/stiffness/segment_mass.hpp"
#include "contact/stiffness/segment_spring.hpp"
#include "contact/surface/neighbours.hpp"

namespace gapcheck::solver {

using contact::corner_count;
using contact::SegmentKind;

namespace {

/// A solid lets go of what has come through this share of its depth behind the face (our own choice).
constexpr double released_share_of_solid = 0.25;
/// The same of a forming tool without thickness, as a share of its shortest edge (our own choice).
constexpr double released_share_of_tool = 0.5;

double area_of(const model::SegmentNodes& nodes, const std::vector<Vector>& x) {
  return quad_normal(nodes, x).norm() / 2;
}

/// Nodes of the element of a segment, ascending, each once.
std::vector<NodeIndex> element_nodes(const model::Mesh& mesh, const contact::Segments& segments, std::size_t s) {
  std::vector<NodeIndex> nodes(segments.nodes[s].begin(), segments.nodes[s].end());
  const std::uint32_t e = segments.element[s];
  if (e != no_position && segments.element_kind[s] == model::ElementKind::solid)
    nodes.insert(nodes.end(), mesh.solids.nodes[e].begin(), mesh.solids.nodes[e].end());
  if (e != no_position && segments.element_kind[s] == model::ElementKind::thick_shell)
    nodes.insert(nodes.end(), mesh.thick_shells.nodes[e].begin(), mesh.thick_shells.nodes[e].end());
  std::erase(nodes, none<NodeIndex>);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// The size that the penetration of a segment is measured by: thickness of a shell, V / A of a solid.
double element_size(const ContactMasses& masses, const contact::Segments& segments, std::size_t s, double area) {
  const std::uint32_t e = segments.element[s];
  if (e == no_position) return 0;
  switch (segments.element_kind[s]) {
    case model::ElementKind::shell:
      return masses.sizes.shell_thickness[e];
    case model::ElementKind::solid:
      return masses.sizes.solid_volume[e] / area;
    case model::ElementKind::thick_shell:
      return masses.sizes.thick_shell_volume[e] / area;
    default:
      return 0;
  }
}

}  // namespace

struct MortarSurface::Side {
  const contact::Segments& segments;
  bool b = false;
  bool oriented_shells = false;
  double scale = 1;  ///< α
};

MortarSurface::MortarSurface(const model::Model& model, const ContactMasses& masses, const model::Contact& contact,
                             const contact::ContactSurfaces& surfaces, const std::vector<Vector>& x)
    : model_(model), masses_(masses), contact_(contact), x_(x) {
  const double slsfac = model.controls.slsfac;
  const bool forming = contact.kind->family == model::Family::forming;
  add_side({surfaces.a.selection.segments, false, false, slsfac * contact.sfs});
  if (surfaces.two_sided()) add_side({surfaces.b.selection.segments, true, forming, slsfac * contact.sfm});
}

void MortarSurface::add_side(const Side& side) {
  const contact::Segments& segments = side.segments;
  const contact::Neighbours around(segments, model_.mesh);
  for (const SegmentIndex s : positions<SegmentIndex>(segments.size())) {
    if (segments.kind[s.value] == SegmentKind::line) continue;
    const MortarFace face = segment_face(side, s.value);
    faces_.push_back(face);
    if (segments.kind[s.value] == SegmentKind::shell && !face.oriented && face.half > 0)
      add_rims(side, face, s, around);
  }
}

MortarFace MortarSurface::segment_face(const Side& side, std::size_t s) const {
  const contact::Segments& segments = side.segments;
  const bool solid = segments.kind[s] == SegmentKind::solid;
  MortarFace face;
  face.nodes = face.shell = segments.nodes[s];
  face.elements = element_nodes(model_.mesh, segments, s);
  face.part = contact::part_of(model_.mesh, segments, s);
  face.on_b = side.b;
  face.oriented = solid || side.oriented_shells;
  face.half = segments.half[s];
  face.thickness = 2 * face.half;
  if (!segments.offset.empty()) face.shift = segments.offset[s];
  const double area = area_of(face.nodes, x_);
  if (!(area > 0) || !std::isfinite(area)) return face;
  const double size = element_size(masses_, segments, s, area);
  face.length = solid && contact_.penmax > 0 ? contact_.penmax : size > 0 ? size : std::sqrt(area);
  if (solid)
    face.reach = contact_.penmax > 0 ? contact_.penmax : released_share_of_solid * face.length;
  else
    face.reach =
        face.half > 0 || !face.oriented ? face.half : released_share_of_tool * contact::shortest_edge(face.nodes, x_);
  const contact::SegmentSpring spring = masses_.springs(segments, s, side.scale);
  const double corners = static_cast<double>(corner_count(face.nodes));
  if (spring.weight > 0) {
    // α K A² / V of a solid, α K A / (longest diagonal) of a shell.
    const double per_area = spring.stiffness / (spring.weight * corners);
    face.slope = per_area * (solid ? size : longest_diagonal(face.nodes, model_.mesh.nodes.x)) / face.length;
  }
  face.mass = contact::segment_mass(model_, masses_.sizes, masses_.mass, segments, s) / area;
  return face;
}

void MortarSurface::add_rims(const Side& side, const MortarFace& face, SegmentIndex segment,
                             const contact::Neighbours& around) {
  const std::size_t corners = corner_count(face.nodes);
  const double area = area_of(face.nodes, x_);
  for (std::size_t i = 0; i < corners; ++i) {
    const NodeIndex a = side.segments.nodes[segment.value][i],
                    b = side.segments.nodes[segment.value][(i + 1) % corners];
    const double length = (x_[a.value] - x_[b.value]).norm();
    if (a == b || !(length > 0) || !around.free_edge(segment, a, b)) continue;
    MortarFace rim = face;
    rim.nodes = {a, b, b, a};
    rim.rim = rim.oriented = true;
    rim.half = 0;
    rim.reach = face.half;
    // Half of the shell moves with the edge.
    rim.mass = face.mass * area / 2 / (length * face.thickness);
    faces_.push_back(rim);
  }
}

std::array<Vector, 4> MortarSurface::offsets(const MortarFace& face, const std::vector<Vector>& x) {
  std::array<Vector, 4> offsets;
  offsets.fill(Vector::Zero());
  if (!face.rim && face.shift == 0) return offsets;
  const Vector normal = quad_normal(face.shell, x).stableNormalized();
  const double half = face.rim ? face.thickness / 2 : 0;
  // Seen from outside the edge is counterclockwise.
  for (std::size_t i = 0; i < 4; ++i) offsets[i] = (face.shift + (i < 2 ? -half : half)) * normal;
  return offsets;
}

std::array<Vector, 4> MortarSurface::corners(const MortarFace& face, const std::vector<Vector>& x) {
  std::array<Vector, 4> corners = offsets(face, x);
  for (std::size_t i = 0; i < 4; ++i) corners[i] += x[face.nodes[i].value];
  return corners;
}

bool are_joined(const MortarFace& a, const MortarFace& b) {
  auto first = a.elements.begin(), second = b.elements.begin();
  while (first != a.elements.end() && second != b.elements.end()) {
    if (*first == *second) return true;
    if (*first < *second)
      ++first;
    else
      ++second;
  }
  return false;
}

}  // namespace gapcheck::solver
