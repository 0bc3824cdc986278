// Any bytes as a deck, audited with all rules. Records point to contacts, files and findings that exist.
#include <string>

#include "audit/audit.hpp"
#include "fuzz.hpp"

namespace gapcheck::fuzz::audit_target {

GAPCHECK_FUZZ_TARGET(audit) {
  Diagnostics diagnostics;
  audit::AuditOptions options;
  options.read.max_include_depth = 0;
  options.today = std::chrono::sys_days(std::chrono::year(2026) / 6 / 1);
  options.scene = options.mesh = options.members = true;
  const auto audited = audit::audit_text(std::string(input), "fuzz.k", options, diagnostics);
  static_cast<void>(diagnostics.sorted());
  if (!audited) {
    require(!audited.error().message.empty());
    return;
  }
  const Report& report = audited.value();
  for (const Penetration& record : report.penetrations)
    require(record.contact < report.contacts.size() && record.depth >= 0);
  for (const TieFailure& record : report.tie_failures) require(record.contact < report.contacts.size());
  for (const Finding& finding : report.findings) require(!finding.id.empty() && !finding.message.empty());
}

}  // namespace gapcheck::fuzz::audit_target
