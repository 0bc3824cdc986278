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
  double largest_difference = 0;                             ///< of depth
  bool missing_in_first = false, missing_in_second = false;  ///< the whole contact
  bool not_checked = false;  ///< one source did not decide it: its records are not held against the other's
  bool counts_only = false;  ///< one source gives the number of nodes without listing them: numbers are compared
};

struct Difference {
  std::int64_t contact = 0, node = 0;
  double first = -1, second = -1;  ///< depth; negative: not in that source
};

struct Comparison {
  std::vector<ContactComparison> contacts;  ///< as in the first report, then what only the second has
  std::vector<Difference> differences;      ///< by contact, then largest first
  [[nodiscard]] bool equal() const;
};

/// Holds the initial-penetration records of two reports against each other, contact by contact (by id), node by node;
/// depths agree within `tolerance` (absolute; on top of it half a unit in the fifth digit, which is what messag
/// prints). A node that one source calls released agrees with a record of the other, and is no difference where there
/// is none: whether the solver lists such a node is not settled. Nodes of the edge zone are left out: the solver never
/// lists them. A contact that only one source has is a difference only if it has records.
[[nodiscard]] Comparison compare(const Report& first, const Report& second, double tolerance);

/// Two depths are the same: `tolerance` apart, plus half a unit in the fifth digit of the larger one.
[[nodiscard]] bool same_depth(double first, double second, double tolerance);

[[nodiscard]] std::string comparison_text(const Comparison& comparison, const Report& first, const Report& second,
                                          std::size_t top);
[[nodiscard]] std::string comparison_json(const Comparison& comparison, const Report& first, const Report& second);

}  // namespace gapcheck::report
