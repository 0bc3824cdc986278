#include "contact/surface/contact_side.hpp"

#include <algorithm>
#include <bit>

#include "contact/surface/surface_parts.hpp"
#include "contact/surface/symmetry.hpp"

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

ContactSide build_side(const model::Model& model, const SideRequest& request, const ContactType& type,
                       const std::vector<Vector>& x, MeshIndex& index) {
  ContactSide side;
  side.selection = select(model, request.input, type, x, index);
  if (request.symmetry && (whole_parts(request.input) || request.input.id == 0))
    SymmetryPlanes(model).leave_out(side.selection.segments, x);
  side.nodes_only = side.selection.segments.size() == 0 && !side.selection.nodes.empty();
  side.names_nodes = side.nodes_only && side.selection.cut.size() == 0;
  for (Segments* segments : {&side.selection.segments, &side.selection.cut}) {
    fill_thickness(*segments, model, request.thickness, x);
    if (request.offsets) fill_offsets(*segments, model);
  }
  if (request.tracks_nodes) side.nodes = tracked_nodes(side.selection, model, request.thickness, x, index);
  side.lines = count_lines(side.selection.segments);
  side.beams_alone = side.lines > 0 && side.lines == side.selection.segments.size();
  if (!request.single && !request.transducer) drop_lines(side);  // transducers measure at beams too
  take_negative(side, request.negative);
  const std::vector<SegmentKind>& kinds = side.selection.segments.kind;
  if (std::find(kinds.begin(), kinds.end(), SegmentKind::solid) != kinds.end()) side.bodies = index.bodies();
  if (request.needs_segments) need_segments(side, request.single && !request.edges ? side.lines : 0);
  return side;
}

SideCache::Key SideCache::key_of(const SideRequest& request) {
  const auto number = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  const auto whole = [](std::int64_t value) { return static_cast<std::uint64_t>(value); };
  const ThicknessSide& t = request.thickness;
  std::uint64_t flags = 0;
  for (const bool flag :
       {request.offsets, request.single, request.tied, request.transducer, request.edges, request.spotwelds,
        request.tracks_nodes, request.needs_segments, request.symmetry, t.edge_limit, t.optt})
    flags = flags << 1 | (flag ? 1U : 0U);
  return {whole(request.input.id),
          whole(request.input.type),
          whole(request.input.box),
          number(t.override_value),
          number(t.scale),
          number(t.global_value),
          number(t.global_scale),
          number(t.solid_coating),
          whole(t.shlthk),
          number(request.negative),
          flags,
          request.input.given ? 1U : 0U};
}

std::shared_ptr<const ContactSide> SideCache::side(const model::Model& model, const SideRequest& request,
                                                   const ContactType& type, const std::vector<Vector>& x,
                                                   MeshIndex& index) {
  return sides_.at(key_of(request),
                   [&] { return std::make_unique<const ContactSide>(build_side(model, request, type, x, index)); });
}

}  // namespace gapcheck::contact
