#include "contact/pair/side_scene.hpp"

#include <algorithm>

namespace gapcheck::contact {
namespace {

bool has_solids(const Segments& segments) {
  return std::find(segments.kind.begin(), segments.kind.end(), SegmentKind::solid) != segments.kind.end();
}

}  // namespace

SideScene::SideScene(const model::Model& model, ContactIndex contact, const ContactSurfaces& surfaces, bool exchanged,
                     const std::vector<Vector>& x)
    : tracked_(exchanged ? surfaces.b : surfaces.a),
      reference_(exchanged || !surfaces.two_sided() ? surfaces.a : surfaces.b),
      neighbours_(reference_.selection.segments, model.mesh, !surfaces.two_sided(), &reference_.selection.cut),
      scene_{model,
             model.contact(contact),
             surfaces.type,
             surfaces.settings,
             x,
             reference_.selection.segments,
             tracked_.nodes,
             neighbours_,
             exchanged || !surfaces.two_sided() ? model.contact(contact).a.type : model.contact(contact).b.type,
             solid_extents(reference_.selection.segments, model.mesh, x),
             {}} {
  const Segments& own = tracked_.selection.segments;
  if (!has_solids(own) || !has_solids(reference_.selection.segments)) return;
  if (&tracked_ != &reference_) own_.emplace(own, model.mesh);
  scene_.own = &own;
  scene_.own_neighbours = own_ ? &*own_ : &neighbours_;
}

}  // namespace gapcheck::contact
