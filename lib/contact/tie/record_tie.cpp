#include "contact/tie/record_tie.hpp"

#include <algorithm>

namespace gapcheck::contact {

TieFailure record_tie(const JudgedNode& judged, const model::Model& model) {
  const model::Nodes& nodes = model.mesh.nodes;
  TieFailure failure;
  failure.contact = judged.contact.value;
  failure.node = nodes.id[judged.node.value];
  if (judged.part != none<PartIndex>) failure.part = model.part(judged.part).id.value;
  if (judged.segment != none<SegmentIndex>) {
    failure.segment_number = judged.segment.value + 1;
    failure.distance = judged.distance;
    failure.allowed = judged.allowed;
    failure.segment_size = judged.diagonal;
    if (std::min(judged.node_thickness, judged.segment_thickness) > 0)
      failure.thickness = judged.node_thickness + judged.segment_thickness;
  }
  failure.reason = *judged.reason;
  failure.by_node_set = judged.by_node_set;
  if (nodes.x[judged.node.value].allFinite()) failure.position = nodes.x[judged.node.value];
  failure.file = nodes.origins.file(judged.node.value).value;
  failure.line = nodes.line[judged.node.value];
  return failure;
}

}  // namespace gapcheck::contact
