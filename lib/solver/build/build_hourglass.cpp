#include "solver/build/build_hourglass.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gapcheck::solver {
namespace {

/// Zero and NaN count as not given.
double given_or(double value, double otherwise) { return std::isfinite(value) && value > 0 ? value : otherwise; }

/// What is written for a part.
struct Written {
  std::int64_t type = 0;
  double coefficient = 0, bending = 0, warping = 0;
  model::Place place;
};

HourglassKind kind_of(std::int64_t type, ElementFamily family) {
  if (type >= 1 && type <= 3) return HourglassKind::viscous;
  const bool stiffness = type == 4 || type == 5 || family == ElementFamily::shells;
  return stiffness ? HourglassKind::stiffness : HourglassKind::assumed_strain;
}

void set_hourglass(const Written& written, ElementFamily family, Hourglass& hourglass) {
  if (written.type != 0) hourglass.kind = kind_of(written.type, family);
  hourglass.exact_volume = written.type == 3 || written.type >= 5;
  hourglass.plain_shapes = written.type == 1;
  if (const double q = given_or(written.coefficient, 0); q > 0) hourglass.set_all(q);
  if (const double q = given_or(written.bending, 0); q > 0) hourglass.bending = hourglass.warping = q;
  hourglass.warping = given_or(written.warping, hourglass.warping);
}

}  // namespace

ElementControl element_control(const model::Model& model, const model::Part& part, ElementFamily family,
                               Hourglass otherwise, Diagnostics& diagnostics) {
  const model::Controls& controls = model.controls;
  ElementControl result{otherwise, given_or(controls.bulk_q1, 1.5), given_or(controls.bulk_q2, 0.06)};
  const auto warn = [&](model::Place place, std::string message) {
    const bool known = place.file.value < model.files.size();
    diagnostics.warning(known ? model.files[place.file.value] : "", place.line, std::move(message));
  };
  Written written{controls.ihq, controls.qh, 0, 0, controls.hourglass_place};
  if (part.hourglass_id != 0) {
    const auto found = model.hourglass.find(part.hourglass_id);
    if (found == model.hourglass.end()) {
      warn(part.place, fmt::format("part {} names hourglass control {}, which is not defined; the default is taken",
                                   part.id.value, part.hourglass_id));
    } else {
      const model::HourglassControl& own = found->second;
      if (own.ihq != 0) written.type = own.ihq;
      if (own.qm != 0) written.coefficient = own.qm;
      written.bending = own.qb;
      written.warping = own.qw;
      written.place = own.place;
      result.quadratic_viscosity = given_or(own.q1, result.quadratic_viscosity);
      result.linear_viscosity = given_or(own.q2, result.linear_viscosity);
    }
  }
  set_hourglass(written, family, result.hourglass);
  const bool shells = family == ElementFamily::shells;
  if (written.type < 0 || written.type > (shells ? 6 : 7))
    warn(written.place, fmt::format("part {}: hourglass control IHQ {} is calculated as type {}", part.id.value,
                                    written.type, shells ? "4 (stiffness)" : "6 (assumed strains)"));
  if (!shells && result.hourglass.kind == HourglassKind::assumed_strain && written.bending > 0)
    warn(written.place,
         fmt::format("part {}: VDC of hourglass control IHQ {} is not calculated", part.id.value, written.type));
  return result;
}

}  // namespace gapcheck::solver
