#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "audit/audit.hpp"

namespace gapcheck::audit_test {

/// One audit with everything it said. `report` is empty where there is none.
struct AuditRun {
  bool ok = false;  ///< there is a report
  Report report;
  std::vector<Diagnostic> diagnostics;  ///< the result's error included
  [[nodiscard]] std::size_t errors() const;
};

[[nodiscard]] AuditRun run_text(const std::string& text, const audit::AuditOptions& options = {});
[[nodiscard]] AuditRun run_file(const std::string& path, const audit::AuditOptions& options = {});

/// Everything in a report that must not depend on threads, search or filter, as text; numbers with all their bits.
[[nodiscard]] std::string dump(const Report& report);

/// The diagnostics as lines FILE:LINE: message, for failure messages.
[[nodiscard]] std::string describe(const std::vector<Diagnostic>& diagnostics);

/// Passes if the run gave a report and no errors.
[[nodiscard]] testing::AssertionResult clean(const AuditRun& run);

}  // namespace gapcheck::audit_test
