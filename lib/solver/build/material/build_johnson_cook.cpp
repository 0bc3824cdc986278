#include "solver/build/material/build_johnson_cook.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

Failure bad_johnson_cook(const model::Material& material, std::string_view why) {
  return Failure{Failure::Kind::bad_material, fmt::format("material {} (*{}): {}", material.id, material.keyword, why),
                 material.place};
}

/// What is wrong with the constants of the yield stress; empty: nothing.
std::string wrong_strength(const model::JohnsonCook& data) {
  if (!(data.a > 0)) return fmt::format("A = {:g} is not above 0: it yields at rest", data.a);
  if (!(data.b >= 0)) return fmt::format("B = {:g} is below 0", data.b);
  if (data.b > 0 && !(data.n > 0)) return fmt::format("N = {:g} is not above 0", data.n);
  if (!(data.c >= 0)) return fmt::format("C = {:g} is below 0", data.c);
  if (data.c > 0 && !(data.rate > 0)) return fmt::format("EPSO = {:g} is not above 0", data.rate);
  if (!(data.most_stress >= 0) || !(data.saturation >= 0)) return "SIGMAX or SIGSAT is below 0";
  if (!(data.failure_strain >= 0)) return fmt::format("PSFAIL = {:g} is below 0", data.failure_strain);
  return "";
}

/// The same of temperatures and failure of 015.
std::string wrong_heat(const model::JohnsonCook& data) {
  if (!(data.heat >= 0)) return "CP is below 0";
  if (data.heat > 0 && !(data.melting > data.room))
    return fmt::format("TM = {:g} is not above TR = {:g}", data.melting, data.room);
  if (data.heat > 0 && !(data.m > 0)) return fmt::format("M = {:g} is not above 0", data.m);
  if (!(data.efmin >= 0)) return fmt::format("EFMIN = {:g} is below 0", data.efmin);
  if (data.d[3] != 0 && !(data.rate > 0)) return fmt::format("EPSO = {:g} is not above 0, but D4 is given", data.rate);
  if (const bool fails = std::any_of(data.d.begin(), data.d.end(), [](double d) { return d != 0; });
      fails && !(data.d[0] + data.d[1] > 0) && data.efmin == 0)
    return "D1 + D2 is not above 0: it fails as soon as it flows";
  return "";
}

}  // namespace

std::string johnson_cook_not_calculated(const model::JohnsonCook& data) {
  if (data.vp != 0 && data.vp != 1) return fmt::format("VP = {:g} is not calculated", data.vp);
  for (const auto& [name, value] : {std::pair("RATEOP", data.rateop),
                                    {"DTF", data.dtf},
                                    {"C2/P", data.c2p},
                                    {"EROD", data.erod},
                                    {"NUMINT", data.numint}})
    if (value != 0) return fmt::format("{} = {:g} is not calculated; set 0", name, value);
  return "";
}

SolverStatus set_johnson_cook(const model::Material& material, Material& result) {
  const model::JohnsonCook& data = *material.johnson_cook;
  for (const std::string& why : {johnson_cook_not_calculated(data), wrong_strength(data), wrong_heat(data)})
    if (!why.empty()) return bad_johnson_cook(material, why);
  JohnsonCook law;
  law.a = data.a;
  law.b = data.b;
  if (data.b > 0) law.n = data.n;
  law.c = data.c;
  if (data.rate > 0) law.rate = data.rate;
  if (data.most_stress > 0) law.most_stress = data.most_stress;
  if (data.saturation > 0) law.saturation = data.saturation;
  if (data.heat > 0) {
    law.heat = material.density * data.heat;
    law.m = data.m;
    law.warming = data.melting - data.room;
  }
  law.d = data.d;
  law.least_failure = data.efmin;
  law.fails = std::any_of(data.d.begin(), data.d.end(), [](double d) { return d != 0; });
  result.kind = MaterialKind::plastic;
  result.failure_strain = data.failure_strain;
  result.viscoplastic = data.vp == 1 && (data.c > 0 || data.d[3] != 0);
  if (!data.simplified && material.young == 0 && data.shear > 0) {
    auto hydro = build_johnson_cook_hydro(material);
    if (!hydro) return hydro.error();
    result.kind = MaterialKind::hydro;
    result.hydro = std::make_shared<const Hydrodynamic>(std::move(hydro).value());
  }
  result.johnson_cook = std::make_shared<const JohnsonCook>(law);
  return {};
}

SolverResult<Hydrodynamic> build_johnson_cook_hydro(const model::Material& material) {
  const model::JohnsonCook& data = *material.johnson_cook;
  if (!(data.shear > 0))
    return bad_johnson_cook(material, fmt::format("G = {:g} is not above 0, which solids need", data.shear));
  if (data.pc > 0) return bad_johnson_cook(material, fmt::format("PC = {:g} is above 0; set 0 or less", data.pc));
  Hydrodynamic hydro;
  hydro.shear = data.shear;
  if (data.pc < 0) hydro.cutoff = data.pc;
  if (data.spall != 0 && data.spall != 1 && data.spall != 2 && data.spall != 3)
    return bad_johnson_cook(material, fmt::format("SPALL = {:g} has no meaning; set 0 to 3", data.spall));
  if (data.pc < 0 && (data.spall == 0 || data.spall == 2)) hydro.spall = Spall::principal;
  if (data.pc < 0 && data.spall == 3) hydro.spall = Spall::pressure;
  return hydro;
}

SolverStatus check_johnson_cook_shell(const model::Material& material) {
  const model::JohnsonCook& data = *material.johnson_cook;
  if (!(material.young > 0)) return bad_johnson_cook(material, "E is not above 0, which shells need");
  if (data.pc != 0)
    return bad_johnson_cook(material, fmt::format("PC = {:g} is not calculated in shells; set 0", data.pc));
  return {};
}

}  // namespace gapcheck::solver
