#include "contact/pair/side_scene.hpp"

namespace gapcheck::contact {

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
             {}} {}

}  // namespace gapcheck::contact
