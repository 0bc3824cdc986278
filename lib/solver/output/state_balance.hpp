#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "solver/run.hpp"

namespace gapcheck::solver {

/// The energy of a part's elements, of a contact, or of all discrete springs, twice: by work and by state.
struct HeldEnergy {
  enum class Kind : std::uint8_t { shells, solids, beams, thick_shells, springs, contact } kind = Kind::shells;
  std::int64_t id = 0;  ///< of the part or contact; 0: springs
  double work = 0;      ///< stored at the start, and taken from the nodes since
  double state = 0;     ///< stored by the present stresses and springs, and dissipated since the start
  /// False: no state tells its energy (constraints, tiebreaks). It may take work, but has none to give.
  bool covered = true;
  /// What it has given beyond what it took and still stores; negative: what has vanished in it.
  [[nodiscard]] double created() const { return state - work; }
};

/// A second energy balance, which can fail: the energy ratio sums the works of the same forces at both ends, so it
/// stays 1 even if a force gives more than it took. The energy of the state does not.
struct StateBalance {
  std::vector<HeldEnergy> held;
  double largest = 0;  ///< sum of energies so far
  double ratio = 1;    ///< the energy ratio with the energies of the state
  [[nodiscard]] double created() const;
  /// Those that have created or lost more than this share of the largest energy, worst first.
  [[nodiscard]] std::vector<HeldEnergy> faults(double tolerance = default_tolerance) const;
  static constexpr double default_tolerance = 0.01;
};

/// Of a run at the time of its last force evaluation. Visits all elements and contacts: for output times.
[[nodiscard]] StateBalance state_balance(const Run& run);

/// "contact 3", "shells of part 7", "springs".
[[nodiscard]] std::string name(const HeldEnergy& held);

}  // namespace gapcheck::solver
