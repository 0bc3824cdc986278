#include "fix/before_after.hpp"

#include <utility>

#include "audit/audit.hpp"
#include "base/file_writer.hpp"
#include "options.hpp"
#include "report/export/finding_grid.hpp"

namespace gapcheck::app {

void add_before_after(CLI::App& command, BeforeAfter& files) {
  command.add_option("--html", files.html, "Write a page for a browser: the mesh before and after, and the findings")
      ->type_name("FILE");
  command.add_option("--vtu", files.vtu, "Write the mesh with the moves and the findings for ParaView")
      ->type_name("FILE");
}

std::vector<PlannedOutput> planned_outputs(const BeforeAfter& files) {
  return {{"--html", files.html}, {"--vtu", files.vtu}};
}

Status write(const BeforeAfter& files, const std::string& deck, const keyword::ReadOptions& read,
             std::vector<NodeMove> moves, std::string said) {
  if (files.html.empty() && files.vtu.empty()) return {};
  audit::AuditOptions options;
  options.read = read;
  options.scene = !files.html.empty();
  options.mesh = !files.vtu.empty();
  Diagnostics repeated;  // the deck was read before
  const auto report = audit::audit_with_moves(deck, options, std::move(moves), std::move(said), repeated);
  if (!report) return report.error();
  OutputOptions page;
  page.html = files.html;
  if (Status written = write_page(report.value(), page, {}); !written.ok() || files.vtu.empty()) return written;
  return write_file(files.vtu, report::vtu(report::finding_grid(report.value(), {})));
}

}  // namespace gapcheck::app
