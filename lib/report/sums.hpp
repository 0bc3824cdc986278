#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "records/report.hpp"

namespace gapcheck::report {

/// Penetrating nodes of one part in segments of another, in one contact. Part 0: unknown.
struct PartPair {
  std::int64_t part = 0, element_part = 0;
  std::size_t nodes = 0;
  const Penetration* deepest = nullptr;
};

/// What the records of one contact amount to; lives as long as the records. Nodes of the edge zone count only in
/// `edge_zone`.
struct Sums {
  std::size_t initial = 0, released = 0, edge_zone = 0;
  const Penetration* deepest = nullptr;  ///< of `initial` and `released`
  std::vector<PartPair> pairs;           ///< deepest first, then by part ids; of `initial` and `released`
  [[nodiscard]] std::size_t penetrations() const { return initial + released; }
};
[[nodiscard]] Sums sums(std::span<const Penetration> records);

/// The records of one contact (position in Report::contacts).
[[nodiscard]] std::span<const Penetration> records_of(const Report& report, std::uint32_t contact);

}  // namespace gapcheck::report
