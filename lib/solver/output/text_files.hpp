#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "model/entity/output.hpp"
#include "results/curves/binout_write.hpp"
#include "solver/output/run_record.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// Takes a file's text in pieces; false: not all of it could be written.
using TextWriter = std::function<bool(std::string_view)>;

/// One file of curves: what it is called, how often it is written and what it holds.
struct TextFile {
  std::string name;
  double interval = 0;  ///< 0: not written
  std::string header;
  /// Writes the present state; ends with false where the writer does.
  std::function<bool(const Run&, const TextWriter&)> state;
  /// Adds the present state to a binout; empty: a binout has no such branch.
  std::function<void(const Run&, results::BinoutWriter&)> binout;
};

/// Effective intervals: those of the deck; if it gives none, a thousandth of the end time for glstat, sleout and rcforc
/// and a twentieth for d3plot (without an end time: only first and last state). Contact files only if there are
/// contacts, the others only if there is something to write.
[[nodiscard]] model::Output output_intervals(const model::Model& model, double end_time);

/// All text files of curves that a run can write, also those that it does not. `program`: "gapcheck 0.1.0"; `record`
/// must outlive the list.
[[nodiscard]] std::vector<TextFile> text_files(const Run& run, const std::string& program, const RunRecord& record);

}  // namespace gapcheck::solver
