#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/ids.hpp"
#include "model/contact/contact_name.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::model {

/// How one side of a contact is given.
enum class SurfaceType : std::uint8_t {
  segment_set = 0,
  shell_set = 1,
  part_set = 2,
  part = 3,
  node_set = 4,
  all = 5,
  exempted_part_set = 6,
  branch = 7,
};

struct SurfaceInput {
  std::int64_t id = 0;    ///< set or part; 0 with type part_set or part on side A means all
  std::int64_t type = 0;  ///< as written; see SurfaceType
  std::int64_t box = 0;   ///< *DEFINE_BOX; 0 = none
  bool given = false;     ///< false: both id and type are blank
  bool operator==(const SurfaceInput&) const = default;
};

/// DT of contacts whose BT is the number of a curve of birth and death times.
inline constexpr double curve_of_times = -9999;

/// Where the lines of a contact's block do not match its cards.
struct CardLines {
  bool any = true;                  ///< false: the block ends before card 1, so that the contact has no surfaces
  std::string missing;              ///< first mandatory card that the block ends before: "card 4 (ISYM, EROSOP, IADJ)"
  std::uint32_t misread = 0;        ///< line in place of the type's own card that cannot be this card; 0: none
  std::string expected;             ///< then: that card
  std::uint32_t surplus = 0;        ///< non-blank lines after the last card
  std::uint32_t first_surplus = 0;  ///< line of the first of them
  bool operator==(const CardLines&) const = default;
};

/// Lines of a contact's cards in its file; 0: the block ends before.
struct ContactLines {
  std::uint32_t mpp = 0, card1 = 0, card2 = 0, card3 = 0;
  std::array<std::uint32_t, 3> optional{};  ///< A, B, C
  std::uint32_t last = 0;                   ///< of the last card up to C; 0: the cards were not read
  bool operator==(const ContactLines&) const = default;
};

/// Card 4 of tiebreak types: when a tie fails, by (tension / normal)^normal_power + (shear / shear)^shear_power >= 1.
struct TiebreakStrength {
  /// NFLF and SFLF, forces on a node, of TIEBREAK_NODES; else NFLS and SFLS, stresses. 0: no such limit.
  double normal = 0, shear = 0;
  double normal_power = 2, shear_power = 2;  ///< NEN, MES
  /// PARAM: of OPTION 6 and 8 the critical opening CCRIT, of 5 a curve, of 7 and 10 the angle of friction in degrees,
  /// of 9 and 11 the exponent of the energies.
  double param = 0;
  double normal_energy = 0, shear_energy = 0;  ///< ERATEN, ERATES: energies per area
  double stiffness = 0;                        ///< CN: stress per length; 0: that of the penalty
  double stiffness_ratio = 1;                  ///< CT2CN: of shear to tension
  std::int64_t curve = 0;                      ///< TBLCID: stress over the gap after failure; 0 = none
  bool thickness_offsets = false;              ///< THKOFF = 1: the thickness counts, and either side may face the other
  bool operator==(const TiebreakStrength&) const = default;
};

/// Card 4 of RIGID types: a force over the penetration. Numbers of curves; 0: none.
struct RigidForce {
  std::int64_t curve = 0;            ///< LCID
  std::int64_t method = 0;           ///< FCM: 1, 4 total force, 2 force on each node, 3 pressure
  double unloading = 0;              ///< US: stiffness; 0: back along the curve
  std::int64_t unloading_curve = 0;  ///< UNLCID
  std::int64_t damping_curve = 0;    ///< LCDC: damping constant over the speed of penetration
  double damping_scale = 1;          ///< DSF
  bool operator==(const RigidForce&) const = default;
};

/// One 3D *CONTACT definition with all its cards. Defaults are the solver's; where "not given" matters, it is an
/// optional. Old and new field names (contact rules, section 1.1): A = slave = tracked, B = master = reference.
struct Contact {
  ContactId id;
  /// Position in the deck among all contacts, from 1; 0 for keywords that only modify others (CONTACT_INTERIOR,
  /// AUTO_MOVE, ADD_WEAR), which then has id 0 too unless one is given.
  std::uint32_t order = 0;
  bool default_id = false;  ///< no ID in the deck: the id is the order, or a free number if that is taken
  std::string title;
  std::string keyword;  ///< without option words: "CONTACT_AUTOMATIC_SINGLE_SURFACE"; set_name() fills it and the next
  std::string written;  ///< as in the deck, upper case, without `*`
  const ContactKind* kind = nullptr;  ///< the row of the table; nullptr: unknown or of a layout of its own
  ContactOptions options;             ///< option words of the keyword
  bool known = true;                  ///< false: no such keyword is known; only id, title and place are filled
  bool own_layout = false;  ///< 2D, ENTITY, INTERIOR, …: the cards are not those of a 3D contact and were not read
  Place place;
  CardLines cards;
  ContactLines lines;

  SurfaceInput a, b;
  bool print_a = false, print_b = false;  ///< SAPR, SBPR: forces on the nodes of that side go to ncforc
  // Card 2
  double fs = 0, fd = 0, dc = 0, vc = 0, vdc = 0;  ///< fs, fd of TIED_..._FAILURE: stresses at which ties fail
  std::int64_t penchk = 0;
  double birth = 0, death = 1e20;  ///< as written; their signs have a meaning, see contact::active_time
  // Card 3; sst, mst: zero = not given
  double sfs = 1, sfm = 1, sst = 0, mst = 0, sfst = 1, sfmt = 1, fsf = 1, vsf = 1;
  // Card 4 of tiebreak types: OPTION
  std::int64_t tiebreak_option = 0;
  TiebreakStrength tiebreak;
  RigidForce rigid;
  // Card 4 of eroding types
  std::int64_t erosop = 0;          ///< EROSOP: 1 = surfaces follow the remaining elements
  std::int64_t iadj = 0;            ///< IADJ: 1 = also inside a body
  std::int64_t symmetry_faces = 0;  ///< ISYM: 1 = faces on planes of symmetry are left out
  // Card 4 of INTERFERENCE types: curves that scale the stiffness, in dynamic relaxation and in the run
  std::int64_t interference_curve_relaxation = 0, interference_curve = 0;
  // MPP card
  std::optional<std::int64_t> mpp_ignore;
  double parmax = 0;            ///< 0 = not given
  std::int64_t mpp_cparm8 = 0;  ///< CPARM8 of this card, which MPP alone reads
  // A
  std::int64_t soft = 0;
  double sofscl = 0.1;
  std::int64_t lcidab = 0;      ///< curve of the thickness over time, only *CONTACT_AIRBAG_SINGLE_SURFACE
  double airbag_thickness = 0;  ///< that curve at time 0; 0 = not given
  double maxpar = 0;            ///< 0 = not given
  std::int64_t sbopt = 2, depth = 2, bsort = 0;
  // B
  double penmax = 0;
  std::int64_t thkopt = 0, shlthk = 0, snlog = 0, isym = 0;
  double sldthk = 0, sldstf = 0;
  // C
  std::int64_t igap = 1;
  std::optional<std::int64_t> ignore;
  double dprfac = 0, dtstif = 0;
  // D
  double dtpchk = 0;
  std::int64_t tcso = 0, tiedid = 0, shledg = 0;
  // E
  std::int64_t sharec = 0, ipback = 0, srnde = 0;
  std::int64_t cparm8 = 0;  ///< 2: spotweld beams take part in types 26 (SMP)
  // F, G
  std::int64_t ignroff = 0;  ///< IGNROFF: shell thickness is ignored on side B (1), A (2) or both (3)
  double shloff = 0;
  std::uint32_t optional_cards = 0;  ///< how many of A … G are in the deck
  bool operator==(const Contact&) const = default;
};

/// True if two contacts differ by their id, title and place in the deck at most.
[[nodiscard]] bool same_cards(const Contact& a, const Contact& b);

/// Fills what a contact has from its keyword (upper case, without `*`).
void set_name(std::string_view written, Contact& contact);

/// *CONTACT_EXCLUDE_INTERACTION: no contact between the two sides, in one contact (0 = in all).
struct ContactExclusion {
  std::int64_t contact = 0;
  struct Pair {
    std::int64_t a = 0, b = 0;  ///< set or part ids
    std::int64_t type_a = 0, type_b = 0;
  };
  std::vector<Pair> pairs;
  Place place;
};

/// Coulomb friction with its limit: μ = FD + (FS - FD) exp(-DC |v|), force at most VC · area where VC > 0.
struct FrictionLaw {
  double fs = 0, fd = 0, dc = 0, vc = 0;
};

/// *DEFINE_FRICTION: friction between pairs of parts, for contacts with FS = -2.
struct FrictionTable {
  std::int64_t id = 0;
  FrictionLaw others;  ///< between parts that no row names
  struct Row {
    std::int64_t i = 0, j = 0;  ///< part, or part set
    bool i_is_set = false, j_is_set = false;
    FrictionLaw law;
  };
  std::vector<Row> rows;
  Place place;
};

/// The solver-wide settings that contact needs, with the solver's defaults.
struct Controls {
  // *CONTROL_CONTACT card 1
  double slsfac = 0.1;
  double rwpnal = 0;  ///< 0: rigid walls ignore the nodes of rigid bodies
  std::int64_t shlthk = 0, penopt = 1, orien = 1;
  std::int64_t enmass = 0;  ///< nodes of failed elements stay in contact: 1 = of solids, 2 = of solids and shells
  // card 2
  double xpene = 4;
  std::int64_t ssthk = 0, ecdt = 0, tiedprj = 0;
  // card 3; zero = not given
  double sfric = 0, dfric = 0, vfc = 0;  ///< friction of parts without their own, in contacts with FS = -1
  double th = 0, th_sf = 0;
  // card 4
  std::int64_t ignore = 0;
  // card 6
  std::int64_t shledg = 0, ftall = 0;
  // *CONTROL_SHELL
  std::int64_t cntco = 0, istupd = 0;
  std::int64_t shell_esort =
      0;  ///< triangles among fully integrated shells: 0 = quads, 1 = C0 triangles, 2 = DKT triangles
  std::int64_t shell_theory = 2;   ///< ELFORM of sections that give none
  std::int64_t shell_normals = 0;  ///< IRNXX
  std::int64_t bwc = 2;            ///< 1: warping stiffness of one-point quads
  std::int64_t proj = 0;           ///< of that: 0 = drill projection, 1 = full projection
  std::int64_t intgrd = 0;         ///< through the thickness: 0 = Gauss, 1 = Lobatto
  std::int64_t pstupd = 0;         ///< set of the parts whose thickness follows; below zero: of those whose does not
  std::int64_t sidt4tu = 0;        ///< set of the parts with ISTUPD = 4
  std::int64_t drcpsid = 0;        ///< set of the parts with a drilling constraint
  // NFAIL1, NFAIL4: 1 = a shell with one or four points that loses its shape fails, 2 = it also is named; PSNFAIL:
  // parts
  std::int64_t nfail1 = 0, nfail4 = 0, psnfail = 0;
  // *CONTROL_TIMESTEP
  double tssfac = 0.9;
  std::int64_t isdo = 0;
  double dt2ms = 0;        ///< mass scaling; zero = none
  double dtinit = 0;       ///< first step; zero = none
  double tslimt = 0;       ///< shells soften to keep this step
  std::int64_t ms1st = 0;  ///< 1: mass is added at the start only
  std::int64_t lctm = 0;   ///< curve that limits the step over time; zero = none
  std::int64_t erode = 0;  ///< 1: solids whose step falls below that of DTMIN are removed instead of ending the run
  Place timestep_place;
  // *CONTROL_SOLUTION: points of a material's curve; 0 = not given
  std::int64_t lcint = 0;
  // *CONTROL_DYNAMIC_RELAXATION; zero as written: the defaults
  std::int64_t idrflg = 0, nrcyck = 250, irelal = 0;
  double drtol = 0.001, drfctr = 0.995;
  double drterm = 0;  ///< end of the relaxation; zero = none
  double tssfdr = 0;  ///< TSSFAC of the relaxation; zero = that of the run
  Place relaxation_place;
  // *CONTROL_TERMINATION; 0 = not given
  double endtim = 0;
  std::int64_t endcyc = 0;
  double dtmin = 0;   ///< the run ends when the step falls below this factor of the first one
  double endeng = 0;  ///< change of the energy ratio, in percent, at which the run ends
  // *CONTROL_HOURGLASS: for parts that name none; 0 = not given
  std::int64_t ihq = 0;
  double qh = 0;
  Place hourglass_place;
  // *CONTROL_SOLID
  std::int64_t solid_esort = 0, psfail = 0;
  Place solid_place;
  // *CONTROL_UNITS
  double length_unit = 0;  ///< metres in the unit of length; 0 = not given
  // *CONTROL_BULK_VISCOSITY
  double bulk_q1 = 1.5, bulk_q2 = 0.06;
  std::int64_t bulk_type = 1;  ///< −1, −2: also in shells; 2: Richards and Wilkins, plane solids only
  std::int64_t bulk_beams = 0, bulk_tshells = 0;  ///< BTYPE, TSTYPE
  Place bulk_place;
  // *CONTROL_ACCURACY
  std::int64_t osu = 0, inn = 1, pidosu = 0;
  Place accuracy_place;
  bool contact_given = false, shell_given = false;
  Place contact_place, shell_place;
};

}  // namespace gapcheck::model
