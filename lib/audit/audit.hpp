#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "audit/audit_steps.hpp"
#include "audit/ignores.hpp"
#include "audit/threshold.hpp"
#include "base/diagnostic.hpp"
#include "base/result.hpp"
#include "keyword/deck.hpp"
#include "model/assumption.hpp"
#include "records/node_move.hpp"
#include "records/report.hpp"

namespace gapcheck::audit {

struct AuditOptions {
  keyword::ReadOptions read;
  std::vector<std::string> select, ignore;  ///< rule ids, names or prefixes; empty select = all
  std::vector<std::int64_t> contacts;       ///< --contact; empty = all
  std::vector<std::int64_t> parts;          ///< --part: only nodes or segments of these parts; empty = all
  std::vector<IgnoreEntry> ignores;         ///< of a settings file; those of the deck's comments come first
  std::vector<model::Assumption> as_if;     ///< --as-if: audits the deck as if it had these values
  Severities severities;                    ///< instead of those of the rules
  Thresholds thresholds;                    ///< instead of those of the rules
  std::chrono::sys_days today{};            ///< date for ignores with a last day; 1970-01-01: none has expired
  double ptol = -1;                         ///< --ptol: replaces the default tolerance; negative = not given
  double rtol = -1;          ///< --rtol: only findings with a remaining distance below it; negative = not given
  double ratio = -1;         ///< --ratio: only findings with depth / contact distance above it; negative = not given
  double millimetre = 0;     ///< --units: what a millimetre is in the deck's unit of length; 0 = not given: inferred
  bool exact = false;        ///< --exact: no floating-point filter
  bool brute_force = false;  ///< the slow search, for tests
  bool scene = false;        ///< fill Report::scene
  bool mesh = false;         ///< fill Report::mesh
  bool members = false;      ///< fill Finding::members
  bool portability = false;  ///< --portability: fill Report::portability
  AuditWatch watch;          ///< empty: nobody watches
};

/// Reads a deck and reports everything that the selected rules find. Errors: the deck cannot be read at all; other
/// input errors are in `diagnostics` (then exit code 2, but the report has what could be audited); `watch` stopped it.
Result<Report> audit_deck(const std::string& path, const AuditOptions& options, Diagnostics& diagnostics);

/// The same, and the report shows where nodes go: what pages and grids draw before and after. `said`: a sentence about
/// the moves.
Result<Report> audit_with_moves(const std::string& path, const AuditOptions& options, std::vector<NodeMove> moves,
                                std::string said, Diagnostics& diagnostics);

/// The same as audit_deck() for a deck in memory.
Result<Report> audit_text(std::string text, const std::string& name, const AuditOptions& options,
                          Diagnostics& diagnostics);

}  // namespace gapcheck::audit
