#pragma once
#include <map>
#include <string>

#include "base/result.hpp"
#include "lsp/audit_job.hpp"
#include "records/repair_plan.hpp"

namespace gapcheck::app::lsp {

/// What repairs of a deck on disk would write in cards, none of them tried, and the files as they were when it was
/// read.
struct DeckRepairs {
  RepairPlan plan;                        ///< lines that are added end as those of their file
  std::map<std::string, ReadFile> files;  ///< by path as read
  std::string summary;                    ///< one line
};

/// Errors: those of `gapcheck fix --plan`, or a file that is written meanwhile.
[[nodiscard]] Result<DeckRepairs> repairs_for_editor(const std::string& deck, const OptionsOf& options_of);

}  // namespace gapcheck::app::lsp
