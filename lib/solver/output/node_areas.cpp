#include "solver/output/node_areas.hpp"

#include <cmath>
#include <unordered_set>

#include "contact/surface/segment_elements.hpp"
#include "solver/contact/contact_method.hpp"

namespace gapcheck::solver {

NodeAreas::NodeAreas(const model::Model& model, contact::SurfaceStore& surfaces) {
  for (const ContactIndex contact : positions<ContactIndex>(model.contacts.size())) {
    const ContactMethod method = choose_method(model.contact(contact)).method;
    if (method == ContactMethod::none || method == ContactMethod::transducer) continue;
    const contact::ContactSurfaces& sides = surfaces.at(contact);
    add(contact, 0, sides.a.selection.segments);
    if (sides.two_sided()) add(contact, 1, sides.b.selection.segments);
  }
}

void NodeAreas::add(ContactIndex contact, std::size_t side, const contact::Segments& segments) {
  std::unordered_set<contact::SegmentKey, contact::SegmentKeyHash> known;  // sets may name a segment twice
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const model::SegmentNodes& nodes = segments.nodes[i];
    if (segments.kind[i] == contact::SegmentKind::line || !known.insert(contact::segment_key(nodes)).second) continue;
    const std::size_t corners = nodes[3] == nodes[2] ? 3 : 4;
    for (std::size_t k = 0; k < corners; ++k) around_[{contact, side, nodes[k]}].push_back(nodes);
  }
}

double NodeAreas::pressure(ContactIndex contact, std::size_t side, NodeIndex node, const Vector& force,
                           const std::vector<Vector>& x) const {
  const auto found = around_.find({contact, side, node});
  if (found == around_.end()) return 0;
  double area = 0;
  Vector normal = Vector::Zero();
  for (const model::SegmentNodes& nodes : found->second) {
    const auto at = [&](std::size_t k) -> const Vector& { return x[nodes[k].value]; };
    const Vector share = (at(2) - at(0)).cross(at(3) - at(1)) / (nodes[3] == nodes[2] ? 6 : 8);
    area += share.norm();
    normal += share;
  }
  const double length = normal.norm();
  return area > 0 && length > 0 ? std::abs(force.dot(normal)) / (length * area) : 0;
}

}  // namespace gapcheck::solver
