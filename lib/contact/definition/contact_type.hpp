#pragma once
#include <cstdint>
#include <string>

#include "model/contact/contact_kind.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

using model::Ability;
using model::ContactCode;
using model::Family;
using model::TieOffset;
using model::Treatment;

/// What a contact looks for when it starts.
enum class Pairing : std::uint8_t {
  none,      ///< no penetrations: ties, transducers, …
  nodes,     ///< tracked nodes in segments
  segments,  ///< segments in segments, SOFT = 2
  mortar,    ///< segments in segments, mortar
};

/// How a contact definition is treated at t = 0.
struct ContactType {
  ContactCode code = ContactCode::unknown;  ///< mortar types have that of their base type
  TieOffset offset = TieOffset::none;
  Treatment treatment = Treatment::none;
  Family family = Family::other;
  std::uint16_t abilities = 0;  ///< of model::Ability
  bool edges = false;           ///< types 26: beams are reference lines too, and edges contact edges
  bool interior_edges = false;  ///< type i26: also edges between shells
  /// Types 26 with CPARM8 = 2 on card E: spotweld beams take part (contact rules, section 13.6).
  bool spotweld_beams = false;
  Pairing pairing = Pairing::none;
  /// Why no penetrations are decided node against segment; empty: they are.
  std::string not_checked;
  [[nodiscard]] bool can(Ability ability) const { return (abilities & static_cast<std::uint16_t>(ability)) != 0; }
  /// As the solver prints it: "13", "a3", "o6"; "?" where the kind is not known.
  [[nodiscard]] std::string printed() const { return model::printed(code, offset); }
  [[nodiscard]] bool checked() const { return not_checked.empty(); }
  /// Neither nodes nor segments meet segments: only edges meet, and beams.
  [[nodiscard]] bool only_edges() const { return pairing == Pairing::nodes && can(Ability::edges_only); }
  /// Both sides are segments and each is searched in the other, even in one-way types.
  [[nodiscard]] bool by_segments() const { return pairing == Pairing::segments || pairing == Pairing::mortar; }
};

/// Type of a contact definition. SOFT = 2 counts only for types that support it; the solver switches others to SOFT
/// = 1.
[[nodiscard]] ContactType classify(const model::Contact& contact);

/// Types that tie by constraint equations: 2, 6, 7 and their c forms. They take no rigid bodies and no node that is
/// constrained already.
[[nodiscard]] bool ties_by_constraint(const ContactType& type);

/// Types that move a tied node onto its segment: 2, 6 and 7 without any offset form.
[[nodiscard]] bool moves_tied_nodes(const ContactType& type);

/// Types that tie only translations and ignore the moments of an offset: 2, 6 and their o forms. The b and c forms
/// carry moments over the offset; 7 and its forms tie rotations.
[[nodiscard]] bool leaves_rotations_free(const ContactType& type);

/// Tiebreaks in which a node pulls away from the side of the segment on which it lies at the start; in the others, from
/// the front that the order of the segment's nodes gives. Source: LS-DYNA Keyword User's Manual, Vol. I, *CONTACT, card
/// 4 of TIEBREAK types: automatic ones but OPTION 2 with PARAM = 1, older ones with THKOFF = 1.
[[nodiscard]] bool sides_are_remembered(const model::Contact& tiebreak);

/// The contact that a tiebreak becomes once its ties have failed: of the same surfaces, types 5 and 3 and their
/// automatic forms; tie thicknesses count by absolute value.
[[nodiscard]] model::Contact after_failure(const model::Contact& tiebreak);

/// The type whose surfaces a RIGID contact has in a run: 5, 10 or 3, without thickness. Source: contact rules, section
/// 1.
[[nodiscard]] model::Contact as_oriented_type(const model::Contact& rigid);

/// True for the types that support the segment-based contact of SOFT = 2; for others the solver uses SOFT = 1.
[[nodiscard]] bool has_soft_2(const ContactType& type);

/// True for the types that read IGNORE: automatic and mortar ones (contact rules, section 1.5). Type 4 does not, though
/// it is two-sided like them.
[[nodiscard]] bool knows_ignore(const ContactType& type);

/// The values that decide, after contact card, MPP card and *CONTROL_CONTACT have been merged.
struct ContactSettings {
  std::int64_t ignore = 0;  ///< first nonzero: MPP card, card C, *CONTROL_CONTACT; 0 except for automatic types
  std::int64_t snlog = 0;
  std::int64_t shlthk = 0;  ///< 0 none, 1 deformable only, 2 all; automatic, single-surface and constraint types: 2
  bool thickness_limit = false;     ///< single-surface types with SSTHK = 0
  bool square_edges = false;        ///< shell surfaces end at their free edges: SRNDE = 1, 2; SOFT = 2: SHLEDG = 1
  bool mid_surface_offset = false;  ///< CNTCO or SHLOFF: NLOC and *ELEMENT_SHELL_OFFSET move the contact surface
};
[[nodiscard]] ContactSettings settings(const model::Contact& contact, const ContactType& type,
                                       const model::Controls& controls);

}  // namespace gapcheck::contact
