#include "contact/pair/penetration_record.hpp"

#include "contact/definition/outcome.hpp"
#include "contact/pair/release.hpp"

namespace gapcheck::contact {
namespace {

PenetrationKind kind_of(const PairScene& scene, const Hit& hit, const PairResult& pair, double depth) {
  if (scene.type.pairing == Pairing::mortar) return PenetrationKind::mortar;
  if (scene.type.pairing == Pairing::segments) return PenetrationKind::segment;
  if (!pair.in_band) return PenetrationKind::edge_zone;
  return depth > release_depth(scene, hit.slot, hit.segment) ? PenetrationKind::released : PenetrationKind::initial;
}

Outcome outcome_of(PenetrationKind kind, const ContactSettings& settings) {
  switch (kind) {
    case PenetrationKind::segment:
    case PenetrationKind::mortar:
      return Outcome::kept;
    case PenetrationKind::released:
      return Outcome::released;
    case PenetrationKind::initial:
      return outcome(settings);
    case PenetrationKind::edge_zone:
    case PenetrationKind::edge:
      break;
  }
  return Outcome::reported;
}

}  // namespace

Penetration penetration_record(const PairScene& scene, ContactIndex contact, const Hit& hit) {
  const Segments& s = scene.segments;
  const model::Mesh& mesh = scene.model.mesh;
  const NodeIndex node = scene.nodes.node[hit.slot.value];
  const PairResult pair = measure_pair(scene, hit.slot, hit.segment);
  Penetration p;
  p.contact = contact.value;
  p.segment_number = hit.segment.value + 1;
  p.node = mesh.nodes.id[node.value];
  if (const PartIndex part = scene.nodes.part[hit.slot.value]; part != none<PartIndex>)
    p.part = scene.model.part(part).id.value;
  for (std::size_t i = 0; i < 4; ++i) p.segment[i] = mesh.nodes.id[s.nodes[hit.segment.value][i].value];
  p.element = element_id(mesh, s, hit.segment.value);
  if (const PartIndex part = part_of(mesh, s, hit.segment.value); part != none<PartIndex>)
    p.element_part = scene.model.part(part).id.value;
  p.contact_distance = scene.nodes.half[hit.slot.value] + s.half[hit.segment.value];
  p.depth = p.contact_distance - pair.distance;
  p.s = pair.closest.s;
  p.t = pair.closest.t;
  p.original = p.moved_to = scene.x[node.value];
  p.point = pair.closest.point;
  p.feature = pair.closest.feature;
  p.node_rule = scene.nodes.rule[hit.slot.value];
  p.segment_rule = s.rule[hit.segment.value];
  p.file = mesh.nodes.origins.file(node.value).value;
  p.line = mesh.nodes.line[node.value];
  p.kind = kind_of(scene, hit, pair, p.depth);
  p.outcome = outcome_of(p.kind, scene.settings);
  const bool recommended = p.outcome == Outcome::kept && scene.settings.ignore == 2;
  if (p.outcome == Outcome::moved || recommended)
    p.moved_to = p.original + shooting_move * p.depth * free_direction(scene, hit.slot, hit.segment, pair);
  return p;
}

}  // namespace gapcheck::contact
