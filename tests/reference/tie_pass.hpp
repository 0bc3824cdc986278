#pragma once
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "records/tie_failure.hpp"
#include "reference/surfaces.hpp"

namespace gapcheck::reference {

/// What the rules say of one node in one tied contact (contact rules, section 9).
struct TieOutcome {
  std::int64_t node = 0;
  bool judged = false;  ///< false: out of reach, or a node of the reference surface
  bool out_of_reach = false;
  bool tied = false;
  std::optional<TieReason> reason;  ///< what is reported of it
  double distance = 0;              ///< from the segment that it ties to
  std::int64_t part = 0;            ///< of that segment
  bool constrained = false;         ///< tied by a constraint
  bool moved = false;
  Vector target = Vector::Zero();  ///< then: where to
  std::string doubt;
};

/// Nodes that may not tie by a constraint.
struct TieState {
  std::set<std::int64_t> rigid;        ///< of rigid bodies
  std::set<std::int64_t> constrained;  ///< by an earlier tie
};

/// Judges all tracked nodes of a tied contact.
[[nodiscard]] std::vector<TieOutcome> judge_ties(const Scene& scene, const Rules& rules, const TieState& state,
                                                 const Positions& x);

}  // namespace gapcheck::reference
