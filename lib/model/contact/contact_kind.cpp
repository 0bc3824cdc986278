#include "model/contact/contact_kind.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>

namespace gapcheck::model {
namespace {

constexpr std::uint16_t bits(std::initializer_list<Ability> abilities) {
  std::uint16_t all = 0;
  for (const Ability ability : abilities) all |= static_cast<std::uint16_t>(ability);
  return all;
}

constexpr auto kind_table = [] {
  using enum Ability;
  using enum TypeCards;
  using F = Family;
  using T = Treatment;
  using C = ContactCode;
  using M = RunMethod;
  using O = TieOffset;
  constexpr std::uint16_t tells = bits({tells_surfaces});
  constexpr std::uint16_t a3 = bits({soft_2, reads_ignore, friction_table, part_friction, tells_surfaces});
  constexpr std::uint16_t a5 = bits({reads_ignore, friction_table, part_friction, tells_surfaces});
  constexpr std::uint16_t k26 = bits({reads_ignore, friction_table, part_friction, tells_surfaces, edges});
  constexpr std::uint16_t i26 = k26 | bits({interior_edges});
  constexpr std::uint16_t k14 = bits({soft_2, reads_ignore});
  constexpr std::uint16_t fit = bits({interference});
  constexpr std::string_view of_type = "contacts of this type are not calculated";
  // Public texts list types 1 and p1 by name: whether the surfaces may part, and what closes them, is in none.
  constexpr std::string_view slides =
      "how SLIDING_ONLY holds its surfaces together is not published; the nearest contact that is calculated, "
      "CONSTRAINT_SURFACE_TO_SURFACE, lets them part";
  constexpr std::string_view slides_by_springs =
      "how SLIDING_ONLY_PENALTY holds its surfaces together is not published; the nearest contact that is calculated, "
      "SURFACE_TO_SURFACE, lets them part";
  constexpr std::string_view layer = "the layer of COMPOSITE and LUBRICATION contacts is not calculated";
  constexpr std::string_view joint = "contraction joints are not calculated";
  constexpr std::string_view sticks = "the ties of AUTOMATIC_..._TIED contacts are not calculated";
  constexpr std::string_view welds = "welding (TIED_WELD) is not calculated";
  return std::to_array<ContactKind>({
      // name, code, treatment, family, abilities, cards, tie, offset, method, why not, after the tie
      {"SLIDING_ONLY", C::sliding, T::two_way, F::old, 0, none, TieForm::none, O::none, M::none, slides},
      {"SLIDING_ONLY_PENALTY", C::sliding, T::two_way, F::old, 0, none, TieForm::none, O::none, M::none,
       slides_by_springs},

      {"TIED_SURFACE_TO_SURFACE", C::tied_surface, T::one_way, F::tied, 0, none, TieForm::permanent, O::none, M::tie},
      {"TIED_SURFACE_TO_SURFACE_OFFSET", C::tied_surface, T::one_way, F::tied, 0, none, TieForm::permanent, O::penalty,
       M::tie},
      {"TIED_SURFACE_TO_SURFACE_BEAM_OFFSET", C::tied_surface, T::one_way, F::tied, 0, none, TieForm::permanent,
       O::beam, M::tie},
      {"TIED_SURFACE_TO_SURFACE_CONSTRAINED_OFFSET", C::tied_surface, T::one_way, F::tied, 0, none, TieForm::permanent,
       O::constrained, M::tie},
      {"TIED_SURFACE_TO_SURFACE_FAILURE", C::tied_surface, T::one_way, F::tied, 0, none, TieForm::with_failure, O::none,
       M::tie},

      {"SURFACE_TO_SURFACE", C::surface, T::two_way, F::old, bits({soft_2}), none, TieForm::none, O::none, M::penalty},
      {"SURFACE_TO_SURFACE_INTERFERENCE", C::surface, T::two_way, F::old, bits({soft_2}) | fit, interference_card,
       TieForm::none, O::none, M::penalty},
      {"SURFACE_TO_SURFACE_CONTRACTION_JOINT", C::surface, T::two_way, F::old, bits({soft_2}), contraction_joint,
       TieForm::none, O::none, M::none, joint},
      {"AUTOMATIC_SURFACE_TO_SURFACE", C::automatic_surface, T::two_way, F::automatic, a3, none, TieForm::none, O::none,
       M::penalty},
      {"AUTOMATIC_SURFACE_TO_SURFACE_COMPOSITE", C::automatic_surface, T::two_way, F::automatic, a3, composite,
       TieForm::none, O::none, M::none, layer},
      {"AUTOMATIC_SURFACE_TO_SURFACE_LUBRICATION", C::automatic_surface, T::two_way, F::automatic, a3, composite,
       TieForm::none, O::none, M::none, layer},
      {"AUTOMATIC_SURFACE_TO_SURFACE_TIED", C::automatic_surface, T::two_way, F::automatic, a3, none,
       TieForm::automatic_tied, O::none, M::none, sticks},
      {"AUTOMATIC_SURFACE_TO_SURFACE_TIED_WELD", C::automatic_surface, T::two_way, F::automatic, a3, tied_weld,
       TieForm::weld, O::none, M::none, welds},
      {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", C::automatic_surface, T::two_way, F::automatic, a3, tiebreak,
       TieForm::automatic_tiebreak, O::none, M::tiebreak, "", "AUTOMATIC_SURFACE_TO_SURFACE"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_DAMPING", C::automatic_surface, T::two_way, F::automatic, a3,
       tiebreak_damping, TieForm::automatic_tiebreak_damping, O::none, M::tiebreak, "", "AUTOMATIC_SURFACE_TO_SURFACE"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_USER", C::automatic_surface, T::two_way, F::automatic, a3, tiebreak_user,
       TieForm::automatic_tiebreak_user, O::none, M::tiebreak, "", "AUTOMATIC_SURFACE_TO_SURFACE"},
      {"FORMING_SURFACE_TO_SURFACE", C::forming_surface, T::two_way, F::forming, 0, none, TieForm::none, O::none,
       M::penalty},

      {"SINGLE_SURFACE", C::single_surface, T::single_surface, F::automatic,
       bits({soft_2, friction_table, part_friction}), none, TieForm::none, O::none, M::penalty},

      {"NODES_TO_SURFACE", C::nodes, T::one_way, F::old, 0, none, TieForm::none, O::none, M::penalty},
      {"NODES_TO_SURFACE_INTERFERENCE", C::nodes, T::one_way, F::old, fit, interference_card, TieForm::none, O::none,
       M::penalty},
      {"AUTOMATIC_NODES_TO_SURFACE", C::automatic_nodes, T::one_way, F::automatic, a5, none, TieForm::none, O::none,
       M::penalty},
      {"AUTOMATIC_NODES_TO_SURFACE_TIEBREAK", C::automatic_nodes, T::one_way, F::automatic, a5, tiebreak,
       TieForm::automatic_tiebreak, O::none, M::tiebreak, "", "AUTOMATIC_NODES_TO_SURFACE"},
      {"AUTOMATIC_BEAMS_TO_SURFACE", C::automatic_nodes, T::one_way, F::automatic, a5, none, TieForm::none, O::none,
       M::penalty},
      {"FORMING_NODES_TO_SURFACE", C::forming_nodes, T::one_way, F::forming, 0, none, TieForm::none, O::none,
       M::penalty},

      {"TIED_NODES_TO_SURFACE", C::tied_nodes, T::one_way, F::tied, 0, none, TieForm::permanent, O::none, M::tie},
      {"TIED_NODES_TO_SURFACE_OFFSET", C::tied_nodes, T::one_way, F::tied, 0, none, TieForm::permanent, O::penalty,
       M::tie},
      {"TIED_NODES_TO_SURFACE_BEAM_OFFSET", C::tied_nodes, T::one_way, F::tied, 0, none, TieForm::permanent, O::beam,
       M::tie},
      {"TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET", C::tied_nodes, T::one_way, F::tied, 0, none, TieForm::permanent,
       O::constrained, M::tie},

      {"TIED_SHELL_EDGE_TO_SURFACE", C::tied_shell_edge, T::one_way, F::tied, 0, none, TieForm::permanent, O::none,
       M::tie},
      {"TIED_SHELL_EDGE_TO_SURFACE_OFFSET", C::tied_shell_edge, T::one_way, F::tied, 0, none, TieForm::permanent,
       O::penalty, M::tie},
      {"TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET", C::tied_shell_edge, T::one_way, F::tied, 0, none, TieForm::permanent,
       O::beam, M::tie},
      {"TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET", C::tied_shell_edge, T::one_way, F::tied, 0, none,
       TieForm::permanent, O::constrained, M::tie},
      {"TIED_SHELL_EDGE_TO_SOLID", C::tied_shell_edge, T::one_way, F::tied, 0, none, TieForm::permanent, O::none,
       M::tie},
      {"TIED_SHELL_EDGE_TO_SOLID_OFFSET", C::tied_shell_edge, T::one_way, F::tied, 0, none, TieForm::permanent,
       O::penalty, M::tie},
      {"TIED_SHELL_EDGE_TO_SOLID_BEAM_OFFSET", C::tied_shell_edge, T::one_way, F::tied, 0, none, TieForm::permanent,
       O::beam, M::tie},
      {"TIED_SHELL_EDGE_TO_SOLID_CONSTRAINED_OFFSET", C::tied_shell_edge, T::one_way, F::tied, 0, none,
       TieForm::permanent, O::constrained, M::tie},
      {"SPOTWELD", C::tied_shell_edge, T::one_way, F::tied, 0, none, TieForm::permanent, O::none, M::tie},
      {"SPOTWELD_OFFSET", C::tied_shell_edge, T::one_way, F::tied, 0, none, TieForm::permanent, O::penalty, M::tie},
      {"SPOTWELD_BEAM_OFFSET", C::tied_shell_edge, T::one_way, F::tied, 0, none, TieForm::permanent, O::beam, M::tie},
      {"SPOTWELD_CONSTRAINED_OFFSET", C::tied_shell_edge, T::one_way, F::tied, 0, none, TieForm::permanent,
       O::constrained, M::tie},
      {"SPOTWELD_WITH_TORSION", C::tied_shell_edge, T::one_way, F::tied, bits({torsion}), none, TieForm::permanent,
       O::none, M::tie},
      {"SPOTWELD_WITH_TORSION_PENALTY", C::tied_shell_edge, T::one_way, F::tied, bits({torsion}), none,
       TieForm::permanent, O::none, M::tie},

      {"TIEBREAK_NODES_TO_SURFACE", C::tiebreak_nodes, T::one_way, F::tied, 0, tiebreak_nodes, TieForm::tiebreak,
       O::none, M::tiebreak, "", "NODES_TO_SURFACE"},
      {"TIEBREAK_NODES_ONLY", C::tiebreak_nodes, T::one_way, F::tied, 0, tiebreak_nodes, TieForm::tiebreak_only,
       O::none, M::tiebreak},
      {"TIEBREAK_SURFACE_TO_SURFACE", C::tiebreak_surface, T::one_way, F::tied, 0, tiebreak_surface, TieForm::tiebreak,
       O::none, M::tiebreak, "", "SURFACE_TO_SURFACE"},
      {"TIEBREAK_SURFACE_TO_SURFACE_ONLY", C::tiebreak_surface, T::one_way, F::tied, 0, tiebreak_surface,
       TieForm::tiebreak_only, O::none, M::tiebreak, "", "SURFACE_TO_SURFACE"},

      {"ONE_WAY_SURFACE_TO_SURFACE", C::one_way, T::one_way, F::old, bits({soft_2}), none, TieForm::none, O::none,
       M::penalty},
      {"ONE_WAY_SURFACE_TO_SURFACE_INTERFERENCE", C::one_way, T::one_way, F::old, bits({soft_2}) | fit,
       interference_card, TieForm::none, O::none, M::penalty},
      {"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", C::automatic_one_way, T::one_way, F::automatic, a3, none, TieForm::none,
       O::none, M::penalty},
      {"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK", C::automatic_one_way, T::one_way, F::automatic, a3, tiebreak,
       TieForm::automatic_tiebreak, O::none, M::tiebreak, "", "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE"},
      {"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK_DAMPING", C::automatic_one_way, T::one_way, F::automatic, a3,
       tiebreak_damping, TieForm::automatic_tiebreak_damping, O::none, M::tiebreak, "",
       "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE"},
      {"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK_USER", C::automatic_one_way, T::one_way, F::automatic, a3,
       tiebreak_user, TieForm::automatic_tiebreak_user, O::none, M::tiebreak, "",
       "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE"},
      {"FORMING_ONE_WAY_SURFACE_TO_SURFACE", C::forming_one_way, T::one_way, F::forming, 0, none, TieForm::none,
       O::none, M::penalty},

      {"AUTOMATIC_SINGLE_SURFACE", C::automatic_single, T::single_surface, F::automatic, a3, none, TieForm::none,
       O::none, M::penalty},
      {"AUTOMATIC_SINGLE_SURFACE_TIED", C::automatic_single, T::single_surface, F::automatic, a3, tied,
       TieForm::automatic_tied, O::none, M::none, sticks},
      {"AUTOMATIC_SINGLE_SURFACE_TIEBREAK", C::automatic_single, T::single_surface, F::automatic, a3, tiebreak,
       TieForm::automatic_tiebreak, O::none, M::tiebreak, "", "AUTOMATIC_SINGLE_SURFACE"},
      {"AUTOMATIC_SINGLE_SURFACE_TIEBREAK_BEAM_OFFSET", C::automatic_single, T::single_surface, F::automatic, tells,
       tiebreak, TieForm::automatic_tiebreak, O::beam, M::tiebreak, "", "AUTOMATIC_SINGLE_SURFACE"},
      {"AIRBAG_SINGLE_SURFACE", C::airbag_single, T::single_surface, F::automatic,
       bits({soft_2, reads_ignore, part_friction, thickness_curve}), none, TieForm::none, O::none, M::penalty},

      {"ERODING_SURFACE_TO_SURFACE", C::eroding_surface, T::two_way, F::automatic, k14, eroding, TieForm::none, O::none,
       M::penalty},
      {"ERODING_SINGLE_SURFACE", C::eroding_single, T::single_surface, F::automatic,
       k14 | bits({friction_table, part_friction}), eroding, TieForm::none, O::none, M::penalty},
      {"ERODING_NODES_TO_SURFACE", C::eroding_nodes, T::one_way, F::automatic, bits({reads_ignore}), eroding,
       TieForm::none, O::none, M::penalty},

      {"CONSTRAINT_SURFACE_TO_SURFACE", C::constraint_surface, T::two_way, F::constraint, 0, constraint, TieForm::none,
       O::none, M::constraint},
      {"CONSTRAINT_NODES_TO_SURFACE", C::constraint_nodes, T::one_way, F::constraint, 0, constraint, TieForm::none,
       O::none, M::constraint},

      {"RIGID_NODES_TO_RIGID_BODY", C::rigid_nodes, T::one_way, F::other, 0, rigid, TieForm::none, O::none, M::penalty},
      {"RIGID_BODY_ONE_WAY_TO_RIGID_BODY", C::rigid_bodies, T::one_way, F::other, 0, rigid, TieForm::none, O::none,
       M::penalty},
      {"RIGID_BODY_TWO_WAY_TO_RIGID_BODY", C::rigid_bodies, T::two_way, F::other, 0, rigid, TieForm::none, O::none,
       M::penalty},
      {"SINGLE_EDGE", C::single_edge, T::none, F::other, 0, none, TieForm::none, O::none, M::penalty},
      {"DRAWBEAD", C::draw_bead, T::none, F::other, 0, draw_bead, TieForm::none, O::none, M::none, of_type},
      {"DRAWBEAD_BENDING", C::draw_bead, T::none, F::other, 0, draw_bead_initialize, TieForm::none, O::none, M::none,
       of_type},
      {"DRAWBEAD_INITIALIZE", C::draw_bead, T::none, F::other, 0, draw_bead_initialize, TieForm::none, O::none, M::none,
       of_type},
      {"FORCE_TRANSDUCER", C::transducer, T::none, F::other, 0, none, TieForm::none, O::none, M::transducer},
      {two_sided_transducer, C::transducer, T::none, F::other, 0, none, TieForm::none, O::none, M::transducer},
      {"FORCE_TRANSDUCER_CONSTRAINT", C::transducer, T::none, F::other, bits({measures_constraints}), none,
       TieForm::none, O::none, M::transducer},

      {"AUTOMATIC_GENERAL", C::general, T::single_surface, F::automatic, k26, none, TieForm::none, O::none, M::penalty},
      {"AUTOMATIC_GENERAL_EDGEONLY", C::general, T::single_surface, F::automatic, k26 | bits({edges_only}), none,
       TieForm::none, O::none, M::penalty},
      {"AUTOMATIC_GENERAL_TIEBREAK", C::general, T::single_surface, F::automatic, k26, tiebreak,
       TieForm::automatic_tiebreak, O::none, M::tiebreak, "", "AUTOMATIC_GENERAL"},
      {"AUTOMATIC_GENERAL_TIEBREAK_BEAM_OFFSET", C::general, T::single_surface, F::automatic, tells | bits({edges}),
       tiebreak, TieForm::automatic_tiebreak, O::beam, M::tiebreak, "", "AUTOMATIC_GENERAL"},
      {"AUTOMATIC_GENERAL_INTERIOR", C::general_interior, T::single_surface, F::automatic, i26, none, TieForm::none,
       O::none, M::penalty},
  });
}();

/// In the order of ContactCode.
constexpr std::string_view codes[] = {"?",  "1",  "2",  "3",  "a3",  "m3",  "4",  "5",   "a5", "m5", "6",
                                      "7",  "8",  "9",  "10", "a10", "m10", "13", "a13", "14", "15", "16",
                                      "17", "18", "20", "21", "22",  "23",  "25", "26",  "i26"};
static_assert(std::size(codes) == static_cast<std::size_t>(ContactCode::general_interior) + 1);

constexpr std::string_view own_families[] = {"1D",           "2D",     "ADD_WEAR",      "AUTO_MOVE",
                                             "COUPLING",     "ENTITY", "GEBOD",         "INTERIOR",
                                             "GUIDED_CABLE", "NURBS",  "RIGID_SURFACE", "SPG"};
constexpr std::string_view modifiers[] = {"ADD_WEAR", "AUTO_MOVE", "INTERIOR"};

bool in_any(std::string_view name, std::span<const std::string_view> families) {
  return std::any_of(families.begin(), families.end(), [&](std::string_view family) {
    return name == family || (name.starts_with(family) && name[family.size()] == '_');
  });
}

/// The most common keyword of a printed code without an offset's letter; empty: none.
std::string_view keyword_of(std::string_view code) {
  const auto found = std::find_if(kind_table.begin(), kind_table.end(),
                                  [&](const ContactKind& kind) { return printed(kind.code) == code; });
  return found == kind_table.end() ? std::string_view() : found->name;
}

}  // namespace

std::span<const ContactKind> contact_kinds() { return kind_table; }

const ContactKind* find_contact_kind(std::string_view name) {
  const auto found =
      std::find_if(kind_table.begin(), kind_table.end(), [&](const ContactKind& kind) { return kind.name == name; });
  return found == kind_table.end() ? nullptr : &*found;
}

bool has_mortar_form(const ContactKind& kind) {
  return kind.can(Ability::tells_surfaces) || kind.family == Family::forming;
}

std::span<const std::string_view> own_layout_families() { return own_families; }

bool has_own_layout(std::string_view name) { return in_any(name, own_families); }

bool only_modifies(std::string_view name) { return in_any(name, modifiers); }

std::string printed(ContactCode code, TieOffset offset) {
  constexpr std::string_view letters[] = {"", "o", "b", "c"};
  return std::string(letters[static_cast<std::size_t>(offset)]) += codes[static_cast<std::size_t>(code)];
}

std::string_view suffix(TieOffset offset) {
  switch (offset) {
    case TieOffset::none:
      return "";
    case TieOffset::penalty:
      return "_OFFSET";
    case TieOffset::beam:
      return "_BEAM_OFFSET";
    case TieOffset::constrained:
      return "_CONSTRAINED_OFFSET";
  }
  return "";
}

std::string keyword_of_printed(std::string_view code) {
  if (code == "*") return "MORTAR";
  if (const std::string_view whole = keyword_of(code); !whole.empty()) return std::string(whole);
  std::string base(code.size() < 2 ? std::string_view() : keyword_of(code.substr(1)));
  if (base.empty()) return {};
  switch (code.front()) {
    case 'a':
      return "AUTOMATIC_" + base;
    case 'm':
      return "FORMING_" + base;
    case 'o':
      return base.append(suffix(TieOffset::penalty));
    case 'b':
      return base.append(suffix(TieOffset::beam));
    case 'c':
      return base.append(suffix(TieOffset::constrained));
    default:
      return {};
  }
}

std::string recommended_keyword(ContactCode code) {
  return std::string("*").append(contact_prefix).append(keyword_of(printed(code)));
}

}  // namespace gapcheck::model
