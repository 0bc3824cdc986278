#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "report/export/vtu.hpp"
#include "results/d3plot/d3plot.hpp"
#include "results/d3plot/d3plot_state.hpp"
#include "solver/run.hpp"

namespace gapcheck::app {

/// The files of a directory with the names of a VtuSeries, sorted. Empty directory: the working directory.
[[nodiscard]] std::vector<std::string> grid_files(const std::string& directory);

/// Those of them that gapcheck did not write.
[[nodiscard]] std::vector<std::string> foreign_grids(const std::string& directory);

/// A run as files for VTK: state_0001.vtu, … and the collection run.pvd, which is rewritten with every state. Files
/// with these names that were there before are removed.
class VtuSeries {
 public:
  /// `directory` must exist.
  VtuSeries(const solver::Run& run, std::string directory);
  /// The error of the file that could not be written or removed.
  [[nodiscard]] solver::SolverStatus add(const results::D3plotState& state, const solver::Run& run);

 private:
  /// Those of an earlier run, which may have had more states.
  [[nodiscard]] Status remove_old() const;
  [[nodiscard]] Status write(const results::D3plotState& state, const solver::Run& run);

  std::string directory_;
  results::D3plot mesh_;
  std::vector<report::PvdEntry> entries_;
};

/// The grid of one state: shells, solids, beams; displacement, velocity and contact results at the points; part, id,
/// stress, plastic strain and thickness in the cells.
[[nodiscard]] report::VtuGrid vtu_grid(const results::D3plot& mesh, const results::D3plotState& state,
                                       const solver::Run& run);

}  // namespace gapcheck::app
