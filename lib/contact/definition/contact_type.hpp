#pragma once
#include <cstdint>
#include <string>

#include "model/model.hpp"

namespace gapcheck::contact {

/// Which nodes meet which segments (contact rules, section 1.3).
enum class Treatment : std::uint8_t { one_way, two_way, single_surface, none };

/// What the surfaces mean: `old` types are oriented and may ignore thickness, `automatic` ones are two-sided.
enum class Family : std::uint8_t { old, automatic, forming, constraint, tied, mortar, other };

/// What a contact looks for when it starts.
enum class Pairing : std::uint8_t {
  none,      ///< no penetrations: ties, transducers, …
  nodes,     ///< tracked nodes in segments
  segments,  ///< segments in segments, SOFT = 2
  mortar,    ///< segments in segments, mortar
};

/// How a contact definition is treated at t = 0.
struct ContactType {
  std::string code;  ///< the solver's: "13", "a3"; mortar types have that of their base type
  Treatment treatment = Treatment::none;
  Family family = Family::other;
  bool edges = false;           ///< types 26: beams are reference lines too, and edges meet edges
  bool interior_edges = false;  ///< type i26: also edges between shells
  Pairing pairing = Pairing::none;
  /// Why no penetrations are decided node against segment; empty: they are.
  std::string not_checked;
  [[nodiscard]] bool checked() const { return not_checked.empty(); }
  /// Both sides are segments and each is looked for in the other, in one-way types too.
  [[nodiscard]] bool by_segments() const { return pairing == Pairing::segments || pairing == Pairing::mortar; }
};

/// Type of a contact definition. SOFT = 2 counts only for types that have it; the solver switches others to SOFT = 1.
[[nodiscard]] ContactType classify(const model::Contact& contact);

/// The contact that a tiebreak is where its ties have failed: of the same surfaces, types 5 and 3 and their automatic
/// forms; tie thicknesses count with their amount.
[[nodiscard]] model::Contact after_failure(const model::Contact& tiebreak);

/// True for the types that have the segment-based contact of SOFT = 2; for others the solver takes SOFT = 1.
[[nodiscard]] bool has_soft_2(const ContactType& type);

/// True for the types that read IGNORE: automatic and mortar ones (contact rules, section 1.5). Type 4 does not, though
/// it is two-sided like them.
[[nodiscard]] bool knows_ignore(const ContactType& type);

/// The values that decide, after contact card, MPP card and *CONTROL_CONTACT have been merged.
struct ContactSettings {
  std::int64_t ignore = 0;  ///< first that is not zero: MPP card, card C, *CONTROL_CONTACT; 0 but for automatic types
  std::int64_t snlog = 0;
  std::int64_t shlthk = 0;  ///< 0 none, 1 deformable only, 2 all; automatic, single-surface and constraint types: 2
  bool thickness_limit = false;  ///< single-surface types with SSTHK = 0
  bool square_edges = false;     ///< shell surfaces end at their free edges: SRNDE = 1; SOFT = 2: SHLEDG = 1
  bool mid_surface_offset = false;  ///< CNTCO or SHLOFF: NLOC and *ELEMENT_SHELL_OFFSET move the contact surface
};
[[nodiscard]] ContactSettings settings(const model::Contact& contact, const ContactType& type,
                                       const model::Controls& controls);

}  // namespace gapcheck::contact
