#include "model/contact/contact_name.hpp"

#include <algorithm>
#include <vector>

#include "keyword/layout.hpp"

namespace gapcheck::model {
namespace {

struct ContactType {
  std::string_view name;  ///< behind CONTACT_, without MORTAR
  ExtraCards extra = ExtraCards::none;
};

/// All 3D contacts.
constexpr ContactType contact_types[] = {
    {"AIRBAG_SINGLE_SURFACE"},
    {"AUTOMATIC_BEAMS_TO_SURFACE"},
    {"AUTOMATIC_GENERAL"},
    {"AUTOMATIC_GENERAL_EDGEONLY"},
    {"AUTOMATIC_GENERAL_INTERIOR"},
    {"AUTOMATIC_GENERAL_TIEBREAK", ExtraCards::tiebreak},
    {"AUTOMATIC_GENERAL_TIEBREAK_BEAM_OFFSET", ExtraCards::tiebreak},
    {"AUTOMATIC_NODES_TO_SURFACE"},
    {"AUTOMATIC_NODES_TO_SURFACE_TIEBREAK", ExtraCards::tiebreak},
    {"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE"},
    {"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK", ExtraCards::tiebreak},
    {"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK_DAMPING", ExtraCards::tiebreak_damping},
    {"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_TIEBREAK_USER", ExtraCards::tiebreak_user},
    {"AUTOMATIC_SINGLE_SURFACE"},
    {"AUTOMATIC_SINGLE_SURFACE_TIEBREAK", ExtraCards::tiebreak},
    {"AUTOMATIC_SINGLE_SURFACE_TIEBREAK_BEAM_OFFSET", ExtraCards::tiebreak},
    {"AUTOMATIC_SINGLE_SURFACE_TIED", ExtraCards::one},
    {"AUTOMATIC_SURFACE_TO_SURFACE"},
    {"AUTOMATIC_SURFACE_TO_SURFACE_COMPOSITE", ExtraCards::one},
    {"AUTOMATIC_SURFACE_TO_SURFACE_LUBRICATION", ExtraCards::one},
    {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", ExtraCards::tiebreak},
    {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_DAMPING", ExtraCards::tiebreak_damping},
    {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_USER", ExtraCards::tiebreak_user},
    {"AUTOMATIC_SURFACE_TO_SURFACE_TIED"},
    {"AUTOMATIC_SURFACE_TO_SURFACE_TIED_WELD", ExtraCards::tied_weld},
    {"CONSTRAINT_NODES_TO_SURFACE", ExtraCards::one},
    {"CONSTRAINT_SURFACE_TO_SURFACE", ExtraCards::one},
    {"DRAWBEAD", ExtraCards::drawbead},
    {"DRAWBEAD_BENDING", ExtraCards::drawbead_initialize},
    {"DRAWBEAD_INITIALIZE", ExtraCards::drawbead_initialize},
    {"ERODING_NODES_TO_SURFACE", ExtraCards::one},
    {"ERODING_SINGLE_SURFACE", ExtraCards::one},
    {"ERODING_SURFACE_TO_SURFACE", ExtraCards::one},
    {"FORCE_TRANSDUCER"},
    {"FORCE_TRANSDUCER_CONSTRAINT"},
    {"FORCE_TRANSDUCER_PENALTY"},
    {"FORMING_NODES_TO_SURFACE"},
    {"FORMING_ONE_WAY_SURFACE_TO_SURFACE"},
    {"FORMING_SURFACE_TO_SURFACE"},
    {"NODES_TO_SURFACE"},
    {"NODES_TO_SURFACE_INTERFERENCE", ExtraCards::one},
    {"ONE_WAY_SURFACE_TO_SURFACE"},
    {"ONE_WAY_SURFACE_TO_SURFACE_INTERFERENCE", ExtraCards::one},
    {"RIGID_BODY_ONE_WAY_TO_RIGID_BODY", ExtraCards::one},
    {"RIGID_BODY_TWO_WAY_TO_RIGID_BODY", ExtraCards::one},
    {"RIGID_NODES_TO_RIGID_BODY", ExtraCards::one},
    {"SINGLE_EDGE"},
    {"SINGLE_SURFACE"},
    {"SLIDING_ONLY"},
    {"SLIDING_ONLY_PENALTY"},
    {"SPOTWELD"},
    {"SPOTWELD_BEAM_OFFSET"},
    {"SPOTWELD_CONSTRAINED_OFFSET"},
    {"SPOTWELD_OFFSET"},
    {"SPOTWELD_WITH_TORSION"},
    {"SPOTWELD_WITH_TORSION_PENALTY"},
    {"SURFACE_TO_SURFACE"},
    {"SURFACE_TO_SURFACE_CONTRACTION_JOINT", ExtraCards::one},
    {"SURFACE_TO_SURFACE_INTERFERENCE", ExtraCards::one},
    {"TIEBREAK_NODES_ONLY", ExtraCards::one},
    {"TIEBREAK_NODES_TO_SURFACE", ExtraCards::one},
    {"TIEBREAK_SURFACE_TO_SURFACE", ExtraCards::one},
    {"TIEBREAK_SURFACE_TO_SURFACE_ONLY", ExtraCards::one},
    {"TIED_NODES_TO_SURFACE"},
    {"TIED_NODES_TO_SURFACE_BEAM_OFFSET"},
    {"TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET"},
    {"TIED_NODES_TO_SURFACE_OFFSET"},
    {"TIED_SHELL_EDGE_TO_SOLID"},
    {"TIED_SHELL_EDGE_TO_SOLID_BEAM_OFFSET"},
    {"TIED_SHELL_EDGE_TO_SOLID_CONSTRAINED_OFFSET"},
    {"TIED_SHELL_EDGE_TO_SOLID_OFFSET"},
    {"TIED_SHELL_EDGE_TO_SURFACE"},
    {"TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET"},
    {"TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET"},
    {"TIED_SHELL_EDGE_TO_SURFACE_OFFSET"},
    {"TIED_SURFACE_TO_SURFACE"},
    {"TIED_SURFACE_TO_SURFACE_BEAM_OFFSET"},
    {"TIED_SURFACE_TO_SURFACE_CONSTRAINED_OFFSET"},
    {"TIED_SURFACE_TO_SURFACE_FAILURE"},
    {"TIED_SURFACE_TO_SURFACE_OFFSET"},
};

/// Families whose blocks have cards of their own.
constexpr std::string_view own_families[] = {"1D",           "2D",     "ADD_WEAR",      "AUTO_MOVE",
                                             "COUPLING",     "ENTITY", "GEBOD",         "INTERIOR",
                                             "GUIDED_CABLE", "NURBS",  "RIGID_SURFACE", "SPG"};
constexpr std::string_view modifiers[] = {"ADD_WEAR", "AUTO_MOVE", "INTERIOR"};

bool in_family(std::string_view name, std::string_view family) {
  return name == family || (name.starts_with(family) && name[family.size()] == '_');
}

template <std::size_t N>
bool in_any(std::string_view name, const std::string_view (&families)[N]) {
  return std::any_of(std::begin(families), std::end(families), [&](auto family) { return in_family(name, family); });
}

std::string joined(const std::vector<std::string_view>& words) {
  std::string name;
  for (const std::string_view word : words) {
    if (!name.empty()) name += '_';
    name += word;
  }
  return name;
}

}  // namespace

std::vector<std::string_view> words_of(std::string_view name) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t cut = name.find('_');
    words.push_back(name.substr(0, cut));
    if (cut == std::string_view::npos) return words;
    name.remove_prefix(cut + 1);
  }
}

ContactName parse_contact_name(std::string_view written) {
  ContactName name;
  std::vector<std::string_view> words = words_of(written), kept;
  bool mortar = false;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string_view word = words[i];
    const bool friction = i + 1 < words.size() && words[i + 1] == "FRICTION";
    if (word == "ID" || word == "TITLE")
      name.id = true;
    else if (word == "MPP")
      name.mpp = true;
    else if (word == "MORTAR")
      mortar = true;
    else if (word == "THERMAL" && words[1] != "2D")
      name.thermal = true, name.thermal_friction = name.thermal_friction || friction, i += friction ? 1 : 0;
    else if (word == "ORTHO" && friction)
      name.ortho_friction = true, ++i;
    else if (word != "SMOOTH")
      kept.push_back(word);
  }
  const std::string type = joined(kept);
  const auto found = std::find_if(std::begin(contact_types), std::end(contact_types),
                                  [&](const ContactType& entry) { return entry.name == type; });
  if (found != std::end(contact_types)) {
    name.known = true;
    name.extra = found->extra;
    name.transducer = in_family(type, "FORCE_TRANSDUCER");
    // The tiebreak of mortar contacts has its option card only.
    if (mortar && name.extra == ExtraCards::tiebreak) name.extra = ExtraCards::one;
  } else if (in_any(type, own_families)) {
    name.known = true;
    name.extra = ExtraCards::own;
    name.modifier = in_any(type, modifiers);
  }
  name.bare = "CONTACT_" + type + (mortar ? "_MORTAR" : "");
  return name;
}

const std::vector<std::string_view>& known_contact_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const ContactType& type : contact_types) list.push_back(type.name);
    constexpr std::string_view family = "CONTACT_";
    for (std::string_view name : keyword::layout_names(family))
      if (name.remove_prefix(family.size()); in_any(name, own_families)) list.push_back(name);
    return list;
  }();
  return names;
}

}  // namespace gapcheck::model
