#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/ids.hpp"
#include "records/baseline.hpp"

namespace gapcheck::report {

/// Rules that are degrees of the same problem: the id that represents all of them, and the degree of this one.
struct Degree {
  std::string_view family;
  int degree = 0;
};
[[nodiscard]] Degree degree_of(std::string_view id);

/// A text without its numbers: every run of digits becomes '#'.
[[nodiscard]] std::string without_numbers(std::string_view text);

inline constexpr std::uint32_t unmatched = no_position;

/// For each of `now` the position in `before` of the matching finding, or `unmatched`; each of `before` at most once.
/// The first `shown` of `now` come before the others. Deterministic. See compare_with_baseline().
[[nodiscard]] std::vector<std::uint32_t> match_findings(const std::vector<KnownFinding>& before,
                                                        const std::vector<KnownFinding>& now, std::size_t shown);

}  // namespace gapcheck::report
