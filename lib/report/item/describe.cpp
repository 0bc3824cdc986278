#include "report/item/describe.hpp"

#include <fmt/compile.h>

#include "records/thickness_source.hpp"
#include "report/write/json_members.hpp"
#include "report/write/short_decimal.hpp"

namespace gapcheck::report {
namespace {

using Out = fmt::memory_buffer;

void append(std::string_view text, Out& out) { out.append(text); }

/// "element 500 (part 2)", or the nodes of the segment if the element is not known.
void append_segment(const Penetration& record, Out& out) {
  auto end = fmt::appender(out);
  if (record.element != 0)
    fmt::format_to(end, FMT_COMPILE("element {}"), record.element);
  else
    fmt::format_to(end, FMT_COMPILE("segment {}-{}-{}-{}"), record.segment[0], record.segment[1], record.segment[2],
                   record.segment[3]);
  if (record.element_part != 0) fmt::format_to(end, FMT_COMPILE(" (part {})"), record.element_part);
}

/// Six digits.
void append_length(double value, Out& out) {
  append_by(number_room, out, [value](char* end) {
    if (char* quick = write_six_digits(value, end)) return quick;
    return fmt::format_to(end, FMT_COMPILE("{:.6g}"), value);
  });
}

}  // namespace

RuleIdentity with_severity(const Report& report, RuleIdentity rule) {
  if (const auto changed = report.severities.find(rule.id); changed != report.severities.end())
    rule.severity = changed->second;
  return rule;
}

RuleIdentity rule_of(const Report& report, PenetrationKind kind) { return with_severity(report, rule_of(kind)); }

RuleIdentity rule_of(const Report& report, const Penetration& record) {
  RuleIdentity rule = rule_of(report, record.kind);
  rule.severity = severity_of(report, record);
  return rule;
}

Severity severity_of(const Report& report, const Penetration& record) {
  // A log may not say how deep a node is.
  if (record.depth > 0 && within_rounding(record)) return Severity::note;
  const RuleIdentity& rule = rule_of(record.kind);
  return report.severities.empty() ? rule.severity : with_severity(report, rule).severity;
}

std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "error";
}

void append_cause(const Penetration& record, Out& out) {
  const ThicknessRule node = record.node_rule, segment = record.segment_rule;
  if (node == ThicknessRule::none && segment == ThicknessRule::none) return;
  if (node == segment) return append(thickness_source(node), out);
  append("node: ", out);
  append(thickness_source(node), out);
  append(", segment: ", out);
  append(thickness_source(segment), out);
}

void append_message(const Penetration& record, Out& out) {
  auto end = fmt::appender(out);
  if (record.kind == PenetrationKind::edge) append("the edge at ", out);
  fmt::format_to(end, FMT_COMPILE("node {}"), record.node);
  if (record.part != 0) fmt::format_to(end, FMT_COMPILE(" (part {})"), record.part);
  if (record.element == 0 && record.segment[0] == 0) {  // a log that names little more than the node
    append(" penetrates", out);
    if (record.depth > 0) {
      append(" by ", out);
      append_length(record.depth, out);
    }
    return;
  }
  if (record.depth == 0 && record.contact_distance == 0) {  // a log in which neither could be read
    append(" penetrates ", out);
    append_segment(record, out);
    return;
  }
  append(" is ", out);
  append_length(record.depth, out);
  append(" inside the contact distance ", out);
  append_length(record.contact_distance, out);
  append(" of ", out);
  if (record.kind == PenetrationKind::edge_zone)
    append(record.feature == Feature::corner ? "a corner of " : "an edge of ", out);
  if (record.kind == PenetrationKind::edge) append("an edge of ", out);
  append_segment(record, out);
  if (record.kind == PenetrationKind::released) append(", too deep: the contact lets go of it", out);
  if (record.kind == PenetrationKind::edge_zone) append(", but beside every segment's search band", out);
  if (record.kind == PenetrationKind::mortar && record.contact_distance > 0)
    fmt::format_to(end, FMT_COMPILE(", {:.3g} % of it"), 100 * record.depth / record.contact_distance);
  if (record.node_rule != ThicknessRule::none || record.segment_rule != ThicknessRule::none) {
    const bool bare = record.kind != PenetrationKind::released && record.kind != PenetrationKind::edge_zone;
    append(bare ? ": thickness from " : "; thickness from ", out);
    append_cause(record, out);
  }
  if (record.recommended())
    fmt::format_to(end, FMT_COMPILE("; the solver recommends {:.6g} {:.6g} {:.6g}"), record.moved_to[0],
                   record.moved_to[1], record.moved_to[2]);
}

std::string_view beginning(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return text;
  while (longest > 0 && (static_cast<unsigned char>(text[longest]) & 0xC0) == 0x80) --longest;
  return text.substr(0, longest);
}

std::string shortened(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return std::string(text);
  return std::string(beginning(text, longest)) + "…";
}

}  // namespace gapcheck::report
