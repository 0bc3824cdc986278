#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "audit/grouped.hpp"
#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/tied_contacts.hpp"
#include "contact/mesh/faces_at.hpp"

namespace gapcheck::audit::rule::tie_large_segment {
namespace {

using contact::JudgedNode;

// From ten edges on 0.05 of the diagonal is half an edge, and the next row of nodes may tie as well.
constexpr std::array thresholds{
    Threshold{"edges", 10, 0, 1e6,
              "shorter diagonal of the segment in edges of the tied node's elements, from which on it is listed"}};

/// Shortest edge of the shells and solids at some nodes of the mesh; infinity where there are none.
class ShortestEdges {
 public:
  ShortestEdges(const model::Mesh& mesh, const std::vector<NodeIndex>& nodes)
      : mesh_(mesh), shortest_(mesh.nodes.size(), not_asked) {
    for (const NodeIndex n : nodes) shortest_[n.value] = std::numeric_limits<double>::infinity();
    contact::for_each_face_at(
        mesh, [&](NodeIndex n) { return asked(n); }, [&](const model::SegmentNodes& face) { visit(face); });
  }
  [[nodiscard]] double at(NodeIndex node) const { return shortest_[node.value]; }

 private:
  static constexpr double not_asked = -1;

  void visit(const model::SegmentNodes& face) {
    for (std::size_t i = 0; i < 4; ++i) {
      const NodeIndex a = face[i], b = face[(i + 1) % 4];
      if (a == b || (!asked(a) && !asked(b))) continue;
      const double length = (mesh_.nodes.x[a.value] - mesh_.nodes.x[b.value]).norm();
      for (const NodeIndex n : {a, b})
        if (asked(n) && length < shortest_[n.value]) shortest_[n.value] = length;
    }
  }
  [[nodiscard]] bool asked(NodeIndex n) const { return shortest_[n.value] != not_asked; }

  const model::Mesh& mesh_;
  std::vector<double> shortest_;
};

/// Tied only because of the share of the diagonal.
bool by_diagonal(const JudgedNode& node) {
  const double by_thickness = contact::tie_thickness_share * (node.node_thickness + node.segment_thickness);
  return node.tied() && node.distance > by_thickness && node.distance > contact::visible_separation * node.diagonal;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  std::vector<JudgedNode> suspects;
  for_each_tied_contact(context, [&](ContactIndex c, std::span<const JudgedNode> nodes) {
    if (model.contact(c).sst < 0 || model.contact(c).mst < 0) return;
    for (const JudgedNode& node : nodes)
      if (by_diagonal(node)) suspects.push_back(node);
  });
  if (suspects.empty()) return;
  std::vector<NodeIndex> asked;
  asked.reserve(suspects.size());
  for (const JudgedNode& node : suspects) asked.push_back(node.node);
  const ShortestEdges edges(model.mesh, asked);
  const double large_ratio = context.threshold(rule, thresholds[0]);
  std::vector<Found> found;
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    const double edge = edges.at(suspects[i].node);
    if (suspects[i].diagonal >= large_ratio * edge)
      found.push_back({suspects[i].contact.value, suspects[i].distance / edge, i});
  }
  const auto words = [&](const Found& item) {
    const JudgedNode& node = suspects[item.item];
    const model::Nodes& nodes = model.mesh.nodes;
    Finding f =
        finding(rule,
                fmt::format("node {} ties over {:.6g} because its segment is large: 0.05 of the diagonal {:.6g}, "
                            "while its own elements have edges of {:.6g}; give the reach with a negative SST",
                            nodes.id[node.node.value], node.distance, node.diagonal, edges.at(node.node)),
                context.path(nodes.origins.file(node.node.value)), nodes.line[node.node.value]);
    f.contact = model.contact(node.contact).id.value;
    f.node = nodes.id[node.node.value];
    if (node.part != none<PartIndex>) f.part = model.part(node.part).id.value;
    if (node.segment_part != none<PartIndex>) f.element_part = model.part(node.segment_part).id.value;
    f.point = nodes.x[node.node.value];
    return f;
  };
  const auto rest = [&](const Found& item, std::uint64_t count) {
    const JudgedNode& node = suspects[item.item];
    return finding_at(rule, context, model.contact(node.contact),
                      fmt::format("{} more tie over up to {:.6g} of their own edges because their segments are large",
                                  node_count(count), item.weight));
  };
  add_grouped(report, std::move(found), words, rest,
              collect_nodes(context, [&](const Found& f) { return suspects[f.item].node; }));
}

}  // namespace

const Rule definition{.identity = {"GC207", "tie-large-segment", Severity::warning,
                                   "a node ties only because the segment is large beside the node's own elements",
                                   Need::ties, "Nodes tie that may not be meant to"},
                      .run = run,
                      .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::tie_large_segment
