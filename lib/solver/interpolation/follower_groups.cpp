#include "solver/interpolation/follower_groups.hpp"

#include <algorithm>
#include <map>

#include "base/union_find.hpp"

namespace gapcheck::solver {

std::vector<FollowerGroup> group_followers(std::span<const Follower> followers) {
  std::vector<FollowerGroup> groups;
  UnionFind joined(followers.size());
  std::map<std::uint32_t, std::uint32_t> user;
  for (std::uint32_t f = 0; f < followers.size(); ++f)
    for (const std::uint32_t node : followers[f].nodes) joined.unite(f, user.emplace(node, f).first->second);
  std::map<std::uint32_t, std::size_t> place;
  for (std::uint32_t f = 0; f < followers.size(); ++f) {
    const auto [at, fresh] = place.emplace(joined.root(f), groups.size());
    if (fresh) groups.emplace_back();
    groups[at->second].followers.push_back(f);
  }
  for (FollowerGroup& group : groups) {
    for (const std::size_t f : group.followers)
      group.nodes.insert(group.nodes.end(), followers[f].nodes.begin(), followers[f].nodes.end());
    std::sort(group.nodes.begin(), group.nodes.end());
    group.nodes.erase(std::unique(group.nodes.begin(), group.nodes.end()), group.nodes.end());
    for (const std::size_t f : group.followers) {
      group.first.push_back(group.rows);
      group.rows += followers[f].axes.cols();
      std::vector<std::size_t>& positions = group.positions.emplace_back();
      for (const std::uint32_t node : followers[f].nodes)
        positions.push_back(static_cast<std::size_t>(std::lower_bound(group.nodes.begin(), group.nodes.end(), node) -
                                                     group.nodes.begin()));
    }
  }
  return groups;
}

}  // namespace gapcheck::solver
