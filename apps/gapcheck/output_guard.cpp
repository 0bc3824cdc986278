#include "output_guard.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "results/d3plot/run_folder.hpp"

namespace gapcheck::app {

std::vector<PlannedOutput> planned_outputs(const OutputOptions& output) {
  return {{"--output", output.output}, {"--html", output.html}};
}

std::vector<PlannedOutput> planned_outputs(const ExportOptions& exports) {
  return {{"--key", exports.key},       {"--ani", exports.ani}, {"--a4sel", exports.a4sel},
          {"--medina", exports.medina}, {"--vtu", exports.vtu}, {"--sets", exports.sets}};
}

std::vector<PlannedOutput> planned_run_outputs(const std::string& directory, bool vtu) {
  namespace fs = std::filesystem;
  const auto is_grid = [](const std::string& name) {
    constexpr std::string_view begin = "state_", end = ".vtu";
    return name == "run.pvd" ||
           (name.size() > begin.size() + end.size() && name.starts_with(begin) && name.ends_with(end) &&
            name.find_first_not_of("0123456789", begin.size()) == name.size() - end.size());
  };
  std::vector<PlannedOutput> outputs;
  for (const std::string& file : results::result_files(directory))
    outputs.push_back({"-o", file, "", "another directory"});
  std::error_code failed;
  for (fs::directory_iterator entry(directory, failed), end; vtu && !failed && entry != end; entry.increment(failed))
    if (is_grid(entry->path().filename().string()))
      outputs.push_back({"-o", entry->path().string(), "", "another directory"});
  std::sort(outputs.begin(), outputs.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return outputs;
}

}  // namespace gapcheck::app
