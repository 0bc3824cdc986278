#pragma once
#include <span>
#include <vector>

#include "contact/stiffness/element_sizes.hpp"
#include "model/model.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// Kinetic energy and momentum of one part.
struct PartMotion {
  double mass = 0, kinetic = 0;
  Vector momentum = Vector::Zero();
};

/// The masses that shells and solids of each part give to their nodes. A part's kinetic energy is the sum of ½ m v²
/// over them: parts that share nodes share the nodes' energy by mass, rotational inertia of shells is left out, and a
/// rigid part counts as its lumped masses. Elements whose mass is not a number do not count.
class PartMasses {
 public:
  PartMasses(const model::Model& model, const contact::ElementSizes& sizes);
  /// By part; sums in the order of nodes.
  [[nodiscard]] std::vector<PartMotion> motion(const State& state) const;

 private:
  struct Share {
    std::uint32_t node;
    double mass;
  };
  std::vector<std::vector<Share>> shares_;  ///< by part, ascending by node
};

}  // namespace gapcheck::solver
