#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "audit/rules.hpp"
#include "audit/shared/mesh_finding.hpp"
#include "audit/shared_results.hpp"
#include "contact/surface/joined_nodes.hpp"
#include "contact/surface/thickness.hpp"
#include "model/read/node_references.hpp"

namespace gapcheck::audit::rule::duplicate_nodes {
namespace {

/// Fraction of the shortest edge at either node. A deck's coordinates are rounded by far less, a mesh's nodes are much
/// further apart.
constexpr double same_place = 1e-3;
/// Fraction of the thinner shell's thickness: foils whose mid-surfaces are half a thickness apart are two sheets.
constexpr double same_sheet = 0.05;

/// What the segments at a node say about it.
struct Corner {
  double shortest_edge = INFINITY;
  double thinnest = INFINITY;        ///< of its shells
  std::vector<NodeIndex> ends;       ///< the other ends of edges at it
  PartIndex part = none<PartIndex>;  ///< of its segments the one with the smallest id
  bool shell = false;                ///< some segment is a shell
};
using Corners = std::unordered_map<std::uint32_t, Corner>;

/// The middle one of a sample of the segments' shortest edges.
double usual_edge(const contact::ContactMesh& mesh) {
  constexpr std::size_t sample = 1001;
  std::vector<double> edges;
  const std::size_t step = std::max<std::size_t>(1, mesh.size() / sample);
  for (std::size_t i = 0; i < mesh.size(); i += step)
    edges.push_back(contact::edge_range(mesh.nodes(i), mesh.model().mesh.nodes.x).shortest);
  std::erase_if(edges, [](double e) { return !std::isfinite(e); });
  if (edges.empty()) return 0;
  const auto half = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
  std::nth_element(edges.begin(), half, edges.end());
  return *half;
}

PartIndex smaller_id(const model::Model& model, PartIndex a, PartIndex b) {
  if (a == none<PartIndex> || b == none<PartIndex>) return std::min(a, b);
  return model.part(b).id < model.part(a).id ? b : a;
}

/// Of a shell's section; infinite where there is none.
double thickness_of(const contact::ContactMesh& mesh, std::size_t segment) {
  if (mesh.kind(segment) != model::ElementKind::shell || mesh.element(segment) == no_position) return INFINITY;
  const double thickness = contact::element_thickness(mesh.model(), mesh.element(segment));
  return thickness > 0 ? thickness : INFINITY;
}

/// Adds the neighbours of a corner along the segment's outline.
void add_ends(const model::SegmentNodes& nodes, NodeIndex corner, std::vector<NodeIndex>& ends) {
  for (std::size_t k = 0; k < 4; ++k) {
    if (nodes[k] != corner) continue;
    for (const NodeIndex end : {nodes[(k + 1) % 4], nodes[(k + 3) % 4]})
      if (end != corner) ends.push_back(end);
  }
}

Corners corners_of(const contact::ContactMesh& mesh, const std::vector<contact::CoincidentNodes>& pairs) {
  std::vector<std::uint8_t> wanted(mesh.model().mesh.nodes.size());
  for (const auto& pair : pairs) wanted[pair.first.value] = wanted[pair.second.value] = 1;
  Corners corners;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const model::SegmentNodes& nodes = mesh.nodes(i);
    if (std::none_of(nodes.begin(), nodes.end(), [&](NodeIndex n) { return wanted[n.value] != 0; })) continue;
    const double shortest = contact::edge_range(nodes, mesh.model().mesh.nodes.x).shortest;
    for (const NodeIndex n : nodes) {
      if (wanted[n.value] == 0) continue;
      Corner& corner = corners[n.value];
      corner.shortest_edge = std::min(corner.shortest_edge, shortest);
      corner.part = smaller_id(mesh.model(), corner.part, mesh.part(i));
      corner.shell = corner.shell || mesh.kind(i) == model::ElementKind::shell;
      corner.thinnest = std::min(corner.thinnest, thickness_of(mesh, i));
      add_ends(nodes, n, corner.ends);
    }
  }
  return corners;
}

class Search {
 public:
  Search(const RuleIdentity& rule, Context& context, contact::ContactMesh& mesh)
      : rule_(rule), context_(context), mesh_(mesh) {}

  void run(Report& report) {
    pairs_ = contact::coincident_nodes(mesh_.corners(), x(), same_place * usual_edge(mesh_));
    if (pairs_.empty()) return;
    corners_ = corners_of(mesh_, pairs_);
    for (const contact::CoincidentNodes& pair : pairs_) first_at_[pair.second.value] = pair.first;
    std::erase_if(pairs_, [&](const contact::CoincidentNodes& pair) { return !suspicious(pair); });
    if (pairs_.empty()) return;
    const auto joined =
        contact::joined(context_.model(), context_.results().surface_store(), context_.contacts(), pairs_);
    const auto constrained = model::referenced_nodes(context_.deck(), context_.model(), "CONSTRAINED_");
    std::vector<Found> found;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      auto& [a, b] = pairs_[i];
      if (id(b) < id(a)) std::swap(a, b);
      if (joined[i] != 0 || (constrained[a.value] != 0 && constrained[b.value] != 0)) continue;
      found.push_back({part_pair(part(a), part(b)), 0, i, {id(b), id(a)}});
    }
    add_grouped(
        report, std::move(found), [&](const Found& f) { return one(pairs_[f.item]); },
        [&](const Found& f, std::uint64_t count) { return rest(pairs_[f.item], count); }, collect());
  }

 private:
  [[nodiscard]] const std::vector<Vector>& x() const { return context_.model().mesh.nodes.x; }
  [[nodiscard]] PartIndex part(NodeIndex n) const { return corners_.at(n.value).part; }
  [[nodiscard]] std::int64_t id(NodeIndex n) const { return context_.model().mesh.nodes.id[n.value]; }
  [[nodiscard]] std::int64_t part_id(NodeIndex n) const {
    return part(n) == none<PartIndex> ? 0 : context_.model().part(part(n)).id.value;
  }
  [[nodiscard]] double distance(const contact::CoincidentNodes& pair) const {
    return (x()[pair.second.value] - x()[pair.first.value]).norm();
  }

  /// Touching bodies of solids often have matching meshes: that is what contact is for. Within a part, or if a shell is
  /// involved, coincident nodes are a crack.
  [[nodiscard]] bool suspicious(const contact::CoincidentNodes& pair) const {
    const Corner &a = corners_.at(pair.first.value), &b = corners_.at(pair.second.value);
    if (a.part != b.part && !a.shell && !b.shell) return false;
    if (!context_.part_chosen(a.part) && !context_.part_chosen(b.part)) return false;
    const double apart = distance(pair);
    if (apart > same_place * std::min(a.shortest_edge, b.shortest_edge)) return false;
    return apart <= same_sheet * std::min(a.thinnest, b.thinnest) && edges_match(a, b);
  }

  /// A crack runs along edges: some edge at one node has its twin at the other. Corners that only meet are none.
  [[nodiscard]] bool edges_match(const Corner& a, const Corner& b) const {
    return std::any_of(a.ends.begin(), a.ends.end(), [&](NodeIndex p) {
      return std::any_of(b.ends.begin(), b.ends.end(), [&](NodeIndex q) { return place_of(p) == place_of(q); });
    });
  }
  /// The first of the nodes at the same place.
  [[nodiscard]] NodeIndex place_of(NodeIndex n) const {
    const auto found = first_at_.find(n.value);
    return found == first_at_.end() ? n : found->second;
  }

  [[nodiscard]] std::string where(const contact::CoincidentNodes& pair) const {
    const std::int64_t a = part_id(pair.first), b = part_id(pair.second);
    return a == b ? fmt::format("part {}", a) : fmt::format("parts {} and {}", std::min(a, b), std::max(a, b));
  }

  [[nodiscard]] Finding one(const contact::CoincidentNodes& pair) const {
    const double apart = distance(pair);
    Finding f =
        node_finding(rule_, context_, pair.second,
                     fmt::format("nodes {} and {} of {} are {}, and nothing joins them: a crack in the mesh; merge "
                                 "them or tie the parts",
                                 id(pair.first), id(pair.second), where(pair),
                                 apart == 0 ? "at the same place" : fmt::format("{:.3g} apart", apart)));
    f.part = part_id(pair.second);
    f.element_part = part_id(pair.first);
    return f;
  }

  [[nodiscard]] Finding rest(const contact::CoincidentNodes& pair, std::uint64_t count) const {
    Finding f = one(pair);
    f.message =
        fmt::format("{} more pairs of nodes of {} are at the same place, and nothing joins them", count, where(pair));
    f.node = 0;
    f.point.reset();
    return f;
  }

  /// Both nodes of each pair.
  [[nodiscard]] Collect collect() const {
    if (!context_.options().members) return {};
    return [this](const Found& f, FindingMembers& members) {
      const contact::CoincidentNodes& pair = pairs_[f.item];
      members.nodes.insert(members.nodes.end(), {id(pair.first), id(pair.second)});
    };
  }

  const RuleIdentity& rule_;
  Context& context_;
  contact::ContactMesh& mesh_;
  std::vector<contact::CoincidentNodes> pairs_;
  Corners corners_;
  std::unordered_map<std::uint32_t, NodeIndex> first_at_;
};

/// Whether the solver itself joins nodes at one place before the run; which ones is not read.
bool solver_merges_nodes(const keyword::Deck& deck) {
  const auto blocks = deck.blocks();
  return std::any_of(blocks.begin(), blocks.end(),
                     [](const keyword::Block& block) { return block.name.starts_with("NODE_MERGE"); });
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  if (solver_merges_nodes(context.deck()))
    return context.skipped(rule, "the deck has *NODE_MERGE, which joins nodes at one place and is not read");
  contact::ContactMesh* mesh = mesh_in_contact(rule, context);
  if (mesh != nullptr) Search(rule, context, *mesh).run(report);
}

}  // namespace

const Rule definition{{"GC507", "duplicate-nodes", Severity::warning,
                       "two nodes of a contact's surface lie at one place and are not joined", Need::surfaces,
                       "The mesh opens there like a crack"},
                      run};

}  // namespace gapcheck::audit::rule::duplicate_nodes
