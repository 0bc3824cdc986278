#include "contact/surface/contact_surfaces.hpp"

#include <algorithm>

#include "base/stopwatch.hpp"
#include "contact/surface/erosion.hpp"

namespace gapcheck::contact {
namespace {

std::size_t count_lines(const Segments& s) {
  return static_cast<std::size_t>(std::count(s.kind.begin(), s.kind.end(), SegmentKind::line));
}

/// Beams are tracked by their nodes in all types, but only types 26 treat them as reference lines.
void drop_lines(ContactSide& side) {
  Segments& s = side.selection.segments;
  const std::size_t keep = s.size() - side.lines;
  s.nodes.resize(keep);
  s.element.resize(keep);
  s.element_kind.resize(keep);
  s.kind.resize(keep);
  s.half.resize(keep);
  s.rule.resize(keep);
  if (!s.offset.empty()) s.offset.resize(keep);
  side.lines = 0;
}

/// A reference side of only nodes or beams has nothing that a node could penetrate.
void need_segments(ContactSide& side, std::size_t lines) {
  if (side.selection.segments.size() > lines || !side.selection.empty_reason.empty()) return;
  side.selection.empty_reason = "what it names has no segments";
}

/// Negative values are thicknesses of everything on their side, solids and free nodes included.
void take_negative(ContactSide& side, double value) {
  if (!(value < 0)) return;
  std::fill(side.nodes.half.begin(), side.nodes.half.end(), -value / 2);
  std::fill(side.selection.segments.half.begin(), side.selection.segments.half.end(), -value / 2);
}

}  // namespace

ContactSurfaces build_surfaces(const model::Model& model, const model::Contact& contact, const std::vector<Vector>& x,
                               MeshIndex& index, const ThicknessChange& change) {
  ContactSurfaces s;
  s.type = classify(contact);
  const bool tied = s.type.family == Family::tied;
  s.settings = tied ? ContactSettings{.shlthk = 2} : settings(contact, s.type, model.controls);
  const auto build = [&](ContactSide& side, bool b) {
    side.selection = select(model, b ? contact.b : contact.a, s.type, x, index);
    side.nodes_only = side.selection.segments.size() == 0 && !side.selection.nodes.empty();
    ThicknessSide thickness = thickness_side(contact, s.settings, model.controls, b);
    if (!tied) thickness = changed(thickness, change);
    for (Segments* segments : {&side.selection.segments, &side.selection.cut}) {
      fill_thickness(*segments, model, thickness, x);
      if (s.settings.mid_surface_offset) fill_offsets(*segments, model);
    }
    if (!b || s.type.treatment == Treatment::two_way || s.type.by_segments())
      side.nodes = tracked_nodes(side.selection, model, thickness, x, index);
    side.lines = count_lines(side.selection.segments);
    if (s.two_sided() && s.type.code != ContactCode::transducer) drop_lines(side);  // transducers measure at beams too
    if (tied) take_negative(side, b ? contact.mst : contact.sst);
  };
  build(s.a, false);
  if (s.two_sided() && (s.type.treatment != Treatment::none || contact.b.given)) build(s.b, true);
  if (s.type.treatment == Treatment::single_surface)
    need_segments(s.a, s.type.edges ? 0 : s.a.lines);
  else if (s.type.treatment != Treatment::none)
    need_segments(s.b, 0);
  return s;
}

const ContactSurfaces& SurfaceStore::at(ContactIndex contact) {
  auto& surfaces = built_[contact.value];
  ++asked_;
  if (!surfaces) {
    const Stopwatch watch(seconds_);
    surfaces = std::make_unique<const ContactSurfaces>(build(contact, model_.mesh.nodes.x));
    ++count_;
  }
  return *surfaces;
}

ContactSurfaces SurfaceStore::build(ContactIndex contact, const std::vector<Vector>& x) {
  const ThicknessChange change = changes_.empty() ? ThicknessChange{} : changes_[contact.value];
  return build_surfaces(model_, model_.contact(contact), x, index_, change);
}

ContactSurfaces SurfaceStore::erode(ContactIndex contact, const ContactSurfaces& now, const GoneElements& gone,
                                    const std::vector<Vector>& x) {
  return erode_surfaces(model_, model_.contact(contact), at(contact), now, gone, x, index_);
}

}  // namespace gapcheck::contact
