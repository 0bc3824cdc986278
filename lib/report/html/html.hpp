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
  std::size_t findings = 20'000;  ///< that travel with the page; all are counted
  std::size_t contacts = 5'000;   ///< the same
  std::size_t group = 100;        ///< findings of each rule in each contact that go before the deeper ones of others
};

/// One file that shows the report in a browser: tables, sums, and a picture of Report::scene with the penetrating nodes
/// in it; without a scene the nodes alone. It loads nothing from anywhere, and nothing in it may: a policy forbids it.
/// Text of decks is data, never markup. `position` may be empty. Deterministic; at most some 20 MB with the limits as
/// they are.
[[nodiscard]] std::string html(const Report& report, const NodePosition& position, const HtmlOptions& options);

}  // namespace gapcheck::report
