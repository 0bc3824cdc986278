#include "audit/shared/mesh_finding.hpp"

#include <fmt/format.h>

#include "audit/shared_results.hpp"

namespace gapcheck::audit {
namespace {

using model::ElementKind;

/// Calls visit(word, elements) with the array that holds a segment's element.
template <class Visit>
void visit_elements(const model::Mesh& mesh, ElementKind kind, const Visit& visit) {
  if (kind == ElementKind::shell) visit("shell", mesh.shells);
  if (kind == ElementKind::solid) visit("solid", mesh.solids);
  if (kind == ElementKind::thick_shell) visit("thick shell", mesh.thick_shells);
}

bool has_element(const contact::ContactMesh& mesh, std::size_t segment) { return mesh.element(segment) != no_position; }

std::string corner_ids(const contact::ContactMesh& mesh, std::size_t segment) {
  const model::SegmentNodes& n = mesh.nodes(segment);
  const auto& id = mesh.model().mesh.nodes.id;
  std::string ids = fmt::format("{} {} {}", id[n[0].value], id[n[1].value], id[n[2].value]);
  if (n[2] != n[3]) ids += fmt::format(" {}", id[n[3].value]);
  return ids;
}

}  // namespace

contact::ContactMesh* mesh_in_contact(const RuleIdentity& rule, Context& context) {
  contact::ContactMesh& mesh = context.results().contact_mesh();
  if (mesh.size() > 0) return &mesh;
  context.skipped(rule, "no contact has any segments");
  return nullptr;
}

std::string segment_name(const contact::ContactMesh& mesh, std::size_t segment) {
  std::string name = fmt::format("segment {}", corner_ids(mesh, segment));
  if (!has_element(mesh, segment)) return name;
  visit_elements(mesh.model().mesh, mesh.kind(segment), [&](const char* word, const auto& elements) {
    const std::int64_t id = elements.id[mesh.element(segment)];
    name = mesh.kind(segment) == ElementKind::shell
               ? fmt::format("{} {}", word, id)
               : fmt::format("face {} of {} {}", corner_ids(mesh, segment), word, id);
  });
  return name;
}

bool of_fabric(const contact::ContactMesh& mesh, std::size_t segment) {
  const PartIndex part = mesh.part(segment);
  if (part == none<PartIndex> || !mesh.model().part(part).material) return false;
  return mesh.model().materials[*mesh.model().part(part).material].fabric;
}

std::string of_part(const contact::ContactMesh& mesh, std::size_t segment) {
  const PartIndex part = mesh.part(segment);
  return part == none<PartIndex> ? "" : fmt::format(" of part {}", mesh.model().part(part).id.value);
}

Finding segments_finding(const RuleIdentity& rule, const Context& context, const contact::ContactMesh& mesh,
                         std::size_t segment, std::string message) {
  const model::Contact& contact = mesh.model().contact(mesh.contact(segment));
  Finding f = finding_at(rule, context, contact, std::move(message));
  const PartIndex part = mesh.part(segment);
  if (part != none<PartIndex>) f.element_part = mesh.model().part(part).id.value;
  return f;
}

Finding segment_finding(const RuleIdentity& rule, const Context& context, const contact::ContactMesh& mesh,
                        std::size_t segment, std::string message) {
  Finding f = segments_finding(rule, context, mesh, segment, std::move(message));
  if (has_element(mesh, segment))
    visit_elements(mesh.model().mesh, mesh.kind(segment), [&](const char*, const auto& elements) {
      const std::uint32_t e = mesh.element(segment);
      f.element = elements.id[e];
      f.file = context.path(elements.origins.file(e));
      f.line = elements.line[e];
    });
  Vector middle = Vector::Zero();
  for (const NodeIndex n : mesh.nodes(segment)) middle += mesh.model().mesh.nodes.x[n.value] / 4;
  if (middle.allFinite()) f.point = middle;
  return f;
}

Finding node_finding(const RuleIdentity& rule, const Context& context, NodeIndex node, std::string message) {
  const model::Nodes& nodes = context.model().mesh.nodes;
  Finding f = finding(rule, std::move(message), context.path(nodes.origins.file(node.value)), nodes.line[node.value]);
  f.node = nodes.id[node.value];
  if (nodes.x[node.value].allFinite()) f.point = nodes.x[node.value];
  return f;
}

}  // namespace gapcheck::audit
