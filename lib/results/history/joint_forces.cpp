#include "results/history/joint_forces.hpp"

#include "results/text/printed_number.hpp"

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
  History<JointForce> history;
  ResultText file(text, name, diagnostics);
  bool joint = false;  // the rows are those of a joint, and of no stiffness
  for (; !file.done(); file.advance()) {
    if (file.take_legend(history.titles)) continue;
    std::string_view rest;
    const std::string_view label = dotted_label(file.line(), rest);
    if (label == "time") {
      history.at(file.take(rest));
      joint = false;
    } else if (label == "joint ID") {
      const auto id = take_integer(rest);
      joint = id.has_value() && !history.states.empty();
      if (joint) history.add({*id, false, Vector::Zero(), Vector::Zero()});
      if (!id) file.unreadable();
    } else if (label.starts_with("joint stiffness")) {
      joint = false;
    } else if (joint && !label.empty()) {
      take_joint_row(file, label, rest, history.states.back().rows.back());
    }
  }
  history.end(file);
  file.finish();
  return history;
}

}  // namespace gapcheck::results
