#pragma once
#include <vector>

#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::contact {

/// Elements that have failed, by position in the mesh; elements beyond the ends have not.
struct GoneElements {
  const std::vector<bool>& shells;
  const std::vector<bool>& solids;
  const std::vector<bool>& beams;
  [[nodiscard]] bool shell(std::uint32_t i) const { return i < shells.size() && shells[i]; }
  [[nodiscard]] bool beam(std::uint32_t i) const { return i < beams.size() && beams[i]; }
  [[nodiscard]] bool solid(std::uint32_t i) const { return i < solids.size() && solids[i]; }
};

/// True for types 14 to 16.
[[nodiscard]] bool is_eroding(const ContactType& type);

/// What is left of a contact's surfaces when elements have failed. Segments of failed elements leave; nodes leave once
/// all their elements have failed, unless ENMASS keeps them. Eroding types with EROSOP = 1 or IADJ = 1 get the faces
/// that remaining solids shared with failed ones, on sides given by whole parts. Remaining segments keep their
/// thickness; new ones have that of the side's other solids, without the parts' own settings. `start`: the surfaces
/// before anything failed; `now`: the current ones; `x`: present coordinates. `index`: of this model. Linear in the
/// surfaces and the number of solids.
[[nodiscard]] ContactSurfaces erode_surfaces(const model::Model& model, const model::Contact& contact,
                                             const ContactSurfaces& start, const ContactSurfaces& now,
                                             const GoneElements& gone, const std::vector<Vector>& x, MeshIndex& index);

}  // namespace gapcheck::contact
