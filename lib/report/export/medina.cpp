#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "report/export/exports.hpp"
#include "report/export/exports_groups.hpp"

namespace gapcheck::report {
namespace {

/// `NODE id x y z`, or only the id if the position is not known.
void append_node(std::string_view word, std::int64_t id, const std::optional<Vector>& x, fmt::memory_buffer& out) {
  fmt::format_to(fmt::appender(out), "{} {}", word, id);
  if (x && x->allFinite()) fmt::format_to(fmt::appender(out), " {} {} {}", (*x)[0], (*x)[1], (*x)[2]);
  out.push_back('\n');
}

}  // namespace

std::string medina_protocol(const Report& report, const NodePosition& position, std::int64_t first_node) {
  const auto count = static_cast<std::int64_t>(report.penetrations.size());
  std::int64_t next = std::min(first_node, std::numeric_limits<std::int64_t>::max() - count);
  fmt::memory_buffer out;
  for (const ExportGroup& group : export_groups(report)) {
    fmt::format_to(fmt::appender(out), "GROUP \"{}\"\n", group.name);
    for (const Penetration* record : group.penetrations) {
      append_node("NODE", record->node, node_of(report, *record, position), out);
      const auto line = penetration_line(report, *record, position);
      if (!line) continue;
      append_node("NEW_NODE", next, line->surface, out);
      fmt::format_to(fmt::appender(out), "LINE {} {}\n", record->node, next);
      ++next;
    }
    if (group.penetrations.empty())
      for (const std::int64_t node : group.nodes)
        append_node("NODE", node, position ? position(node) : std::nullopt, out);
  }
  return fmt::to_string(out);
}

}  // namespace gapcheck::report
