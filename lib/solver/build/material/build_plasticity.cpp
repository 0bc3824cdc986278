#include "solver/build/material/build_plasticity.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gapcheck::solver {
namespace {

constexpr double no_strain_limit = 1e10;  ///< EPPF and EPPFR from here on are none: their defaults are 1e12 and 1e14

Failure bad_plasticity(const model::Material& material, std::string_view why) {
  return Failure{Failure::Kind::bad_material, fmt::format("material {} (*{}): {}", material.id, material.keyword, why),
                 material.place};
}

bool is_modified(const model::Material& material) {
  return material.keyword == "MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY";
}

/// NUMINT of 123: all points where it is zero, per cent of the layers below zero.
SolverStatus set_strain_limits(const model::Material& material, Material& result) {
  const model::Plasticity& data = *material.plasticity;
  if (data.thinning == 0 && data.major_strain == 0 && data.failed_points == 0) return {};
  const double points = data.failed_points;
  if (!(points >= -100 && points <= 1000) || (points > 0 && points != std::floor(points)))
    return bad_plasticity(material, fmt::format("NUMINT = {:g} is no count of points; set 1 or more, or -1 to -100 for "
                                                "per cent of the layers",
                                                points));
  Erosion erosion;
  if (data.thinning > 0) erosion.thinning = data.thinning;
  if (data.major_strain > 0) erosion.in_plane_strain = data.major_strain;
  if (data.failure_strain > 0 && data.failure_strain < no_strain_limit) erosion.plastic_strain = data.failure_strain;
  erosion.points = points == 0 ? -100 : points;
  if (erosion.given() == 0) return {};
  result.failure_strain = 0;
  result.erosion = erosion;
  return {};
}

}  // namespace

SolverStatus set_power_law(const model::Material& material, Material& result) {
  const model::Plasticity& data = *material.plasticity;
  const double k = data.power_k, n = data.power_n, young = material.young;
  if (!(k > 0)) return bad_plasticity(material, fmt::format("K = {:g} is not above 0", k));
  if (!(n > 0 && n < 1)) return bad_plasticity(material, fmt::format("N = {:g} is not between 0 and 1", n));
  if (!(young > 0)) return bad_plasticity(material, fmt::format("E = {:g} is not above 0", young));
  if (!(data.sigy >= 0)) return bad_plasticity(material, fmt::format("SIGY = {:g} is below 0", data.sigy));
  constexpr double least_stress = 0.02;
  const double first = data.sigy == 0             ? std::pow(young / k, 1 / (n - 1))
                       : data.sigy < least_stress ? data.sigy
                                                  : std::pow(data.sigy / k, 1 / n);
  constexpr double largest = 10, ratio = 1.02, least_strain = 1e-9;
  if (!(first >= least_strain && first <= largest))
    return bad_plasticity(material, fmt::format("its strain at yield is {:g}; look at K, N and SIGY", first));
  std::vector<YieldCurve::Point> points;
  for (double strain = first; strain < largest * ratio; strain *= ratio)
    points.push_back({strain - first, k * std::pow(strain, n)});
  result.kind = MaterialKind::plastic;
  result.yield = YieldCurve(points);
  return {};
}

SolverStatus set_own_failure(const model::Material& material, Material& result) {
  const model::Plasticity& data = *material.plasticity;
  if (const std::string why = plasticity_not_calculated(material); !why.empty())
    return Failure{Failure::Kind::not_calculated,
                   fmt::format("material {} (*{}): {}", material.id, material.keyword, why), material.place};
  if (is_modified(material)) return set_strain_limits(material, result);
  if (!(data.softening >= 0) || !(data.rupture >= 0)) return bad_plasticity(material, "EPPF or EPPFR is below 0");
  if (data.rupture == 0 || data.rupture >= no_strain_limit) return {};
  const bool softens = data.softening > 0 && data.softening < no_strain_limit;
  if (!softens || !(data.rupture > data.softening))
    return bad_plasticity(material, fmt::format("EPPFR = {:g} is not above EPPF = {:g}; set both, or none",
                                                data.rupture, data.softening));
  result.softening = data.softening;
  result.rupture = data.rupture;
  return {};
}

std::string plasticity_not_calculated(const model::Material& material) {
  if (!material.plasticity) return "";
  const model::Plasticity& data = *material.plasticity;
  if (data.damage_curve != 0) return "the damage by a curve (LCDM) is not calculated";
  if (data.thinning < 0) return "plastic thinning (EPSTHIN < 0) is not calculated";
  if (data.major_strain < 0) return "a filtered strain (EPSMAJ < 0) is not calculated";
  if (!is_modified(material) && data.failed_points != 0)
    return fmt::format("NUMINT = {:g} is not calculated; all points of a shell must fail", data.failed_points);
  return "";
}

}  // namespace gapcheck::solver
