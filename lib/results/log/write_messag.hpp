#pragma once
#include <string>

#include "records/report.hpp"

namespace gapcheck::results {

/// The penetration records of a report as the solver's 40565 blocks (SMP, one per node), tie failures as 40538, 40533
/// and 40552 blocks: four decimals, slave/master words; released nodes as blocks in our own words, since no list of the
/// solver shows one; after each contact the summary. Reading it back gives the same records to the printed digits.
[[nodiscard]] std::string write_messag(const Report& report);

/// Only the blocks, as in the messag and d3hsp of a run.
[[nodiscard]] std::string message_blocks(const Report& report);

}  // namespace gapcheck::results
