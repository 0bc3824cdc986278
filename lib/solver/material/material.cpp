#include "solver/material/material.hpp"

#include <algorithm>
#include <cmath>

#include "solver/material/falling_root.hpp"

namespace gapcheck::solver {
namespace {

/// σ + C : ε of the isotropic elastic law.
Symmetric elastic_trial(const Material& material, const Symmetric& increment, const Symmetric& stress) {
  const double two_shear = 2 * material.shear();
  const double pressure_part = (material.bulk() - two_shear / 3) * trace(increment);
  Symmetric trial = stress;
  for (std::size_t i = 0; i < 6; ++i) trial[i] += two_shear * increment[i] + (i < 3 ? pressure_part : 0);
  return trial;
}

/// The rate of the whole strain that Johnson and Cook's laws take: √(2/3 ε̇ : ε̇).
double effective_rate(const Symmetric& increment, double dt) {
  return dt > 0 ? std::sqrt(2.0 / 3 * contract(increment, increment)) / dt : 0;
}

/// The yield stress for one step from `start`.
StepYield step_yield(const Material& material, const Symmetric& increment, double dt, const PointState& start) {
  if (const auto& law = material.johnson_cook)
    return {material, effective_rate(increment, dt), dt, law->softening(law->warmth(start.plastic_work))};
  const bool by_rate = dt > 0 && (material.rate_c > 0 || !material.table.curves.empty());
  return {material, by_rate ? std::sqrt(contract(increment, increment)) / dt : 0, dt};
}

/// Stress relative to the centre of the yield surface, its size as a von Mises stress.
struct Relative {
  Symmetric direction;  ///< deviatoric
  double size;
};

Relative relative(const Symmetric& stress, const Symmetric& back_stress) {
  Symmetric xi = deviator(stress);
  for (std::size_t i = 0; i < 6; ++i) xi[i] -= back_stress[i];
  return {xi, std::sqrt(1.5 * contract(xi, xi))};
}

/// The returned point and dσzz/dεzz of the step.
struct Returned {
  PointState point;
  double tangent_zz;
};

/// Radial return from a trial stress.
Returned radial_return(const Material& material, const Symmetric& trial, const StepYield& yield,
                       const PointState& start) {
  const double shear = material.shear();
  PointState point = start;
  point.stress = trial;
  const auto [xi, size] = relative(trial, start.back_stress);
  if (!(size > yield.stress(start.plastic_strain))) return {point, material.wave_modulus()};
  const double kinematic = material.kinematic_slope;
  const auto [increment, slope] = yield.solve(size, 3 * shear + kinematic, start.plastic_strain);
  const double stress_part = 3 * shear * increment / size, shift_part = kinematic * increment / size;
  for (std::size_t i = 0; i < 6; ++i) {
    point.stress[i] -= stress_part * xi[i];
    point.back_stress[i] += shift_part * xi[i];
  }
  point.plastic_strain += increment;
  // The mean stress of the step on the plastic strain 3/2 Δε̄ ξ/q: with it the elastic energy adds up to the whole work.
  point.plastic_work += 0.75 * increment / size * (contract(start.stress, xi) + contract(point.stress, xi));
  const double theta = 1 - stress_part;
  const double theta_bar = 3 * shear / (3 * shear + kinematic + slope) - (1 - theta);
  const double normal_zz = xi[zz] * xi[zz] * 1.5 / (size * size);
  return {point, material.bulk() + 4.0 / 3.0 * shear * theta - 2 * shear * theta_bar * normal_zz};
}

/// Plastic plane-stress step from `start`; `guess` is the elastic εzz.
double plastic_plane(const Material& material, Symmetric increment, const StepYield& yield, double guess,
                     PointState& point) {
  constexpr int newton_steps = 12, most_steps = 100;
  const double tolerance = 1e-10 * yield.stress(point.plastic_strain);
  const PointState start = point;
  increment[zz] = guess;
  for (int step = 0; step < most_steps; ++step) {
    const Returned result = radial_return(material, elastic_trial(material, increment, start.stress), yield, start);
    point = result.point;
    if (!(std::abs(point.stress[zz]) > tolerance)) break;
    // The stiffest slope always converges, if slowly: σzz rises with εzz and never faster than that.
    const double slope =
        step < newton_steps ? std::max(result.tangent_zz, 0.05 * material.wave_modulus()) : material.wave_modulus();
    increment[zz] -= point.stress[zz] / slope;
  }
  // Exactly zero from here on; the removed part is below the tolerance.
  point.stress[zz] = 0;
  return increment[zz];
}

/// What damage needs to know of a point before a step.
struct BeforeFlow {
  double plastic_strain, plastic_work;
  explicit BeforeFlow(const PointState& point)
      : plastic_strain(point.plastic_strain), plastic_work(point.plastic_work) {}
};

/// Adds the damage of a step after Johnson and Cook. `mean`: the mean stress, tension positive.
void grow_damage(const Material& material, const Symmetric& increment, double dt, const BeforeFlow& before, double mean,
                 PointState& point) {
  if (!material.johnson_cook || !material.johnson_cook->fails) return;
  const double flow = point.plastic_strain - before.plastic_strain;
  if (!(flow > 0)) return;
  const JohnsonCook& law = *material.johnson_cook;
  const Symmetric s = deviator(point.stress);
  const double size = std::sqrt(1.5 * contract(s, s));
  const double rate = material.viscoplastic ? flow / dt : effective_rate(increment, dt);
  const double limit = law.failure_strain(size > 0 ? mean / size : 0, rate, law.warmth(before.plastic_work));
  point.damage += limit > 0 ? flow / limit : 1;
}

/// A step of 081 by `step`, which updates the stress that the undamaged part carries. The damage grows with the plastic
/// strain; what the part that goes has stored is dissipated.
template <class Step>
double with_damage(const Material& material, PointState& point, const Step& step) {
  if (!(material.rupture > 0)) return step();
  const double before = point.damage, work = point.plastic_work;
  for (double& s : point.stress) s /= 1 - before;
  const double result = step();
  const double span = material.rupture - material.softening;
  point.damage = std::max(before, std::clamp((point.plastic_strain - material.softening) / span, 0.0, 1.0));
  const double mean = (before + point.damage) / 2;
  point.plastic_work = work + (1 - mean) * (point.plastic_work - work) +
                       (point.damage - before) * elastic_energy(material, point.stress);
  for (double& s : point.stress) s *= 1 - point.damage;
  return result;
}

/// Removes the stress from a point that has reached the failure strain, or whose damage is complete.
void fail_when_due(const Material& material, PointState& point) {
  const bool strained = material.failure_strain > 0 && point.plastic_strain >= material.failure_strain;
  if (!strained && !(point.damage >= 1)) return;
  point.failed = true;
  point.stress = point.back_stress = {};
}

/// update_stress() with an equation of state.
void update_deviator(const Material& material, const Symmetric& increment, double dt, PointState& point) {
  PointState start = point;
  start.stress = deviator(point.stress);
  if (material.shear() > 0) {
    Symmetric trial = start.stress;
    for (std::size_t i = 0; i < 6; ++i) trial[i] += 2 * material.shear() * increment[i];
    point = radial_return(material, trial, step_yield(material, increment, dt, start), start).point;
  } else if (dt > 0) {
    for (std::size_t i = 0; i < 6; ++i) point.stress[i] = 2 * material.hydro->viscosity / dt * increment[i];
    point.plastic_work += (contract(start.stress, increment) + contract(point.stress, increment)) / 2;
  }
}

/// update_plane_stress() of a point that can carry stress.
double plane_stress(const Material& material, const Symmetric& increment, double dt, PointState& point) {
  if (material.kind == MaterialKind::elastic) return PlaneModuli(material).add(increment, point.stress);
  if (material.kind == MaterialKind::anisotropic) return update_anisotropic_plane_stress(material, increment, point);
  if (material.viscoelastic) return update_viscoelastic_plane(material, increment, dt, point);
  if (material.orthotropic) return update_orthotropic_plane(material, increment, point);
  Symmetric trial = point.stress;
  const double through = PlaneModuli(material).add(increment, trial);
  Symmetric rate_increment = increment;
  rate_increment[zz] = through;
  const StepYield yield = step_yield(material, rate_increment, dt, point);
  if (!(relative(trial, point.back_stress).size > yield.stress(point.plastic_strain))) {
    point.stress = trial;
    return through;
  }
  return plastic_plane(material, increment, yield, through, point);
}

}  // namespace

bool Material::valid() const {
  if (!std::isfinite(density) || density <= 0) return false;
  if (kind == MaterialKind::null) return true;
  if (hydro)
    return std::isfinite(hydro->shear) && hydro->shear >= 0 &&
           (hydro->shear == 0 || johnson_cook || yield.stress(0) > 0);
  if (finite) return std::isfinite(finite->wave) && finite->wave > 0;
  if (!std::isfinite(young) || young <= 0 || !(poisson > -1 && poisson < 0.5)) return false;
  if (kind == MaterialKind::anisotropic)
    return !yield.empty() && yield.stress(0) >= 0 && std::isfinite(anisotropy) && anisotropy >= 0;
  if (kind == MaterialKind::rubber)
    return std::isfinite(rubber.a) && std::isfinite(rubber.b) && std::isfinite(rubber.d);
  if (orthotropic) {
    const OrthotropicPlane& law = *orthotropic;
    return law.ea > 0 && law.eb > 0 && law.gab > 0 && law.gbc >= 0 && law.gca >= 0 &&
           law.poisson_ba * law.poisson_ba * law.ea < law.eb;
  }
  if (kind != MaterialKind::plastic || johnson_cook) return true;
  for (const YieldCurve& curve : table.curves)
    if (curve.empty() || !(curve.stress(0) > 0)) return false;
  return !yield.empty() && yield.stress(0) > 0 && std::isfinite(kinematic_slope) && kinematic_slope >= 0;
}

YieldLaw Material::yield_at(double rate) const {
  if (table.curves.empty()) return {&yield, &yield, 0, rate_scale(rate, rate_c, rate_p)};
  const double value = table.logarithmic ? std::log(rate) : rate;
  const auto above = std::upper_bound(table.rates.begin(), table.rates.end(), value);
  const auto position = static_cast<std::size_t>(above - table.rates.begin());
  const YieldCurve* high = &table.curves[std::min(position, table.curves.size() - 1)];
  if (position == 0 || position == table.rates.size()) return {high, high, 0, 1};
  const double low_rate = table.rates[position - 1], high_rate = table.rates[position];
  return {&table.curves[position - 1], high, (value - low_rate) / (high_rate - low_rate), 1};
}

double Material::viscous_stress(double plastic_strain, double plastic_rate) const {
  if (!table.curves.empty()) return yield_at(plastic_rate).stress(plastic_strain);
  const double still = yield.stress(plastic_strain), excess = rate_scale(plastic_rate, rate_c, rate_p) - 1;
  return still + excess * (rate_stress > 0 ? rate_stress : still);
}

YieldCurve::Return StepYield::solve(double trial, double resistance, double plastic_strain) const {
  if (!(dt_ > 0) && !material_->johnson_cook) return law_.solve(trial, resistance, plastic_strain);
  const auto excess = [&](double increment) {
    return trial - resistance * increment - after(plastic_strain, increment);
  };
  const double increment = falling_root(excess, 0, trial / resistance, 1e-15 * trial);
  const double nearby = 1e-6 * increment;
  const double slope =
      nearby > 0
          ? (after(plastic_strain, increment + nearby) - after(plastic_strain, increment - nearby)) / (2 * nearby)
          : 0;
  return {increment, std::max(slope, (1e-6 - 1) * resistance)};
}

Material plastic_kinematic(double density, double young, double poisson, double yield, double tangent, double beta) {
  Material material{MaterialKind::plastic, density, young, poisson, {}, 0, 0, 0, {}, 1};
  const double plastic_slope = young * tangent / (young - tangent);
  material.yield = YieldCurve(yield, beta * plastic_slope);
  material.kinematic_slope = (1 - beta) * plastic_slope;
  return material;
}

double elastic_energy(const Material& material, const Symmetric& stress) {
  if (!material.has_stress()) return 0;
  if (material.hydro) {
    const Symmetric s = deviator(stress);
    return material.shear() > 0 ? contract(s, s) / (4 * material.shear()) : 0;
  }
  const double sum = trace(stress), nu = material.poisson;
  return ((1 + nu) * contract(stress, stress) - nu * sum * sum) / (2 * material.young);
}

void update_stress(const Material& material, const Symmetric& increment, double dt, PointState& point) {
  if (!material.has_stress() || point.failed) return;
  const BeforeFlow before(point);
  if (material.hydro) {
    const double mean = trace(point.stress) / 3;  // the pressure of this step is not known yet
    update_deviator(material, deviator(increment), dt, point);
    grow_damage(material, increment, dt, before, mean, point);
    fail_when_due(material, point);
    return;
  }
  if (material.kind == MaterialKind::elastic)
    point.stress = elastic_trial(material, increment, point.stress);
  else if (material.crushable)
    update_crushable(material, increment, point);
  else if (material.viscoelastic)
    update_viscoelastic(material, increment, dt, point);
  else
    with_damage(material, point, [&] {
      point = radial_return(material, elastic_trial(material, increment, point.stress),
                            step_yield(material, increment, dt, point), point)
                  .point;
      return 0.0;
    });
  grow_damage(material, increment, dt, before, trace(point.stress) / 3, point);
  fail_when_due(material, point);
}

double update_plane_stress(const Material& material, const Symmetric& increment, double dt, PointState& point) {
  if (point.failed || (!material.has_stress() && !material.erosion)) return 0;
  const BeforeFlow before(point);
  const double through =
      material.has_stress() ? with_damage(material, point, [&] { return plane_stress(material, increment, dt, point); })
                            : 0;
  Symmetric whole = increment;
  whole[zz] = through;
  grow_damage(material, whole, dt, before, trace(point.stress) / 3, point);
  fail_when_due(material, point);
  if (material.erosion) {
    for (std::size_t i = 0; i < 6; ++i) point.strain[i] += whole[i];
    erode(material, dt, point);
  }
  return through;
}

void erode(const Material& material, double dt, PointState& point) {
  if (!material.erosion || !(dt > 0) || point.failed) return;
  const Erosion& erosion = *material.erosion;
  const ErosionMeasures measures = erosion_measures(point.stress, point.strain, point.plastic_strain);
  const double excess = std::max(measures.principal_stress - erosion.threshold, 0.0);
  point.impulse += excess * excess * dt;
  if (erosion.met(measures, point.impulse) < erosion.conditions) return;
  point.failed = point.eroded = true;
  point.stress = point.back_stress = {};
}

}  // namespace gapcheck::solver
