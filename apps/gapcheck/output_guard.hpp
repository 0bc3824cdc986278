#pragma once
#include <string>
#include <vector>

#include "common/file_guard.hpp"
#include "options.hpp"

namespace gapcheck::app {

/// The outputs that these options request, under their names.
[[nodiscard]] std::vector<PlannedOutput> planned_outputs(const OutputOptions& output);
[[nodiscard]] std::vector<PlannedOutput> planned_outputs(const ExportOptions& exports);

/// The files below `directory` that a run would replace or delete; `vtu`: with those of --vtu.
[[nodiscard]] std::vector<PlannedOutput> planned_run_outputs(const std::string& directory, bool vtu);

}  // namespace gapcheck::app
