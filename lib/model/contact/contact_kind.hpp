#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace gapcheck::model {

/// Which nodes contact which segments (contact rules, section 1).
enum class Treatment : std::uint8_t { one_way, two_way, single_surface, none };

/// What the surfaces mean: `old` types are oriented and may ignore thickness, `automatic` ones are two-sided.
enum class Family : std::uint8_t { old, automatic, forming, constraint, tied, mortar, other };

/// The solver's code of a contact, without the letter of an offset form. printed() gives it as the solver's files do.
enum class ContactCode : std::uint8_t {
  unknown,             ///< "?"
  sliding,             ///< "1"
  tied_surface,        ///< "2"
  surface,             ///< "3"
  automatic_surface,   ///< "a3"
  forming_surface,     ///< "m3"
  single_surface,      ///< "4"
  nodes,               ///< "5"
  automatic_nodes,     ///< "a5"
  forming_nodes,       ///< "m5"
  tied_nodes,          ///< "6"
  tied_shell_edge,     ///< "7"
  tiebreak_nodes,      ///< "8"
  tiebreak_surface,    ///< "9"
  one_way,             ///< "10"
  automatic_one_way,   ///< "a10"
  forming_one_way,     ///< "m10"
  automatic_single,    ///< "13"
  airbag_single,       ///< "a13"
  eroding_surface,     ///< "14"
  eroding_single,      ///< "15"
  eroding_nodes,       ///< "16"
  constraint_surface,  ///< "17"
  constraint_nodes,    ///< "18"
  rigid_nodes,         ///< "20"
  rigid_bodies,        ///< "21"
  single_edge,         ///< "22"
  draw_bead,           ///< "23"
  transducer,          ///< "25"
  general,             ///< "26"
  general_interior,    ///< "i26"
};

/// What a tie does with the distance between node and segment.
enum class TieOffset : std::uint8_t {
  none,
  penalty,      ///< _OFFSET, "o": kept, its moment is ignored
  beam,         ///< _BEAM_OFFSET, "b": kept with its moment
  constrained,  ///< _CONSTRAINED_OFFSET, "c": the same by a constraint
};

/// Whether and how a contact ties.
enum class TieForm : std::uint8_t {
  none,
  permanent,      ///< TIED and SPOTWELD types
  with_failure,   ///< TIED_SURFACE_TO_SURFACE_FAILURE
  tiebreak,       ///< TIEBREAK types, 8 and 9
  tiebreak_only,  ///< the same with _ONLY: no contact after the failure
  automatic_tiebreak,
  automatic_tiebreak_damping,
  automatic_tiebreak_user,
  automatic_tied,  ///< AUTOMATIC_…_TIED
  weld,            ///< …_TIED_WELD
};

/// The cards of a type that follow the three mandatory ones.
enum class TypeCards : std::uint8_t {
  none,
  eroding,
  interference_card,
  constraint,
  rigid,
  composite,  ///< COMPOSITE and LUBRICATION
  contraction_joint,
  tied,
  tiebreak,          ///< OPTION card; two more for the options with a cohesive law, but for mortar contacts
  tiebreak_damping,  ///< the same with a damping card after the first
  tiebreak_user,     ///< three
  tiebreak_nodes,
  tiebreak_surface,
  tied_weld,  ///< one, plus the number of parameters that it gives
  draw_bead,  ///< one, plus one per bead
  draw_bead_initialize,
};

/// What the solver of gapcheck does with a contact while it runs, before the settings on its cards are considered.
enum class RunMethod : std::uint8_t { none, penalty, constraint, tie, tiebreak, transducer };

/// Abilities of a type.
enum class Ability : std::uint16_t {
  soft_2 = 1,                  ///< has the segment-based contact of SOFT = 2; the solver switches others to SOFT = 1
  reads_ignore = 2,            ///< reads IGNORE (contact rules, section 7)
  edges = 4,                   ///< beams are reference lines too, and edges contact edges
  interior_edges = 8,          ///< also edges between shells
  edges_only = 16,             ///< nodes and segments do not meet
  friction_table = 32,         ///< FS = -2, *DEFINE_FRICTION
  part_friction = 64,          ///< FS = -1, *PART_CONTACT
  tells_surfaces = 128,        ///< says which of its forces act between which surfaces (automatic types)
  interference = 256,          ///< an initial overlap is intended
  measures_constraints = 512,  ///< a transducer that measures ties and constraint contacts, not penalty contacts
  thickness_curve = 1024,      ///< LCIDAB gives a thickness over time
  torsion = 2048,              ///< a tie that carries moments about the normal into the segment
};

/// One kind of contact: a row of the table of contact_kinds(), the only place where a contact's keyword or code is
/// text.
struct ContactKind {
  std::string_view name;                    ///< the keyword after `*CONTACT_`, without option words and MORTAR
  ContactCode code = ContactCode::unknown;  ///< of tiebreaks of automatic types that of the base type
  Treatment treatment = Treatment::none;
  Family family = Family::other;
  std::uint16_t abilities = 0;
  TypeCards cards = TypeCards::none;
  TieForm tie = TieForm::none;
  TieOffset offset = TieOffset::none;
  RunMethod method = RunMethod::none;
  std::string_view not_run{};    ///< of RunMethod::none: why
  std::string_view after_tie{};  ///< name of the kind that a tiebreak becomes once its ties have failed

  [[nodiscard]] constexpr bool can(Ability ability) const {
    return (abilities & static_cast<std::uint16_t>(ability)) != 0;
  }
  [[nodiscard]] constexpr bool ties() const { return tie != TieForm::none; }
  /// Tiebreaks of any type.
  [[nodiscard]] constexpr bool breaks() const {
    return tie == TieForm::tiebreak || tie == TieForm::tiebreak_only || automatic_tiebreak();
  }
  [[nodiscard]] constexpr bool automatic_tiebreak() const {
    return tie == TieForm::automatic_tiebreak || tie == TieForm::automatic_tiebreak_damping ||
           tie == TieForm::automatic_tiebreak_user;
  }
};

/// All 3D contacts between surfaces; of each code the most common keyword first.
[[nodiscard]] std::span<const ContactKind> contact_kinds();

/// The kind of this name; nullptr if there is none.
[[nodiscard]] const ContactKind* find_contact_kind(std::string_view name);

/// True for kinds that have a MORTAR form: automatic and forming ones.
[[nodiscard]] bool has_mortar_form(const ContactKind& kind);

/// Families of *CONTACT keywords whose blocks have their own cards: 2D, ENTITY, INTERIOR, …
[[nodiscard]] std::span<const std::string_view> own_layout_families();
/// True for a keyword of such a family (after `*CONTACT_`).
[[nodiscard]] bool has_own_layout(std::string_view name);
/// Those of them that define no interface but change others: ADD_WEAR, AUTO_MOVE, INTERIOR.
[[nodiscard]] bool only_modifies(std::string_view name);

/// As the solver prints a type: "13", "a3", "o6"; "?" for ContactCode::unknown.
[[nodiscard]] std::string printed(ContactCode code, TieOffset offset = TieOffset::none);

/// What a form's keyword ends with: "_OFFSET", "_BEAM_OFFSET", "_CONSTRAINED_OFFSET"; empty for none.
[[nodiscard]] std::string_view suffix(TieOffset offset);

/// The most common keyword (after `*CONTACT_`) of a printed code: "AUTOMATIC_SURFACE_TO_SURFACE" for "a3", "MORTAR" for
/// "*"; empty for unknown codes.
[[nodiscard]] std::string keyword_of_printed(std::string_view code);

/// The most common keyword of a code with `*CONTACT_`, for messages that recommend it.
[[nodiscard]] std::string recommended_keyword(ContactCode code);

/// What begins every keyword of a contact and what ends that of a mortar contact.
inline constexpr std::string_view contact_prefix = "CONTACT_", mortar_suffix = "_MORTAR";
/// The force transducer that can have a second surface.
inline constexpr std::string_view two_sided_transducer = "FORCE_TRANSDUCER_PENALTY";
/// The keyword that excludes pairs of parts from contacts.
inline constexpr std::string_view exclusion_keyword = "CONTACT_EXCLUDE_INTERACTION";

}  // namespace gapcheck::model
