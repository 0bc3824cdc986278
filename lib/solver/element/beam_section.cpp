#include "solver/element/beam_section.hpp"

#include <cmath>
#include <numbers>

#include "solver/quadrature/gauss.hpp"

namespace gapcheck::solver {
namespace {

/// Points along one side of a rectangle, in [-1, 1]; weights add up to 2.
std::vector<GaussPoint> side_rule(std::int64_t rule) {
  switch (rule) {
    case 1:
    case 2:
    case 3:
      return gauss_rule(static_cast<int>(rule));
    case 4:
      return {{-1, 1.0 / 3}, {0, 4.0 / 3}, {1, 1.0 / 3}};
    case 5:
      return gauss_rule(4);
    default:
      return {};
  }
}

std::vector<Fiber> rectangle_fibers(std::int64_t rule, double along_s, double along_t) {
  std::vector<Fiber> fibers;
  const std::vector<GaussPoint> points = side_rule(rule);
  for (const GaussPoint& a : points)
    for (const GaussPoint& b : points)
      fibers.push_back({a.place * along_s / 2, b.place * along_t / 2, a.weight * b.weight / 4 * along_s * along_t});
  return fibers;
}

/// `circles` with `count` points each. The area between two radii goes with their squares, so a Gauss rule over the
/// squared radius integrates squares of lengths exactly.
std::vector<Fiber> circle_fibers(int circles, int count, double outer, double inner) {
  std::vector<Fiber> fibers;
  const double area = std::numbers::pi / 4 * (outer * outer - inner * inner);
  const double most = outer * outer / 4, least = inner * inner / 4;
  int circle = 0;
  for (const GaussPoint& point : gauss_rule(circles)) {
    const double radius = std::sqrt((most + least) / 2 + point.place * (most - least) / 2);
    const int turned = circles - 1 - circle;  // the inner one by half a spacing
    for (int i = 0; i < count; ++i) {
      const double angle = std::numbers::pi / count * (2 * i + 1 + turned);
      fibers.push_back({radius * std::cos(angle), radius * std::sin(angle), area * point.weight / 2 / count});
    }
    ++circle;
  }
  return fibers;
}

}  // namespace

std::vector<Fiber> section_fibers(const model::BeamProfile& profile) {
  if (profile.arbitrary || profile.rule < 1 || profile.rule > 5) return {};
  const double along_s = (profile.s[0] + profile.s[1]) / 2, along_t = (profile.t[0] + profile.t[1]) / 2;
  if (!profile.tube) return rectangle_fibers(profile.rule, along_s, along_t);
  if (profile.rule == 1) return {{0, 0, std::numbers::pi / 4 * (along_s * along_s - along_t * along_t)}};
  return circle_fibers(profile.rule == 2 ? 1 : 2, profile.rule == 5 ? 8 : 4, along_s, along_t);
}

model::BeamSection section_constants(const model::BeamProfile& profile, const std::vector<Fiber>& fibers) {
  model::BeamSection section;
  for (const Fiber& fiber : fibers) {
    section.area += fiber.area;
    section.iss += fiber.area * fiber.t * fiber.t;
    section.itt += fiber.area * fiber.s * fiber.s;
  }
  section.torsion = profile.torsion_free ? 0 : section.iss + section.itt;
  section.shear_area = profile.shear_factor * section.area;
  section.line_mass = profile.line_mass;
  return section;
}

}  // namespace gapcheck::solver
