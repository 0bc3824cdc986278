#pragma once
#include <cstdint>
#include <string_view>

#include "base/diagnostic.hpp"

namespace gapcheck {

/// One kind of data that a rule judges.
enum class Need : std::uint8_t {
  model,                 ///< the model as it was read; alone: neither surfaces nor a search
  surfaces,              ///< surfaces of contacts, or the mesh of all their segments
  crossings,             ///< elements and edges that cross, bodies within bodies
  time_steps,            ///< of contacts and elements
  node_penetrations,     ///< nodes in segments when the contacts are initialised
  segment_penetrations,  ///< segments in segments, contacts with SOFT = 2
  mortar_penetrations,   ///< segments in segments, mortar contacts
  edge_penetrations,     ///< edges near edges, types 26
  moved_nodes,           ///< where the nodes land that the solver moves
  intended_overlaps,     ///< of INTERFERENCE contacts
  ties,                  ///< nodes that tie and nodes that do not
  run_files,             ///< what a run has written
  ignores,               ///< which findings were left out on purpose
};

/// What a rule judges; the audit computes nothing that no selected rule needs. Never empty: rules must declare it.
class RuleNeeds {
 public:
  constexpr RuleNeeds(Need need) : bits_(bit(need)) {}
  [[nodiscard]] constexpr bool has(Need need) const { return (bits_ & bit(need)) != 0; }
  constexpr RuleNeeds& operator|=(RuleNeeds others) {
    bits_ |= others.bits_;
    return *this;
  }
  [[nodiscard]] constexpr bool operator==(const RuleNeeds&) const = default;

 private:
  static constexpr std::uint32_t bit(Need need) { return std::uint32_t{1} << static_cast<unsigned>(need); }
  std::uint32_t bits_;
};

[[nodiscard]] constexpr RuleNeeds operator|(Need a, Need b) { return RuleNeeds(a) |= b; }

/// Public facts about a rule. Its page is docs/rules/<name>.md.
struct RuleIdentity {
  std::string_view id;       ///< "GC101"
  std::string_view name;     ///< "initial-penetration"
  Severity severity;         ///< of most of its findings
  std::string_view summary;  ///< one line
  RuleNeeds needs;
  std::string_view consequence = {};  ///< what happens if its findings are left as they are, one sentence
  /// Judges the output of a run, not a deck.
  [[nodiscard]] constexpr bool of_runs() const { return needs.has(Need::run_files); }
  /// Judges the demands to leave findings out.
  [[nodiscard]] constexpr bool of_ignores() const { return needs.has(Need::ignores); }
};

}  // namespace gapcheck
