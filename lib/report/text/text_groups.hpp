#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "records/report.hpp"
#include "report/item/finding_groups.hpp"
#include "report/text/paint.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report {

/// The beginning of a line in `width` columns, with "…" if something is left out; 0: no limit.
[[nodiscard]] std::string cut(std::string text, std::size_t width);

/// "If this deck runs:" and at most five lines: what goes wrong, with how many things it does and where.
[[nodiscard]] std::vector<std::string> verdict_lines(const Report& report, std::span<const FindingGroup> groups,
                                                     std::size_t width, const Paint& paint);

struct LineLimits {
  std::size_t all, per_rule;
};

/// The groups under headings (TextOptions::group_by), a line each. Every rule keeps a line
/// as long as there is room for one; its last line says how many more there are.
[[nodiscard]] std::vector<std::string> group_lines(const Report& report, std::span<const FindingGroup> groups,
                                                   const TextOptions& options, LineLimits limits, const Paint& paint);

/// "GC102 released-node 20, GC111 coincident-surfaces 29, …" in lines of `width` characters.
[[nodiscard]] std::vector<std::string> rule_sum_lines(std::span<const FindingGroup> groups, std::size_t width,
                                                      const Paint& paint);

}  // namespace gapcheck::report
