#include "records/fix.hpp"

#include <numeric>

namespace gapcheck {

std::string_view name(HoldReason reason) {
  switch (reason) {
    case HoldReason::locked:
      return "locked";
    case HoldReason::rigid:
      return "rigid";
    case HoldReason::constrained:
      return "constrained";
    case HoldReason::unwritable:
      return "unwritable";
    case HoldReason::shape:
      return "shape";
    case HoldReason::conflict:
      return "conflict";
    case HoldReason::crossing:
      return "crossing";
    default:
      return "none";
  }
}

std::string_view words(HoldReason reason) {
  switch (reason) {
    case HoldReason::locked:
      return "locked nodes";
    case HoldReason::rigid:
      return "rigid bodies have the nodes";
    case HoldReason::constrained:
      return "boundary conditions, welds or other joints hold the nodes";
    case HoldReason::unwritable:
      return "the coordinates cannot be rewritten";
    case HoldReason::shape:
      return "an element would lose its shape";
    case HoldReason::conflict:
      return "what frees it from one segment pushes it into another";
    case HoldReason::crossing:
      return "elements would cross";
    default:
      return "no way out was found";
  }
}

std::uint64_t penetrating_before(const FixReport& report) {
  std::uint64_t sum = 0;
  for (const FixContact& c : report.contacts) sum += c.before.penetrations + c.before.released + c.edges_before;
  for (const FixWall& wall : report.walls) sum += wall.before.penetrations;
  return sum;
}

std::uint64_t penetrating_after(const FixReport& report) {
  return std::accumulate(report.walls.begin(), report.walls.end(), std::uint64_t{report.unfixed.size()},
                         [](std::uint64_t sum, const FixWall& wall) { return sum + wall.unfixed.size(); });
}

bool complete(const FixReport& report) {
  return penetrating_after(report) == 0 && report.crossings_after == 0 && report.enclosed.empty() &&
         report.separated_ties_after == 0;
}

}  // namespace gapcheck
