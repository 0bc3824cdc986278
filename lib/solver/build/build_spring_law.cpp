#include "solver/build/build_spring_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

using SpringKind = model::DiscreteMaterial::Kind;
using SpringPoints = std::vector<std::array<double, 2>>;

/// Builds the law of one material; remembers the first failure.
class SpringLawBuilder {
 public:
  SpringLawBuilder(const model::Model& model, const model::Material& material, bool torsional)
      : model_(model),
        material_(material),
        data_(*material.discrete),
        force_(torsional ? data_.length_factor : 1),
        constant_(torsional ? data_.length_factor * data_.length_factor : 1) {}

  SolverResult<SpringLaw> build() {
    switch (data_.kind) {
      case SpringKind::spring:
        law_.stiffness = data_.constant * constant_;
        break;
      case SpringKind::damper:
        law_.damping = data_.constant * constant_;
        break;
      case SpringKind::plastic_spring:
        take_plastic();
        break;
      case SpringKind::nonlinear_spring:
        law_.curve = points();
        break;
      case SpringKind::nonlinear_damper:
        take_damper();
        break;
      case SpringKind::maxwell_spring:
        take_maxwell();
        break;
      case SpringKind::inelastic_spring:
        take_inelastic();
        break;
    }
    if (!status_.ok()) return status_.error();
    return std::move(law_);
  }

 private:
  void refuse(const std::string& why) {
    if (status_.ok())
      status_ = Failure{Failure::Kind::bad_material,
                        fmt::format("material {} (*{}): {}", material_.id, material_.keyword, why), material_.place};
  }
  void not_below_zero(std::string_view what, double value) {
    if (!(value >= 0)) refuse(fmt::format("{} is {:g}; set a number not below zero", what, value));
  }

  void take_plastic() {
    law_.kind = SpringLaw::Kind::elastoplastic;
    const double elastic = data_.constant, tangent = data_.tangent;
    if (!(elastic > 0)) refuse(fmt::format("K is {:g}; set a number above zero", elastic));
    if (!(tangent >= 0 && tangent < elastic))
      refuse(fmt::format("KT is {:g}; set a number from zero to below K = {:g}", tangent, elastic));
    if (!(data_.yield > 0)) refuse(fmt::format("FY is {:g}; set a number above zero", data_.yield));
    if (!status_.ok()) return;
    law_.stiffness = elastic * constant_;
    law_.hardening = elastic / (elastic - tangent) * tangent * constant_;
    law_.yield = data_.yield * force_;
  }

  void take_damper() {
    const SpringPoints list = points();
    if (!status_.ok()) return;
    law_.rates = ForceCurve(list);
    double largest = 0;
    for (const auto& point : list) largest = std::max(largest, std::abs(point[1]));
    if (!(list.front()[0] < 0 && list.back()[0] > 0) || std::abs(law_.rates.at(0)) > 1e-9 * largest)
      refuse(fmt::format("curve {} (LCDR) must reach from rates below zero to rates above zero and go through (0, 0)",
                         data_.curve));
  }

  void take_maxwell() {
    law_.kind = SpringLaw::Kind::maxwell;
    not_below_zero("KI", data_.long_time);
    if (!(data_.constant >= data_.long_time))
      refuse(fmt::format("K0 is {:g}; set a number not below KI = {:g}", data_.constant, data_.long_time));
    not_below_zero("BETA", data_.decay);
    not_below_zero("TC", data_.cutoff);
    law_.stiffness = data_.long_time * constant_;
    law_.transient = (data_.constant - data_.long_time) * constant_;
    law_.decay = data_.decay;
    if (data_.cutoff > 0 && data_.cutoff < 1e19) law_.cutoff = data_.cutoff;
    law_.cutoff_force = data_.cutoff_force * force_;
  }

  void take_inelastic() {
    law_.kind = SpringLaw::Kind::inelastic;
    const SpringPoints list = points();
    if (!status_.ok()) return;
    double slope = 0;
    for (std::size_t i = 1; i < list.size(); ++i)
      slope = std::max(slope, (list[i][1] - list[i - 1][1]) / (list[i][0] - list[i - 1][0]));
    const bool negative = std::any_of(list.begin(), list.end(), [](const auto& point) { return !(point[1] >= 0); });
    if (list.front()[0] != 0 || list.front()[1] != 0 || negative || !(slope > 0))
      refuse(
          fmt::format("curve {} (LCFD) must begin at (0, 0), rise and have no force below zero, in tension as in "
                      "compression",
                      data_.curve));
    not_below_zero("KU", data_.constant);
    if (data_.sense != 0 && data_.sense != 1 && data_.sense != -1)
      refuse(fmt::format("CTF is {:g}; set -1 for tension or 1 for compression", data_.sense));
    law_.loading = ForceCurve(list);
    law_.sense = data_.sense == -1 ? 1 : -1;
    law_.stiffness = std::max(data_.constant * constant_, slope);
  }

  /// The points of the curve with strictly rising abscissas.
  SpringPoints points() {
    SpringPoints list;
    const auto curve = model_.curves.find(data_.curve);
    if (curve != model_.curves.end())
      for (const auto& point : curve->second.points)
        if (list.empty() || point[0] > list.back()[0]) list.push_back(point);
    if (list.size() < 2) refuse(fmt::format("curve {} is not there or has no two points", data_.curve));
    return list;
  }

  const model::Model& model_;
  const model::Material& material_;
  const model::DiscreteMaterial& data_;
  double force_, constant_;  ///< of the deck's units, of forces and of what is per length
  SpringLaw law_;
  SolverStatus status_;
};

}  // namespace

std::string spring_not_calculated(const model::Material& material) {
  if (material.keyword == "MAT_SPRING_GENERAL_NONLINEAR")
    return "how its curves move with the yield forces is published as pictures only; *MAT_SPRING_ELASTOPLASTIC and "
           "*MAT_SPRING_INELASTIC are calculated";
  if (!material.discrete) return "";
  if (material.discrete->kind == SpringKind::nonlinear_spring && material.discrete->rate_curve != 0)
    return fmt::format("the curve over the rate (LCR = {}) is not calculated; set LCR to 0",
                       material.discrete->rate_curve);
  if (material.discrete->kind == SpringKind::maxwell_spring && material.discrete->option != 0)
    return fmt::format("COPT = {:g} is not calculated; set 0, increments of the deformation",
                       material.discrete->option);
  return "";
}

SolverResult<SpringLaw> build_spring_law(const model::Model& model, const model::Material& material, bool torsional,
                                         Diagnostics& diagnostics) {
  if (!material.discrete)
    return Failure{Failure::Kind::bad_material,
                   fmt::format("material {} (*{}) is none of the springs and dampers S01 to S05, S07 and S08; replace "
                               "it for this run",
                               material.id, material.keyword),
                   material.place};
  if (const std::string why = spring_not_calculated(material); !why.empty())
    diagnostics.warning(model.file(material.place), material.place.line,
                        fmt::format("material {}: {}", material.id, why));
  return SpringLawBuilder(model, material, torsional).build();
}

}  // namespace gapcheck::solver
