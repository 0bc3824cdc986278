#include "report/item/describe_tie.hpp"

#include <fmt/format.h>

namespace gapcheck::report {

RuleIdentity rule_of(const Report& report, const TieFailure& failure) {
  return with_severity(report, rule_of(failure));
}

std::string_view what_happened(TieReason reason) {
  switch (reason) {
    case TieReason::sep:
      return "separated from the segment, moved onto it";
    case TieReason::offset:
      return "separated from the segment, not moved, tied all the same";
    case TieReason::too_far:
      return "too far from the segment (untied)";
    case TieReason::too_short:
      return "tying would shorten a connected beam (untied)";
    case TieReason::not_found:
      return "on no segment (untied)";
    case TieReason::rigslav:
      return "rigid tracked node (untied)";
    case TieReason::rigmast:
      return "segment with a rigid node (untied)";
    case TieReason::conflict:
      return "already constrained elsewhere (untied)";
  }
  return "?";
}

std::string message(const TieFailure& failure) {
  std::string text = fmt::format("node {}", failure.node);
  if (failure.part != 0) text += fmt::format(" (part {})", failure.part);
  text += fmt::format(": {}", what_happened(failure.reason));
  if (failure.segment_number != 0) text += fmt::format(", segment {}", failure.segment_number);
  if (failure.distance >= 0) text += fmt::format(", separation {:.6g}", failure.distance);
  if (failure.allowed >= 0) text += fmt::format(", tie distance {:.6g}", failure.allowed);
  if (failure.moved_far()) text += fmt::format(", both parts together are {:.6g} thick", failure.thickness);
  return text;
}

}  // namespace gapcheck::report
