#pragma once
#include <algorithm>
#include <cstdint>
#include <span>

#include "contact/initial.hpp"

namespace gapcheck::audit {

/// The records of one contact.
[[nodiscard]] inline std::span<const Penetration> records_of(const contact::InitialState& state, ContactIndex contact) {
  const auto& all = state.penetrations;
  const auto first =
      std::partition_point(all.begin(), all.end(), [&](const Penetration& p) { return p.contact < contact.value; });
  const auto end =
      std::partition_point(first, all.end(), [&](const Penetration& p) { return p.contact == contact.value; });
  return {first, end};
}

}  // namespace gapcheck::audit
