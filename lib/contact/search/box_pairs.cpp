// Every leaf of a tree of boxes queries a tree for the leaves that it meets, and two leaves compare their boxes. The
// trees hold single-precision numbers; at the end the boxes themselves remove pairs that meet only there.
#include "contact/search/box_pairs.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "contact/search/box_tree.hpp"

namespace gapcheck::contact {
namespace {

constexpr std::size_t leaf_grain = 256;

void brute_force(std::span<const Bounds> a, std::span<const Bounds> b, bool self, const BoxPairVisit& visit) {
  parallel_for(a.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = self ? i + 1 : 0; j < b.size(); ++j)
        if (!a[i].empty() && !b[j].empty() && a[i].meets(b[j]))
          visit(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
  });
}

}  // namespace

void for_each_box_pair(std::span<const Bounds> a, std::span<const Bounds> b, const BoxPairVisit& visit,
                       BoxSearch search) {
  if (a.empty() || b.empty()) return;
  if (search == BoxSearch::brute_force) return brute_force(a, b, false, visit);
  const FloatMap map(a, b);
  const BoxTree first(a, map), second(b, map);
  parallel_for(first.leaves(), leaf_grain, [&](std::size_t begin, std::size_t end) {
    for (auto l = static_cast<std::uint32_t>(begin); l < end; ++l) {
      const FloatBox hull = first.leaf(l).hull();
      second.leaves_meeting(hull, 0, [&](std::uint32_t m) {
        compare_leaves(first, l, hull, second, m, [&](std::uint32_t i, std::uint32_t j) {
          const std::uint32_t p = first.box(l, i), q = second.box(m, j);
          if (a[p].meets(b[q])) visit(p, q);
        });
      });
    }
  });
}

void for_each_box_pair(std::span<const Bounds> boxes, const BoxPairVisit& visit, BoxSearch search) {
  if (boxes.empty()) return;
  if (search == BoxSearch::brute_force) return brute_force(boxes, boxes, true, visit);
  const BoxTree tree(boxes, FloatMap(boxes, std::span<const Bounds>{}));
  parallel_for(tree.leaves(), leaf_grain, [&](std::size_t begin, std::size_t end) {
    for (auto l = static_cast<std::uint32_t>(begin); l < end; ++l) {
      const FloatBox hull = tree.leaf(l).hull();
      tree.leaves_meeting(hull, l, [&](std::uint32_t m) {
        compare_leaves(tree, l, hull, tree, m, [&](std::uint32_t i, std::uint32_t j) {
          if (l == m && i >= j) return;
          const std::uint32_t p = tree.box(l, i), q = tree.box(m, j);
          if (boxes[p].meets(boxes[q])) visit(std::min(p, q), std::max(p, q));
        });
      });
    }
  });
}

}  // namespace gapcheck::contact
