#include "results/curves/nodout.hpp"

#include <fmt/format.h>

#include <initializer_list>

#include "results/text/fortran_number.hpp"

namespace gapcheck::results {
namespace {

std::string state_heading(std::uint64_t cycle, double time) {
  return fmt::format("\n\n\n n o d a l   p r i n t   o u t   f o r   t i m e  s t e p{:8}{:30}( at time{} )\n\n", cycle,
                     "", scientific(time, 14, 7));
}

std::string node_row(std::int64_t node, std::initializer_list<Vector> values) {
  std::string text = fmt::format("{:9} ", node);
  for (const Vector& v : values)
    for (int axis = 0; axis < 3; ++axis) text += scientific(v[axis], 12, 5);
  return text + '\n';
}

}  // namespace

std::string nodout_header(const FileHeader& header, std::vector<LegendEntry> nodes) {
  return header_text(header) + legend_text(std::move(nodes), 80) + "\n";
}

std::string nodout_text(std::uint64_t cycle, double time, std::span<const NodeState> nodes) {
  std::string text = state_heading(cycle, time);
  text +=
      " nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel      x-accl      y-accl      "
      "z-accl      x-coor      y-coor      z-coor\n";
  for (const NodeState& n : nodes) text += node_row(n.node, {n.displacement, n.velocity, n.acceleration, n.position});
  text += state_heading(cycle, time);
  text +=
      " nodal point  x-rot      y-rot       z-rot       x-rot vel   y-rot vel   z-rot vel   x-rot acc   y-rot acc   "
      "z-rot acc\n";
  for (const NodeState& n : nodes) text += node_row(n.node, {n.rotation, n.angular_velocity, n.angular_acceleration});
  return text;
}

}  // namespace gapcheck::results
