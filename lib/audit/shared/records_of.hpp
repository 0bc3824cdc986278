#pragma once
#include <algorithm>
#include <cstdint>
#include <span>

#include "contact/initial.hpp"

namespace gapcheck::audit {

/// Those of one contact among records that ascend by contact.
[[nodiscard]] inline std::span<const Penetration> records_of(std::span<const Penetration> all, ContactIndex contact) {
  const auto first =
      std::partition_point(all.begin(), all.end(), [&](const Penetration& p) { return p.contact < contact.value; });
  const auto end =
      std::partition_point(first, all.end(), [&](const Penetration& p) { return p.contact == contact.value; });
  return {first, end};
}

/// The penetrations of one contact.
[[nodiscard]] inline std::span<const Penetration> records_of(const contact::InitialState& state, ContactIndex contact) {
  return records_of(state.penetrations, contact);
}

}  // namespace gapcheck::audit
