#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "contact/initial.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "model/model.hpp"

namespace gapcheck::audit {

/// How the contact distance of a record depends on a thickness t: fixed + share · t.
struct DistanceRule {
  double share = 0;  ///< a half from a node that takes t, a half from a segment
  double fixed = 0;  ///< half the coating of a solid (SLDTHK) on either side
};

/// What records say about a thickness at which no node penetrates.
struct FreeThickness {
  double value = std::numeric_limits<double>::infinity();  ///< no listed node is nearer to any segment
  std::uint64_t free_count = 0, stuck_count = 0;           ///< records that a thickness sets free, and the others
  std::uint64_t coated_count = 0;  ///< records that penetrate with any thickness, because of a coating
  Penetration closest;             ///< the record that sets the value; only if free_count is above 0
  Penetration stuck;               ///< deepest node on its segment or behind it; only if stuck_count is above 0
  Penetration coated;              ///< of coated_count the one whose coating must shrink most; only if there is one
  double coat_factor = 1;          ///< by which it must shrink
  [[nodiscard]] std::uint64_t count() const { return free_count + stuck_count + coated_count; }
};

/// True if a node keeps enough of its distance, 0.05 of the contact distance, for a thickness that anybody can use.
[[nodiscard]] inline bool far_enough(const Penetration& p) { return p.remaining() > 0.05 * p.contact_distance; }

/// The largest thickness at which none of the records would exist. Records that are only notes do not count. A pure
/// function of the records: only a search can say whether other nodes come nearer with it.
[[nodiscard]] FreeThickness free_thickness(std::span<const Penetration> records,
                                           const std::function<DistanceRule(const Penetration&)>& distance);

/// True for the parts of solids and thick shells, which have no contact thickness of their own.
[[nodiscard]] bool solid_part(const model::Model& model, PartIndex part);
[[nodiscard]] bool solid_part(const model::Model& model, std::int64_t id);

/// Four digits, rounded down: the printed value must still be penetration-free.
[[nodiscard]] double rounded_down(double value);
/// The same rounded up, so that the printed value reaches as far; not for mere rounding.
[[nodiscard]] double rounded_up(double value);

/// The largest SST = MST with which a contact has no initial penetrations.
struct FreeCard {
  ContactIndex contact;
  FreeThickness bound;
  double value = 0;                ///< SST; only where nothing is stuck and no coating holds
  bool optt = false;               ///< parts have OPTT, which is to be 0
  std::uint64_t penetrations = 0;  ///< as the deck is
};

/// How free_cards() examines a model.
struct FreeCardScene {
  const model::Model& model;
  /// Of one contact as the deck is.
  std::function<const contact::ContactSurfaces&(ContactIndex)> surfaces;
  /// The contacts chosen, without nodes being moved, with other thicknesses.
  std::function<contact::InitialState(std::vector<contact::ThicknessChange>, const std::vector<ContactIndex>&)> search;
};

/// Finds it for those of the contacts given (ascending) that have penetrations; those that needed another search come
/// last. `state`: of the initialisation as the deck is. If SST would thicken something, or nodes were moved, one more
/// search with all values found so far shows what else is as near.
[[nodiscard]] std::vector<FreeCard> free_cards(const FreeCardScene& scene, std::span<const ContactIndex> contacts,
                                               const contact::InitialState& state);

}  // namespace gapcheck::audit
