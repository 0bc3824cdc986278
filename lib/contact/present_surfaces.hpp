#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/initial.hpp"

namespace gapcheck::contact {

/// The surfaces of contacts while their initialisation moves nodes: those of the deck until the first node has moved,
/// then rebuilt for each contact. All references must outlive it.
class PresentSurfaces {
 public:
  /// `x`: present coordinates, as in the deck; only changed through this.
  PresentSurfaces(SurfaceStore& deck, std::vector<Vector>& x, InitialCounters& counters)
      : deck_(deck), x_(x), counters_(counters) {}
  [[nodiscard]] const std::vector<Vector>& x() const { return x_; }
  /// Valid until the next call.
  [[nodiscard]] const ContactSurfaces& at(ContactIndex contact);
  void move(NodeIndex node, const Vector& to);
  /// How often nodes have moved: as long as it stays, so do all coordinates.
  [[nodiscard]] std::uint64_t moves() const { return moves_; }
  /// Ties the nodes of a contact, which may move them.
  [[nodiscard]] TieResult tie(const TieScene& scene, ContactIndex contact, const ContactSurfaces& surfaces,
                              TiedPairs& ties);

 private:
  SurfaceStore& deck_;
  std::vector<Vector>& x_;
  InitialCounters& counters_;
  std::uint64_t moves_ = 0;  ///< 0: all nodes are at their positions in the deck
  SideCache sides_;          ///< on the present coordinates
  std::optional<ContactSurfaces> built_;
};

}  // namespace gapcheck::contact
