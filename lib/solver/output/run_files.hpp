#pragma once
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/stiffness/element_sizes.hpp"
#include "results/curves/contact_forces.hpp"
#include "results/d3plot/d3plot_write.hpp"
#include "results/text/file_header.hpp"
#include "results/curves/glstat.hpp"
#include "solver/output/part_masses.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

struct RunFilesSettings {
  std::string directory;
  std::string program;        ///< "gapcheck 0.1.0", below the title of every file
  bool double_words = false;  ///< d3plot in words of eight bytes
  /// Told of every state that goes to the d3plot, with its number from 1; what it returns ends the run.
  std::function<std::optional<Failure>(const results::D3plotState&, const Run&, std::size_t)> on_plot;
};

/// Times at which something is written: the multiples of an interval, each once, at the first step that reaches it.
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

/// Intervals as they are used: those of the deck; of glstat, sleout and rcforc a thousandth of the end time and of
/// d3plot a twentieth, where the deck gives none (without an end time: first and last state only). Contact files only
/// where there are contacts, nodout only where there are nodes to follow.
[[nodiscard]] model::Output output_intervals(const model::Model& model, double end_time);

/// Writes a run's results into a directory, state by state: messag, d3hsp, glstat, matsum, nodout, rcforc, sleout,
/// ncforc, d3plot. Existing files of these names are replaced. Without ncforc or so in the deck old ones are removed.
class RunFiles : public Run::Observer {
 public:
  static std::variant<RunFiles, Failure> create(const Run& run, contact::SurfaceStore& surfaces,
                                                RunFilesSettings settings);
  [[nodiscard]] std::optional<Failure> observe(const Run& run, std::optional<RunEnd> end) override;

  /// Names of the files that are written.
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] std::size_t plotted_states() const { return plotted_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  /// One text file and when it is due.
  struct Text {
    std::string name, path;
    Interval interval;
    std::unique_ptr<std::FILE, Close> file;
  };
  enum Which : std::size_t { glstat, matsum, nodout, rcforc, sleout, ncforc };

  RunFiles() = default;
  [[nodiscard]] std::optional<Failure> open(Text& text, const std::string& header);
  [[nodiscard]] std::optional<Failure> open_texts(const Run& run);
  [[nodiscard]] std::optional<Failure> open_logs(const Run& run, contact::SurfaceStore& surfaces);
  [[nodiscard]] std::optional<Failure> open_plot(const Run& run);
  [[nodiscard]] std::optional<Failure> log(const std::string& text);
  [[nodiscard]] std::optional<Failure> log_failures(const Run& run);
  [[nodiscard]] std::optional<Failure> log_end(const Run& run, RunEnd end);
  [[nodiscard]] std::string state_text(std::size_t which, const Run& run) const;
  [[nodiscard]] std::optional<Failure> plot(const Run& run);

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
