#include <fmt/format.h>

#include <cmath>

#include "solver/build/build.hpp"
#include "solver/build/material/build_equation_of_state.hpp"
#include "solver/build/material/build_erosion.hpp"
#include "solver/build/material/build_foam_rubber.hpp"
#include "solver/build/material/build_johnson_cook.hpp"
#include "solver/build/material/build_orthotropic.hpp"
#include "solver/build/material/build_plasticity.hpp"
#include "solver/build/material/material_curve.hpp"

namespace gapcheck::solver {
namespace {

std::vector<YieldCurve::Point> points_of(const std::vector<std::array<double, 2>>& pairs) {
  std::vector<YieldCurve::Point> points;
  points.reserve(pairs.size());
  for (const auto& [strain, stress] : pairs) points.push_back({strain, stress});
  return points;
}

/// The curves of a table; nothing if one is missing.
std::optional<RateTable> rate_table(const model::Model& model, const model::Table& table) {
  RateTable result;
  result.logarithmic = !table.rows.empty() && table.rows[0].value < 0;
  for (const model::Table::Row& row : table.rows) {
    const auto curve = model.curves.find(row.curve);
    if (curve == model.curves.end()) return std::nullopt;
    if (!result.rates.empty() && !(row.value > result.rates.back())) return std::nullopt;
    result.rates.push_back(row.value);
    result.curves.emplace_back(points_of(material_points(model, curve->second)));
  }
  if (result.curves.empty()) return std::nullopt;
  YieldCurve::align(result.curves);
  return result;
}

/// Material 037: the slope is over plastic strain.
YieldCurve anisotropic_yield(const model::Model& model, const model::Plasticity& data) {
  if (data.lcss == 0) return {data.sigy, std::abs(data.etan)};
  const auto curve = model.curves.find(data.lcss);
  return curve == model.curves.end() ? YieldCurve() : YieldCurve(points_of(material_points(model, curve->second)));
}

/// Material 024: a curve takes precedence over points, points over SIGY and ETAN.
YieldCurve piecewise_linear(const model::Model& model, const model::Material& material) {
  const model::Plasticity& data = *material.plasticity;
  if (data.lcss != 0) {
    const auto curve = model.curves.find(data.lcss);
    return curve == model.curves.end() ? YieldCurve() : YieldCurve(points_of(material_points(model, curve->second)));
  }
  if (!data.points.empty()) return YieldCurve(points_of(data.points));
  return {data.sigy, material.young * data.etan / (material.young - data.etan)};
}

/// Material 100: EH is the slope over the plastic strain. A curve or table takes the place of SIGY and EH.
SolverStatus set_weld_yield(const model::Model& model, const model::SpotWeld& weld, Material& material) {
  material.kind = MaterialKind::plastic;
  material.yield = {weld.sigy, weld.hardening};
  if (weld.curve == 0) return {};
  if (const auto curve = model.curves.find(weld.curve); curve != model.curves.end()) {
    material.yield = YieldCurve(points_of(material_points(model, curve->second)));
  } else if (const auto table = model.tables.find(weld.curve); table != model.tables.end()) {
    if (auto rates = rate_table(model, table->second)) material.table = std::move(*rates);
    if (!material.table.curves.empty()) material.yield = material.table.curves[0];
  } else {
    material.yield = {};
  }
  if (!material.yield.empty()) return {};
  return Failure{Failure::Kind::bad_material, "names a yield curve or table (SIGY below zero) that is not there", {}};
}

/// VP = 1 counts where the yield stress depends on a rate. SIGY times the rate's part adds to the curve of 024.
void set_rate_dependence(const model::Plasticity& data, bool piecewise, Material& material) {
  material.rate_c = data.rate_c;
  material.rate_p = data.rate_p;
  const bool table = !material.table.curves.empty();
  material.viscoplastic = data.viscoplastic && (table || data.by_rate());
  if (material.viscoplastic && piecewise && !table && data.sigy > 0) material.rate_stress = data.sigy;
}

/// Material 010: SIGY and EH, or points.
SolverStatus set_hydro(const model::Material& material, Material& result) {
  const model::Hydro& data = *material.hydro;
  auto hydro = build_hydro(material);
  if (!hydro) return hydro.error();
  result.kind = MaterialKind::hydro;
  result.hydro = std::make_shared<const Hydrodynamic>(std::move(hydro).value());
  result.yield = data.points.empty() ? YieldCurve(data.sigy, data.eh) : YieldCurve(points_of(data.points));
  result.failure_strain = data.fs;
  return {};
}

/// FS or FAIL is an effective plastic strain.
bool fails(const model::Plasticity& data) {
  constexpr double never = 1e20;
  return data.failure_strain > 0 && data.failure_strain < never;
}

}  // namespace

SolverResult<Material> build_material(const model::Model& model, const model::Material& material) {
  const auto refused = [&](std::string_view why) {
    return Failure{Failure::Kind::bad_material, fmt::format("material {} (*{}) {}", material.id, material.keyword, why),
                   material.place};
  };
  Material result{MaterialKind::elastic, material.density, material.young, material.poisson, {}, 0, 0, 0, {}, 1};
  if (material.rigid) {
    result.kind = MaterialKind::rigid;
  } else if (material.null_material) {
    result.kind = MaterialKind::null;
  } else if (material.plasticity) {
    const model::Plasticity& data = *material.plasticity;
    if (material.keyword == "MAT_PLASTIC_KINEMATIC") {
      result = plastic_kinematic(material.density, material.young, material.poisson, data.sigy, data.etan, data.beta);
    } else if (material.keyword == "MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC") {
      result.kind = MaterialKind::anisotropic;
      result.anisotropy = std::abs(data.anisotropy);
      result.yield = anisotropic_yield(model, data);
      if (result.yield.empty()) return refused("names a yield curve that is not there");
    } else if (material.keyword == "MAT_POWER_LAW_PLASTICITY") {
      if (const SolverStatus set = set_power_law(material, result); !set.ok()) return set.error();
    } else if (const auto table = model.tables.find(data.lcss); table != model.tables.end() && data.lcss != 0) {
      result.kind = MaterialKind::plastic;
      auto rates = rate_table(model, table->second);
      if (!rates) return refused("names a table whose curves are not all there or whose rates do not rise");
      result.yield = rates->curves[0];
      result.table = std::move(*rates);
    } else {
      result.kind = MaterialKind::plastic;
      result.yield = piecewise_linear(model, material);
      if (result.yield.empty()) return refused("names a yield curve or table that is not there");
    }
    set_rate_dependence(
        data,
        material.keyword.ends_with("PIECEWISE_LINEAR_PLASTICITY") || material.keyword == "MAT_PLASTICITY_WITH_DAMAGE",
        result);
    if (fails(data)) result.failure_strain = data.failure_strain;
    if (const SolverStatus set = set_own_failure(material, result); !set.ok()) return set.error();
  } else if (material.weld) {
    if (!material.weld->variant.empty())
      return refused(fmt::format("is the variant {}, which is not calculated; use *MAT_SPOTWELD for this run",
                                 material.weld->variant));
    if (const SolverStatus set = set_weld_yield(model, *material.weld, result); !set.ok())
      return refused(set.error().message);
  } else if (material.mooney_rivlin) {
    result.kind = MaterialKind::rubber;
    result.rubber = mooney_rivlin(material.mooney_rivlin->a, material.mooney_rivlin->b, material.poisson);
  } else if (material.hydro) {
    if (const SolverStatus set = set_hydro(material, result); !set.ok()) return set.error();
  } else if (material.johnson_cook) {
    if (const SolverStatus set = set_johnson_cook(material, result); !set.ok()) return set.error();
  } else if (material.orthotropic) {
    if (const SolverStatus set = set_orthotropic(material, result); !set.ok()) return set.error();
  } else if (!std::holds_alternative<std::monostate>(material.foam_rubber)) {
    if (const SolverStatus set = set_foam_rubber(model, material, result); !set.ok()) return set.error();
  } else if (material.keyword != "MAT_ELASTIC") {
    return refused(
        "is none of 001, 003, 006, 007, 009, 010, 015, 020, 024, 027, 037, 057, 063, 077, 098, 100 and 181; replace it "
        "for "
        "this run");
  }
  if (!result.valid()) return refused("has a density, stiffness or yield stress out of range");
  auto erosion = build_erosion(model, material);
  if (!erosion) return erosion.error();
  if (erosion.value() && result.erosion)
    return refused("has limits of its own (EPSTHIN, EPSMAJ, NUMINT) and *MAT_ADD_EROSION; keep one of them");
  if (result.kind != MaterialKind::rigid && erosion.value()) result.erosion = erosion.value();
  return result;
}

void name_what_is_not_calculated(const model::Model& model, const model::Material& material, Diagnostics& diagnostics) {
  if (!material.plasticity) return;
  const model::Plasticity& data = *material.plasticity;
  const auto warn = [&](std::string_view what) {
    diagnostics.warning(model.file(material.place), material.place.line,
                        fmt::format("material {} (*{}): {}", material.id, material.keyword, what));
  };
  if (data.failure_strain < 0) warn("failure by a subroutine (FAIL < 0) is not calculated");
  const bool table = data.lcss != 0 && model.tables.count(data.lcss) > 0;
  if (data.other_vp != 0 && (data.by_rate() || table))
    warn(fmt::format("VP = {:g} is not calculated; the total strain rate counts", data.other_vp));
  if (data.lcsr != 0) warn("the curve LCSR over the rate is not calculated");
  const bool anisotropic = material.keyword == "MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC";
  if (anisotropic && data.lcss != 0)
    if (const auto curve = model.curves.find(data.lcss); curve != model.curves.end() && !curve->second.points.empty())
      if (curve->second.points[0][1] <= 0) warn("its yield curve starts at zero: it yields under any load");
}

}  // namespace gapcheck::solver
