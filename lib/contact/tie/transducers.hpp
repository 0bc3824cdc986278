#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::contact {

/// A force transducer that measures between two surfaces; both must outlive it.
struct Transducer {
  const Selection* a = nullptr;
  const Selection* b = nullptr;
};

/// Whether SURFB of a force transducer counts: only FORCE_TRANSDUCER_PENALTY measures between two surfaces, and then
/// only what automatic contacts do. Source: contact rules, section 10.
[[nodiscard]] bool measures_between(const model::Contact& transducer);
/// Whether a force transducer measures ties and constraint contacts, and not those that act by penalty.
[[nodiscard]] bool measures_constraints(const model::Contact& transducer);
/// Whether SURFB names anything.
[[nodiscard]] bool has_second_surface(const model::Contact& transducer);
/// Whether a contact says which of its forces act between two surfaces.
[[nodiscard]] bool tells_surfaces(const model::Contact& contact);
/// Whether a transducer measures a contact at all: _CONSTRAINT those that act by constraints (types 2, 6, 7 and their c
/// forms, 17, 18), the others those that act by penalty.
[[nodiscard]] bool measures(const model::Contact& transducer, const model::Contact& contact);

/// For each transducer the first one before it (position in the list) that measures some of the same forces: both
/// sides share an element with the other's, straight or crosswise. Sides that name nodes alone share their nodes.
/// At most `max_transducers` are compared; the later ones get nothing.
[[nodiscard]] std::vector<std::optional<std::uint32_t>> overlapping_transducers(
    const model::Mesh& mesh, const std::vector<Transducer>& transducers);

inline constexpr std::size_t max_transducers = 128;

}  // namespace gapcheck::contact
