#pragma once
#include <cstddef>
#include <functional>
#include <string_view>

namespace gapcheck::audit {

/// A step of an audit that is about to begin: "read", "model", a rule ("GC101"), "records" at the end.
struct AuditStep {
  std::string_view name;
  std::size_t done = 0, all = 0;  ///< steps
};

/// Called between steps by the thread that audits. False stops the audit.
using AuditWatch = std::function<bool(const AuditStep&)>;

/// Counts the steps and asks before each.
class AuditSteps {
 public:
  AuditSteps(const AuditWatch& watch, std::size_t all) : watch_(watch), all_(all) {}
  /// False: the audit is to stop.
  [[nodiscard]] bool begin(std::string_view name) { return !watch_ || watch_({name, done_++, all_}); }

 private:
  const AuditWatch& watch_;
  std::size_t done_ = 0, all_;
};

}  // namespace gapcheck::audit
