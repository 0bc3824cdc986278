#include "results/history/body_motion.hpp"

#include <fmt/format.h>

#include "base/number.hpp"
#include "results/text/fortran_number.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

std::string motion_row(std::string_view label, std::initializer_list<Vector> values) {
  std::string text = fmt::format("{:>14}:  ", label);
  for (const Vector& v : values)
    for (int axis = 0; axis < 3; ++axis) text += scientific(v[axis], 12, 4);
  return text + '\n';
}

/// The numbers behind "velocities:" and the like.
void take_motion(ResultText& file, Vector& move, Vector* turn) {
  std::string_view rest = behind(file.line(), ":");
  move = take_vector(file, rest);
  if (turn != nullptr) *turn = take_vector(file, rest);
}

class RbdoutReader {
 public:
  RbdoutReader(ResultText& file, History<BodyMotion>& history) : file_(file), history_(history) {}

  void line() {
    const std::string_view line = trimmed(file_.line());
    std::string_view time = behind(line, "time=");
    if (line.starts_with("r i g i d")) return history_.at(file_.take(time));
    if (line.starts_with("rigid body") || line.starts_with("nodal rigid body")) return begin(line);
    if (line.starts_with("output in principal")) global_ = false;
    if (history_.states.empty() || history_.states.back().rows.empty()) return;
    BodyMotion& body = history_.states.back().rows.back();
    for (Eigen::Index row = 0; row < 3; ++row)
      if (line.starts_with(fmt::format("row {}", row + 1))) {
        std::string_view rest = line.substr(5);
        body.axes.row(row) = take_vector(file_, rest);
      }
    if (!global_) return;
    if (line.starts_with("coordinates:")) take_motion(file_, body.position, nullptr);
    if (line.starts_with("displacements:")) take_motion(file_, body.displacement, &body.rotation);
    if (line.starts_with("velocities:")) take_motion(file_, body.velocity, &body.spin);
    if (line.starts_with("accelerations:")) take_motion(file_, body.acceleration, &body.spin_rate);
  }

 private:
  void begin(std::string_view line) {
    std::string_view rest = behind(line, "body");
    const auto id = take_integer(rest);
    if (!id) return file_.unreadable();
    BodyMotion body;
    body.body = *id;
    body.nodal = line.starts_with("nodal");
    history_.add(body);
    global_ = true;
  }

  ResultText& file_;
  History<BodyMotion>& history_;
  bool global_ = false;  ///< the rows are in global axes
};

}  // namespace

std::string rbdout_header(const FileHeader& header) { return header_text(header); }

std::string rbdout_text(std::uint64_t cycle, double time, std::span<const BodyMotion> bodies) {
  std::string text = fmt::format("1\n\n  r i g i d   b o d y   m o t i o n   a t  cycle={:8}    time={}\n", cycle,
                                 scientific(time, 15, 6));
  for (const BodyMotion& b : bodies) {
    text += fmt::format("{}{:8}\n", b.nodal ? " nodal rigid body" : "\n rigid body", b.body);
    text += "   global             x           y           z          x-rot       y-rot       z-rot\n";
    text += motion_row("coordinates", {b.position});
    text += motion_row("displacements", {b.displacement, b.rotation});
    text += motion_row("velocities", {b.velocity, b.spin});
    text += motion_row("accelerations", {b.acceleration, b.spin_rate});
    text +=
        "\nprincipal or user defined local coordinate direction vectors\n                     a           b           "
        "c\n";
    for (int row = 0; row < 3; ++row)
      text += fmt::format("     row {}{}{}{}\n", row + 1, scientific(b.axes(row, 0), 15, 4),
                          scientific(b.axes(row, 1), 15, 4), scientific(b.axes(row, 2), 15, 4));
    text +=
        "\n output in principal or user defined local coordinate directions\n"
        "                      a           b           c          a-rot       b-rot       c-rot\n";
    const auto local = [&](const Vector& v) { return Vector(b.axes.transpose() * v); };
    text += motion_row("displacements", {local(b.displacement), local(b.rotation)});
    text += motion_row("velocities", {local(b.velocity), local(b.spin)});
    text += motion_row("accelerations", {local(b.acceleration), local(b.spin_rate)});
  }
  return text;
}

History<BodyMotion> read_rbdout(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  History<BodyMotion> history;
  ResultText file(text, name, diagnostics);
  RbdoutReader reader(file, history);
  for (; !file.done(); file.advance()) reader.line();
  history.end(file);
  file.finish();
  return history;
}

}  // namespace gapcheck::results
