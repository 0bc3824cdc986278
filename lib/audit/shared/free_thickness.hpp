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

/// What records say about a thickness at which no node penetrates.
struct FreeThickness {
  double value = std::numeric_limits<double>::infinity();  ///< no listed node is nearer to any segment
  std::uint64_t free_count = 0, stuck_count = 0;           ///< records that a thickness sets free, and the others
  Penetration closest;  ///< the record that sets the value; only if free_count is above 0
  Penetration stuck;    ///< deepest node on its segment or behind it; only if stuck_count is above 0
  [[nodiscard]] std::uint64_t count() const { return free_count + stuck_count; }
};

/// The largest thickness at which none of the records would exist. `share(p)`: the contact distance of a record as a
/// multiple of the thickness: a half from a node that takes it, a half from a segment. Records that are only notes do
/// not count. A pure function of the records: only a search can say whether other nodes come nearer with it.
[[nodiscard]] FreeThickness free_thickness(std::span<const Penetration> records,
                                           const std::function<double(const Penetration&)>& share);

/// True for the parts of solids and thick shells, which have no contact thickness of their own.
[[nodiscard]] bool solid_part(const model::Model& model, PartIndex part);
[[nodiscard]] bool solid_part(const model::Model& model, std::int64_t id);

/// Four digits, rounded down: the printed value must still be penetration-free.
[[nodiscard]] double rounded_down(double value);

/// The largest SST = MST with which a contact has no initial penetrations.
struct FreeCard {
  ContactIndex contact;
  FreeThickness bound;
  double value = 0;                ///< SST; only where nothing is stuck
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

struct FreeCards {
  std::vector<FreeCard> list;  ///< contacts with penetrations; those that needed another search come last
  std::uint64_t fixed = 0;     ///< contacts with thicknesses that SST does not replace: OPTT, SLDTHK
};

/// Finds it for the contacts given (ascending); `state`: of the initialisation as the deck is. If SST would
/// thicken something, or nodes were moved, one more search with all values found so far shows what else is as near.
[[nodiscard]] FreeCards free_cards(const FreeCardScene& scene, std::span<const ContactIndex> contacts,
                                   const contact::InitialState& state);

}  // namespace gapcheck::audit
