#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "report/html/html_data.hpp"

namespace gapcheck::report {

/// What the page draws: positions and vectors of the findings, the faces of the scene with their elements and contact
/// thicknesses, and for every finding the points of its node and of its segment.
[[nodiscard]] std::string picture_json(const Report& report, const std::vector<HtmlFinding>& findings);

// Parts of the above, for tests.

/// Differences of consecutive numbers, as unsigned numbers of seven bits per byte, the lowest first, the sign in the
/// lowest bit (0, -1, 1, -2: 0, 1, 2, 3): neighbouring faces have neighbouring points, so most take one byte or two.
[[nodiscard]] std::string packed_differences(std::span<const std::uint32_t> numbers);

/// Consecutive ids as runs: first id, number of ids. Those outside 32 bits become 0.
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> id_runs(const std::vector<std::int64_t>& ids);

}  // namespace gapcheck::report
