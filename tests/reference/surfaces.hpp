#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "model/contact/contact_kind.hpp"
#include "reference/closest.hpp"
#include "reference/scene.hpp"

namespace gapcheck::reference {

/// Coordinates by node id; entry 0 is not used.
using Positions = std::vector<Vector>;

[[nodiscard]] inline const Vector& at(const Positions& x, std::int64_t node) {
  return x[static_cast<std::size_t>(node)];
}

/// What of a contact type and its cards the rules ask for (contact rules, sections 1.2 to 1.5, 4.4, 7.1).
struct Rules {
  const Contact& contact;
  const Controls& controls;
  const model::ContactKind& kind;
  bool single = false, two_way = false;
  bool oriented = false;        ///< shells act on the side of their normal (1.4)
  bool edge_limit = false;      ///< 4.3
  bool by_segments = false;     ///< SOFT = 2 or mortar (7.4, 7.5)
  int shlthk = 2;               ///< shells whose thickness counts: 0 none, 1 deformable, 2 all (4.4)
  bool free_edges_end = false;  ///< nothing lies beside a free edge (3.3)

  Rules(const Contact& c, const Scene& scene);
};

/// A reference segment.
struct Facet {
  std::array<std::int64_t, 4> nodes{};
  bool triangle = false, solid = false;
  bool line = false;  ///< a beam's axis
  std::int64_t element = 0, part = 0;
  double thickness = 0;            ///< contact thickness, full
  double own_thickness = 0;        ///< of the element, whether the contact counts it or not
  const Element* brick = nullptr;  ///< whose face it is
  bool coated = false;             ///< a dummy shell of SLDTHK on the face of a brick, outward (4.5)
  [[nodiscard]] bool has(std::int64_t node) const;
};

/// A brick of the reference side with its outer faces, whether these are segments or not.
struct Body {
  std::int64_t part = 0;
  std::vector<const Element*> bricks;
  std::vector<Facet> faces;
};

/// One side of a contact.
struct Side {
  std::vector<Facet> facets;
  std::map<std::int64_t, double> nodes;  ///< tracked: half their contact thickness
  std::map<std::int64_t, Body> bodies;   ///< by part
  bool turned_by_default = false;        ///< given by parts (1.4)
};

/// Which side: field names SST, SFST or MST, SFMT.
enum class Which : std::uint8_t { a, b };

[[nodiscard]] Side make_side(const Scene& scene, const Rules& rules, Which which, const Positions& x);

/// Contact thickness of a shell or beam (contact rules, section 4.2), and of a shell without what the contact ignores.
[[nodiscard]] double contact_thickness(const Scene& scene, const Rules& rules, Which which, const Element& element,
                                       const Positions& x);
[[nodiscard]] double uncounted_thickness(const Scene& scene, const Element& element);

[[nodiscard]] Corners corners(const std::array<std::int64_t, 4>& nodes, const Positions& x);
[[nodiscard]] Closest closest_of(const Facet& facet, const Corners& x, const Vector& query);
/// All faces of a brick, outward.
[[nodiscard]] std::vector<Facet> faces_of(const Element& brick, const Positions& x);
/// V / A of the face of a brick (4.5).
[[nodiscard]] double solid_depth(const Facet& facet, const Positions& x);
[[nodiscard]] double shorter_diagonal(const Facet& facet, const Positions& x);

}  // namespace gapcheck::reference
