#include "contact/surface/joined_nodes.hpp"

#include <algorithm>
#include <tuple>

#include "contact/mesh/rigid_nodes.hpp"

namespace gapcheck::contact {
namespace {

/// Finds pairs by the nodes of an element or group.
class Joiner {
 public:
  Joiner(std::size_t nodes, std::span<const CoincidentNodes> pairs)
      : pairs_(pairs), joined_(pairs.size()), group_(nodes, no_position) {
    for (const CoincidentNodes& pair : pairs) {
      if (group_[pair.first.value] == no_position) group_[pair.first.value] = pair.first.value;
      group_[pair.second.value] = group_[pair.first.value];
    }
  }

  /// Marks the pairs whose nodes are both among these. Nodes of one group lie at one place.
  template <class Nodes>
  void join(const Nodes& nodes) {
    here_.clear();
    for (const NodeIndex n : nodes)
      if (n != none<NodeIndex> && group_[n.value] != no_position) here_.emplace_back(group_[n.value], n);
    if (here_.size() < 2) return;
    std::sort(here_.begin(), here_.end());
    for (const auto& [group, node] : here_) {
      const auto at = position(node);
      if (at == pairs_.size()) continue;
      const auto other = std::pair{group, pairs_[at].first};
      if (std::binary_search(here_.begin(), here_.end(), other)) joined_[at] = 1;
    }
  }
  void join_pair(std::size_t i) { joined_[i] = 1; }
  [[nodiscard]] bool concerns(NodeIndex node) const { return group_[node.value] != no_position; }
  [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(joined_); }

 private:
  /// The pair with this second node.
  [[nodiscard]] std::size_t position(NodeIndex second) const {
    const auto found = std::lower_bound(pairs_.begin(), pairs_.end(), second,
                                        [](const CoincidentNodes& p, NodeIndex n) { return p.second < n; });
    if (found == pairs_.end() || found->second != second) return pairs_.size();
    return static_cast<std::size_t>(found - pairs_.begin());
  }

  std::span<const CoincidentNodes> pairs_;
  std::vector<std::uint8_t> joined_;
  std::vector<std::uint32_t> group_;  ///< by node
  std::vector<std::pair<std::uint32_t, NodeIndex>> here_;
};

/// A node on one side of a tied contact.
struct Membership {
  NodeIndex node;
  ContactIndex contact;
  bool tracked;
  friend bool operator<(const Membership& p, const Membership& q) {
    return std::tie(p.node, p.contact, p.tracked) < std::tie(q.node, q.contact, q.tracked);
  }
};

/// Which tied contacts track the nodes of the pairs or have them as reference nodes.
std::vector<Membership> tied_memberships(const model::Model& model, SurfaceStore& surfaces,
                                         std::span<const ContactIndex> contacts, const Joiner& joiner) {
  std::vector<Membership> list;
  for (const ContactIndex c : contacts) {
    if (!model.contact(c).known || classify(model.contact(c)).family != Family::tied) continue;
    const ContactSurfaces& s = surfaces.at(c);
    for (const NodeIndex n : s.a.nodes.node)
      if (joiner.concerns(n)) list.push_back({n, c, true});
    for (const auto& nodes : s.b.selection.segments.nodes)
      for (const NodeIndex n : nodes)
        if (joiner.concerns(n)) list.push_back({n, c, false});
  }
  std::sort(list.begin(), list.end());
  return list;
}

bool tied(const std::vector<Membership>& list, NodeIndex tracked, NodeIndex reference) {
  for (auto m = std::lower_bound(list.begin(), list.end(), Membership{tracked, ContactIndex{}, false});
       m != list.end() && m->node == tracked; ++m)
    if (m->tracked && std::binary_search(list.begin(), list.end(), Membership{reference, m->contact, false}))
      return true;
  return false;
}

}  // namespace

std::vector<std::uint8_t> joined(const model::Model& model, SurfaceStore& surfaces,
                                 std::span<const ContactIndex> contacts, std::span<const CoincidentNodes> pairs) {
  Joiner joiner(model.mesh.nodes.size(), pairs);
  const auto join_elements = [&](const auto& elements) {
    for (const auto& nodes : elements.nodes) joiner.join(nodes);
  };
  join_elements(model.mesh.shells);
  join_elements(model.mesh.solids);
  join_elements(model.mesh.thick_shells);
  join_elements(model.mesh.beams);
  join_elements(model.mesh.discrete);
  for (const model::RigidGroup& group : model.rigid_groups) joiner.join(group.nodes);
  const RigidNodes rigid(model);
  const std::vector<Membership> memberships = tied_memberships(model, surfaces, contacts, joiner);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [a, b] = pairs[i];
    if ((rigid.owner(a) && rigid.owner(b)) || tied(memberships, a, b) || tied(memberships, b, a)) joiner.join_pair(i);
  }
  return joiner.take();
}

}  // namespace gapcheck::contact
