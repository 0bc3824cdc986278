#pragma once
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "keyword/deck.hpp"
#include "records/report.hpp"

namespace gapcheck::audit {

struct AuditOptions;

/// A closed range of ids.
struct IdRange {
  std::int64_t first = 0, last = 0;
};

/// One demand to leave findings out of the report: a comment of the deck, or an entry of a settings file. Empty lists
/// match everything.
struct IgnoreEntry {
  std::vector<std::string> rules;  ///< ids, names or beginnings of them, as --ignore takes them; "GC1"; never empty
  std::vector<IdRange> contacts, nodes, parts, elements;
  std::string files;  ///< pattern (*, ?, **) for the finding's file, relative to `base`; empty: all
  std::string base;   ///< folder that `files` is relative to
  double ptol = -1;   ///< only penetrations that are not deeper; negative: any depth
  double ratio = -1;  ///< only penetrations not deeper than this share of the contact distance
  std::optional<std::chrono::year_month_day> until;  ///< the last day on which it applies
  std::string reason;                                ///< the text after "because"
  std::string file;                                  ///< where it stands
  std::uint32_t line = 0;
};

/// What the rules on ignores report. One line for each place, however often its file is included.
struct IgnoreOutcome {
  struct Place {
    std::string file;
    std::uint32_t line = 0;
    std::string rules;  ///< as they are written: "GC101, GC3"
    std::optional<std::chrono::year_month_day> until;
    std::uint64_t matched = 0;  ///< expired ones: findings that they would leave out
  };
  struct Bad {
    std::string file;
    std::uint32_t line = 0;
    std::string what;  ///< what is wrong and what to write
  };
  std::vector<Place> unused;  ///< comments that matched nothing, although everything they could match was looked for
  std::vector<Place> expired;
  std::vector<Bad> bad;  ///< comments that are not understood
};

/// Moves the findings that the comments of the deck and `options.ignores` leave out into `report.ignored`. Ids in
/// comments are those of their file, so the offsets of its *INCLUDE_TRANSFORM apply to them; they apply to the whole
/// deck. Only settings leave out findings of the rules on ignores. The caller updates the counts of the contacts.
[[nodiscard]] IgnoreOutcome leave_out_ignored(Report& report, const keyword::Deck& deck, const AuditOptions& options);

}  // namespace gapcheck::audit
