#include "contact/pair/release.hpp"

#include <limits>

namespace gapcheck::contact {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
/// Contact thickness of a solid in single-surface types, as a share of V / A (contact rules, section 4.5).
constexpr double single_surface_solid_share = 0.4;
/// Default PENMAX of types a3, a5, a10, 13, 15: solid segments / shell segments (contact rules, section 5).
constexpr double penmax_solid = 0.5, penmax_shell = 0.4;
/// Default PENMAX of types 26 (contact rules, section 5).
constexpr double penmax_general = 200;
/// PENCHK = 2: share of the shorter diagonal (contact rules, section 5).
constexpr double penchk_diagonal_share = 0.05;

/// XPENE · t with t of the segment: in the contact, or of its element if the contact ignores it (rigid tools).
double xpene_depth(const model::Controls& controls, const ReleasePair& pair, double solid_t) {
  const double shell_t = pair.segment_thickness > 0 ? pair.segment_thickness : pair.element_thickness;
  const double t = pair.solid_segment ? solid_t : shell_t;
  return t > 0 ? controls.xpene * t : never;
}

}  // namespace

double release_depth(const model::Contact& contact, const ContactType& type, const ContactSettings& settings,
                     const model::Controls& controls, const ReleasePair& pair) {
  const bool single = type.treatment == Treatment::single_surface;
  const double solid_t = pair.solid_depth * (single ? single_surface_solid_share : 1);
  const double t = pair.solid_segment ? solid_t : pair.node_thickness + pair.segment_thickness;
  switch (type.family) {
    case Family::automatic: {
      if (type.code == ContactCode::single_surface) return (pair.solid_segment ? penmax_solid : penmax_shell) * t;
      double penmax = contact.penmax;
      if (penmax <= 0) penmax = type.edges ? penmax_general : pair.solid_segment ? penmax_solid : penmax_shell;
      return penmax * t;
    }
    case Family::old:
      if (type.code == ContactCode::sliding) return never;
      if (settings.shlthk > 0) return xpene_depth(controls, pair, solid_t);
      if (contact.penchk == 1) return xpene_depth(controls, pair, solid_t);
      if (contact.penchk == 2) return penchk_diagonal_share * pair.min_diagonal;
      return contact.penmax > 0 ? contact.penmax : never;
    case Family::forming:
    case Family::constraint:
      return xpene_depth(controls, pair, solid_t);
    default:
      return never;
  }
}

ReleasePair release_pair(const PairScene& scene, SlotIndex slot, SegmentIndex segment) {
  const Segments& s = scene.segments;
  ReleasePair pair;
  pair.solid_segment = s.kind[segment.value] == SegmentKind::solid;
  pair.node_thickness = 2 * scene.nodes.half[slot.value];
  pair.segment_thickness = 2 * s.half[segment.value];
  if (!scene.solids.empty()) pair.solid_depth = scene.solids.depth[segment.value];
  if (s.element_kind[segment.value] == model::ElementKind::shell && element_id(scene.model.mesh, s, segment.value) != 0)
    pair.element_thickness = element_thickness(scene.model, s.element[segment.value]);
  pair.min_diagonal = min_diagonal(scene.facet(segment));
  return pair;
}

double release_depth(const PairScene& scene, SlotIndex slot, SegmentIndex segment) {
  return release_depth(scene.contact, scene.type, scene.settings, scene.model.controls,
                       release_pair(scene, slot, segment));
}

}  // namespace gapcheck::contact
