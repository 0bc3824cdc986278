#include "solver/build/material/build_orthotropic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapcheck::solver {
namespace {

Failure bad_orthotropic(const model::Material& material, std::string_view why) {
  return Failure{Failure::Kind::bad_material, fmt::format("material {} (*{}): {}", material.id, material.keyword, why),
                 material.place};
}

/// With EA and PRBA alone a fabric is isotropic.
OrthotropicPlane moduli_of(const model::Orthotropic& data) {
  OrthotropicPlane law;
  law.ea = data.ea;
  law.eb = data.fabric && data.eb == 0 ? data.ea : data.eb;
  law.poisson_ba = data.prba;
  law.gab = data.fabric && data.gab == 0 ? law.ea / (2 * (1 + data.prba)) : data.gab;
  law.gbc = data.fabric && data.gbc == 0 ? law.gab : data.gbc;
  law.gca = data.fabric && data.gca == 0 ? law.gab : data.gca;
  if (data.ec > 0) {
    law.thinning_a = data.prca / data.ec;
    law.thinning_b = data.prcb / law.eb;
  } else if (data.fabric && data.eb == 0) {
    law.thinning_a = law.thinning_b = data.prba / law.ea;
  }
  law.only_tension = data.only_tension;
  return law;
}

}  // namespace

SolverStatus set_orthotropic(const model::Material& material, Material& result) {
  const model::Orthotropic& data = *material.orthotropic;
  if (const std::string why = orthotropic_not_calculated(data); !why.empty())
    return Failure{Failure::Kind::not_calculated,
                   fmt::format("material {} (*{}): {}", material.id, material.keyword, why), material.place};
  const OrthotropicPlane law = moduli_of(data);
  if (!(law.ea > 0 && law.eb > 0)) return bad_orthotropic(material, "EA and EB are not both above 0");
  if (!(law.gab > 0) || !(law.gbc > 0 && law.gca > 0))
    return bad_orthotropic(material, "GAB, GBC and GCA are not all above 0");
  if (!(data.prba * data.prba * law.ea < law.eb))
    return bad_orthotropic(material, fmt::format("PRBA = {:g} is beyond √(EB/EA)", data.prba));
  result.kind = MaterialKind::orthotropic;
  result.orthotropic = law;
  // Bounds of all moduli for the step: E/(1 − ν) of the plane, E/(1 + ν)/2 of transverse shear.
  const double nu = std::abs(data.prba) * std::sqrt(law.ea / law.eb);
  result.poisson = nu;
  result.young = std::max({law.ea, law.eb, 2 * (1 - nu) * law.gab, 2 * (1 + nu) * std::max(law.gbc, law.gca)});
  return {};
}

std::string orthotropic_not_calculated(const model::Orthotropic& data) {
  if (!data.unread.empty()) return fmt::format("{} is not calculated; set 0", data.unread);
  if (data.aopt != 0 && data.aopt != 2 && data.aopt != 3)
    return fmt::format("AOPT = {:g} is not calculated", data.aopt);
  return "";
}

std::optional<double> material_angle(const model::Orthotropic& data, const Matrix& axes) {
  const Vector normal = axes.col(2);
  const Vector along = data.aopt == 2 ? data.a : data.aopt == 3 ? Vector(data.v.cross(normal)) : Vector(axes.col(0));
  const double x = along.dot(axes.col(0)), y = along.dot(axes.col(1));
  constexpr double parallel = 1e-6;
  if (!(std::hypot(x, y) > parallel * along.norm())) return std::nullopt;
  const double turn = data.aopt == 2 ? 0 : data.beta * std::numbers::pi / 180;
  return std::atan2(y, x) + turn;
}

SolverStatus turn_material(const model::Material& material, const Matrix& axes, double& angle) {
  const auto found = material_angle(*material.orthotropic, axes);
  if (!found) return bad_orthotropic(material, "its vectors give no direction in the plane of a shell; mend A or V");
  angle = *found;
  return {};
}

}  // namespace gapcheck::solver
