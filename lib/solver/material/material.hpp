#pragma once
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>

#include "solver/material/crushable_foam.hpp"
#include "solver/material/erosion.hpp"
#include "solver/material/finite_law.hpp"
#include "solver/material/hardening.hpp"
#include "solver/material/hydrodynamic.hpp"
#include "solver/material/johnson_cook.hpp"
#include "solver/material/orthotropic.hpp"
#include "solver/material/rubber.hpp"
#include "solver/material/viscoelastic.hpp"
#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// The history of an integration point. In shells the axes are the element's, in solids the global ones.
struct PointState {
  Symmetric stress{};
  Symmetric back_stress{};    ///< centre of the yield surface, deviatoric; of 006 the stress that relaxes
  double plastic_strain = 0;  ///< effective; of 063 ln V, the sum of volume strains
  double plastic_work = 0;    ///< per volume, since the start
  double damage = 0;    ///< of 015: Σ Δε̄ / ε̄ at failure; of 081 ω, the stress has 1 − ω; it fails at 1
  double axis = 0;      ///< of orthotropic shells: the angle from the element's x to the material's a
  bool failed = false;  ///< no stress from then on
  // Of materials with erosion alone:
  Symmetric strain{};   ///< sum of the strain increments
  double impulse = 0;   ///< ∫ (σ₁ − SIGTH)² dt over the times when σ₁ is above SIGTH
  bool eroded = false;  ///< it has failed by its erosion criteria
};

enum class MaterialKind : std::uint8_t {
  elastic,       ///< 001
  plastic,       ///< 003, 024
  anisotropic,   ///< 037: plastic, in plane stress only
  null,          ///< 009: mass, no stress
  rigid,         ///< 020: no stress; elastic constants count for contact and time step only
  rubber,        ///< 027, and laws of FiniteLaw: stress by the deformation since the start, in solids only
  orthotropic,   ///< 002, 034: in shells only
  viscoelastic,  ///< 006
  crushable,     ///< 063: in solids only
  hydro,  ///< 009, 010 and 015 with an equation of state, in solids only: points have deviators, pressures are added
};

/// Yield curves over the strain rate, rates rising, curves aligned. Linear in the rate (or its logarithm) between them,
/// constant beyond.
struct RateTable {
  bool logarithmic = false;  ///< then rates are natural logarithms
  std::vector<double> rates;
  std::vector<YieldCurve> curves;
};

/// Constants of one material, in the deck's units.
struct Material {
  MaterialKind kind = MaterialKind::elastic;
  double density = 0, young = 0, poisson = 0;
  YieldCurve yield;               ///< of the isotropic part
  double kinematic_slope = 0;     ///< (1 − β) Eₚ of material 003
  double rate_c = 0, rate_p = 0;  ///< Cowper–Symonds on the total strain rate √(ε̇:ε̇); zero = rate independent
  RateTable table = {};           ///< replaces `yield` if it has curves
  double anisotropy = 1;          ///< R of 037
  double failure_strain = 0;      ///< effective plastic strain at which a point fails; 0: it never does
  Rubber rubber = {};             ///< of 027
  bool viscoplastic = false;      ///< VP = 1: the rate is that of the effective plastic strain
  double rate_stress = 0;         ///< SIGY of 024 with VP = 1, which the rate multiplies; 0: it multiplies the whole
  std::optional<Erosion> erosion = {};                   ///< *MAT_ADD_EROSION
  std::shared_ptr<const JohnsonCook> johnson_cook = {};  ///< of 015 and 098; replaces `yield`
  std::shared_ptr<const Hydrodynamic> hydro = {};        ///< of the kind `hydro`; then E and ν do not count
  std::shared_ptr<const FiniteLaw> finite = {};          ///< of the kind `rubber`; replaces 027's
  std::shared_ptr<const CrushableFoam> crushable = {};   ///< of 063
  std::optional<Viscoelastic> viscoelastic = {};         ///< of 006
  std::optional<OrthotropicPlane> orthotropic = {};      ///< of 002 and 034
  double softening = 0, rupture = 0;  ///< of 081: plastic strains at which the damage begins and is complete
  double damping = 0;                 ///< DAMP of foams, in solids: a stress DAMP ρ c l ε̇ beside that of the point

  [[nodiscard]] double shear() const { return hydro ? hydro->shear : young / (2 * (1 + poisson)); }
  /// Of equations of state: at rest.
  [[nodiscard]] double bulk() const { return hydro ? hydro->bulk : young / (3 * (1 - 2 * poisson)); }
  /// Largest stiffness of a plane wave: K + 4/3 G. Of rubber K, which LS-DYNA takes (read off a run).
  [[nodiscard]] double wave_modulus() const {
    if (finite) return finite->wave;
    return bulk() + (kind == MaterialKind::rubber ? 0 : 4.0 / 3.0 * shear());
  }
  /// Of a plate: E / (1 − ν²).
  [[nodiscard]] double plate_modulus() const { return young / (1 - poisson * poisson); }
  /// Points may fail, by the material's own criteria or by erosion.
  [[nodiscard]] bool can_fail() const {
    return failure_strain > 0 || rupture > 0 || erosion.has_value() || (johnson_cook && johnson_cook->fails);
  }
  [[nodiscard]] bool solids_only() const {
    return kind == MaterialKind::rubber || kind == MaterialKind::hydro || kind == MaterialKind::crushable;
  }
  [[nodiscard]] bool shells_only() const {
    const bool limited = erosion && (std::isfinite(erosion->thinning) || std::isfinite(erosion->in_plane_strain));
    return kind == MaterialKind::anisotropic || kind == MaterialKind::orthotropic || limited;
  }
  /// Hooke's law alone: points remember nothing but their stress.
  [[nodiscard]] bool linear() const { return kind == MaterialKind::elastic && !can_fail(); }
  [[nodiscard]] bool in_beams() const { return !johnson_cook && !viscoelastic && !(rupture > 0); }
  /// Points turn their back_stress with the material.
  [[nodiscard]] bool has_back_stress() const { return kinematic_slope > 0 || viscoelastic; }
  [[nodiscard]] bool has_stress() const { return kind != MaterialKind::null && kind != MaterialKind::rigid; }
  /// The yield stress at a strain rate.
  [[nodiscard]] YieldLaw yield_at(double rate) const;
  /// With VP = 1, of an effective plastic strain and its rate: σ + SIGY (ε̇ₚ/C)^(1/P), σ (1 + (ε̇ₚ/C)^(1/P)) without
  /// SIGY, or that of the table.
  [[nodiscard]] double viscous_stress(double plastic_strain, double plastic_rate) const;
  /// All constants finite and in the range where the formulas are meaningful: density > 0; for materials with stress
  /// also E > 0, −1 < ν < 0.5 and a yield stress above 0.
  [[nodiscard]] bool valid() const;
};

/// The yield stress over one step of plastic flow.
class StepYield {
 public:
  /// `total_rate`: of the whole strain; with VP = 1 the rate of the plastic strain counts instead, its increment / dt.
  /// `softening`: factor by which heat has softened laws after Johnson and Cook.
  StepYield(const Material& material, double total_rate, double dt, double softening = 1)
      : material_(&material),
        law_(material.yield_at(material.viscoplastic ? 0 : total_rate)),
        rate_(material.viscoplastic ? 0 : total_rate),
        softening_(softening),
        dt_(material.viscoplastic ? dt : 0) {}

  /// Before it flows.
  [[nodiscard]] double stress(double plastic_strain) const {
    if (material_->johnson_cook) return softening_ * material_->johnson_cook->stress(plastic_strain, rate_);
    return law_.stress(plastic_strain);
  }
  /// After the plastic strain has grown by `increment` in the step.
  [[nodiscard]] double after(double plastic_strain, double increment) const {
    if (material_->johnson_cook)
      return softening_ *
             material_->johnson_cook->stress(plastic_strain + increment, dt_ > 0 ? increment / dt_ : rate_);
    return dt_ > 0 ? material_->viscous_stress(plastic_strain + increment, increment / dt_)
                   : law_.stress(plastic_strain + increment);
  }
  /// Solves trial − resistance · Δ = after(plastic_strain, Δ); with VP = 1 to rounding, without it exactly. The slope
  /// is that of after() at Δ.
  [[nodiscard]] YieldCurve::Return solve(double trial, double resistance, double plastic_strain) const;

 private:
  const Material* material_;
  YieldLaw law_;
  double rate_, softening_;
  double dt_;  ///< 0: the plastic rate does not count
};

/// Isotropic bilinear law of material 003: Eₚ = E Eₜ / (E − Eₜ), β shares it between growth (1) and shift (0).
[[nodiscard]] Material plastic_kinematic(double density, double young, double poisson, double yield, double tangent,
                                         double beta);

/// Elastic energy per volume of a stress: ½ σ : C⁻¹ : σ; of `hydro` that of its deviator. Zero for materials without
/// stress. Not for rubber.
[[nodiscard]] double elastic_energy(const Material& material, const Symmetric& stress);
/// The same of a point, whose stress may have parts with moduli of their own (006).
[[nodiscard]] double elastic_energy(const Material& material, const PointState& point);

/// Adds the strain increment (over dt) to a point in three dimensions. Plasticity: radial return to the von Mises
/// cylinder (Wilkins; Krieg and Key), exact for a piecewise linear curve. Null, rigid and failed: stress stays zero.
/// Not for rubber.
/// Of `hydro` the deviator alone: return mapping, or 2 μ dev ε̇ without a shear modulus, whose work counts as plastic.
void update_stress(const Material& material, const Symmetric& increment, double dt, PointState& point);

/// update_stress() of 063: Hooke's law, then each principal stress is cut to its limits.
void update_crushable(const Material& material, const Symmetric& increment, PointState& point);
/// update_stress() of 006: the exact solution for a constant rate in the step.
void update_viscoelastic(const Material& material, const Symmetric& increment, double dt, PointState& point);
/// The same in plane stress; returns εzz.
double update_viscoelastic_plane(const Material& material, Symmetric increment, double dt, PointState& point);

/// update_plane_stress() of 002 and 034.
double update_orthotropic_plane(const Material& material, const Symmetric& increment, PointState& point);
[[nodiscard]] double orthotropic_energy(const OrthotropicPlane& law, const PointState& point);

/// The same with σzz = 0: increment[zz] is not read but solved for, and returned. Plastic points iterate on it with the
/// consistent tangent (Simo and Taylor 1985) until σzz is below 1e-10 of the yield stress.
double update_plane_stress(const Material& material, const Symmetric& increment, double dt, PointState& point);

/// Hooke's law in plane stress.
struct PlaneModuli {
  double plate, poisson, two_shear, thinning;
  explicit PlaneModuli(const Material& material)
      : plate(material.plate_modulus()),
        poisson(material.poisson),
        two_shear(2 * material.shear()),
        thinning(-poisson / (1 - poisson)) {}
  /// Adds the stress of a strain increment; returns εzz.
  double add(const Symmetric& increment, Symmetric& stress) const {
    stress[xx] += plate * (increment[xx] + poisson * increment[yy]);
    stress[yy] += plate * (increment[yy] + poisson * increment[xx]);
    stress[zz] = 0;
    for (const std::size_t i : {xy, yz, zx}) stress[i] += two_shear * increment[i];
    return thinning * (increment[xx] + increment[yy]);
  }
};

/// Fails a point whose stress and strain at the end of a step of dt meet the material's erosion criteria; nothing
/// without erosion or with dt = 0.
void erode(const Material& material, double dt, PointState& point);

/// Material 037 in plane stress: transverse isotropy after Hill with the Lankford parameter R,
/// q² = σxx² + σyy² − 2R/(1+R) σxx σyy + 2(1+2R)/(1+R) σxy² + 3 (σyz² + σzx²) <= σ(ε̄)², associated flow. Pressure,
/// shear and transverse shear each return by their own factor (Simo and Taylor 1986), so one scalar equation is left,
/// which is bracketed. R = 1 is von Mises. Returns εzz.
double update_anisotropic_plane_stress(const Material& material, const Symmetric& increment, PointState& point);

}  // namespace gapcheck::solver
