#pragma once
#include <cstdint>
#include <vector>

#include "contact/surface/surface.hpp"

namespace gapcheck::contact {

/// The nodes that single point constraints hold for the whole run, and the faces that lie on planes of symmetry: ISYM
/// of eroding contacts leaves out faces of solids whose corners are all held along the face's normal (keyword manual,
/// *CONTACT, card 4).
class SymmetryPlanes {
 public:
  explicit SymmetryPlanes(const model::Model& model);
  /// Every corner is held in each direction that the normal has, but for a thousandth of it.
  [[nodiscard]] bool holds(const model::SegmentNodes& face, const std::vector<Vector>& x) const;
  /// Removes such faces of solids and thick shells; call it before thicknesses are filled in.
  void leave_out(Segments& segments, const std::vector<Vector>& x) const;

 private:
  std::vector<std::uint8_t> held_;  ///< by node: bits of x, y and z
};

}  // namespace gapcheck::contact
