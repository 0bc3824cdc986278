#pragma once
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/stiffness/element_sizes.hpp"
#include "results/d3plot/d3plot_write.hpp"
#include "results/text/file_header.hpp"
#include "solver/output/run_binout.hpp"
#include "solver/output/run_intfor.hpp"
#include "solver/output/run_record.hpp"
#include "solver/output/text_files.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

struct RunFilesSettings {
  std::string directory;
  std::string program;        ///< "gapcheck 0.1.0", below the title of every file
  bool double_words = false;  ///< d3plot in words of eight bytes
  bool binout = false;        ///< all files of curves also in a binout, whatever BINARY of their cards says
  /// Called for every state that goes to the d3plot, with its number from 1; a returned failure ends the run.
  std::function<SolverStatus(const results::D3plotState&, const Run&, std::size_t)> on_plot;
};

/// Output times: the multiples of an interval, each once, at the first step that reaches it.
class Interval {
 public:
  Interval() = default;
  /// 0: never.
  explicit Interval(double length) : length_(length) {}
  [[nodiscard]] bool wanted() const { return length_ > 0; }
  [[nodiscard]] bool due(double time) const;
  void written(double time);

 private:
  double length_ = 0;
  double multiple_ = 0;  ///< the next one, a whole number
};

/// Writes a run's results into a directory, state by state: messag, d3hsp, glstat, matsum, nodout, rcforc, sleout,
/// ncforc, secforc and so on, d3plot, and binout and intfor where the deck asks for them. Existing files of these names
/// are replaced. Old files of optional kinds (such as ncforc) that the deck does not request are removed.
class RunFiles : public Run::Observer {
 public:
  static SolverResult<RunFiles> create(const Run& run, contact::SurfaceStore& surfaces, RunFilesSettings settings);
  [[nodiscard]] SolverStatus observe(const Run& run, std::optional<RunEnd> end) override;

  /// Names of the files that are written.
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] std::size_t plotted_states() const { return plotted_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  /// One text file, its output times and what writes its states.
  struct Text {
    std::string name, path;
    Interval interval;
    std::unique_ptr<std::FILE, Close> file;
    std::function<bool(const Run&, const TextWriter&)> state;
  };

  RunFiles() = default;
  [[nodiscard]] SolverStatus open(Text& text, const std::string& header);
  [[nodiscard]] SolverStatus open_texts(const Run& run);
  [[nodiscard]] SolverStatus open_logs(const Run& run, contact::SurfaceStore& surfaces);
  [[nodiscard]] SolverStatus open_plot(const Run& run);
  [[nodiscard]] SolverStatus log(const std::string& text);
  [[nodiscard]] SolverStatus log_plot(const Run& run, const std::string& what);
  [[nodiscard]] SolverStatus log_failures(const Run& run);
  [[nodiscard]] SolverStatus log_end(const Run& run, RunEnd end);
  [[nodiscard]] SolverStatus plot(const Run& run);
  /// A failure if a file is no longer where it was written.
  [[nodiscard]] SolverStatus check_names() const;

  RunFilesSettings settings_;
  std::vector<Text> texts_, logs_;  ///< logs: messag, d3hsp
  Interval plot_interval_;
  std::size_t plotted_ = 0;
  std::size_t logged_failures_ = 0;  ///< of the stepper's
  std::unique_ptr<results::D3plotWriter> plot_;
  contact::ElementSizes sizes_;
  std::unique_ptr<RunRecord> record_;
  std::unique_ptr<RunBinout> binout_;  ///< of what is not only text; none: nothing
  std::unique_ptr<RunIntfor> intfor_;  ///< none: not asked for, or no segment
};

}  // namespace gapcheck::solver
