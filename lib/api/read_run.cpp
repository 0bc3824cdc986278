#include <filesystem>
#include <gapcheck/read_run.hpp>
#include <system_error>
#include <utility>

#include "api/convert.hpp"
#include "api/option_check.hpp"
#include "api/part_history.hpp"
#include "api/report_store.hpp"
#include "api/watched.hpp"
#include "audit/judge.hpp"
#include "report/compare/curves.hpp"
#include "report/text/check_c_view.hpp"
#include "results/curves/run_results.hpp"
#include "results/d3plot/mesh_source.hpp"
#include "results/log/input_kind.hpp"
#include "results/log/solver_log.hpp"

namespace gapcheck::api {
namespace {

namespace fs = std::filesystem;

std::string option_fault(const RunReadOptions& options) {
  OptionCheck check;
  check.amount("ptol", options.ptol);
  check.amount("rtol", options.rtol);
  check.rules("select", options.select, true);
  check.rules("ignore", options.ignore, true);
  return check.message();
}

/// Judges the run by its result files. Says what was not judged if the caller may expect it: if there is any such file,
/// or a directory was given.
void judge_by(const results::RunResults& files, bool by_directory, const RunReadOptions& options,
              gapcheck::Report& report, gapcheck::Diagnostics& diagnostics) {
  constexpr std::size_t judged_files = 4;
  const audit::JudgeOptions judge{options.select, options.ignore, options.contacts};
  const std::vector<std::string> skips = audit::judge_run(files, judge, report);
  if (files.missing.size() == judged_files && !by_directory) return;
  for (const std::string& skip : skips)
    diagnostics.add({gapcheck::Severity::note, files.directory, 0, "not judged: " + skip});
}

Result<Report> report_of_run(const std::vector<std::string>& paths, const RunReadOptions& options) {
  gapcheck::Diagnostics diagnostics;
  const auto files = results::log_files(paths);
  if (!files) return error_of(files.error(), diagnostics);
  const std::string& log = files.value().front();
  results::LogOptions settings;
  settings.d3hsp = options.d3hsp;
  settings.message_files = options.message_tables;
  auto read = results::read_solver_logs(files.value(), settings, diagnostics);
  if (!read) return error_of(read.error(), diagnostics);
  const results::RunResults beside =
      results::read_run_results(fs::path(log).parent_path().string(), false, diagnostics);
  judge_by(beside, log != paths.front(), options, read.value(), diagnostics);
  const auto mesh = results::find_mesh(options.d3plot, log, diagnostics);
  if (!mesh) return error_of(mesh.error(), diagnostics);
  report::CheckCOptions only;
  only.sid = options.contacts;
  only.ptol = options.ptol.value_or(0);
  only.rtol = options.rtol.value_or(-1);
  gapcheck::Report picked = report::pick(std::move(read).value(), only);
  results::add_parts(mesh.value(), picked);
  Report report = report_of(std::move(picked), diagnostics);
  report.parts = part_arrays(beside.matsum);
  return report;
}

}  // namespace

Result<Report> read_run(const std::vector<std::string>& paths, const RunReadOptions& options) {
  if (paths.empty())
    return plain_error("no file is given; give the messag, mesNNNN or d3hsp files of a run, or its directory");
  if (std::string fault = option_fault(options); !fault.empty()) return plain_error(std::move(fault));
  const Jobs jobs(options.jobs);
  return watched(options.watch, "the reading was stopped", [&] { return report_of_run(paths, options); });
}

Result<Curves> read_curves(const std::string& directory) {
  std::error_code failed;
  if (!fs::is_directory(directory, failed)) return Error{directory, 0, "is not a directory; give that of a run", {}};
  gapcheck::Diagnostics diagnostics;
  Curves result;
  const results::RunResults files = results::read_run_results(directory, true, diagnostics);
  const auto take = [&result](std::vector<report::Curve> list) {
    for (report::Curve& curve : list)
      result.curves.push_back({std::move(curve.name), std::move(curve.file), std::move(curve.quantity), curve.contact,
                               std::move(curve.times), std::move(curve.values), curve.not_numbers});
  };
  take(report::curves(files));
  take(report::part_curves(files.matsum));
  result.complete = !diagnostics.has_errors();
  result.diagnostics = listed(diagnostics);
  return result;
}

}  // namespace gapcheck::api
