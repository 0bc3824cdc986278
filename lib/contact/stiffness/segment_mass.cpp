#include "contact/stiffness/segment_mass.hpp"

#include <cmath>

#include "contact/stiffness/node_masses.hpp"
#include "contact/stiffness/segment_spring.hpp"

namespace gapcheck::contact {
namespace {

double beam_volume(const model::Model& model, PartIndex part, const model::SegmentNodes& nodes) {
  if (part == none<PartIndex> || !model.part(part).section) return 0;
  const std::vector<Vector>& x = model.mesh.nodes.x;
  return model.sections[*model.part(part).section].beam_area * (x[nodes[0].value] - x[nodes[1].value]).norm();
}

double segment_volume(const model::Model& model, const ElementSizes& sizes, const Segments& s, std::size_t i) {
  const std::uint32_t e = s.element[i];
  if (e == no_position) return 0;
  switch (s.element_kind[i]) {
    case model::ElementKind::shell:
      return sizes.shell_area[e] * sizes.shell_thickness[e];
    case model::ElementKind::solid:
      return sizes.solid_volume[e] / 2;
    case model::ElementKind::thick_shell:
      return sizes.thick_shell_volume[e] / 2;
    case model::ElementKind::beam:
      return beam_volume(model, part_of(model.mesh, s, i), s.nodes[i]);
    default:
      return 0;
  }
}

}  // namespace

double segment_mass(const model::Model& model, const ElementSizes& sizes, const std::vector<double>& node_mass,
                    const Segments& segments, std::size_t segment) {
  const double mass =
      density(model, part_of(model.mesh, segments, segment)) * segment_volume(model, sizes, segments, segment);
  if (mass > 0 && std::isfinite(mass)) return mass;
  double sum = 0;
  const model::SegmentNodes& nodes = segments.nodes[segment];
  for (std::size_t c = 0; c < corner_count(nodes); ++c) sum += node_mass[nodes[c].value];
  return sum / 4;
}

}  // namespace gapcheck::contact
