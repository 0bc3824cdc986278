#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/vector.hpp"
#include "results/text/file_header.hpp"

namespace gapcheck::results {

/// One state of glstat: energies of the whole model. Units of the model.
struct GlobalState {
  std::uint64_t cycle = 1;    ///< from 1
  std::string controlled_by;  ///< what sets the time step: "solid", "shell", "load curve"
  std::int64_t element = 0;   ///< the element that does; 0: none
  std::int64_t part = 0;      ///< its part
  double time = 0, time_step = 0;
  double kinetic = 0, internal = 0, springs = 0, hourglass = 0, damping = 0, sliding = 0;
  double external = 0;  ///< work
  double total = 0;
  double ratio = 1;                                  ///< total / initial energy, external work counted as initial
  double eroded_internal = 0, eroded_hourglass = 0;  ///< of deleted elements; in internal and hourglass too
  double ratio_without_eroded = 1;                   ///< the same without these
  Vector velocity = Vector::Zero();                  ///< of the centre of mass
  struct Wall {
    std::int64_t number = 0;
    double energy = 0;
  };
  std::vector<Wall> walls;        ///< rigid walls
  bool mass_scaling = false;      ///< then the next two are printed
  double added_mass = 0;          ///< since the start
  double added_percent = 0;       ///< of the mass without it
  std::uint64_t nanoseconds = 0;  ///< per element and cycle; 0: not measured
};

[[nodiscard]] std::string glstat_header(const FileHeader& header);
[[nodiscard]] std::string glstat_text(const GlobalState& state);

/// The states of a glstat file, except what controls the step. Unknown rows are skipped; a state begins at its "time"
/// row and is left out if it lacks its total energy, the last one also if it has fewer rows than the one before. NaN of
/// the run, unreadable numbers and missing ratios are NaN; `diagnostics` name what cannot be read, and what was left
/// out.
[[nodiscard]] std::vector<GlobalState> read_glstat(std::string_view text, const std::string& name,
                                                   Diagnostics& diagnostics);
/// For files known to be complete.
[[nodiscard]] std::vector<GlobalState> read_glstat(std::string_view text);

}  // namespace gapcheck::results
