#include "solver/output/run_intfor.hpp"

#include <filesystem>
#include <utility>

#include "solver/output/run_files.hpp"

namespace gapcheck::solver {
namespace {

Failure intfor_failure(const Diagnostic& error) { return {Failure::Kind::output, error.file + ": " + error.message}; }

}  // namespace

struct RunIntfor::Content {
  Interval interval;
  InterfacePlot plot;
  results::IntforWriter writer;
};

RunIntfor::RunIntfor(std::unique_ptr<Content> content) : content_(std::move(content)) {}
RunIntfor::~RunIntfor() = default;

SolverResult<std::unique_ptr<RunIntfor>> RunIntfor::create(const Run& run, contact::SurfaceStore& surfaces,
                                                           const std::string& directory, double interval,
                                                           bool double_words) {
  const std::string path = (std::filesystem::path(directory) / name()).string();
  results::remove_family(path);
  if (!(interval > 0)) return std::unique_ptr<RunIntfor>();
  InterfacePlot plot(run, surfaces);
  if (plot.mesh().segments.empty()) return std::unique_ptr<RunIntfor>();
  results::IntforWriteSettings settings;
  settings.word_bytes = double_words ? 8 : 4;
  auto writer = results::IntforWriter::create(path, plot.mesh(), settings);
  if (!writer) return intfor_failure(writer.error());
  auto content = std::make_unique<Content>(Content{Interval(interval), std::move(plot), std::move(writer).value()});
  return std::unique_ptr<RunIntfor>(new RunIntfor(std::move(content)));
}

bool RunIntfor::due(double time) const { return content_->interval.due(time); }

SolverStatus RunIntfor::observe(const Run& run, std::optional<RunEnd> end) {
  const double time = run.stepper().state().time;
  if (!due(time) && !end) return {};
  content_->interval.written(time);
  if (const Status added = content_->writer.append(content_->plot.state(run)); !added.ok())
    return intfor_failure(added.error());
  return {};
}

SolverStatus RunIntfor::check_names() const {
  if (const Status there = content_->writer.check_names(); !there.ok()) return intfor_failure(there.error());
  return {};
}

}  // namespace gapcheck::solver
