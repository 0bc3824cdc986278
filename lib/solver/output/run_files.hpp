#pragma once
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/stiffness/element_sizes.hpp"
#include "results/curves/contact_forces.hpp"
#include "results/curves/glstat.hpp"
#include "results/d3plot/d3plot_write.hpp"
#include "results/text/file_header.hpp"
#include "solver/output/part_masses.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

struct RunFilesSettings {
  std::string directory;
  std::string program;        ///< "gapcheck 0.1.0", below the title of every file
  bool double_words = false;  ///< d3plot in words of eight bytes
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

/// Effective intervals: those of the deck; if it gives none, a thousandth of the end time for glstat, sleout and rcforc
/// and a twentieth for d3plot (without an end time: only first and last state). Contact files only if there are
/// contacts, nodout only if there are nodes to follow.
[[nodiscard]] model::Output output_intervals(const model::Model& model, double end_time);

/// Writes a run's results into a directory, state by state: messag, d3hsp, glstat, matsum, nodout, rcforc, sleout,
/// ncforc, d3plot. Existing files of these names are replaced. Old files of optional kinds (such as ncforc) that the
/// deck does not request are removed.
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
  /// One text file and its output times.
  struct Text {
    std::string name, path;
    Interval interval;
    std::unique_ptr<std::FILE, Close> file;
  };
  enum Which : std::size_t { glstat, matsum, nodout, rcforc, sleout, ncforc };

  RunFiles() = default;
  [[nodiscard]] SolverStatus open(Text& text, const std::string& header);
  [[nodiscard]] SolverStatus open_texts(const Run& run);
  [[nodiscard]] SolverStatus open_logs(const Run& run, contact::SurfaceStore& surfaces);
  [[nodiscard]] SolverStatus open_plot(const Run& run);
  [[nodiscard]] SolverStatus log(const std::string& text);
  [[nodiscard]] SolverStatus log_failures(const Run& run);
  [[nodiscard]] SolverStatus log_end(const Run& run, RunEnd end);
  [[nodiscard]] std::string state_text(std::size_t which, const Run& run) const;
  /// Writes the present state to one of the text files; false: not all of it could be written.
  [[nodiscard]] bool write_state(std::size_t which, const Run& run) const;
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
  std::unique_ptr<PartMasses> masses_;
};

}  // namespace gapcheck::solver
