#pragma once
#include <cstdint>
#include <optional>

#include "contact/definition/contact_type.hpp"
#include "model/model.hpp"
#include "records/penetration.hpp"

namespace gapcheck::contact {

/// A contact thickness and the rule that gave it. Shells and coated solids: the full thickness (half of it lies on
/// either side); beams: the diameter.
struct Thickness {
  double value = 0;
  ThicknessRule rule = ThicknessRule::none;
};

/// The fields of one side of a contact that change thickness.
struct ThicknessSide {
  double override_value = 0;  ///< SST or MST, of airbags LCIDAB at time 0; zero = not given
  double scale = 1;           ///< SFST or SFMT
  double global_value = 0;    ///< TH; zero = not given
  double global_scale = 1;    ///< TH_SF
  double solid_coating = 0;   ///< SLDTHK
  std::int64_t shlthk = 2;    ///< 0 none, 1 not for rigid parts, 2 all
  bool edge_limit = false;    ///< at most 0.4 of the shortest edge
  bool optt = true;           ///< OPTT counts
};

/// What the surfaces of a contact use instead of its cards, to see the effect of a change.
struct ThicknessChange {
  bool own = false;  ///< OPTT, SST, MST and TH are left out: what remains is the elements' own thickness
  double card = 0;   ///< replaces SST and MST; 0: they stay
};

/// Side A (`tracked` surface) or side B of a contact. Single-surface types have only side A.
[[nodiscard]] ThicknessSide thickness_side(const model::Contact& contact, const ContactSettings& settings,
                                           const model::Controls& controls, bool side_b);

[[nodiscard]] ThicknessSide changed(ThicknessSide side, const ThicknessChange& change);

/// Factor on an element's own thickness: SFT of the part, which replaces SFST and SFMT of the contact (dynasupport.com,
/// "Contact thickness"), and TH_SF.
[[nodiscard]] double scale_of(const model::PartContact* part, const ThicknessSide& side);

/// Thickness of a shell in a contact: OPTT, then SST/MST, then TH, then the element's own × SFT or SFST (limited by
/// 0.4 of the shortest edge where `edge_limit`). `element` and `shortest_edge` in deck units.
/// Source: contact rules, section 4.2.
[[nodiscard]] Thickness shell_thickness(double element, double shortest_edge, const model::PartContact* part,
                                        bool rigid, const ThicknessSide& side);

/// Thickness of a solid's facet or node: SLDTHK, else none.
[[nodiscard]] Thickness solid_thickness(const ThicknessSide& side);

/// Thickness (diameter) of a beam: OPTT, then SST/MST, then TH, then twice the section's radius × SFT or SFST.
[[nodiscard]] Thickness beam_thickness(double radius, const model::PartContact* part, const ThicknessSide& side);

/// Mean thickness of a shell element: own values of *ELEMENT_SHELL_THICKNESS before the section's; plies of
/// *PART_COMPOSITE before both. 0 if the deck gives none.
[[nodiscard]] double element_thickness(const model::Model& model, std::uint32_t shell);

/// Where the mid-surface of a shell lies along its normal, seen from its nodes: the offset of *ELEMENT_SHELL_OFFSET,
/// else -NLOC · t / 2 (NLOC = 1: the nodes are on the top surface).
[[nodiscard]] double mid_surface_offset(const model::Model& model, std::uint32_t shell);

}  // namespace gapcheck::contact
