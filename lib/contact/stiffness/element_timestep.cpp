#include "contact/stiffness/element_timestep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/parallel.hpp"
#include "contact/stiffness/node_masses.hpp"
#include "model/entity/faces.hpp"

namespace gapcheck::contact {
namespace {

constexpr double nearly_incompressible = 0.4999;
/// Steps that differ by less are equal: their elements have the same shape.
constexpr double equal_steps = 1e-12;

double root(double stiffness, double density) {
  const double squared_speed = stiffness / density;
  return density > 0 && squared_speed > 0 && std::isfinite(squared_speed) ? std::sqrt(squared_speed) : 0;
}

/// One speed per part; 0 for those that do not count.
template <class Speed>
std::vector<double> speeds(const model::Model& model, const Speed& speed) {
  std::vector<double> of_part(model.parts.size(), 0.0);
  for (std::uint32_t p = 0; p < of_part.size(); ++p) {
    const model::Part& part = model.parts[p];
    if (!part.material || model.rigid(PartIndex{p})) continue;
    of_part[p] = speed(model.materials[*part.material], density(model, PartIndex{p}), part);
  }
  return of_part;
}

/// By how much the linear bulk viscosity of one-point solids speeds up their sound at rest: the solver takes it for
/// compression, so that L / c becomes L / (Q + √(Q² + c²)) with Q = q2 c (contact rules, section 13.1). The list of a
/// run with fully integrated solids (ELFORM 2) has L / c.
double bulk_viscosity_factor(const model::Model& model, const model::Part& part) {
  if (!part.section) return 1;
  const model::Section& section = model.sections[*part.section];
  const bool one_point = section.elform == 0 || section.elform == 1 || section.elform == 10;
  if (section.kind != model::SectionKind::solid || !one_point) return 1;
  const double q2 = std::max(model.controls.bulk_q2, 0.0);
  return q2 + std::sqrt(q2 * q2 + 1);
}

double step_of(const std::vector<double>& speed, PartIndex part, double length) {
  const double c = part == none<PartIndex> ? 0 : speed[part.value];
  const double step = c > 0 ? length / c : 0;
  return step > 0 ? step : std::numeric_limits<double>::infinity();
}

/// Length / speed of all elements of one kind; infinite for those that do not count.
template <std::size_t N, class Length>
std::vector<double> steps_of(const model::Elements<N>& elements, const std::vector<double>& speed,
                             const Length& length) {
  std::vector<double> steps(elements.size());
  constexpr std::size_t grain = 16384;
  parallel_for(elements.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      // Without a speed the length is not needed.
      const PartIndex part = elements.part[i];
      const bool counts = part != none<PartIndex> && speed[part.value] > 0;
      steps[i] = counts ? step_of(speed, part, length(i)) : std::numeric_limits<double>::infinity();
    }
  });
  return steps;
}

double beam_length(const std::array<NodeIndex, 2>& nodes, const std::vector<Vector>& x) {
  return nodes[1] == none<NodeIndex> ? 0 : (x[nodes[0].value] - x[nodes[1].value]).norm();
}

/// Calls take(kind, steps) for shells, solids, thick shells and beams.
template <class Take>
void for_each_kind(const model::Model& model, const ElementSizes& sizes, const Take& take) {
  const model::Mesh& mesh = model.mesh;
  const std::vector<Vector>& x = mesh.nodes.x;
  const PartSpeeds speed(model);
  take(model::ElementKind::shell,
       steps_of(mesh.shells, speed.shell, [&](std::size_t i) { return sizes.shell_length[i]; }));
  take(model::ElementKind::solid, steps_of(mesh.solids, speed.solid, [&](std::size_t i) {
         return solid_length(mesh.solids.nodes[i], sizes.solid_volume[i], x);
       }));
  take(model::ElementKind::thick_shell, steps_of(mesh.thick_shells, speed.solid, [&](std::size_t i) {
         return solid_length(mesh.thick_shells.nodes[i], sizes.thick_shell_volume[i], x);
       }));
  take(model::ElementKind::beam,
       steps_of(mesh.beams, speed.beam, [&](std::size_t i) { return beam_length(mesh.beams.nodes[i], x); }));
}

}  // namespace

PartSpeeds::PartSpeeds(const model::Model& model)
    : shell(
          speeds(model, [&](const model::Material& material, double density,
                            const model::Part&) { return shell_sound_speed(material, density, model.controls.isdo); })),
      solid(speeds(model,
                   [&](const model::Material& material, double density, const model::Part& part) {
                     return solid_sound_speed(material, density) * bulk_viscosity_factor(model, part);
                   })),
      beam(speeds(model, [&](const model::Material& material, double density, const model::Part& part) {
        const bool discrete = part.section && model.sections[*part.section].elform == model::discrete_beam;
        return discrete ? 0 : beam_sound_speed(material, density);
      })) {}

double ElementSteps::operator()(model::ElementKind kind, std::uint32_t i, const std::vector<Vector>& x) const {
  const model::Mesh& mesh = model_.mesh;
  const auto solid = [&](const model::Elements<8>& elements) {
    const auto& nodes = elements.nodes[i];
    return step_of(speeds_.solid, elements.part[i], solid_length(nodes, brick_volume(nodes, x), x));
  };
  switch (kind) {
    case model::ElementKind::shell: {
      const auto& nodes = mesh.shells.nodes[i];
      return step_of(speeds_.shell, mesh.shells.part[i],
                     shell_length(nodes, shell_area(nodes, x), model_.controls.isdo, x));
    }
    case model::ElementKind::solid:
      return solid(mesh.solids);
    case model::ElementKind::thick_shell:
      return solid(mesh.thick_shells);
    case model::ElementKind::beam:
      return step_of(speeds_.beam, mesh.beams.part[i], beam_length(mesh.beams.nodes[i], x));
    default:
      return std::numeric_limits<double>::infinity();
  }
}

double ElementSteps::smallest(const std::vector<Vector>& x) const {
  double least = std::numeric_limits<double>::infinity();
  const auto take = [&](model::ElementKind kind, std::size_t count) {
    for (std::uint32_t i = 0; i < count; ++i) least = std::min(least, (*this)(kind, i, x));
  };
  const model::Mesh& mesh = model_.mesh;
  take(model::ElementKind::shell, mesh.shells.size());
  take(model::ElementKind::solid, mesh.solids.size());
  take(model::ElementKind::thick_shell, mesh.thick_shells.size());
  take(model::ElementKind::beam, mesh.beams.size());
  return least;
}

double shell_sound_speed(const model::Material& material, double density, std::int64_t isdo) {
  if (isdo == 2) return beam_sound_speed(material, density);
  return root(material.young / (1 - material.poisson * material.poisson), density);
}

double solid_sound_speed(const model::Material& material, double density) {
  if (material.wave_modulus > 0) return root(material.wave_modulus, density);
  if (material.young == 0) return root(material.bulk, density);
  const double nu = std::min(material.poisson, nearly_incompressible);
  return root(material.young * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), density);
}

double beam_sound_speed(const model::Material& material, double density) { return root(material.young, density); }

double solid_length(const std::array<NodeIndex, 8>& nodes, double volume, const std::vector<Vector>& x) {
  double largest = 0;
  for (const model::SegmentNodes& face : model::SolidFaces(nodes)) largest = std::max(largest, shell_area(face, x));
  if (!(largest > 0)) return 0;
  return (model::is_tetrahedron(nodes) ? 3 : 1) * volume / largest;
}

ElementTimestep smallest_element_timestep(const model::Model& model, const ElementSizes& sizes) {
  ElementTimestep best;
  for_each_kind(model, sizes, [&](model::ElementKind kind, const std::vector<double>& steps) {
    const auto least = std::min_element(steps.begin(), steps.end());
    if (least == steps.end() || !std::isfinite(*least)) return;
    const double bound = *least * (1 + equal_steps);
    if (best.timestep > 0 && bound >= best.timestep) return;
    const auto first = std::find_if(steps.begin(), steps.end(), [&](double step) { return step <= bound; });
    best = {*first, kind, static_cast<std::uint32_t>(first - steps.begin())};
  });
  return best;
}

std::vector<ElementTimestep> smallest_element_timesteps(const model::Model& model, const ElementSizes& sizes,
                                                        std::size_t count) {
  std::vector<ElementTimestep> list;
  const auto before = [](const ElementTimestep& a, const ElementTimestep& b) {
    return std::tie(a.timestep, a.kind, a.element) < std::tie(b.timestep, b.kind, b.element);
  };
  for_each_kind(model, sizes, [&](model::ElementKind kind, const std::vector<double>& steps) {
    for (std::uint32_t i = 0; i < steps.size(); ++i)
      if (std::isfinite(steps[i])) list.push_back({steps[i], kind, i});
    const std::size_t kept = std::min(count, list.size());
    std::partial_sort(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(kept), list.end(), before);
    list.resize(kept);
  });
  return list;
}

}  // namespace gapcheck::contact
