#include "contact/pair/penetration_list.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "base/parallel.hpp"

namespace gapcheck::contact {

void PenetrationList::keep_one_per_node(std::vector<Hit>& hits, const TrackedNodes& nodes,
                                        const std::vector<std::int64_t>& id) {
  if (records().empty()) return;
  std::unordered_map<std::int64_t, PenetrationKind> listed;
  for (const Penetration& p : records()) listed.emplace(p.node, p.kind);
  std::unordered_set<std::int64_t> replaced;
  std::erase_if(hits, [&](const Hit& hit) {
    const auto found = listed.find(id[nodes.node[hit.slot.value].value]);
    if (found == listed.end()) return false;
    if (found->second != PenetrationKind::edge_zone || !hit.in_band) return true;
    replaced.insert(found->first);
    return false;
  });
  const auto begin = all_.begin() + static_cast<std::ptrdiff_t>(first_);
  all_.erase(std::remove_if(begin, all_.end(), [&](const Penetration& p) { return replaced.contains(p.node); }),
             all_.end());
}

std::span<Penetration> PenetrationList::add(std::size_t count) {
  all_.resize(all_.size() + count);
  return std::span(all_).last(count);
}

void PenetrationList::sort_deepest_first() {
  const auto deeper = [](const Penetration& l, const Penetration& r) {
    return l.depth != r.depth ? l.depth > r.depth : l.node < r.node;
  };
  parallel_sort(all_.begin() + static_cast<std::ptrdiff_t>(first_), all_.end(), deeper);
}

}  // namespace gapcheck::contact
