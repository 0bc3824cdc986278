#include "contact/definition/contact_type.hpp"

#include <array>
#include <cmath>
#include <string_view>

namespace gapcheck::contact {
namespace {

struct Row {
  std::string_view keyword;  // after CONTACT_, without what `tokens` takes away
  std::string_view code;
  Treatment treatment;
  Family family;
  bool edges = false;
};

constexpr auto table = [] {
  using enum Treatment;
  using enum Family;
  return std::array{
      Row{"SLIDING_ONLY", "1", two_way, old},
      Row{"SLIDING_ONLY_PENALTY", "1", two_way, old},
      Row{"TIED_SURFACE_TO_SURFACE", "2", one_way, tied},
      Row{"TIED_SURFACE_TO_SURFACE_FAILURE", "2", one_way, tied},
      Row{"SURFACE_TO_SURFACE", "3", two_way, old},
      Row{"AUTOMATIC_SURFACE_TO_SURFACE", "a3", two_way, automatic},
      Row{"FORMING_SURFACE_TO_SURFACE", "m3", two_way, forming},
      Row{"SINGLE_SURFACE", "4", single_surface, automatic},
      Row{"NODES_TO_SURFACE", "5", one_way, old},
      Row{"AUTOMATIC_NODES_TO_SURFACE", "a5", one_way, automatic},
      Row{"AUTOMATIC_BEAMS_TO_SURFACE", "a5", one_way, automatic},
      Row{"FORMING_NODES_TO_SURFACE", "m5", one_way, forming},
      Row{"TIED_NODES_TO_SURFACE", "6", one_way, tied},
      Row{"TIED_SHELL_EDGE_TO_SURFACE", "7", one_way, tied},
      Row{"TIED_SHELL_EDGE_TO_SOLID", "7", one_way, tied},
      Row{"SPOTWELD", "7", one_way, tied},
      Row{"SPOTWELD_WITH_TORSION", "7", one_way, tied},
      Row{"SPOTWELD_WITH_TORSION_PENALTY", "7", one_way, tied},
      Row{"TIEBREAK_NODES_TO_SURFACE", "8", one_way, tied},
      Row{"TIEBREAK_NODES_ONLY", "8", one_way, tied},
      Row{"TIEBREAK_SURFACE_TO_SURFACE", "9", one_way, tied},
      Row{"TIEBREAK_SURFACE_TO_SURFACE_ONLY", "9", one_way, tied},
      Row{"ONE_WAY_SURFACE_TO_SURFACE", "10", one_way, old},
      Row{"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", "a10", one_way, automatic},
      Row{"FORMING_ONE_WAY_SURFACE_TO_SURFACE", "m10", one_way, forming},
      Row{"AUTOMATIC_SINGLE_SURFACE", "13", single_surface, automatic},
      Row{"AIRBAG_SINGLE_SURFACE", "a13", single_surface, automatic},
      Row{"ERODING_SURFACE_TO_SURFACE", "14", two_way, automatic},
      Row{"ERODING_SINGLE_SURFACE", "15", single_surface, automatic},
      Row{"ERODING_NODES_TO_SURFACE", "16", one_way, automatic},
      Row{"CONSTRAINT_SURFACE_TO_SURFACE", "17", two_way, constraint},
      Row{"CONSTRAINT_NODES_TO_SURFACE", "18", one_way, constraint},
      Row{"RIGID_NODES_TO_RIGID_BODY", "20", one_way, other},
      Row{"RIGID_BODY_TWO_WAY_TO_RIGID_BODY", "21", two_way, other},
      Row{"RIGID_BODY_ONE_WAY_TO_RIGID_BODY", "21", one_way, other},
      Row{"SINGLE_EDGE", "22", none, other},
      Row{"DRAWBEAD", "23", none, other},
      Row{"DRAWBEAD_BENDING", "23", none, other},
      Row{"DRAWBEAD_INITIALIZE", "23", none, other},
      Row{"FORCE_TRANSDUCER", "25", none, other},
      Row{"FORCE_TRANSDUCER_PENALTY", "25", none, other},
      Row{"FORCE_TRANSDUCER_CONSTRAINT", "25", none, other},
      Row{"AUTOMATIC_GENERAL", "26", single_surface, automatic, true},
      Row{"AUTOMATIC_GENERAL_INTERIOR", "i26", single_surface, automatic, true},
      Row{"AUTOMATIC_GENERAL_EDGEONLY", "26", single_surface, automatic, true},
  };
}();

/// Takes a token with its underscore out of a name; true if it was there.
bool take(std::string& name, std::string_view token) {
  const auto at = name.find(token);
  if (at == std::string::npos) return false;
  const auto end = at + token.size();
  if (end != name.size() && name[end] != '_') return false;
  name.erase(at, token.size());
  return true;
}

/// *CONTACT_AUTOMATIC_..._TIEBREAK ties like types 8 and 9 before it works as its base type.
void make_tiebreak(ContactType& type) {
  type.family = Family::tied;
  if (type.treatment != Treatment::single_surface) {
    type.code = type.code == "a5" ? "8" : "9";
    type.treatment = Treatment::one_way;
  }
}

std::string reason(const ContactType& type, bool ties) {
  if (ties)
    return "ties nodes to segments instead of keeping them apart";
  if (type.pairing == Pairing::mortar)
    return "mortar contact works segment to segment; the solver lists no nodes for it (GC108)";
  if (type.code == "20" || type.code == "21") return "rigid-body contact by force curve has no contact thickness";
  if (type.code == "22") return "edge-to-edge contact has no node-to-segment penetrations";
  if (type.code == "23") return "a draw bead has no contact surface of its own";
  if (type.code == "25") return "a force transducer measures other contacts and has no force of its own";
  if (type.pairing == Pairing::segments)
    return "SOFT = 2 works segment to segment; the solver lists no nodes for it (GC107)";
  return {};
}

}  // namespace

ContactType classify(const model::Contact& contact) {
  ContactType type;
  if (!contact.known) {
    type.code = "?";
    type.not_checked = "the keyword *" + contact.written + " is not known";
    return type;
  }
  if (contact.own_layout) {
    type.code = "?";
    type.not_checked = "*" + contact.keyword + " is not a contact between segments of shells and solids";
    return type;
  }
  if (!contact.cards.any) {
    type.code = "?";
    type.not_checked = "*" + contact.keyword + " ends before its first card";
    return type;
  }
  std::string name = contact.keyword.starts_with("CONTACT_") ? contact.keyword.substr(8) : contact.keyword;
  const bool mortar = take(name, "_MORTAR");
  const bool tiebreak = take(name, "_TIEBREAK_USER") || take(name, "_TIEBREAK_DAMPING") || take(name, "_TIEBREAK");
  const bool tied_weld = take(name, "_TIED_WELD") || (!name.starts_with("TIED") && take(name, "_TIED"));
  std::string prefix;
  if (take(name, "_CONSTRAINED_OFFSET")) prefix = "c";
  if (take(name, "_BEAM_OFFSET")) prefix = "b";
  if (take(name, "_OFFSET")) prefix = "o";
  for (const std::string_view token : {"_SMOOTH", "_ORTHO_FRICTION", "_THERMAL_FRICTION", "_THERMAL", "_INTERFERENCE",
                                       "_COMPOSITE", "_LUBRICATION", "_CONTRACTION_JOINT"})
    take(name, token);
  for (const Row& row : table) {
    if (row.keyword != name) continue;
    type.code = prefix + std::string(row.code);
    type.treatment = row.treatment;
    type.family = mortar ? Family::mortar : row.family;
    type.edges = row.edges;
    if (tiebreak && type.family == Family::automatic) make_tiebreak(type);
    type.interior_edges = row.code == "i26";
    const bool ties = tiebreak || tied_weld || row.family == Family::tied;
    if (row.treatment != Treatment::none && row.family != Family::other && !ties)
      type.pairing = mortar                                  ? Pairing::mortar
                     : contact.soft == 2 && has_soft_2(type) ? Pairing::segments
                                                             : Pairing::nodes;
    type.not_checked = reason(type, ties);
    return type;
  }
  type.code = "?";
  type.not_checked = "*" + contact.keyword + " is none of the contact types whose rules are known";
  return type;
}

model::Contact after_failure(const model::Contact& tiebreak) {
  model::Contact contact = tiebreak;
  for (const std::string_view token : {"_TIEBREAK_USER", "_TIEBREAK_DAMPING", "_TIEBREAK", "_ONLY"})
    take(contact.keyword, token);
  contact.sst = std::abs(tiebreak.sst);
  contact.mst = std::abs(tiebreak.mst);
  return contact;
}

bool has_soft_2(const ContactType& type) {
  for (const std::string_view code : {"3", "a3", "4", "13", "a13", "14", "15", "10", "a10"})
    if (type.code == code) return true;
  return false;
}

bool knows_ignore(const ContactType& type) {
  return (type.family == Family::automatic && type.code != "4") || type.family == Family::mortar;
}

namespace {

/// SHLEDG is read by segment-based contact alone (contact rules, section 3.3); 2 on the contact is round, whatever the
/// control card says. SRNDE = 1 does not let edges grow either. Mortar segments meet where they overlap in
/// projection: nothing lies beside a free edge.
bool has_square_edges(const model::Contact& contact, const ContactType& type, const model::Controls& controls) {
  if (type.family == Family::mortar || contact.srnde == 1) return true;
  const std::int64_t edges = contact.shledg != 0 ? contact.shledg : controls.shledg;
  return type.pairing == Pairing::segments && edges == 1;
}

}  // namespace

ContactSettings settings(const model::Contact& contact, const ContactType& type, const model::Controls& controls) {
  ContactSettings s;
  // Zero leaves the decision to the next place: pre-processors write zeros into every field.
  s.ignore = contact.mpp_ignore.value_or(0);
  if (s.ignore == 0) s.ignore = contact.ignore.value_or(0);
  if (s.ignore == 0) s.ignore = controls.ignore;
  if (!knows_ignore(type)) s.ignore = 0;
  s.snlog = contact.snlog;
  switch (type.family) {
    case Family::old:
      // THKOPT: 0 takes the global setting, 1 the one beside it, 2 none (contact rules, section 4.4).
      s.shlthk = contact.thkopt == 2 ? 0 : contact.thkopt == 1 ? contact.shlthk : controls.shlthk;
      break;
    case Family::forming:
      // The blank's thickness counts, that of rigid tools does not, unless SHLTHK = 2.
      s.shlthk = contact.shlthk == 2 ? 2 : 1;
      break;
    case Family::mortar: s.shlthk = type.code.starts_with('m') && contact.shlthk != 2 ? 1 : 2; break;
    default: s.shlthk = 2;
  }
  s.square_edges = has_square_edges(contact, type, controls);
  s.mid_surface_offset = controls.cntco != 0 || contact.shloff > 0;
  s.thickness_limit = type.treatment == Treatment::single_surface && controls.ssthk == 0;
  return s;
}

}  // namespace gapcheck::contact
