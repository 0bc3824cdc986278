#pragma once
#include "contact/definition/contact_type.hpp"
#include "records/penetration.hpp"

namespace gapcheck::contact {

/// How far the shooting-node logic moves a node, in penetrations (from real runs; contact rules, section 12.1).
inline constexpr double shooting_move = 1.002;

/// What happens to a node that penetrates and is not too deep; IGNORE takes precedence over SNLOG (contact rules,
/// section 7.1).
[[nodiscard]] inline Outcome outcome(const ContactSettings& settings) {
  if (settings.ignore != 0) return Outcome::kept;
  return settings.snlog == 1 ? Outcome::forced : Outcome::moved;
}

}  // namespace gapcheck::contact
