#include "output_guard.hpp"

#include <algorithm>
#include <utility>

#include "results/d3plot/run_folder.hpp"
#include "run_vtu.hpp"

namespace gapcheck::app {

std::vector<PlannedOutput> planned_outputs(const OutputOptions& output) {
  return {{"--output", output.output}, {"--html", output.html}};
}

std::vector<PlannedOutput> planned_outputs(const ExportOptions& exports) {
  return {{"--key", exports.key},       {"--ani", exports.ani}, {"--a4sel", exports.a4sel},
          {"--medina", exports.medina}, {"--vtu", exports.vtu}, {"--sets", exports.sets}};
}

std::vector<PlannedOutput> planned_run_outputs(const std::string& directory, bool vtu) {
  std::vector<std::string> files = results::result_files(directory);
  if (vtu)
    for (std::string& grid : grid_files(directory)) files.push_back(std::move(grid));
  std::sort(files.begin(), files.end());
  std::vector<PlannedOutput> outputs;
  outputs.reserve(files.size());
  for (std::string& file : files) outputs.push_back({"-o", std::move(file), "", "another directory"});
  return outputs;
}

}  // namespace gapcheck::app
