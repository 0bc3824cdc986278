#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "records/report.hpp"

namespace gapcheck::report {

/// A deck that was not audited, and why: it or its baseline cannot be read.
struct Unread {
  std::string deck, reason;
};

/// The output of one call: one report, or those of several decks.
struct Reports {
  Reports(const Report& report) : all(&report, 1) {}  // NOLINT: one report is the usual case
  Reports(std::span<const Report> reports, std::span<const Unread> not_read) : all(reports), unread(not_read) {}
  /// Decides the form of the output, regardless of how many could be read.
  [[nodiscard]] bool several() const { return all.size() + unread.size() > 1; }
  std::span<const Report> all;
  std::span<const Unread> unread = {};
};

/// How the text report groups its lines.
enum class GroupBy : unsigned char { severity, rule, contact, part, file };

struct TextOptions {
  std::size_t top = 5;     ///< with `all`: deepest nodes per contact
  bool all = false;        ///< without a bound on lines, and each contact with its deepest nodes
  bool list = false;       ///< `all`, with every node and every finding
  bool stats = false;      ///< counters at the end
  bool color = false;      ///< ANSI colours
  bool quiet = false;      ///< only the last line
  std::size_t lines = 40;  ///< bound of the short report on a deck
  std::optional<std::size_t> per_rule =
      std::nullopt;       ///< lines of one rule under one heading; none: 6, with `all` no bound
  std::size_t width = 0;  ///< columns of the terminal; lines of findings are cut; 0: no limit
  GroupBy group_by = GroupBy::severity;
};

/// The text report: what goes wrong if the deck runs, a line for each rule, contact and pair of parts, a line for each
/// contact, sums by rule, and the verdict. At most TextOptions::lines lines unless more is asked for; what a run says
/// besides (messages, rigid walls) is not counted. Deterministic.
[[nodiscard]] std::string text(const Report& report, const TextOptions& options);

/// The last line for several decks: "3 decks: 1 error, 12 warnings, 0 notes; against the baselines: 3 new, 1 worse, 40
/// unchanged, 2 gone; 1 more not audited".
[[nodiscard]] std::string text_of_all(const Reports& reports, const TextOptions& options);

/// The counters and times alone, as `text` prints them with `stats`.
[[nodiscard]] std::string statistics(const Report& report);

/// Schema gapcheck/1. Appends to no stream, throws nothing. Deterministic except for "timing".
[[nodiscard]] std::string json(const Report& report);

/// Takes the output piece by piece; false ends the writing.
using Sink = std::function<bool(std::string_view piece)>;

/// The same in pieces of about a megabyte, for reports whose whole text should not be in memory. `statistics`: with the
/// counters too, as a list "statistics" of {"name", "value"} in the order of printing. Several decks are a list "decks"
/// of such objects, the "unread" ones by name with their "reasons", and the "summary" of all.
void json(const Reports& reports, const Sink& sink, bool statistics = false);

/// Number of findings by severity, penetration records included.
struct Totals {
  std::size_t errors = 0, warnings = 0, notes = 0;
  Totals& operator+=(const Totals& other) {
    errors += other.errors, warnings += other.warnings, notes += other.notes;
    return *this;
  }
};
[[nodiscard]] Totals totals(const Report& report);
/// The same without those that are unchanged since the baseline.
[[nodiscard]] Totals counting_totals(const Report& report);

}  // namespace gapcheck::report
