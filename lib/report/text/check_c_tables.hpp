#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "records/report.hpp"
#include "report/text/check_c_view.hpp"

namespace gapcheck::report {

/// The records of one interface in the order of the view: deepest first, or with -rsort the least remaining distance
/// first and unknown ones last; then by node id.
[[nodiscard]] std::vector<const Penetration*> in_view_order(const Report& report, std::span<const Penetration> records,
                                                            bool rsort);

/// The tie failures of one interface for one reason: largest separation first, unknown ones last; then by node id.
[[nodiscard]] std::vector<const TieFailure*> in_view_order(std::span<const TieFailure> failures, TieReason reason);

/// The tie failures of one contact (position in Report::contacts).
[[nodiscard]] std::span<const TieFailure> ties_of(const Report& report, std::uint32_t contact);

/// Number of values in each tenth of [0, largest]; a value on a border counts in the upper tenth, the largest value in
/// the last one, negative ones in the first.
inline constexpr std::size_t bucket_count = 10;
[[nodiscard]] std::array<std::size_t, bucket_count> buckets(std::span<const double> values, double largest);

/// Tables of the view, indented; at most `limit` rows.
void append_penetrations(const Report& report, std::span<const Penetration* const> records, std::size_t limit, bool pid,
                         std::string& out);
void append_ties(std::span<const TieFailure* const> failures, std::size_t limit, bool pid, std::string& out);
void append_buckets(std::string_view title, std::span<const double> values, std::string& out);

/// Nodes per part of the tracked node, with the largest value; parts ascending, unknown ones as "-".
void append_part_sums(std::span<const Penetration* const> records, std::span<const TieFailure> ties, std::string& out);

}  // namespace gapcheck::report
