#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace gapcheck::audit_test {

/// What a deck holds by counting its lines, without reading a single number.
struct NaiveCount {
  std::uint64_t nodes = 0, shells = 0, solids = 0, beams = 0, particles = 0, parts = 0;
  std::vector<std::string> contacts;  ///< keywords as written, upper case, without `*`
};

/// Counts a deck and the includes that stand in the same folder as their includer.
[[nodiscard]] NaiveCount naive_count(const std::string& path);

}  // namespace gapcheck::audit_test
