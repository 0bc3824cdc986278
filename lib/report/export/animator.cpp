#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "report/export/exports.hpp"
#include "report/export/exports_groups.hpp"

namespace gapcheck::report {
namespace {

constexpr std::size_t nodes_per_line = 10;

void append_node_commands(std::string_view verb, const std::vector<std::int64_t>& nodes, std::string& out) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i % nodes_per_line == 0) {
      if (i > 0) out += '\n';
      out += verb;
    }
    out += ' ';
    out += fmt::format_int(nodes[i]).str();
  }
  if (!nodes.empty()) out += '\n';
}

}  // namespace

std::string animator_session(const Report& report, bool animator4) {
  std::string out;
  for (const ExportGroup& group : export_groups(report)) {
    append_node_commands(animator4 ? "sel nod" : "ide nod", group.nodes, out);
    if (animator4) out += fmt::format("gro \"{}\"\n", group.name);
  }
  return out;
}

}  // namespace gapcheck::report
