#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "base/vector.hpp"
#include "results/history/history.hpp"

namespace gapcheck::results {

/// What a single point constraint does to its node (spcforc): the force and moment on the node, in the axes of the
/// constraint.
struct SupportState {
  std::int64_t node = 0;
  bool translation = false, rotation = false;  ///< which of the two rows the file has
  Vector force = Vector::Zero(), moment = Vector::Zero();
};

/// One state: the supports by node, and the sum of their forces in global axes.
struct SupportStates {
  std::vector<SupportState> supports;
  Vector resultant = Vector::Zero();
};

/// Of a file: the sum of a state is its last row, with node 0.
using SupportHistory = History<SupportState>;

// The layout is that of the solver developer's own converter from binout to text (l2a). Newer releases add the set of
// the constraint behind each row.
[[nodiscard]] std::string spcforc_header(const FileHeader& header);
[[nodiscard]] std::string spcforc_text(double time, const SupportStates& states);
[[nodiscard]] SupportHistory read_spcforc(std::string_view text, const std::string& name, Diagnostics& diagnostics);

}  // namespace gapcheck::results
