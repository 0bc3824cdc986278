#pragma once
#include <string>
#include <vector>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test {

/// A mistake that somebody published or warns of, as the smallest deck of our own that has it, and the same deck put
/// right. docs/real-decks.md names the rule, the case and its source.
struct PublishedCase {
  const char* rule;
  const char* says;  ///< part of what the finding says
  RuleDeck wrong, right;
};

// One group for each file of this folder; names are those of the files, since a unity build compiles them together.
namespace published_penetrations {
[[nodiscard]] std::vector<PublishedCase> cases();
}
namespace published_ties {
[[nodiscard]] std::vector<PublishedCase> cases();
}
namespace published_thicknesses {
[[nodiscard]] std::vector<PublishedCase> cases();
}
namespace published_definitions {
[[nodiscard]] std::vector<PublishedCase> cases();
[[nodiscard]] std::vector<PublishedCase> friction_cases();
}  // namespace published_definitions
namespace published_surfaces {
[[nodiscard]] std::vector<PublishedCase> cases();
}
namespace published_meshes {
[[nodiscard]] std::vector<PublishedCase> cases();
}

}  // namespace gapcheck::audit_test
