#pragma once
#include <map>
#include <utility>

#include "reference/surfaces.hpp"

namespace gapcheck::reference {

/// The edges that only one shell segment of a surface has (contact rules, section 3.3).
class FreeEdges {
 public:
  explicit FreeEdges(const Side& side);
  /// Whether a node lies beside the surface, where the closest point of a facet is on a free edge or at its end.
  [[nodiscard]] bool beside(const Facet& facet, const Closest& c) const;
  /// True if that hangs on the last digits: the node is straight above a free edge, or level with the end of an edge
  /// that is not free, and at which a free one begins.
  [[nodiscard]] bool level_with_end(const Facet& facet, const Closest& c, const Corners& x, const Vector& query) const;

 private:
  [[nodiscard]] bool ends_at(std::int64_t node) const;
  using Edge = std::pair<std::int64_t, std::int64_t>;
  std::map<Edge, int> uses_;
};

}  // namespace gapcheck::reference
