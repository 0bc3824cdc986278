#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "records/report.hpp"

namespace gapcheck::report {

/// Which findings of a report follow from others of it. Lives as long as the report.
class Causes {
 public:
  explicit Causes(const Report& report) {
    for (const Finding& finding : report.findings)
      if (finding.key != 0) of_key_.emplace(finding.key, &finding);
  }
  /// The finding that this one follows from; nullptr: it stands by itself, or its cause is not in the report.
  [[nodiscard]] const Finding* of(const Finding& finding) const {
    if (finding.cause == 0) return nullptr;
    const auto found = of_key_.find(finding.cause);
    return found == of_key_.end() ? nullptr : found->second;
  }

 private:
  std::unordered_map<std::uint32_t, const Finding*> of_key_;
};

/// The number of findings that follow from another one of the report.
[[nodiscard]] inline std::size_t consequences(const Report& report) {
  const Causes causes(report);
  return static_cast<std::size_t>(std::count_if(report.findings.begin(), report.findings.end(),
                                                [&](const Finding& finding) { return causes.of(finding) != nullptr; }));
}

}  // namespace gapcheck::report
