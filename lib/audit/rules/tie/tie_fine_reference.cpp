#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "audit/rules.hpp"
#include "audit/shared/side_sizes.hpp"
#include "audit/shared/tied_contacts.hpp"
#include "contact/mesh/faces_at.hpp"
#include "contact/mesh/mean_edge.hpp"
#include "contact/stiffness/stiffness.hpp"

namespace gapcheck::audit::rule::tie_fine_reference {
namespace {

using contact::JudgedNode;

/// A reference side that is stiffer by more than this may be finer: the stiffer side is the reference then. The
/// recommendation is for similar materials.
constexpr double much_stiffer = 10;

/// Where one contact ties: the mesh of both sides at the tied nodes only.
struct Joint {
  ContactIndex contact;
  std::vector<NodeIndex> nodes;  ///< ascending
  PartIndex part, segment_part;  ///< of the first of them
  contact::MeanEdge tracked, reference;
};

/// Spotwelds are as large as they are, rigid segments do not deform between the nodes, and with unknown stiffness
/// nobody can tell which side should be the reference.
bool judgeable(const model::Model& model, const JudgedNode& node) {
  if (!node.tied() || node.part == none<PartIndex> || node.segment_part == none<PartIndex>) return false;
  const model::Part& part = model.part(node.part);
  if (!part.material || model.materials[*part.material].spotweld || model.rigid(node.segment_part)) return false;
  const double own = contact::contact_modulus(model, node.part),
               other = contact::contact_modulus(model, node.segment_part);
  return own > 0 && other > 0 && other <= much_stiffer * own;
}

std::vector<Joint> joints(Context& context) {
  const model::Model& model = context.model();
  std::vector<Joint> list;
  for_each_tied_contact(context, [&](ContactIndex c, std::span<const JudgedNode> nodes) {
    Joint joint;
    joint.contact = c;
    std::vector<SegmentIndex> segments;
    for (const JudgedNode& node : nodes) {
      if (!judgeable(model, node)) continue;
      if (joint.nodes.empty()) joint.part = node.part, joint.segment_part = node.segment_part;
      joint.nodes.push_back(node.node);
      segments.push_back(node.segment);
    }
    const contact::ContactSurfaces& surfaces = context.surfaces(c);
    if (joint.nodes.empty() || !surfaces.two_sided()) return;
    std::sort(segments.begin(), segments.end());
    segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
    for (const SegmentIndex s : segments)
      joint.reference.add(surfaces.b.selection.segments.nodes[s.value], model.mesh.nodes.x);
    list.push_back(std::move(joint));
  });
  return list;
}

/// Adds the shells and faces of solids with all their nodes in a joint: edges of shells that are tied along a line have
/// none, and no sides that could be exchanged. One pass over the mesh for all joints.
void measure_tracked(const model::Mesh& mesh, std::vector<Joint>& joints) {
  std::vector<bool> tied(mesh.nodes.size(), false);
  std::vector<std::pair<NodeIndex, std::uint32_t>> joint_of;
  for (std::uint32_t j = 0; j < joints.size(); ++j)
    for (const NodeIndex n : joints[j].nodes) {
      tied[n.value] = true;
      joint_of.emplace_back(n, j);
    }
  std::sort(joint_of.begin(), joint_of.end());
  const auto is_tied = [&](NodeIndex n) { return tied[n.value]; };
  contact::for_each_face_at(mesh, is_tied, [&](const model::SegmentNodes& face) {
    if (!std::all_of(face.begin(), face.end(), is_tied)) return;
    const auto first = std::lower_bound(joint_of.begin(), joint_of.end(), std::pair(face[0], std::uint32_t{0}));
    for (auto at = first; at != joint_of.end() && at->first == face[0]; ++at) {
      Joint& joint = joints[at->second];
      if (std::all_of(face.begin(), face.end(),
                      [&](NodeIndex n) { return std::binary_search(joint.nodes.begin(), joint.nodes.end(), n); }))
        joint.tracked.add(face, mesh.nodes.x);
    }
  });
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  std::vector<Joint> list = joints(context);
  if (list.empty()) return;
  measure_tracked(model.mesh, list);
  for (const Joint& joint : list) {
    const SideSizes sizes{joint.tracked.value(), joint.reference.value()};
    if (!sizes.reference_too_fine()) continue;
    Finding f =
        finding_at(rule, context, model.contact(joint.contact),
                   fmt::format("{} where they are tied: the nodes of B between the tied ones are free; exchange "
                               "the sides, or refine A",
                               sizes.text()));
    f.node = model.mesh.nodes.id[joint.nodes.front().value];
    f.point = model.mesh.nodes.x[joint.nodes.front().value];
    f.part = model.part(joint.part).id.value;
    f.element_part = model.part(joint.segment_part).id.value;
    report.findings.push_back(std::move(f));
  }
}

}  // namespace

const Rule definition{{"GC211", "tie-fine-reference", Severity::note,
                       "the reference side of a tie is finer than the tracked side where they are tied",
                       Need::surfaces | Need::ties, "The tie is uneven: not every node of the finer side is held"},
                      run};

}  // namespace gapcheck::audit::rule::tie_fine_reference
