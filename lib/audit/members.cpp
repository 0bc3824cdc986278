#include "audit/members.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "model/entity/faces.hpp"

namespace gapcheck::audit {
namespace {

bool names_part(const Finding& finding, const model::Model& model, PartIndex part) {
  if (finding.part == 0 && finding.element_part == 0) return true;
  if (part.value >= model.parts.size()) return false;
  const std::int64_t id = model.part(part).id.value;
  return id == finding.part || id == finding.element_part;
}

/// Calls add(element) where the finding's element is one of this kind.
template <std::size_t N, class Add>
void with_element(const Finding& finding, const model::Model& model, const model::Elements<N>& elements,
                  const Add& add) {
  const auto element = elements.lookup.find(finding.element);
  if (element && names_part(finding, model, elements.part[*element])) add(elements.nodes[*element]);
}

void add_element(const model::Model& model, Finding& finding) {
  const model::Mesh& mesh = model.mesh;
  const auto add = [&](const model::SegmentNodes& nodes) { add_segment(mesh.nodes, nodes, finding.members); };
  const auto add_faces = [&](const std::array<NodeIndex, 8>& nodes) {
    for (const model::SegmentNodes& face : model::SolidFaces(nodes)) add(face);
  };
  with_element(finding, model, mesh.shells, add);
  with_element(finding, model, mesh.solids, add_faces);
  with_element(finding, model, mesh.thick_shells, add_faces);
  with_element(finding, model, mesh.beams, [&](const std::array<NodeIndex, 2>& n) { add({n[0], n[1], n[1], n[1]}); });
}

}  // namespace

void add_segment(const model::Nodes& nodes, const model::SegmentNodes& segment, FindingMembers& members) {
  std::array<std::int64_t, 4> ids{};
  for (std::size_t i = 0; i < 4; ++i) {
    if (segment[i].value >= nodes.size()) return;
    ids[i] = nodes.id[segment[i].value];
  }
  members.segments.push_back(ids);
}

Collect collect_segments(const Context& context, SegmentsOf segments) {
  if (!context.options().members) return {};
  return
      [&nodes = context.model().mesh.nodes, segments = std::move(segments)](const Found& f, FindingMembers& members) {
        segments(f, [&](const model::SegmentNodes& segment) { add_segment(nodes, segment, members); });
      };
}

Collect collect_nodes(const Context& context, std::function<NodeIndex(const Found&)> node) {
  if (!context.options().members) return {};
  return [&nodes = context.model().mesh.nodes, node = std::move(node)](const Found& f, FindingMembers& members) {
    members.nodes.push_back(nodes.id[node(f).value]);
  };
}

void add_named_elements(const model::Model& model, std::vector<Finding>& findings) {
  for (Finding& finding : findings)
    if (finding.element != 0 && finding.members.nodes.empty() && finding.members.segments.empty())
      add_element(model, finding);
}

}  // namespace gapcheck::audit
