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

std::uint64_t untreated(const FixReport& report) {
  return std::accumulate(report.contacts.begin(), report.contacts.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const FixContact& contact) {
                           return sum + contact.edges_after + (contact.by_segments ? contact.after.penetrations : 0);
                         });
}

bool complete(const FixReport& report) {
  return report.unfixed.empty() && report.crossings_after == 0 && report.separated_ties_after == 0 &&
         untreated(report) == 0;
}

}  // namespace gapcheck
