#include "results/history/joint_forces.hpp"

namespace gapcheck::results {
namespace {

/// "x-force" or "x-moment (local)"; other rows are left out.
void take_joint_row(ResultText& file, std::string_view label, std::string_view rest, JointForce& joint) {
  const bool moment = label.find("-moment") == 1;
  if (!moment && label.find("-force") != 1) return;
  if (label.ends_with("(local)")) joint.local = true;
  for (int axis = 0; axis < 3; ++axis)
    if (label[0] == "xyz"[axis]) (moment ? joint.moment : joint.force)[axis] = file.take(rest);
}

}  // namespace

std::string jntforc_header(const FileHeader& header) { return header_text(header) + "\n\n"; }

std::string jntforc_text(double time, std::span<const JointForce> joints) {
  std::string text = "\n\n" + dotted_row("time", time);
  for (const JointForce& j : joints) {
    text += dotted_row("joint ID", j.joint);
    for (const auto& [what, value] : {std::pair("force", &j.force), {"moment", &j.moment}})
      for (int axis = 0; axis < 3; ++axis)
        text += dotted_row(
            j.local ? fmt::format("{}-{:<6} (local) ", "xyz"[axis], what) : fmt::format("{}-{}", "xyz"[axis], what),
            (*value)[axis]);
    text += dotted_row("resultant force", j.force.stableNorm());
    text += dotted_row("resultant moment", j.moment.stableNorm());
  }
  return text;
}

History<JointForce> read_jntforc(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  return read_dotted<JointForce>(
      ResultText(text, name, diagnostics), "joint ID", "joint stiffness",
      [](std::int64_t id) {
        return JointForce{id, false, Vector::Zero(), Vector::Zero()};
      },
      take_joint_row);
}

}  // namespace gapcheck::results
