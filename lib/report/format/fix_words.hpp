#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

// Words of the reports on corrections and repairs.
namespace gapcheck::report::fix_words {

[[nodiscard]] inline std::string number(double value) { return fmt::format("{:.6g}", value); }

/// "1 node", "2 nodes".
[[nodiscard]] inline std::string plural(std::uint64_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

[[nodiscard]] inline std::string part_name(std::int64_t part) {
  return part == 0 ? "nodes without part" : fmt::format("part {}", part);
}

}  // namespace gapcheck::report::fix_words
