#include "results/history/spring_forces.hpp"

namespace gapcheck::results {
namespace {

/// Puts a labelled number into its place.
void take_spring_row(ResultText& file, std::string_view label, std::string_view rest, SpringForce& spring) {
  if (label.ends_with("moment") || label == "relative rotation") spring.torsional = true;
  for (int axis = 0; axis < 3; ++axis)
    if (label.size() > 1 && label[0] == "xyz"[axis] && label[1] == '-') spring.force[axis] = file.take(rest);
  if (label.starts_with("resultant")) spring.resultant = file.take(rest);
  if (label == "change in length" || label == "relative rotation") spring.change = file.take(rest);
}

}  // namespace

std::string deforc_header(const FileHeader& header) { return header_text(header) + "\n\n"; }

std::string deforc_text(double time, std::span<const SpringForce> springs) {
  std::string text = "\n" + dotted_row("time", time);
  for (const SpringForce& s : springs) {
    const std::string_view what = s.torsional ? "moment" : "force";
    text += dotted_row("spring/damper number", s.spring);
    for (int axis = 0; axis < 3; ++axis) text += dotted_row(fmt::format("{}-{}", "xyz"[axis], what), s.force[axis]);
    text += dotted_row(fmt::format("resultant {}", what), s.resultant);
    text += dotted_row(s.torsional ? "relative rotation" : "change in length", s.change);
  }
  return text;
}

History<SpringForce> read_deforc(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  return read_dotted<SpringForce>(
      ResultText(text, name, diagnostics), "spring/damper number", "",
      [](std::int64_t id) {
        return SpringForce{id, false, Vector::Zero(), 0, 0};
      },
      take_spring_row);
}

}  // namespace gapcheck::results
