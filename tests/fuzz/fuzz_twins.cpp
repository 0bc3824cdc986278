// Any bytes as a deck: the audit finds the same with every search and filter and without them.
#include <string>

#include "audit/audit.hpp"
#include "fuzz.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::fuzz::twins_target {
namespace {

std::string findings(std::string_view text, bool slow) {
  Diagnostics diagnostics;
  audit::AuditOptions options;
  options.read.max_include_depth = 0;
  options.exact = options.brute_force = slow;
  auto audited = audit::audit_text(std::string(text), "fuzz.k", options, diagnostics);
  if (!audited) return audited.error().message;
  audited.value().timing = {};
  audited.value().statistics.clear();
  return report::json(audited.value());
}

}  // namespace

GAPCHECK_FUZZ_TARGET(twins) { require(findings(input, false) == findings(input, true)); }

}  // namespace gapcheck::fuzz::twins_target
