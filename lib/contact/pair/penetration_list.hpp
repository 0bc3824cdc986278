#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "contact/pair/hit.hpp"
#include "records/penetration.hpp"

namespace gapcheck::contact {

/// The penetrations of one contact while its sides are searched in turn: the end of the list of all contacts. A node is
/// listed once, by the side that is searched first.
class PenetrationList {
 public:
  /// `all`: begins with the penetrations of other contacts. Must outlive this, and must not be changed elsewhere
  /// meanwhile.
  explicit PenetrationList(std::vector<Penetration>& all) : all_(all), first_(all.size()) {}
  /// Drops the hits of nodes already listed; but a penetration replaces a note on the edge zone. `id`: of the nodes of
  /// the mesh.
  void keep_one_per_node(std::vector<Hit>& hits, const TrackedNodes& nodes, const std::vector<std::int64_t>& id);
  void add(std::span<const Penetration> records) { all_.insert(all_.end(), records.begin(), records.end()); }
  /// Adds that many records and returns them to be filled in; valid until the next change.
  [[nodiscard]] std::span<Penetration> add(std::size_t count);
  /// Nodes that penetrate equally deep ascending by their ids.
  void sort_deepest_first();
  [[nodiscard]] std::span<const Penetration> records() const { return std::span(all_).subspan(first_); }

 private:
  std::vector<Penetration>& all_;
  std::size_t first_;
};

}  // namespace gapcheck::contact
