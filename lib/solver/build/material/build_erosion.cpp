#include "solver/build/material/build_erosion.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gapcheck::solver {
namespace {

/// The one definition for a material; nullptr if there is none.
SolverResult<const model::Erosion*> find_erosion(const model::Model& model, std::int64_t material) {
  const model::Erosion* found = nullptr;
  for (const model::Erosion& one : model.erosions) {
    if (one.material_id != material) continue;
    if (found != nullptr)
      return Failure{Failure::Kind::contradiction,
                     fmt::format("material {} has two *MAT_ADD_EROSION (the first in {}); remove one", material,
                                 model.where(found->place)),
                     one.place};
    found = &one;
  }
  return found;
}

/// Takes over the fields and collects the first thing that is wrong.
class ErosionFields {
 public:
  /// A limit that must be above zero.
  void above_zero(std::string_view name, const std::optional<double>& value, double& limit) {
    take(name, value, limit, value.value_or(1) > 0, "is met by elements without load; set a number above 0, or EXCL");
  }
  /// A limit that must not be above zero.
  void not_above_zero(std::string_view name, const std::optional<double>& value, double& limit) {
    take(name, value, limit, value.value_or(-1) <= 0,
         "is met by elements without load; set a number not above 0, or EXCL");
  }
  void wrong(std::string text) {
    if (wrong_.empty()) wrong_ = std::move(text);
  }
  [[nodiscard]] const std::string& first_wrong() const { return wrong_; }

 private:
  void take(std::string_view name, const std::optional<double>& value, double& limit, bool good, std::string_view why) {
    if (!value) return;
    limit = *value;
    if (!good || !std::isfinite(*value)) wrong(fmt::format("{} = {:g} {}", name, *value, why));
  }
  std::string wrong_;
};

void take_strains(const model::Erosion& data, ErosionFields& fields, Erosion& erosion) {
  fields.not_above_zero("MNEPS", data.mneps, erosion.min_strain);
  fields.above_zero("MXEPS", data.mxeps, erosion.max_strain);
  fields.above_zero("EPSSH", data.epssh, erosion.shear_strain);
  if (data.effeps && *data.effeps < 0)
    erosion.plastic_strain = -*data.effeps;
  else
    fields.above_zero("EFFEPS", data.effeps, erosion.effective_strain);
  if (data.voleps && *data.voleps < 0)
    erosion.shrinkage = *data.voleps;
  else
    fields.above_zero("VOLEPS", data.voleps, erosion.growth);
}

void take_stresses(const model::Erosion& data, ErosionFields& fields, Erosion& erosion) {
  fields.above_zero("MXPRES", data.mxpres, erosion.max_pressure);
  fields.not_above_zero("MNPRES", data.mnpres, erosion.min_pressure);
  fields.above_zero("SIGP1", data.sigp1, erosion.principal_stress);
  fields.above_zero("SIGVM", data.sigvm, erosion.von_mises);
  fields.above_zero("IMPULSE", data.impulse, erosion.impulse);
  if (data.impulse && !data.sigth)
    fields.wrong("IMPULSE is given, but SIGTH is left out (it equals EXCL); set both or none");
  erosion.threshold = data.sigth.value_or(0);
  if (!(erosion.threshold >= 0)) fields.wrong(fmt::format("SIGTH = {:g} is below 0; set 0 or more", erosion.threshold));
}

void take_counts(const model::Erosion& data, ErosionFields& fields, Erosion& erosion) {
  constexpr double most_points = 1000;
  erosion.points = data.numfip;
  const bool whole = data.numfip == std::floor(data.numfip) && data.numfip >= 1 && data.numfip <= most_points;
  if (!whole && !(data.numfip < 0 && data.numfip >= -100))
    fields.wrong(fmt::format("NUMFIP = {:g} is no count of points; set 1 to {:g}, or -1 to -100 for per cent of layers",
                             data.numfip, most_points));
  const int given = erosion.given();
  if (!(data.ncs >= 1 && data.ncs <= std::max(given, 1)) || data.ncs != std::floor(data.ncs))
    fields.wrong(fmt::format("NCS = {:g} is not between 1 and the {} criteria that are given", data.ncs, given));
  else
    erosion.conditions = static_cast<int>(data.ncs);
  if (data.failtm < 0) fields.wrong(fmt::format("FAILTM = {:g} is below 0; set a time above 0", data.failtm));
  if (data.failtm > 0) erosion.time = data.failtm;
}

}  // namespace

std::string erosion_not_calculated(const model::Erosion& data) {
  if (!data.unread.empty()) return fmt::format("{}: damage and further criteria are not calculated", data.unread);
  for (const auto& [name, value] :
       {std::pair("SIGP1", data.sigp1), {"SIGVM", data.sigvm}, {"MXEPS", data.mxeps}, {"EPSSH", data.epssh}})
    if (value && *value < 0) return fmt::format("a curve over the strain rate ({} < 0) is not calculated", name);
  return "";
}

SolverResult<std::optional<Erosion>> build_erosion(const model::Model& model, const model::Material& material) {
  const auto found = find_erosion(model, material.id);
  if (!found) return found.error();
  if (found.value() == nullptr) return std::optional<Erosion>();
  const model::Erosion& data = *found.value();
  const auto refused = [&](Failure::Kind kind, std::string_view why) {
    return Failure{kind, fmt::format("*MAT_ADD_EROSION of material {}: {}", material.id, why), data.place};
  };
  if (const std::string why = erosion_not_calculated(data); !why.empty())
    return refused(Failure::Kind::not_calculated, why);
  Erosion erosion;
  ErosionFields fields;
  take_strains(data, fields, erosion);
  take_stresses(data, fields, erosion);
  take_counts(data, fields, erosion);
  if (!fields.first_wrong().empty()) return refused(Failure::Kind::contradiction, fields.first_wrong());
  if (erosion.given() == 0 && erosion.time == Erosion::never) return std::optional<Erosion>();
  return std::optional(erosion);
}

}  // namespace gapcheck::solver
