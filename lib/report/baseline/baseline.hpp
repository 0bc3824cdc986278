#pragma once
#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "records/report.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report {

/// The findings of a report as a baseline keeps them, in the report's order; without those that are left out on
/// purpose.
[[nodiscard]] std::vector<KnownFinding> known_findings(const Report& report);

/// A baseline file: JSON lines, the schema first, then one line per finding, sorted, so that version control shows what
/// has changed. The same for any order and numbering of the deck, if findings have a position.
[[nodiscard]] std::string baseline_text(std::vector<KnownFinding> findings);

/// One finding as a JSON object, as in the file.
void append_known(const KnownFinding& finding, fmt::memory_buffer& out);

/// Reads it back. The error contains `name` and the first line that is not a finding.
[[nodiscard]] Result<std::vector<KnownFinding>> read_baseline(std::string_view text, const std::string& name);

/// True if the audit looked for such findings at all, so that a missing one is gone.
using LookedFor = std::function<bool(const KnownFinding&)>;

/// Compares the findings of a report with a baseline. A finding is identified by contact, rule and position; among the
/// rest, the nearest ones within half the contact distance match (for ties: within a tenth of the segment's shorter
/// diagonal; if neither is known: within a thousandth of the diagonal of all positions), and findings without a
/// position match by their text without numbers. Each finding of the baseline matches one of the report. Rules that are
/// degrees of the same problem count as one (GC106, GC101, GC102; GC204, GC202, GC201). Worse means: a higher degree or
/// severity, more things in one line, or deeper by more than 1 % of the contact distance (unknown: of the previous
/// depth). Findings left out on purpose (Report::ignored) are compared too, so they are not gone, but after the others,
/// which take precedence. Where a rule lists the first findings and counts the rest, only the totals matter: what
/// exceeds the baseline's total is new.
[[nodiscard]] BaselineComparison compare_with_baseline(const Report& report, const std::vector<KnownFinding>& baseline,
                                                       const LookedFor& looked_for);

/// One sentence on a finding that is gone: "GC101 initial-penetration: contact 1 at 5 5 0, penetration 0.3".
[[nodiscard]] std::string describe(const KnownFinding& finding);

/// Number of findings of each kind.
struct BaselineCounts {
  std::size_t fresh = 0, worse = 0, unchanged = 0, gone = 0;
};
[[nodiscard]] BaselineCounts counts(const BaselineComparison& comparison);
/// Of all that have a baseline; nothing if none has.
[[nodiscard]] std::optional<BaselineCounts> baseline_counts(const Reports& reports);

/// "3 new, 1 worse, 40 unchanged, 2 gone".
[[nodiscard]] std::string summary(const BaselineCounts& counts);
[[nodiscard]] std::string summary(const BaselineComparison& comparison);

}  // namespace gapcheck::report
