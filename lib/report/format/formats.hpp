#pragma once
#include <cstddef>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "records/repair_plan.hpp"
#include "records/report.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report {

// Formats that other programs read; the contents are those of json(). All are deterministic except for times, end early
// when the sink returns false, and need memory for one finding at a time unless stated otherwise. Several decks come
// one after the other; decks that were not audited are not findings, and only json(), sarif() and junit() name them.

/// What a format may say about a rule.
struct RuleText {
  std::string_view id, name;
  Severity severity = Severity::warning;
  std::string_view summary;  ///< one line
  std::string_view page;     ///< markdown
};

/// Repairs of a report's findings, by Item::number.
using FindingFixes = std::map<std::size_t, std::vector<const Repair*>>;

/// SARIF 2.1.0 (OASIS, sections 3.13 to 3.49): one run, rules with their help, one result per finding with file and
/// line, the node as a logical location, the contact's card and the finding that it follows from as related locations,
/// `partialFingerprints`. Of several decks each is an artifact, and a result names its deck as `analysisTarget`; decks
/// that were not audited are notifications. `version` is the program's. `fixes`: of each report the repairs that its
/// findings have as `fixes`; or of none.
void sarif(const Reports& reports, std::string_view version, std::span<const RuleText> rules, const Sink& sink,
           std::span<const FindingFixes> fixes = {});

/// JUnit: one suite per contact and one for the rest, a case per rule that found something there. A case fails if one
/// of its findings is at least as severe as `limit`; without a limit none fails. A suite without findings has one case
/// that passes. Each case shows the first `top` findings and counts the others. With several decks the suites' names
/// begin with the deck; one that was not audited is a suite with an error that says why.
void junit(const Reports& reports, const Severity* limit, std::size_t top, const Sink& sink);

/// Annotations as GitHub's runners read them from standard output. At most `top` per rule and contact, then one that
/// counts the rest: a run shows only the first few. Errors come first.
void github(const Reports& reports, std::size_t top, const Sink& sink);

/// GitLab's code quality report. Duplicate fingerprints get a number appended, since GitLab shows each only once. Keeps
/// the fingerprints in memory.
void gitlab(const Reports& reports, const Sink& sink);

/// A table (RFC 4180) with one line per finding under a line of names; for several decks with a last column `deck`.
void csv(const Reports& reports, const Sink& sink);

}  // namespace gapcheck::report
