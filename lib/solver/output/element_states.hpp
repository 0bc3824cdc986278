#pragma once
#include <vector>

#include "results/history/element_stress.hpp"
#include "results/history/weld_forces.hpp"
#include "solver/output/element_places.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver {

/// Stresses of the elements of *DATABASE_HISTORY_SOLID, _BEAM and _SHELL; elements of rigid parts have none, and failed
/// ones are no longer listed. Shells in global axes, or with EOCS = 1 in their own.
[[nodiscard]] std::vector<results::ElementStress> element_stresses(const Run& run, const ElementPlaces& places);

/// What the welds of a deck carry: links, then beams and solids of material 100.
class WeldForces {
 public:
  WeldForces() = default;
  explicit WeldForces(const Run& run);
  /// Once per step: notes what has failed.
  void advance(const Run& run);
  [[nodiscard]] bool empty() const { return links_.empty() && beams_.empty() && solids_.empty(); }
  [[nodiscard]] std::vector<results::WeldForce> states(const Run& run) const;

 private:
  struct Link {
    std::size_t body = 0;
    std::uint32_t weld = 0;  ///< position in Model::welds
    bool failed = false;
    double failure_time = 0;
  };
  [[nodiscard]] results::WeldForce link_force(const Run& run, const Link& link) const;

  std::vector<Link> links_;
  std::vector<std::uint32_t> beams_, solids_;  ///< positions in the structure
};

}  // namespace gapcheck::solver
