#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "common/failures.hpp"
#include "options.hpp"
#include "records/repair_plan.hpp"
#include "records/report.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::app {

/// What the decks of a call gave, in its order.
struct DeckResults {
  std::vector<Report> reports;
  std::vector<report::Unread> unread;
  std::vector<RepairPlan> plans;  ///< of each report; empty: they were not asked for
};

/// Contacts and parts that a call asked for.
struct AskedIds {
  std::vector<std::int64_t> contacts, parts;
};

[[nodiscard]] bool has_contact(const Report& report, std::int64_t id);

/// Nothing is found in contacts and parts that do not exist: those that none of the decks has are failures. `several`:
/// the call is about more than one deck.
void check_ids(const DeckResults& results, const AskedIds& ids, bool several, Failures& failures);

/// Writes the files about all decks and the results in the form of `output`; the exit code of all that has happened.
[[nodiscard]] int write_results(const DeckResults& results, const OutputOptions& output,
                                const OverviewOptions& overview, Failures& failures);

}  // namespace gapcheck::app
