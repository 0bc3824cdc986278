#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/contact_surfaces.hpp"

namespace gapcheck::contact {

/// A force transducer that measures between two surfaces; both must outlive it.
struct Transducer {
  const Selection* a = nullptr;
  const Selection* b = nullptr;
};

/// For each transducer the first one before it (position in the list) that measures some of the same forces: both
/// sides share an element with the other's, straight or crosswise. Sides that name nodes alone share their nodes.
/// At most `max_transducers` are compared; the later ones get nothing.
[[nodiscard]] std::vector<std::optional<std::uint32_t>> overlapping_transducers(
    const model::Mesh& mesh, const std::vector<Transducer>& transducers);

inline constexpr std::size_t max_transducers = 128;

}  // namespace gapcheck::contact
