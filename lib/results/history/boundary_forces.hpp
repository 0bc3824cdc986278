#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/vector.hpp"
#include "results/history/history.hpp"

namespace gapcheck::results {

/// Where a force of bndout comes from.
enum class BoundaryKind : std::uint8_t {
  discrete,  ///< *LOAD_NODE, *LOAD_RIGID_BODY
  pressure,  ///< *LOAD_SEGMENT, *LOAD_SHELL
  velocity,  ///< prescribed motions
};

/// A load or the reaction of a prescribed motion on one node or rigid body: the force on it, and the work that it has
/// done since the start.
struct BoundaryState {
  BoundaryKind kind = BoundaryKind::discrete;
  bool body = false;
  std::int64_t id = 0;  ///< of the node, or of the rigid body's part
  Vector force = Vector::Zero();
  double energy = 0;
  Vector moment = Vector::Zero();  ///< of rigid bodies with prescribed motions
};

using BoundaryHistory = History<BoundaryState>;

// The layout is that of the solver developer's own converter from binout to text (l2a). Newer releases add the set of
// the condition behind each row.
[[nodiscard]] std::string bndout_header(const FileHeader& header);
/// By kind, nodes before bodies, with a total for each kind.
[[nodiscard]] std::string bndout_text(double time, const std::vector<BoundaryState>& states);
[[nodiscard]] BoundaryHistory read_bndout(std::string_view text, const std::string& name, Diagnostics& diagnostics);
/// "discrete", "pressure", "velocity".
[[nodiscard]] std::string_view name(BoundaryKind kind);

}  // namespace gapcheck::results
