#pragma once
#include <string>

#include "report/write/writers.hpp"

namespace gapcheck::report {

/// The decks of a call rule by rule, as a table in Markdown: severity, in how many decks, how many findings; with
/// baselines also how many are new, worse, unchanged and gone. Above it the numbers of all decks, below it the decks
/// that were not audited, the first of them with the reason.
[[nodiscard]] std::string rule_table(const Reports& reports);

}  // namespace gapcheck::report
