#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "results/curves/run_results.hpp"

namespace gapcheck::report {

/// One quantity of a run over time, as a result file prints it. Units of the model.
struct Curve {
  std::string file;                   ///< "glstat"
  std::string quantity;               ///< "energy"; curves of one file and quantity are comparable in size
  std::string name;                   ///< "rcforc contact 3 side A x-force"; unique within the run
  int digits = 6;                     ///< that the file prints of a number
  std::vector<double> times, values;  ///< ascending times, finite values
  std::uint64_t not_numbers = 0;      ///< NaN values of the run, left out
  std::int64_t contact = 0;           ///< whose curve it is; 0: no contact's

  /// A state; one that is not later than earlier ones replaces them: a restarted run repeats some.
  void add(double time, double value);
};

/// glstat: kinetic, internal, hourglass, sliding, total energy, external work, energy ratio, stonewall energies.
/// rcforc, per contact and side: force components and resultant. sleout, per contact: energy of both sides, friction.
/// nodout, per node: displacement and velocity. Then those of history_curves.hpp. In order of the files; contacts,
/// nodes and other entities as they first appear.
[[nodiscard]] std::vector<Curve> curves(const results::RunResults& run);

/// matsum, per part: internal, kinetic, hourglass and both eroded energies, momentum, velocity as a rigid body. Not
/// among those of curves(), which are compared: the sums of the parts are in glstat.
[[nodiscard]] std::vector<Curve> part_curves(const results::PartHistory& history);

}  // namespace gapcheck::report
