#include <fmt/format.h>

#include "solver/build.hpp"

namespace gapcheck::solver {
namespace {

std::vector<YieldCurve::Point> points_of(const std::vector<std::array<double, 2>>& pairs) {
  std::vector<YieldCurve::Point> points;
  for (const auto& [strain, stress] : pairs) points.push_back({strain, stress});
  return points;
}

/// Material 024: a curve goes before points, points before SIGY and ETAN.
YieldCurve piecewise_linear(const model::Model& model, const model::Material& material) {
  const model::Plasticity& data = *material.plasticity;
  if (data.lcss != 0) {
    const auto curve = model.curves.find(data.lcss);
    return curve == model.curves.end() ? YieldCurve() : YieldCurve(points_of(curve->second.points));
  }
  if (!data.points.empty()) return YieldCurve(points_of(data.points));
  return YieldCurve(data.sigy, material.young * data.etan / (material.young - data.etan));
}

}  // namespace

std::variant<Material, Failure> build_material(const model::Model& model, const model::Material& material) {
  const auto refused = [&](std::string_view why) {
    return Failure{Failure::Kind::bad_material,
                   fmt::format("material {} (*{}) {}", material.id, material.keyword, why)};
  };
  Material result{MaterialKind::elastic, material.density, material.young, material.poisson, {}, 0, 0, 0};
  if (material.rigid) {
    result.kind = MaterialKind::rigid;
  } else if (material.null_material) {
    result.kind = MaterialKind::null;
  } else if (material.plasticity) {
    const model::Plasticity& data = *material.plasticity;
    if (material.keyword == "MAT_PLASTIC_KINEMATIC") {
      result = plastic_kinematic(material.density, material.young, material.poisson, data.sigy, data.etan, data.beta);
    } else {
      result.kind = MaterialKind::plastic;
      result.yield = piecewise_linear(model, material);
      if (result.yield.empty()) return refused("names a yield curve that is not there (tables are not read yet)");
    }
    result.rate_c = data.rate_c;
    result.rate_p = data.rate_p;
  } else if (material.keyword != "MAT_ELASTIC") {
    return refused("is none of 001, 003, 009, 020 and 024; replace it for this run");
  }
  if (!result.valid()) return refused("has a density, stiffness or yield stress out of range");
  return result;
}

}  // namespace gapcheck::solver
