#include "solver/build/material/build_equation_of_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/build/material/build_johnson_cook.hpp"

namespace gapcheck::solver {
namespace {

using StateKind = model::EquationOfState::Kind;

Failure wrong_material(const model::Material& material, std::string_view why) {
  return Failure{Failure::Kind::bad_material, fmt::format("material {} (*{}): {}", material.id, material.keyword, why),
                 material.place};
}

/// The rows by rising strain; empty if they are in no order.
std::vector<PressureTable::Row> rows_in_order(std::vector<std::array<double, 3>> data) {
  if (data.size() > 1 && data[0][0] > data[1][0]) std::reverse(data.begin(), data.end());
  std::vector<PressureTable::Row> rows;
  for (const auto& [strain, cold, thermal] : data) {
    if (!rows.empty() && !(strain > rows.back().strain)) return {};
    rows.push_back({strain, cold, thermal});
  }
  return rows;
}

SolverResult<EquationOfState> build_state(const model::EquationOfState& data, double density) {
  const auto refused = [&](Failure::Kind kind, std::string_view why) {
    return Failure{kind, fmt::format("equation of state {} (*{}): {}", data.id, data.keyword, why), data.place};
  };
  if (const std::string why = state_not_calculated(data); !why.empty())
    return refused(Failure::Kind::not_calculated, why);
  if (!(data.e0 >= 0)) return refused(Failure::Kind::bad_material, "E0 is below 0; set 0 or more");
  EquationOfState state;
  state.initial_energy = data.e0;
  if (data.kind == StateKind::linear_polynomial) {
    state.law = LinearPolynomial{data.polynomial};
  } else if (data.kind == StateKind::gruneisen) {
    state.law = Gruneisen{density * data.c * data.c, data.s1, data.s2, data.s3, data.gamma, data.a};
  } else {
    PressureTable table{rows_in_order(data.rows), data.gamma};
    if (table.rows.size() < 2)
      return refused(Failure::Kind::bad_material, "its strains EV neither rise nor fall throughout; put them in order");
    state.law = std::move(table);
  }
  if (const double bulk = state.bulk(1, data.e0); !(bulk > 0) || !std::isfinite(bulk))
    return refused(Failure::Kind::bad_material,
                   fmt::format("its bulk modulus at rest is {:g}; the pressure must rise with the density", bulk));
  return state;
}

/// PC, MU, TEROD and CEROD of 009.
SolverResult<Hydrodynamic> build_fluid(const model::Material& material) {
  const model::Fluid& data = *material.fluid;
  if (data.pc > 0) return wrong_material(material, fmt::format("PC = {:g} is above 0; set 0 or less", data.pc));
  if (!(data.mu >= 0)) return wrong_material(material, fmt::format("MU = {:g} is below 0; set 0 or more", data.mu));
  if (data.terod != 0 && !(data.terod > 1))
    return wrong_material(material, fmt::format("TEROD = {:g} is met at rest; set 0 or a number above 1", data.terod));
  if (!(data.cerod >= 0 && data.cerod < 1))
    return wrong_material(material, fmt::format("CEROD = {:g} is met at rest; set 0 to below 1", data.cerod));
  Hydrodynamic hydro;
  hydro.cutoff = data.pc;
  hydro.viscosity = data.mu;
  hydro.least_volume = data.cerod;
  if (data.terod > 0) hydro.largest_volume = data.terod;
  return hydro;
}

}  // namespace

std::string state_not_calculated(const model::EquationOfState& state) {
  if (state.kind == StateKind::other) return "it is none of 001, 004 and 009, which are calculated";
  if (state.by_curves) return "curves (LCC, LCT, LCID) are not calculated; give numbers";
  if (state.v0 != 0 && state.v0 != 1)
    return fmt::format("an initial relative volume (V0 = {:g}) other than 1 is not calculated", state.v0);
  return "";
}

std::string hydro_not_calculated(const model::Hydro& data) {
  if (data.stochastic) return "STOCHASTIC is not calculated";
  if (data.a1 != 0 || data.a2 != 0) return "hardening by pressure (A1, A2) is not calculated";
  if (data.charl != 0) return "CHARL, for elements in two dimensions, is not calculated";
  return "";
}

SolverResult<Hydrodynamic> build_hydro(const model::Material& material) {
  const model::Hydro& data = *material.hydro;
  if (const std::string why = hydro_not_calculated(data); !why.empty()) return wrong_material(material, why);
  if (!(data.shear > 0)) return wrong_material(material, fmt::format("G = {:g} is not above 0", data.shear));
  if (data.pc > 0) return wrong_material(material, fmt::format("PC = {:g} is above 0; set 0 or less", data.pc));
  if (!(data.fs >= 0)) return wrong_material(material, fmt::format("FS = {:g} is below 0; set 0 or more", data.fs));
  Hydrodynamic hydro;
  hydro.shear = data.shear;
  if (data.pc < 0) hydro.cutoff = data.pc;
  if (data.spall != 0 && data.spall != 1 && data.spall != 2 && data.spall != 3)
    return wrong_material(material, fmt::format("SPALL = {:g} has no meaning; set 0 to 3", data.spall));
  if (data.spall > 1 && data.pc == 0)
    return wrong_material(material, fmt::format("SPALL = {:g} needs a PC below 0", data.spall));
  if (data.spall == 2) hydro.spall = Spall::principal;
  if (data.spall == 3) hydro.spall = Spall::pressure;
  return hydro;
}

SolverStatus add_equation_of_state(const model::Model& model, const model::Part& part, Material& material) {
  const model::Material& data = model.materials[*part.material];
  const bool fluid = material.kind == MaterialKind::null && part.eos_id != 0;
  const bool johnson_cook = data.johnson_cook && !data.johnson_cook->simplified;
  if (!fluid && !johnson_cook && !material.hydro) return {};
  const auto found = model.equations_of_state.find(part.eos_id);
  if (found == model.equations_of_state.end())
    return Failure{
        Failure::Kind::unknown_reference,
        part.eos_id == 0
            ? fmt::format("part {}: material {} needs an equation of state; set EOSID of *PART", part.id.value, data.id)
            : fmt::format("part {}: there is no equation of state {} (EOSID)", part.id.value, part.eos_id),
        part.place};
  auto state = build_state(found->second, data.density);
  if (!state) return state.error();
  Hydrodynamic hydro;
  if (fluid) {
    auto built = build_fluid(data);
    if (!built) return built.error();
    hydro = std::move(built).value();
  } else if (johnson_cook) {
    auto built = build_johnson_cook_hydro(data);
    if (!built) return built.error();
    hydro = std::move(built).value();
  } else {
    hydro = *material.hydro;
  }
  hydro.state = std::move(state).value();
  hydro.bulk = hydro.state.bulk(1, hydro.state.initial_energy);
  material.kind = MaterialKind::hydro;
  material.hydro = std::make_shared<const Hydrodynamic>(std::move(hydro));
  return {};
}

}  // namespace gapcheck::solver
