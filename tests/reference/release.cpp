#include "reference/release.hpp"

#include <limits>

namespace gapcheck::reference {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// t of the table: of the segment, solids 0.4 V/A in single-surface types and V/A in the others (4.5).
double segment_thickness(const Rules& rules, const Facet& facet, const Positions& x) {
  if (facet.solid) return (rules.single ? 0.4 : 1.0) * solid_depth(facet, x);
  return facet.thickness > 0 ? facet.thickness : facet.own_thickness;
}

double or_default(double value, double normal) { return value > 0 ? value : normal; }

}  // namespace

double release_depth(const Rules& rules, const Facet& facet, double h, const Positions& x) {
  using model::ContactCode;
  const double t = segment_thickness(rules, facet, x), both = 2 * h, penmax = rules.contact.penmax;
  const double by_xpene = rules.controls.xpene * t;
  const bool solid = facet.solid;
  if (rules.by_segments) return never;
  switch (rules.kind.code) {
    case ContactCode::surface:
    case ContactCode::nodes:
    case ContactCode::one_way:
      if (rules.shlthk > 0) return by_xpene;
      if (rules.contact.penchk == 1) return by_xpene;
      if (rules.contact.penchk == 2) return 0.05 * shorter_diagonal(facet, x);
      return penmax > 0 ? penmax : never;
    case ContactCode::constraint_surface:
    case ContactCode::constraint_nodes:
    case ContactCode::forming_surface:
    case ContactCode::forming_nodes:
    case ContactCode::forming_one_way:
      return by_xpene;
    case ContactCode::single_surface:
      return solid ? 0.5 * t : 0.4 * both;
    case ContactCode::general:
    case ContactCode::general_interior:
      return or_default(penmax, 200) * (solid ? t : both);
    case ContactCode::automatic_surface:
    case ContactCode::automatic_nodes:
    case ContactCode::automatic_one_way:
    case ContactCode::automatic_single:
    case ContactCode::airbag_single:
    case ContactCode::eroding_surface:
    case ContactCode::eroding_single:
    case ContactCode::eroding_nodes:
      return solid ? or_default(penmax, 0.5) * t : or_default(penmax, 0.4) * both;
    default:
      return never;
  }
}

}  // namespace gapcheck::reference
