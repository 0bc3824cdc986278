#include "results/log/solver_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>

#include "base/file_bytes.hpp"
#include "results/log/input_kind.hpp"
#include "results/log/log_collector.hpp"
#include "results/log/log_reader.hpp"
#include "results/log/message_kinds.hpp"

namespace gapcheck::results {
namespace {

namespace fs = std::filesystem;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void add_kinds(const LogOptions& options, MessageKinds& kinds, Diagnostics& diagnostics) {
  for (const std::string& path : options.message_files) {
    auto file = FileBytes::open(path);
    if (file)
      kinds.add(file.value().bytes(), path, diagnostics);
    else
      diagnostics.add(file.error());
  }
}

/// The canonical path of a file, however it was given.
std::string identity(const std::string& path) {
  std::error_code failed;
  const fs::path canonical = fs::weakly_canonical(path, failed);
  return failed ? path : canonical.string();
}

std::string d3hsp_beside(const std::vector<std::string>& paths) {
  if (paths.empty()) return "";
  std::error_code failed;
  const fs::path candidate = fs::path(paths.front()).parent_path() / "d3hsp";
  return fs::is_regular_file(candidate, failed) ? candidate.string() : "";
}

/// Reads the files one after the other; remembers which it has read, and whether any was a log.
class LogFilesReader {
 public:
  LogFilesReader(const LogOptions& options, Diagnostics& diagnostics)
      : diagnostics_(diagnostics), collector_(diagnostics) {
    add_kinds(options, kinds_, diagnostics);
  }

  /// `text`: in memory, or a file.
  template <class Text>
  void read(Text&& text, const LogFile& file) {
    if (read_log_file(text, file, kinds_, collector_))
      any_log_ = true;
    else
      strangers_.push_back(file.name);
  }

  /// Fails if the file cannot be opened.
  Status path(const std::string& path, bool companion) {
    if (!seen_.insert(identity(path)).second) {
      if (!companion) diagnostics_.warning(path, 0, "was given before; it is read once");
      return {};
    }
    auto file = FileBytes::begin(path);
    if (!file) return file.error();
    if (!companion && begins_as_deck(file.value()))
      return Diagnostic{Severity::error, path, 0, "is a keyword deck, not a solver's log; use gapcheck audit"};
    opened_ = true;
    read(file.value(), {path, companion});
    return {};
  }

  [[nodiscard]] bool opened() const { return opened_; }

  Report finish(const LogOptions& options) {
    for (const std::string& name : strangers_) {
      const std::string what = "no line of it is of a solver's log; give messag, mesNNNN, d3hsp or the screen output";
      if (any_log_)
        diagnostics_.warning(name, 0, what);
      else
        diagnostics_.error(name, 0, what);
    }
    return collector_.finish(options);
  }

 private:
  Diagnostics& diagnostics_;
  MessageKinds kinds_;
  LogCollector collector_;
  std::set<std::string> seen_;
  std::vector<std::string> strangers_;
  bool any_log_ = false, opened_ = false;
};

}  // namespace

Result<Report> read_solver_logs(const std::vector<std::string>& paths, const LogOptions& options,
                                Diagnostics& diagnostics) {
  const auto start = std::chrono::steady_clock::now();
  LogFilesReader reader(options, diagnostics);
  std::vector<Diagnostic> failures;
  for (const std::string& path : paths)
    if (const Status read = reader.path(path, false); !read.ok()) failures.push_back(read.error());
  if (!reader.opened()) {
    if (failures.empty()) return Diagnostic{Severity::error, "", 0, "no messag, mesNNNN or d3hsp file was given"};
    for (std::size_t i = 1; i < failures.size(); ++i) diagnostics.add(std::move(failures[i]));
    return std::move(failures.front());
  }
  for (Diagnostic& failure : failures) diagnostics.add(std::move(failure));
  const std::string companion = options.d3hsp.empty() ? d3hsp_beside(paths) : options.d3hsp;
  if (!companion.empty())
    if (const Status read = reader.path(companion, true); !read.ok()) diagnostics.add(read.error());
  Report report = reader.finish(options);
  for (const std::string& path : paths) report.input += (report.input.empty() ? "" : " ") + path;
  report.timing.read_s = report.timing.total_s = seconds_since(start);
  return report;
}

Report read_solver_log_text(std::string_view text, const std::string& name, const LogOptions& options,
                            Diagnostics& diagnostics) {
  LogFilesReader reader(options, diagnostics);
  reader.read(text, {name, false});
  Report report = reader.finish(options);
  report.input = name;
  return report;
}

}  // namespace gapcheck::results
