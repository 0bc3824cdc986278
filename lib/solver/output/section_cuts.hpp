#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace gapcheck::solver {

/// What a cross-section of the deck (*DATABASE_CROSS_SECTION_PLANE, _SET) cuts at the start. The elements stay the same
/// from then on, as in LS-DYNA (Keyword User's Manual, Vol. I, *DATABASE_CROSS_SECTION).
struct CutSection {
  /// An element whose forces count on some of its corners.
  struct Element {
    std::uint32_t element = 0;  ///< position in the model
    std::uint8_t corners = 0;   ///< one bit each
  };
  /// A point of the element's edge: a + share (b − a).
  struct EdgePoint {
    NodeIndex a, b;
    double share = 0;
  };
  enum class Kind : std::uint8_t { shell, solid, beam };
  /// The area that one element has in the section: a polygon, a line times the thickness, or a point with an area.
  struct Patch {
    Kind kind = Kind::solid;
    std::uint32_t element = 0;
    std::vector<EdgePoint> points;
  };

  std::uint32_t section = 0;                     ///< position in Model::cross_sections
  std::array<std::vector<Element>, 3> elements;  ///< by kind
  std::vector<Patch> patches;
  std::string fault;  ///< why it is not calculated; empty: it is

  [[nodiscard]] bool empty() const { return elements[0].empty() && elements[1].empty() && elements[2].empty(); }
};

/// One for each section of the deck. A plane cuts the elements with nodes on both sides of it: at or behind it, and in
/// front of it; those that its edges cross are left out. The nodes behind the plane count, so that a pulled section has
/// a force along its normal. Of sets, the elements' forces on the nodes of the set count.
[[nodiscard]] std::vector<CutSection> section_cuts(const model::Model& model);

}  // namespace gapcheck::solver
