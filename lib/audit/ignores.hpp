#pragma once
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gapcheck::audit {

/// A closed range of ids.
struct IdRange {
  std::int64_t first = 0, last = 0;
};

/// One demand to leave findings out of the report: a comment of the deck, or an entry of a settings file. Empty lists
/// let everything through.
struct IgnoreEntry {
  std::vector<std::string> rules;  ///< ids, names or beginnings of them, as --ignore takes them; "GC1"; never empty
  std::vector<IdRange> contacts, nodes, parts, elements;
  std::string files;  ///< pattern (*, ?, **) for the finding's file, relative to `base`; empty: all
  std::string base;   ///< folder that `files` is relative to
  double ptol = -1;   ///< only penetrations that are not deeper; negative: any depth
  double ratio = -1;  ///< only penetrations not deeper than so much of the contact distance
  std::optional<std::chrono::year_month_day> until;  ///< the last day on which it holds
  std::string reason;                                ///< what stands behind "because"
  std::string file;                                  ///< where it stands
  std::uint32_t line = 0;
};

}  // namespace gapcheck::audit
