#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/vector.hpp"

namespace gapcheck {

/// What happened to a finding since the baseline was written.
enum class BaselineState : std::uint8_t { fresh, worse, unchanged };

/// "new", "worse", "unchanged".
[[nodiscard]] std::string_view name(BaselineState state);

/// One finding as a baseline keeps it: nothing that renumbering changes, unless nothing else identifies it.
struct KnownFinding {
  std::string id, rule;  ///< "GC101", "initial-penetration"
  Severity severity = Severity::warning;
  std::int64_t contact = 0;                        ///< id; 0: none
  std::optional<Vector> position;                  ///< finite, rounded to six digits of the largest coordinate
  double penetration = -1, contact_distance = -1;  ///< six digits; negative: unknown
  double segment_size = -1;                        ///< the same, of ties
  std::uint64_t count = 1;                         ///< number of things that the finding represents
  std::string message;                             ///< only if a position does not identify it
};

/// A report compared with a baseline.
struct BaselineComparison {
  std::vector<BaselineState> states;  ///< of the penetrations, ties and other findings of the report, in that order
  std::vector<BaselineState> ignored_states;  ///< of those in Report::ignored, in its order
  std::vector<KnownFinding> gone;             ///< in the baseline's order
  [[nodiscard]] std::size_t count(BaselineState state) const;
};

}  // namespace gapcheck
