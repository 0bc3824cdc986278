#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "records/report.hpp"

namespace gapcheck::report {

/// How the penetration records of one contact agree between two sources.
struct ContactComparison {
  std::int64_t id = 0;
  std::string title, type;
  std::uint64_t agree = 0, depth_differs = 0, only_first = 0, only_second = 0;
  double largest_difference = 0;  ///< of depth
  bool missing_in_first = false, missing_in_second = false;  ///< the whole contact
  bool not_checked = false;       ///< one source did not decide it: its records are not held against the other's
};

struct Difference {
  std::int64_t contact = 0, node = 0;
  double first = -1, second = -1;  ///< depth; negative: not in that source
};

struct Comparison {
  std::vector<ContactComparison> contacts;
  std::vector<Difference> differences;  ///< by contact, then largest first
  [[nodiscard]] bool equal() const;
};

/// Holds the initial-penetration records of two reports against each other, contact by contact (by id), node by node;
/// depths agree within `tolerance` (absolute; on top of it half a unit in the fifth digit, which is what messag prints).
[[nodiscard]] Comparison compare(const Report& first, const Report& second, double tolerance);

[[nodiscard]] std::string comparison_text(const Comparison& comparison, const Report& first, const Report& second,
                                          std::size_t top);
[[nodiscard]] std::string comparison_json(const Comparison& comparison, const Report& first, const Report& second);

}  // namespace gapcheck::report
