#include "contact/surface/contact_surfaces.hpp"

#include "base/stopwatch.hpp"
#include "contact/surface/erosion.hpp"

namespace gapcheck::contact {
namespace {

const std::shared_ptr<const ContactSide>& empty_side() {
  static const auto empty = std::make_shared<const ContactSide>();
  return empty;
}

SideRequest request_of(const model::Model& model, const model::Contact& contact, const ContactSurfaces& of, bool b,
                       const ThicknessChange& change) {
  const bool tied = of.type.family == Family::tied, two_way = of.type.treatment == Treatment::two_way;
  SideRequest request;
  request.input = b ? contact.b : contact.a;
  request.thickness = thickness_side(contact, of.settings, model.controls, b);
  if (!tied) request.thickness = changed(request.thickness, change);
  request.offsets = of.settings.mid_surface_offset;
  request.single = !of.two_sided();
  request.tied = tied;
  request.transducer = of.type.code == ContactCode::transducer;
  request.edges = of.type.edges;
  request.spotwelds = of.type.spotweld_beams;
  request.tracks_nodes = !b || two_way || of.type.by_segments();
  request.needs_segments = of.type.treatment != Treatment::none && (b || request.single);
  request.symmetry = contact.symmetry_faces == 1;
  if (tied) request.negative = b ? contact.mst : contact.sst;
  return request;
}

}  // namespace

ContactSurfaces::ContactSurfaces(ContactType contact_type, const ContactSettings& contact_settings,
                                 std::shared_ptr<const ContactSide> side_a, std::shared_ptr<const ContactSide> side_b)
    : type(std::move(contact_type)),
      settings(contact_settings),
      a(*side_a),
      b(side_b ? *side_b : *empty_side()),
      shared_a_(std::move(side_a)),
      shared_b_(side_b ? std::move(side_b) : std::shared_ptr<const ContactSide>(empty_side())) {}

ContactSurfaces build_surfaces(const model::Model& model, const model::Contact& contact, const std::vector<Vector>& x,
                               MeshIndex& index, const ThicknessChange& change, SideCache* sides) {
  const ContactType type = classify(contact);
  const ContactSettings values =
      type.family == Family::tied ? ContactSettings{.shlthk = 2} : settings(contact, type, model.controls);
  const ContactSurfaces empty(type, values, empty_side());
  SideCache none_before;
  const auto build = [&](bool b) {
    return (sides != nullptr ? *sides : none_before)
        .side(model, request_of(model, contact, empty, b, change), type, x, index);
  };
  const bool has_b = empty.two_sided() && (type.treatment != Treatment::none || contact.b.given);
  std::shared_ptr<const ContactSide> a = build(false);
  return {type, values, std::move(a), has_b ? build(true) : nullptr};
}

const ContactSurfaces& SurfaceStore::at(ContactIndex contact) {
  auto& surfaces = built_[contact.value];
  ++asked_;
  if (!surfaces) {
    const Stopwatch watch(seconds_);
    surfaces = std::make_unique<const ContactSurfaces>(build(contact, model_.mesh.nodes.x, &sides_));
    ++count_;
  }
  return *surfaces;
}

ContactSurfaces SurfaceStore::build(ContactIndex contact, const std::vector<Vector>& x, SideCache* sides) {
  const ThicknessChange change = changes_.empty() ? ThicknessChange{} : changes_[contact.value];
  return build_surfaces(model_, model_.contact(contact), x, index_, change, sides);
}

ContactSurfaces SurfaceStore::erode(ContactIndex contact, const ContactSurfaces& now, const GoneElements& gone,
                                    const std::vector<Vector>& x) {
  return erode_surfaces(model_, model_.contact(contact), at(contact), now, gone, x, index_);
}

}  // namespace gapcheck::contact
