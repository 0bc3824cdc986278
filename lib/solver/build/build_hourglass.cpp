#include "solver/build/build_hourglass.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gapcheck::solver {
namespace {

/// Zero and NaN count as not given.
double given_or(double value, double otherwise) { return std::isfinite(value) && value > 0 ? value : otherwise; }

}  // namespace

ElementControl element_control(const model::Model& model, const model::Part& part, Hourglass otherwise,
                               Diagnostics& diagnostics) {
  const model::Controls& controls = model.controls;
  ElementControl result{otherwise, given_or(controls.bulk_q1, 1.5), given_or(controls.bulk_q2, 0.06)};
  const auto warn = [&](model::Place place, std::string message) {
    const bool known = place.file.value < model.files.size();
    diagnostics.warning(known ? model.files[place.file.value] : "", place.line, std::move(message));
  };
  std::int64_t type = controls.ihq;
  double coefficient = controls.qh;
  model::Place place = controls.hourglass_place;
  if (part.hourglass_id != 0) {
    const auto found = model.hourglass.find(part.hourglass_id);
    if (found == model.hourglass.end()) {
      warn(part.place, fmt::format("part {} names hourglass control {}, which is not defined; the default is taken",
                                   part.id.value, part.hourglass_id));
    } else {
      const model::HourglassControl& own = found->second;
      if (own.ihq != 0) type = own.ihq;
      if (own.qm != 0) coefficient = own.qm;
      place = own.place;
      result.quadratic_viscosity = given_or(own.q1, result.quadratic_viscosity);
      result.linear_viscosity = given_or(own.q2, result.linear_viscosity);
    }
  }
  if (type != 0) result.hourglass.kind = type >= 1 && type <= 3 ? HourglassKind::viscous : HourglassKind::stiffness;
  result.hourglass.exact_volume = type == 3 || type >= 5;
  if (type < 0 || type > 5)
    warn(place,
         fmt::format("part {}: hourglass control IHQ {} is calculated as type 4 (stiffness)", part.id.value, type));
  result.hourglass.coefficient = given_or(coefficient, otherwise.coefficient);
  return result;
}

}  // namespace gapcheck::solver
