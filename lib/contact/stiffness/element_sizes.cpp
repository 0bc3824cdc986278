#include "contact/stiffness/element_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/quad.hpp"
#include "contact/surface/thickness.hpp"
#include "model/entity/faces.hpp"

namespace gapcheck::contact {
namespace {

constexpr std::size_t elements_per_task = 8192;

double squared_distance(const std::vector<Vector>& x, NodeIndex a, NodeIndex b) {
  return (x[a.value] - x[b.value]).squaredNorm();
}

std::vector<double> volumes(const model::Elements<8>& elements, const std::vector<Vector>& x) {
  std::vector<double> volume(elements.size());
  parallel_for(elements.size(), elements_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) volume[i] = brick_volume(elements.nodes[i], x);
  });
  return volume;
}

}  // namespace

double shell_area(const model::SegmentNodes& n, const std::vector<Vector>& x) { return 0.5 * quad_normal(n, x).norm(); }

double brick_volume(const std::array<NodeIndex, 8>& nodes, const std::vector<Vector>& x) {
  // Divergence theorem; the flux through a bilinear face is the mean of those through its two triangulations.
  const Vector& origin = x[nodes[0].value];
  double sum = 0;
  for (const model::SegmentNodes& n : model::SolidFaces(nodes)) {
    const Vector a = x[n[0].value] - origin, b = x[n[1].value] - origin, c = x[n[2].value] - origin,
                 d = x[n[3].value] - origin;
    const Vector ab = a.cross(b), cd = c.cross(d);
    sum += ab.dot(c) + ab.dot(d) + cd.dot(a) + cd.dot(b);
  }
  return std::abs(sum) / 12;
}

double shell_length(const model::SegmentNodes& n, double area, std::int64_t isdo, const std::vector<Vector>& x) {
  const bool triangle = n[2] == n[3];
  if (triangle) area *= 2;
  if (isdo == 1) {
    const double longest = std::max(squared_distance(x, n[0], n[2]), squared_distance(x, n[1], n[3]));
    return area / std::sqrt(longest);
  }
  double longest = 0, shortest = squared_distance(x, n[0], n[1]);
  for (std::size_t i = 0; i < 4; ++i) {
    const double squared_side = squared_distance(x, n[i], n[(i + 1) % 4]);
    longest = std::max(longest, squared_side);
    shortest = std::min(shortest, squared_side);
  }
  const double length = area / std::sqrt(longest);
  return isdo == 2 && !triangle ? std::max(length, std::sqrt(shortest)) : length;
}

ElementSizes element_sizes(const model::Model& model) {
  const model::Mesh& mesh = model.mesh;
  const std::vector<Vector>& x = mesh.nodes.x;
  ElementSizes sizes;
  sizes.shell_area.resize(mesh.shells.size());
  sizes.shell_thickness.resize(mesh.shells.size());
  sizes.shell_length.resize(mesh.shells.size());
  parallel_for(mesh.shells.size(), elements_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& nodes = mesh.shells.nodes[i];
      sizes.shell_area[i] = shell_area(nodes, x);
      sizes.shell_length[i] = shell_length(nodes, sizes.shell_area[i], model.controls.isdo, x);
      sizes.shell_thickness[i] = element_thickness(model, static_cast<std::uint32_t>(i));
    }
  });
  sizes.solid_volume = volumes(mesh.solids, x);
  sizes.thick_shell_volume = volumes(mesh.thick_shells, x);
  return sizes;
}

}  // namespace gapcheck::contact
