#pragma once
#include <unordered_map>
#include <vector>

#include "base/diagnostic.hpp"
#include "contact/surface/surface.hpp"
#include "solver/state/failure.hpp"
#include "solver/tie/tie.hpp"
#include "solver/tie/tie_strength.hpp"

namespace gapcheck::solver {

/// The strengths of one contact's ties: of tiebreaks by their card 4, of TIED_..._FAILURE by FS and FD. Stresses count
/// with the area of the node, or of the segment if the node is given without segments.
class TieStrengths {
 public:
  /// `own`: the segments of the tracked side, at the positions `x`. The model must outlive the strengths.
  TieStrengths(const model::Model& model, ContactIndex contact, const contact::Segments& own,
               const std::vector<Vector>& x);

  /// Unlimited for contacts whose ties do not fail.
  [[nodiscard]] TieStrength of(const Tie& tie, const std::vector<Vector>& x) const;
  /// CN times the area; 0: the stiffness is that of the penalty.
  [[nodiscard]] double stiffness(const TieStrength& strength) const;

 private:
  void set_law(TieStrength& strength) const;

  const model::Model& model_;
  const model::Contact& contact_;
  bool fails_ = false;                              ///< it has strengths at all
  std::unordered_map<std::uint32_t, double> area_;  ///< by tracked node
};

/// OPTION 4: nodes slide along the surface until tension alone breaks their ties.
[[nodiscard]] bool ties_slide(const model::Contact& contact);

/// Cards of a tiebreak that contradict themselves, or name a curve that is missing or of no use; what is not calculated
/// of them goes to `diagnostics`.
[[nodiscard]] SolverStatus check_tie_strength(const model::Model& model, const model::Contact& contact,
                                              Diagnostics& diagnostics);

}  // namespace gapcheck::solver
