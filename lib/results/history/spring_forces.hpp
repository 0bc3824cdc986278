#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/vector.hpp"
#include "results/history/history.hpp"

namespace gapcheck::results {

/// What one discrete spring or damper does at one time (deforc), in global axes.
struct SpringForce {
  std::int64_t spring = 0;        ///< id of the element
  bool torsional = false;         ///< then it has moments and an angle
  Vector force = Vector::Zero();  ///< on its first node
  double resultant = 0;           ///< above zero in tension
  double change = 0;              ///< in length
};

// The layout is that of the solver developer's own converter from binout to text (l2a). It does not say which node the
// force acts on, nor whether the resultant has a sign.
[[nodiscard]] std::string deforc_header(const FileHeader& header);
[[nodiscard]] std::string deforc_text(double time, std::span<const SpringForce> springs);
[[nodiscard]] History<SpringForce> read_deforc(std::string_view text, const std::string& name,
                                               Diagnostics& diagnostics);

}  // namespace gapcheck::results
