#include "solver/output/run_binout.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "results/text/binout_name.hpp"
#include "solver/output/run_files.hpp"

namespace gapcheck::solver {
namespace {

using results::BinoutWriter;

int binary_of(const model::Output& output, std::string_view file) {
  const auto found = output.binary.find(file);
  return found == output.binary.end() ? 1 : found->second;
}

SolverStatus failure_of(const Status& status) {
  if (status.ok()) return {};
  return Failure{Failure::Kind::output, status.error().file + ": " + status.error().message};
}

/// What readers of the directory would take for this run's.
void remove_old_binouts(const std::string& directory) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  std::vector<fs::path> old;
  for (fs::directory_iterator entry(directory.empty() ? "." : directory, ignored), end; !ignored && entry != end;
       entry.increment(ignored))
    if (results::is_binout_name(entry->path().filename().string())) old.push_back(entry->path());
  for (const fs::path& path : old) fs::remove(path, ignored);
}

}  // namespace

/// One branch: when it is due, and what adds its present state.
struct RunBinout::Branch {
  Interval interval;
  std::function<void(const Run&, BinoutWriter&)> add;
};

bool writes_text(const model::Output& output, std::string_view file, bool all) {
  return all || binary_of(output, file) != 2;
}

RunBinout::RunBinout(BinoutWriter binout) : binout_(std::move(binout)) {}
RunBinout::~RunBinout() = default;

SolverResult<std::unique_ptr<RunBinout>> RunBinout::create(const std::string& directory,
                                                           const results::FileHeader& header,
                                                           const std::vector<TextFile>& files,
                                                           const model::Output& output, bool all) {
  std::vector<Branch> branches;
  for (const TextFile& file : files)
    if (file.binout && file.interval > 0 && (all || binary_of(output, file.name) >= 2))
      branches.push_back({Interval(file.interval), file.binout});
  remove_old_binouts(directory);
  if (branches.empty()) return std::unique_ptr<RunBinout>();
  auto binout = BinoutWriter::create((std::filesystem::path(directory) / name()).string(), header);
  if (!binout) return failure_of(binout.error()).error();
  std::unique_ptr<RunBinout> result(new RunBinout(std::move(binout).value()));
  result->branches_ = std::move(branches);
  return result;
}

SolverStatus RunBinout::observe(const Run& run, std::optional<RunEnd> end) {
  const double time = run.stepper().state().time;
  for (Branch& branch : branches_) {
    if (!branch.interval.due(time) && !end) continue;
    branch.interval.written(time);
    branch.add(run, binout_);
  }
  return failure_of(binout_.file().flush());
}

SolverStatus RunBinout::check_names() const { return failure_of(binout_.file().check_names()); }

}  // namespace gapcheck::solver
