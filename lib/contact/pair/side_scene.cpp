#include "contact/pair/side_scene.hpp"

#include <algorithm>

namespace gapcheck::contact {
namespace {

bool has_solids(const Segments& segments) {
  return std::find(segments.kind.begin(), segments.kind.end(), SegmentKind::solid) != segments.kind.end();
}

std::shared_ptr<const Neighbours> neighbours_of(const ContactSide& side, const model::Mesh& mesh, NeighbourKind kind,
                                                NeighbourCache* shared) {
  return shared != nullptr ? shared->of(side, mesh, kind) : make_neighbours(side, mesh, kind);
}

}  // namespace

SideScene::SideScene(const model::Model& model, ContactIndex contact, const ContactSurfaces& surfaces, bool exchanged,
                     const std::vector<Vector>& x, NeighbourCache* shared)
    : tracked_(exchanged ? surfaces.b : surfaces.a),
      reference_(exchanged || !surfaces.two_sided() ? surfaces.a : surfaces.b),
      neighbours_(neighbours_of(reference_, model.mesh,
                                surfaces.two_sided() ? NeighbourKind::with_cut : NeighbourKind::with_solids, shared)),
      scene_{model,
             model.contact(contact),
             surfaces.type,
             surfaces.settings,
             x,
             reference_.selection.segments,
             tracked_.nodes,
             *neighbours_,
             exchanged || !surfaces.two_sided() ? model.contact(contact).a.type : model.contact(contact).b.type,
             reference_.bodies ? solid_extents(reference_.selection.segments, model.mesh, *reference_.bodies, x)
                               : SolidExtents{},
             {}} {
  const Segments& own = tracked_.selection.segments;
  if (!has_solids(own) || !has_solids(reference_.selection.segments)) return;
  if (&tracked_ != &reference_) own_ = neighbours_of(tracked_, model.mesh, NeighbourKind::segments, shared);
  scene_.own = &own;
  scene_.own_neighbours = own_ ? own_.get() : neighbours_.get();
}

}  // namespace gapcheck::contact
