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

/// What one joint between rigid bodies does at one time (jntforc): the force on its second body, and the moment about
/// the joint's point there.
struct JointForce {
  std::int64_t joint = 0;
  bool local = false;  ///< in a local system; otherwise in global axes
  Vector force = Vector::Zero(), moment = Vector::Zero();
};

// The layout is that of the solver developer's own converter from binout to text (l2a). It does not say which body the
// force acts on.
[[nodiscard]] std::string jntforc_header(const FileHeader& header);
[[nodiscard]] std::string jntforc_text(double time, std::span<const JointForce> joints);
/// Angles and moments of joint stiffnesses are left out.
[[nodiscard]] History<JointForce> read_jntforc(std::string_view text, const std::string& name,
                                               Diagnostics& diagnostics);

}  // namespace gapcheck::results
