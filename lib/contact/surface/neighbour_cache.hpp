#pragma once
#include <cstdint>
#include <memory>
#include <utility>

#include "base/weak_cache.hpp"
#include "contact/surface/contact_side.hpp"
#include "contact/surface/neighbours.hpp"

namespace gapcheck::contact {

/// Which neighbours of a side's segments are meant.
enum class NeighbourKind : std::uint8_t {
  segments,     ///< these alone
  with_cut,     ///< also of those that a box leaves out
  with_solids,  ///< also of those, and of solids whose faces are no segments
};

[[nodiscard]] inline std::unique_ptr<const Neighbours> make_neighbours(const ContactSide& side, const model::Mesh& mesh,
                                                                       NeighbourKind kind) {
  return std::make_unique<const Neighbours>(side.selection.segments, mesh, kind == NeighbourKind::with_solids,
                                            kind == NeighbourKind::segments ? nullptr : &side.selection.cut);
}

/// The neighbours in use of the sides of one mesh: contacts with the same side share them. Does not keep them: they
/// must not outlive their side. Not for use from several threads.
class NeighbourCache {
 public:
  [[nodiscard]] std::shared_ptr<const Neighbours> of(const ContactSide& side, const model::Mesh& mesh,
                                                     NeighbourKind kind) {
    return built_.at({&side, kind}, [&] { return make_neighbours(side, mesh, kind); });
  }

 private:
  WeakCache<std::pair<const ContactSide*, NeighbourKind>, Neighbours> built_;
};

}  // namespace gapcheck::contact
