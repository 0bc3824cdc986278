#include "contact/stiffness/segment_spring.hpp"

#include <algorithm>
#include <cmath>

#include "contact/stiffness/stiffness.hpp"

namespace gapcheck::contact {
namespace {

/// Of a triangle the longest side.
double longest_diagonal(const model::SegmentNodes& n, const std::vector<Vector>& x) {
  const auto squared = [&](std::size_t a, std::size_t b) { return (x[n[a].value] - x[n[b].value]).squaredNorm(); };
  const double longest = std::max(squared(0, 2), squared(1, 3));
  return std::sqrt(corner_count(n) == 3 ? std::max(longest, squared(0, 1)) : longest);
}

/// Of a triangle as of the quad n1 n2 n3 n3.
double shorter_diagonal(const model::SegmentNodes& n, const std::vector<Vector>& x) {
  const auto squared = [&](std::size_t a, std::size_t b) { return (x[n[a].value] - x[n[b].value]).squaredNorm(); };
  return std::sqrt(std::min(squared(0, 2), squared(1, 3)));
}

}  // namespace

SegmentSprings::SegmentSprings(const model::Model& model, const ElementSizes& sizes) : model_(model), sizes_(sizes) {
  for (std::uint32_t p = 0; p < model.parts.size(); ++p) {
    const auto& own = model.parts[p].contact;
    moduli_.push_back(contact_modulus(model, PartIndex{p}) * (own && own->ssf > 0 ? own->ssf : 1));
  }
}

SegmentSpring SegmentSprings::beam(const model::SegmentNodes& nodes, PartIndex part, double scale) const {
  if (!model_.part(part).section) return {};
  const std::vector<Vector>& x = model_.mesh.nodes.x;
  const double length = (x[nodes[0].value] - x[nodes[1].value]).norm();
  const double area = 2 * model_.sections[*model_.part(part).section].beam_radius * length;
  const double stiffness = shell_segment_stiffness(scale, moduli_[part.value], area, length);
  const double weight = area / 2;
  if (!(weight > 0) || !std::isfinite(weight * stiffness)) return {};
  return {stiffness, weight};
}

SegmentSpring SegmentSprings::operator()(const Segments& s, std::size_t i, double scale, bool printed,
                                         double solid_modulus) const {
  const bool of_beam = s.element_kind[i] == model::ElementKind::beam;
  if (s.element[i] == no_position || (of_beam && printed)) return {};
  const PartIndex part = part_of(model_.mesh, s, i);
  if (part == none<PartIndex>) return {};
  if (of_beam) return beam(s.nodes[i], part, scale);
  const std::vector<Vector>& x = model_.mesh.nodes.x;
  const double modulus = moduli_[part.value];
  const std::uint32_t e = s.element[i];
  double area = 0, stiffness = 0;
  if (s.element_kind[i] == model::ElementKind::shell) {
    area = sizes_.shell_area[e];
    const double thickness = sizes_.shell_thickness[e];
    stiffness =
        printed ? shell_segment_stiffness(scale, modulus, area, std::max(thickness, shorter_diagonal(s.nodes[i], x)))
                : shell_segment_stiffness(scale, modulus, area, longest_diagonal(s.nodes[i], x));
  } else {
    const bool thick = s.element_kind[i] == model::ElementKind::thick_shell;
    area = shell_area(s.nodes[i], x);
    stiffness = solid_segment_stiffness(scale, solid_modulus > 0 ? solid_modulus : modulus, area,
                                        (thick ? sizes_.thick_shell_volume : sizes_.solid_volume)[e]);
  }
  const double weight = area / static_cast<double>(printed ? s.nodes[i].size() : corner_count(s.nodes[i]));
  if (!(weight > 0) || !std::isfinite(weight * stiffness)) return {};
  return {stiffness, weight};
}

}  // namespace gapcheck::contact
