#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "records/report.hpp"

namespace gapcheck::report {

/// Penetrating nodes (or edges) of one part in segments (or edges) of another, in one contact. Part 0: unknown.
struct PartPair {
  std::int64_t part = 0, element_part = 0;
  std::size_t nodes = 0;
  const Penetration* deepest = nullptr;
};

/// Sums of the records of one contact; lives as long as the records. Nodes of the edge zone count only in `edge_zone`.
struct Sums {
  std::array<std::size_t, penetration_kinds> count{};  ///< by kind
  const Penetration* deepest = nullptr;                ///< of all except the edge zone
  std::vector<PartPair> pairs;                         ///< deepest first, then by part ids; of nodes()
  std::vector<PartPair> edge_pairs;                    ///< the same of edges
  [[nodiscard]] std::size_t of(PenetrationKind kind) const { return count[static_cast<std::size_t>(kind)]; }
  /// Nodes in segments, whatever the contact.
  [[nodiscard]] std::size_t nodes() const {
    using enum PenetrationKind;
    return of(initial) + of(released) + of(segment) + of(mortar);
  }
  [[nodiscard]] std::size_t penetrations() const { return nodes() + of(PenetrationKind::edge); }
  /// Adds the counts of another contact; the pairs stay.
  Sums& operator+=(const Sums& other);
};
[[nodiscard]] Sums sums(std::span<const Penetration> records);

/// The records of one contact (position in Report::contacts).
[[nodiscard]] std::span<const Penetration> records_of(const Report& report, std::uint32_t contact);

}  // namespace gapcheck::report
