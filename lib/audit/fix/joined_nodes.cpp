#include "audit/fix/joined_nodes.hpp"

#include <algorithm>
#include <array>

#include "base/union_find.hpp"
#include "model/read/node_references.hpp"

namespace gapcheck::audit {
namespace {

/// Sets of nodes that merge.
class Groups {
 public:
  explicit Groups(std::size_t nodes) : sets_(nodes), named_(nodes) {}

  void join(std::span<const NodeIndex> nodes, bool by_keyword) {
    for (const NodeIndex n : nodes) {
      if (n == none<NodeIndex> || n.value >= sets_.size()) continue;
      any_ = true;
      if (by_keyword) named_[n.value] = 1;
      sets_.unite(nodes.front().value, n.value);
    }
  }
  [[nodiscard]] bool any() const { return any_; }
  /// The smallest node of its set.
  [[nodiscard]] std::uint32_t root(std::uint32_t n) { return sets_.root(n); }
  [[nodiscard]] std::vector<std::uint8_t> take_named() { return std::move(named_); }

 private:
  UnionFind sets_;
  std::vector<std::uint8_t> named_;
  bool any_ = false;
};

template <std::size_t N>
void join_welds(Groups& groups, const model::Model& model, const model::Elements<N>& elements, std::size_t corners) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements.part[i] == none<PartIndex>) continue;
    const auto& material = model.part(elements.part[i]).material;
    if (!material || !model.materials[*material].spotweld) continue;
    const auto nodes = std::span(elements.nodes[i]).first(corners);
    if (std::find(nodes.begin(), nodes.end(), none<NodeIndex>) == nodes.end()) groups.join(nodes, false);
  }
}

/// Keywords that hold bodies or parts, whose nodes are rigid or free in any case.
bool names_no_nodes(std::string_view name) {
  constexpr std::array<std::string_view, 9> parts{
      "CONSTRAINED_BEAM_IN_SOLID",     "CONSTRAINED_EULER_IN_EULER",    "CONSTRAINED_JOINT_STIFFNESS",
      "CONSTRAINED_LAGRANGE_IN_SOLID", "CONSTRAINED_RIGID_BODY_INSERT", "CONSTRAINED_RIGID_BODY_STOPPERS",
      "CONSTRAINED_SHELL_IN_SOLID",    "CONSTRAINED_SOIL_PILE",         "BOUNDARY_PRESCRIBED_MOTION_RIGID"};
  return std::any_of(parts.begin(), parts.end(), [&](std::string_view part) { return name.starts_with(part); });
}

bool constrains(std::string_view name) {
  return (name.starts_with("CONSTRAINED_") || name.starts_with("BOUNDARY_")) && !names_no_nodes(name);
}

}  // namespace

JoinedNodes::JoinedNodes(const model::Model& model, const std::vector<model::NodeLink>& links, bool welds) {
  const std::size_t count = model.mesh.nodes.size();
  Groups groups(count);
  for (const model::NodeLink& link : links)
    if (link.freedoms != 0 && (welds || link.kind == model::NodeLink::Kind::node_set)) groups.join(link.nodes, true);
  if (welds) {
    for (const model::Weld& weld : model.welds) groups.join(weld.nodes, true);
    join_welds(groups, model, model.mesh.beams, 2);
    join_welds(groups, model, model.mesh.solids, 8);
  }
  if (!groups.any()) return;
  named_ = groups.take_named();
  leader_.reserve(count);
  std::vector<std::uint32_t> size(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    leader_.emplace_back(groups.root(i));
    ++size[leader_.back().value];
  }
  std::vector<std::uint32_t> next(count);
  start_.push_back(0);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (size[i] < 2) continue;
    next[i] = start_.back();
    leaders_.emplace_back(i);
    start_.push_back(start_.back() + size[i]);
  }
  list_.resize(start_.back());
  for (std::uint32_t i = 0; i < count; ++i)
    if (const std::uint32_t first = leader_[i].value; size[first] > 1) list_[next[first]++] = NodeIndex{i};
}

std::span<const NodeIndex> JoinedNodes::followers(NodeIndex leader) const {
  const auto found = std::lower_bound(leaders_.begin(), leaders_.end(), leader);
  if (found == leaders_.end() || *found != leader) return {};
  const auto i = static_cast<std::size_t>(found - leaders_.begin());
  return std::span(list_).subspan(start_[i], start_[i + 1] - start_[i]);
}

UnreadConstraints unread_constraints(const keyword::Deck& deck, const model::Model& model) {
  UnreadConstraints unread;
  for (const auto& [name, blocks] : model.skipped_keywords)
    if (constrains(name) && !model::is_link(name))
      (model::nodes_can_be_told(name) ? unread.keywords : unread.unknown).push_back(name);
  if (!unread.keywords.empty())
    unread.held = model::referenced_nodes(deck, model, [&](std::string_view name) {
      return std::binary_search(unread.keywords.begin(), unread.keywords.end(), name);
    });
  return unread;
}

}  // namespace gapcheck::audit
