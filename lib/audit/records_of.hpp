#pragma once
#include <algorithm>
#include <cstdint>
#include <span>

#include "contact/initial.hpp"

namespace gapcheck::audit {

/// The records of one contact (position in Model::contacts).
[[nodiscard]] inline std::span<const Penetration> records_of(const contact::InitialState& state, std::uint32_t contact) {
  const auto& all = state.penetrations;
  const auto first = std::partition_point(all.begin(), all.end(), [&](const Penetration& p) { return p.contact < contact; });
  const auto end = std::partition_point(first, all.end(), [&](const Penetration& p) { return p.contact == contact; });
  return {first, end};
}

}  // namespace gapcheck::audit
