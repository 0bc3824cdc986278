#include "solver/condition/section_plane.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gapcheck::solver {
namespace {

bool has_edges(const model::CrossSection& section) {
  return section.radius == 0 && (section.along > 0 || section.across > 0);
}

Vector edge_in_plane(const model::CrossSection& section, const Vector& normal) {
  return section.edge - section.edge.dot(normal) * normal;
}

}  // namespace

std::string SectionPlane::fault(const model::CrossSection& section) {
  const auto absurd = [](double length) { return !std::isfinite(length) || length < 0; };
  if (absurd(section.radius) || absurd(section.along) || absurd(section.across))
    return fmt::format("RADIUS, LENL or LENM of section {} is not a length; use 0 or more", section.id);
  const double length = section.normal.norm();
  if (!(length > 0) || !std::isfinite(length) || !section.tail.allFinite())
    return fmt::format("the normal of section {} has no direction", section.id);
  if (has_edges(section) && !(edge_in_plane(section, section.normal / length).norm() > 1e-9 * section.edge.norm()))
    return fmt::format("the edge XHEV, YHEV, ZHEV of section {} has no direction in the plane", section.id);
  return {};
}

SectionPlane::SectionPlane(const model::CrossSection& section)
    : section_(&section), normal_(section.normal.normalized()) {
  if (has_edges(section)) along_ = edge_in_plane(section, normal_).normalized();
  across_ = normal_.cross(along_);
}

bool SectionPlane::within(const Vector& x) const {
  const Vector from = x - section_->tail;
  if (section_->radius > 0) return (from - from.dot(normal_) * normal_).norm() <= section_->radius;
  const auto inside = [](double at, double length) { return length == 0 || (at >= 0 && at <= length); };
  return inside(from.dot(along_), section_->along) && inside(from.dot(across_), section_->across);
}

}  // namespace gapcheck::solver
