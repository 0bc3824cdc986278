#include "contact/pair/tied_pairs.hpp"

#include <algorithm>

namespace gapcheck::contact {

void TiedPairs::remove(NodeIndex node, PartIndex part) {
  const auto found = pairs_.find(key(node, part));
  if (found != pairs_.end() && --found->second == 0) pairs_.erase(found);
}

void TiedPairs::constrain(NodeIndex node, ContactIndex contact) {
  if (holder_.empty()) holder_.assign(model_.mesh.nodes.size(), none<ContactIndex>);
  if (holder_[node.value] == none<ContactIndex>) holder_[node.value] = contact;
}

std::optional<ContactIndex> TiedPairs::constrained_by(NodeIndex node) const {
  if (holder_.empty() || holder_[node.value] == none<ContactIndex>) return std::nullopt;
  return holder_[node.value];
}

const RigidNodes& TiedPairs::rigid() {
  if (!rigid_) rigid_.emplace(model_);
  return *rigid_;
}

std::span<const std::pair<NodeIndex, NodeIndex>> TiedPairs::beams_at(NodeIndex node) {
  if (!beams_known_) {
    beams_known_ = true;
    const std::size_t nodes = model_.mesh.nodes.size();
    for (const auto& n : model_.mesh.beams.nodes) {
      if (n[0].value >= nodes || n[1].value >= nodes) continue;
      beams_.emplace_back(n[0], n[1]);
      beams_.emplace_back(n[1], n[0]);
    }
    std::sort(beams_.begin(), beams_.end());
  }
  const auto first = std::lower_bound(beams_.begin(), beams_.end(), std::pair{node, NodeIndex{0}});
  auto last = first;
  while (last != beams_.end() && last->first == node) ++last;
  return {first, last};
}

}  // namespace gapcheck::contact
