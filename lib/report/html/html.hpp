#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "records/report.hpp"
#include "report/export/exports.hpp"

namespace gapcheck::report {

struct HtmlOptions {
  std::string_view version;       ///< the program's
  std::size_t findings = 20'000;  ///< included in the page; all are counted
  std::size_t contacts = 5'000;   ///< the same
  std::size_t group = 100;        ///< findings of each rule and contact that come before deeper ones elsewhere
};

/// One file that shows the report in a browser: tables, sums, and a picture of Report::scene with the penetrating nodes
/// in it; without a scene the nodes alone. It loads nothing, and a policy in it forbids loading. Text of decks is data,
/// never markup. `position` may be empty. Deterministic; at most about 20 MB with the present limits.
[[nodiscard]] std::string html(const Report& report, const NodePosition& position, const HtmlOptions& options);

}  // namespace gapcheck::report
