#pragma once
#include <cstdint>
#include <vector>

#include "results/history/boundary_forces.hpp"
#include "results/history/support_forces.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// By node the degrees of freedom that the deck's supports hold, six bits each.
struct HeldFreedoms {
  std::vector<std::uint32_t> nodes;    ///< of *BOUNDARY_SPC, in no rigid body, ascending
  std::vector<std::uint8_t> supports;  ///< by position there: by *BOUNDARY_SPC
  std::vector<std::int64_t> systems;   ///< the local system of their rows; 0: global
  std::vector<std::uint8_t> held;      ///< by node of the model: by *BOUNDARY_SPC, or TC and RC of *NODE

  explicit HeldFreedoms(const Run& run);
};

/// What the supports of *BOUNDARY_SPC do to their nodes now; those of TC and RC in *NODE are left out.
[[nodiscard]] results::SupportStates support_states(const Run& run, const HeldFreedoms& held);

/// The forces of loads and prescribed motions, and their work since the start, which needs every step.
class BoundaryWork {
 public:
  BoundaryWork() = default;
  BoundaryWork(const Run& run, const HeldFreedoms& held);
  /// Once per step, after its forces are known.
  void advance(const Run& run);
  [[nodiscard]] std::vector<results::BoundaryState> states() const;

 private:
  struct Entry {
    results::BoundaryState state;
    std::uint32_t target = 0;
    Vector velocity = Vector::Zero(), spin = Vector::Zero();  ///< in the step that follows the last evaluation
    Vector turn = Vector::Zero();                             ///< moment there, of bodies and nodes
  };
  void add(results::BoundaryKind kind, bool body, const std::vector<std::uint32_t>& targets, const Run& run);
  void load(const Run& run, Entry& entry, const Forces& loads, const Forces& pressures) const;

  std::vector<Entry> entries_;
  std::vector<std::uint8_t> held_;  ///< by node: degrees of freedom of supports
};

}  // namespace gapcheck::solver
