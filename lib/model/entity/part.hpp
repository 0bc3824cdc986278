#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/ids.hpp"
#include "base/vector.hpp"
#include "model/entity/discrete_beam.hpp"
#include "model/entity/foam_rubber.hpp"
#include "model/entity/hydrodynamic.hpp"
#include "model/entity/orthotropic.hpp"

namespace gapcheck::model {

/// Where an entity is defined in the deck. Line 0: unknown.
struct Place {
  FileIndex file = none<FileIndex>;
  std::uint32_t line = 0;
  bool operator==(const Place&) const = default;
};

/// Contact data of *PART_CONTACT; zero = not given.
struct PartContact {
  double fs = 0, fd = 0, dc = 0, vc = 0;
  double optt = 0;  ///< contact thickness, replaces all others
  double sft = 0;   ///< scale on the element thickness
  double ssf = 0;   ///< scale on the penalty stiffness
};

/// One layer of *PART_COMPOSITE or *ELEMENT_SHELL_COMPOSITE.
struct Ply {
  std::int64_t material_id = 0;
  double thickness = 0;
  std::optional<std::uint32_t> material;  ///< position in Model::materials
};

/// CMO, CON1 and CON2: how the motion of a rigid body is constrained, as written.
struct BodyConstraint {
  double cmo = 0;  ///< 1: global directions; -1: those of a local system
  std::int64_t translations = 0, rotations = 0;
};

/// Mass properties and initial motion of a rigid body that do not come from its elements (*PART_INERTIA and nodal rigid
/// bodies with _INERTIA); in the model's units and axes.
struct BodyInertia {
  Vector center = Vector::Zero();
  std::int64_t center_node = 0;  ///< the centre is where this node is; 0: as above
  double mass = 0;
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();  ///< about the centre
  Vector velocity = Vector::Zero(), spin = Vector::Zero();
  std::int64_t system = 0;  ///< local system of the tensor, not applied; 0: none
};

struct Part {
  PartId id;
  std::string title;
  std::int64_t section_id = 0, material_id = 0;
  std::optional<std::uint32_t> section;   ///< position in Model::sections
  std::optional<std::uint32_t> material;  ///< position in Model::materials
  std::int64_t hourglass_id = 0;
  std::int64_t eos_id = 0;  ///< equation of state; 0: none
  std::optional<PartContact> contact;
  std::optional<BodyInertia> inertia;
  std::vector<Ply> plies;          ///< of *PART_COMPOSITE
  double composite_thickness = 0;  ///< sum of the plies of *PART_COMPOSITE; 0 = not composite
  Place place;
};

enum class SectionKind : std::uint8_t { shell, solid, thick_shell, beam, discrete, particle, other };

/// Cross-section of a beam. s and t are its axes across, moments of area are taken about them.
struct BeamSection {
  double area = 0, iss = 0, itt = 0, torsion = 0;  ///< torsion: J
  double shear_area = 0;                           ///< 0: rigid against transverse shear
  double line_mass = 0;                            ///< NSM: mass per length that is not of the material
};

/// What integrated beams (ELFORM 1 and 9) say about their cross-section besides its constants, in the model's units.
struct BeamProfile {
  bool tube = false;               ///< CST = 1; otherwise a rectangle
  std::array<double, 2> s{}, t{};  ///< at both ends: sides of the rectangle; of tubes outer and inner diameter
  std::int64_t rule = 2;           ///< QR/IRID: the quadrature; below zero a rule of *INTEGRATION_BEAM
  double shear_factor = 1;         ///< SHRF
  double line_mass = 0;            ///< NSM
  bool arbitrary = false;          ///< CST = 2
  /// NSLOC, NTLOC: where the reference surface is, from -1 to 1 of half a side; the axis is not the line between the
  /// nodes
  std::array<double, 2> location{};
  bool torsion_free = false;  ///< ITOFF = 1 of ELFORM 9
};

/// ELFORM of discrete beams: springs, with neither the mass of a bar nor a contact surface.
inline constexpr std::int64_t discrete_beam = 6;

struct Section {
  std::int64_t id = 0;
  SectionKind kind = SectionKind::other;
  std::int64_t elform = 0;
  std::array<double, 4> thickness{};  ///< shells: T1 … T4; where T2 … T4 are blank they repeat T1
  double nloc = 0;                    ///< shells: NLOC
  std::int64_t nip = 2;               ///< shells: integration points through the thickness
  std::int64_t rule = 0;              ///< shells: QR/IRID; below zero minus the id of an *INTEGRATION_SHELL
  double shrf = 1;                    ///< shells: factor on the transverse shear
  double beam_radius = 0;             ///< beams: outer diameter / 2 of a tube, otherwise √(A/π)
  double beam_area = 0;
  std::optional<BeamSection> beam;            ///< where its constants are given, or follow from a rectangle or tube
  std::optional<BeamProfile> profile;         ///< ELFORM 1 and 9
  std::optional<DiscreteBeamSection> spring;  ///< ELFORM 6
  bool torsional = false;                     ///< discrete: DRO
  bool limited = false;                       ///< discrete: KD, V0, CL, FD, CDL or TDL are given
  Place place;
  /// Of beams that are integrated over their cross-section.
  [[nodiscard]] bool integrated() const { return kind == SectionKind::beam && profile.has_value(); }
};

/// *INTEGRATION_SHELL: integration points through the thickness.
struct ShellRule {
  struct Point {
    double place = 0;          ///< S, from −1 at the lower side to 1
    double weight = 0;         ///< WF: the share of the thickness
    std::int64_t part_id = 0;  ///< whose material it has; 0: that of the element's part
  };
  std::int64_t count = 0;     ///< NIP
  std::int64_t equal = 0;     ///< ESOP: 1: layers of equal thickness
  std::int64_t failure = 0;   ///< FAILOPT
  std::vector<Point> points;  ///< as listed
  Place place;
};

/// *HOURGLASS: how the modes without strain are held. Zero = not given.
struct HourglassControl {
  std::int64_t ihq = 0;
  double qm = 0;
  double q1 = 0, q2 = 0;  ///< bulk viscosity
  double qb = 0, qw = 0;  ///< of shells; of solids with type 6 and 7 qb is VDC
  Place place;
};

/// Yield data of materials 003 and 024; stresses in the model's unit. Zero = not given.
struct Plasticity {
  double sigy = 0, etan = 0, beta = 0;
  double rate_c = 0, rate_p = 0;  ///< Cowper and Symonds
  std::int64_t lcss = 0;          ///< curve (or table) of yield stress over plastic strain
  std::vector<std::array<double, 2>> points =
      {};                             ///< plastic strain, yield stress; EPSi and ESi as far as they are used
  double failure_strain = 0;          ///< FS, FAIL; 0 or from 1e20 on: none
  std::int64_t lcsr = 0;              ///< curve of a factor on the yield stress over the rate
  bool viscoplastic = false;          ///< VP = 1: the rate of the plastic strain counts
  double other_vp = 0;                ///< VP as written where it is neither 0 nor 1
  double anisotropy = 1;              ///< of 037: R as written, the Lankford parameter
  double power_k = 0, power_n = 0;    ///< of 018: σ = K ε^N
  double softening = 0, rupture = 0;  ///< of 081: EPPF, EPPFR
  double thinning = 0, major_strain = 0, failed_points = 0;  ///< of 123 and 081: EPSTHIN, EPSMAJ, NUMINT
  std::int64_t damage_curve = 0;                             ///< of 081: LCDM
  /// The yield stress depends on a rate by C and P.
  [[nodiscard]] bool by_rate() const { return rate_c > 0 && rate_p > 0; }
};

/// Data of spotwelds, material 100, in the model's units. Zero = not given.
struct SpotWeld {
  std::string variant;               ///< name of a variant with other cards, which were not read; empty: *MAT_SPOTWELD
  double sigy = 0, hardening = 0;    ///< EH, over the plastic strain
  std::int64_t curve = 0;            ///< SIGY below zero: curve or table of the yield stress
  double step = 0;                   ///< DT: mass is added until the element's time step is as long
  double failure_time = 0;           ///< TFAIL
  double failure_strain = 0;         ///< EFAIL
  std::array<double, 6> strength{};  ///< NRR NRS NRT MRR MSS MTT: resultants at failure
  double filter = 0;                 ///< NF: number of force vectors that are averaged
};

/// Constants of Mooney–Rivlin rubber, material 027, in the model's units.
struct MooneyRivlin {
  double a = 0, b = 0;
  SpecimenTest test = {};  ///< where A and B are both zero they are fitted to its curve
};

/// Material of springs and dampers. Constants are for translation, in the model's units; for torsion multiply
/// stiffness, damping and force by `length_factor`, squared for those per length.
struct DiscreteMaterial {
  enum class Kind : std::uint8_t {
    spring,            ///< S01: force = constant x elongation
    damper,            ///< S02: force = constant x its rate
    plastic_spring,    ///< S03
    nonlinear_spring,  ///< S04: force by a curve over the elongation
    nonlinear_damper,  ///< S05: force by a curve over the rate
    maxwell_spring,    ///< S07
    inelastic_spring,  ///< S08: force by a curve over the elongation, in tension or in compression alone
  } kind = Kind::spring;
  double constant = 0;  ///< K of S01 and S03, DC of S02, K0 of S07, KU of S08
  double length_factor = 1;
  std::int64_t curve = 0, rate_curve = 0;  ///< S04: LCD, LCR; S05: LCDR; S08: LCFD
  double tangent = 0, yield = 0;           ///< S03: KT, FY
  double long_time = 0, decay = 0;         ///< S07: KI, BETA
  double cutoff = 0, cutoff_force = 0;     ///< S07: TC, 0 = none; FC
  double option = 0;                       ///< S07: COPT
  double sense = 0;                        ///< S08: CTF
};

struct Material {
  std::int64_t id = 0;
  std::string keyword;  ///< "MAT_ELASTIC"; numbers are resolved to names where the manual has both (MAT_001)
  double density = 0, young = 0, poisson = 0;
  double bulk = 0;               ///< given, or E / (3 (1 - 2 ν)); of foams what contacts take
  double wave_modulus = 0;       ///< ρ c² of solids where E and ν do not give it; 0: they do
  bool stiffness_known = false;  ///< the elastic constants above were read, even if they are zero
  bool rigid = false;            ///< MAT_RIGID (020)
  bool null_material = false;    ///< MAT_NULL (009)
  bool spotweld = false;         ///< MAT_SPOTWELD (100)
  bool fabric = false;           ///< MAT_FABRIC (034)
  std::optional<Plasticity> plasticity;
  std::optional<SpotWeld> weld;
  std::optional<DiscreteMaterial> discrete;
  std::optional<DiscreteBeamMaterial> discrete_beam;
  std::optional<MooneyRivlin> mooney_rivlin;
  std::optional<Fluid> fluid;  ///< of 009
  std::optional<Hydro> hydro;  ///< of 010
  std::optional<JohnsonCook> johnson_cook;
  FoamRubber foam_rubber;
  std::optional<Orthotropic> orthotropic;  ///< of 002 and 034
  BodyConstraint constraint;               ///< of rigid ones
  Place place;
};

}  // namespace gapcheck::model
