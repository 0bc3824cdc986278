#include "contact/definition/contact_type.hpp"

#include <cmath>

#include "records/record_rules.hpp"

namespace gapcheck::contact {
namespace {

/// *CONTACT_AUTOMATIC_..._TIEBREAK ties like types 8 and 9 before it acts as its base type.
void make_tiebreak(ContactType& type) {
  type.family = Family::tied;
  if (type.treatment == Treatment::single_surface) return;
  type.code = type.code == ContactCode::automatic_nodes ? ContactCode::tiebreak_nodes : ContactCode::tiebreak_surface;
  type.treatment = Treatment::one_way;
  type.abilities = 0;
}

/// OPTION 2 with PARAM = 1: the surfaces are oriented, and the thickness of shells is left out.
bool without_thickness(const model::Contact& tiebreak) {
  return tiebreak.kind->automatic_tiebreak() && std::abs(tiebreak.tiebreak_option) == 2 && tiebreak.tiebreak.param == 1;
}

/// Types 2, 6 and 7 in any form.
bool is_tied(const ContactType& type) {
  return type.code == ContactCode::tied_surface || type.code == ContactCode::tied_nodes ||
         type.code == ContactCode::tied_shell_edge;
}

/// "mortar contact works segment to segment; the solver lists no nodes for it (GC108)".
std::string by_segments(std::string what, const RuleIdentity& rule) {
  what += " works segment to segment; the solver lists no nodes for it (";
  return what.append(rule.id) + ')';
}

/// Why nothing is decided node against segment; empty where it is.
std::string reason(const ContactType& type, bool ties) {
  if (ties) return "ties nodes to segments instead of keeping them apart";
  if (type.can(Ability::interference))
    return "the overlap of an INTERFERENCE contact is meant: the solver lets it grow from nothing";
  if (type.pairing == Pairing::mortar) return by_segments("mortar contact", record_rules::mortar_penetration);
  switch (type.code) {
    case ContactCode::rigid_nodes:
    case ContactCode::rigid_bodies:
      return "rigid-body contact by force curve has no contact thickness";
    case ContactCode::single_edge:
      return "edge-to-edge contact has no node-to-segment penetrations";
    case ContactCode::draw_bead:
      return "a draw bead has no contact surface of its own";
    case ContactCode::transducer:
      return "a force transducer measures other contacts and has no force of its own";
    default:
      break;
  }
  if (type.pairing == Pairing::segments) return by_segments("SOFT = 2", record_rules::segment_penetration);
  return {};
}

/// Why a contact has no type; empty where it has one.
std::string untyped(const model::Contact& contact) {
  if (!contact.known) return "the keyword *" + contact.written + " is not known";
  if (contact.own_layout) return "*" + contact.keyword + " is not a contact between segments of shells and solids";
  if (!contact.cards.any) return "*" + contact.keyword + " ends before its first card";
  if (contact.kind == nullptr) return "*" + contact.keyword + " is none of the contact types whose rules are known";
  return {};
}

Pairing pairing_of(const ContactType& type, const model::Contact& contact) {
  const model::ContactKind& kind = *contact.kind;
  const bool keeps_apart = kind.treatment != Treatment::none && kind.family != Family::other && !kind.ties();
  if (!keeps_apart || type.can(Ability::interference)) return Pairing::none;
  if (contact.options.mortar) return Pairing::mortar;
  return contact.soft == 2 && has_soft_2(type) ? Pairing::segments : Pairing::nodes;
}

}  // namespace

ContactType classify(const model::Contact& contact) {
  ContactType type;
  type.not_checked = untyped(contact);
  if (!type.not_checked.empty()) return type;
  const model::ContactKind& kind = *contact.kind;
  type.code = kind.code;
  type.offset = kind.offset;
  type.treatment = kind.treatment;
  type.family = contact.options.mortar ? Family::mortar : kind.family;
  type.abilities = kind.abilities;
  type.edges = type.can(Ability::edges);
  type.interior_edges = type.can(Ability::interior_edges);
  type.spotweld_beams = type.edges && contact.cparm8 == 2;
  if (kind.automatic_tiebreak() && type.family == Family::automatic) make_tiebreak(type);
  type.pairing = pairing_of(type, contact);
  type.not_checked = reason(type, kind.ties());
  return type;
}

bool ties_by_constraint(const ContactType& type) {
  return moves_tied_nodes(type) || type.offset == TieOffset::constrained;
}

bool moves_tied_nodes(const ContactType& type) { return is_tied(type) && type.offset == TieOffset::none; }

bool leaves_rotations_free(const ContactType& type) {
  const bool no_moment = type.offset == TieOffset::none || type.offset == TieOffset::penalty;
  return is_tied(type) && type.code != ContactCode::tied_shell_edge && no_moment;
}

bool sides_are_remembered(const model::Contact& tiebreak) {
  return tiebreak.kind->automatic_tiebreak() ? !without_thickness(tiebreak) : tiebreak.tiebreak.thickness_offsets;
}

model::Contact after_failure(const model::Contact& tiebreak) {
  model::Contact contact = tiebreak;
  if (tiebreak.kind != nullptr && tiebreak.kind->breaks()) {
    constexpr std::string_view automatic = "AUTOMATIC_";
    std::string name(tiebreak.kind->after_tie);
    if (tiebreak.tiebreak.thickness_offsets && !name.empty()) name.insert(0, automatic);
    if (without_thickness(tiebreak) && name.starts_with(automatic)) {
      name.erase(0, automatic.size());
      contact.thkopt = 2;
    }
    contact.kind = model::find_contact_kind(name);
    contact.keyword = std::string(model::contact_prefix).append(name);
  }
  contact.sst = std::abs(tiebreak.sst);
  contact.mst = std::abs(tiebreak.mst);
  return contact;
}

model::Contact as_oriented_type(const model::Contact& rigid) {
  model::Contact contact = rigid;
  const ContactCode code = rigid.kind->code == ContactCode::rigid_nodes  ? ContactCode::nodes
                           : rigid.kind->treatment == Treatment::two_way ? ContactCode::surface
                                                                         : ContactCode::one_way;
  contact.keyword = model::recommended_keyword(code).substr(1);  // without the asterisk
  contact.kind = model::find_contact_kind(std::string_view(contact.keyword).substr(model::contact_prefix.size()));
  contact.thkopt = 2;
  contact.sst = contact.mst = 0;
  contact.soft = 0;
  return contact;
}

bool has_soft_2(const ContactType& type) { return type.can(Ability::soft_2); }

bool knows_ignore(const ContactType& type) {
  return (type.family == Family::automatic && type.can(Ability::reads_ignore)) || type.family == Family::mortar;
}

namespace {

/// Only segment-based contact reads SHLEDG (contact rules, section 3.3); 2 on the contact is round, whatever the
/// control card says. SRNDE = 1 (round) and 2 (square) do not extend edges either. Mortar segments meet where they
/// overlap in projection: nothing beyond a free edge counts.
bool has_square_edges(const model::Contact& contact, const ContactType& type, const model::Controls& controls) {
  if (type.family == Family::mortar || contact.srnde == 1 || contact.srnde == 2) return true;
  const std::int64_t edges = contact.shledg != 0 ? contact.shledg : controls.shledg;
  return type.pairing == Pairing::segments && edges == 1;
}

}  // namespace

ContactSettings settings(const model::Contact& contact, const ContactType& type, const model::Controls& controls) {
  ContactSettings s;
  // Zero defers to the next source: pre-processors write zeros into every field.
  s.ignore = contact.mpp_ignore.value_or(0);
  if (s.ignore == 0) s.ignore = contact.ignore.value_or(0);
  if (s.ignore == 0) s.ignore = controls.ignore;
  if (!knows_ignore(type)) s.ignore = 0;
  s.snlog = contact.snlog;
  // THKOPT: 0 uses the global setting, 1 the one beside it, 2 none (contact rules, section 4.4).
  const std::int64_t shlthk = contact.thkopt == 2 ? 0 : contact.thkopt == 1 ? contact.shlthk : controls.shlthk;
  switch (type.family) {
    case Family::old:
      s.shlthk = shlthk;
      break;
    case Family::forming:
      // The blank's thickness counts, that of rigid tools does not, unless SHLTHK = 2.
      s.shlthk = shlthk == 2 ? 2 : 1;
      break;
    case Family::mortar:
      s.shlthk = contact.kind->family == Family::forming && shlthk != 2 ? 1 : 2;
      break;
    default:
      s.shlthk = 2;
  }
  s.square_edges = has_square_edges(contact, type, controls);
  s.mid_surface_offset = controls.cntco != 0 || contact.shloff > 0;
  s.thickness_limit = type.treatment == Treatment::single_surface && controls.ssthk == 0;
  return s;
}

}  // namespace gapcheck::contact
