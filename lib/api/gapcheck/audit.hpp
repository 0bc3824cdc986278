#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <gapcheck/includes.hpp>
#include <gapcheck/report.hpp>
#include <gapcheck/result.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gapcheck::api {

/// A step of an audit that is about to begin.
struct AuditStep {
  std::string_view name;          ///< "read", "model", the id of a rule, "records" at the end
  std::size_t done = 0, all = 0;  ///< steps
};

/// What an audit looks for and reports. The defaults are those of `gapcheck audit`; settings files and baselines are
/// not read. Limits are numbers of 0 or more; anything else is an error.
struct AuditOptions {
  Includes includes = {};
  std::vector<std::string> select = {};  ///< only these rules: ids, names or beginnings of either ("GC1"); empty: all
  std::vector<std::string> ignore = {};  ///< not these rules
  std::vector<std::int64_t> contacts = {};  ///< only the contacts with these ids; empty: all
  std::vector<std::int64_t> parts = {};     ///< only findings that involve one of these parts; empty: all
  std::optional<double> ptol = {};          ///< only penetrations deeper than this, in place of the built-in tolerance
  std::optional<double> rtol = {};          ///< only penetrations with a smaller remaining distance
  std::optional<double> ratio = {};         ///< only penetrations deeper than this share of the contact distance
  std::map<std::string, Severity> severities = {};  ///< by rule id or name, instead of the rules' own
  std::optional<double> millimetre = {};            ///< in the deck's unit of length, above 0; none: inferred
  std::chrono::sys_days today{};                    ///< for ignores with a last day; 1970-01-01: none has expired
  bool exact = false;                               ///< no floating-point filter: slow, same results
  bool picture = false;                             ///< keep what Format::html needs to draw the mesh
  bool mesh = false;                                ///< fill Report::mesh
  /// Called before each step by the thread that audits, which waits for it. False stops the audit, which is an error
  /// then. It must not throw. Empty: no calls.
  std::function<bool(const AuditStep&)> watch = {};
  /// Threads at most; 0: no limit of its own. While calls run at the same time in one process, the smallest limit
  /// holds for all of them. Results do not depend on it.
  std::size_t jobs = 0;
};

/// Audits the contacts of a keyword deck and its includes. Errors: the deck cannot be opened, is a directory, empty or
/// binary; `watch` stopped it; an option that names no rule, no contact of the deck or no valid number. With faults in
/// the deck's text or missing includes there is still a report, with Report::complete false. Nothing is written. May be
/// called from several threads at once.
///
///     const auto report = gapcheck::api::audit_deck("model.k", {.select = {"GC101", "GC2"}});
///     if (!report) return fail(report.error());
///     print(report.value().penetrations.size());
[[nodiscard]] Result<Report> audit_deck(const std::string& path, const AuditOptions& options = {});

/// The same for a deck in memory. `name` replaces its path; includes are looked up in the working directory.
[[nodiscard]] Result<Report> audit_text(std::string text, const std::string& name, const AuditOptions& options = {});

/// A rule of the audit, or of read_run().
struct Rule {
  std::string_view id;    ///< "GC101"
  std::string_view name;  ///< "initial-penetration"
  Severity severity = Severity::warning;
  std::string_view summary;  ///< one line
  std::string_view page;     ///< markdown: formula, example, what to do
  bool of_runs = false;      ///< judges the output of a run, not a deck
};

/// All rules, by id. The views live as long as the program.
[[nodiscard]] std::vector<Rule> rules();

}  // namespace gapcheck::api
