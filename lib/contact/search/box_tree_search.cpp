// Points and boxes each go into a tree; every leaf of eight boxes queries the points' tree for the leaves that it
// meets.
#include <array>
#include <vector>

#include "base/parallel.hpp"
#include "contact/search/box_tree.hpp"
#include "contact/search/search.hpp"

namespace gapcheck::contact {
namespace {

class BoxTreeSearch final : public CandidateSearch {
 public:
  [[nodiscard]] std::string_view name() const override { return "box tree"; }

  void run(std::span<const Vector> points, std::span<const Bounds> boxes, const CandidateSink& sink) const override {
    if (points.empty() || boxes.empty()) return;
    const FloatMap map(points, boxes);
    const BoxTree asking(boxes, map), asked(points, map);
    parallel_for(asking.leaves(), 32, [&](std::size_t begin, std::size_t end) {
      std::array<std::vector<std::uint32_t>, BoxPack::width> inside;
      for (auto l = static_cast<std::uint32_t>(begin); l < end; ++l) {
        for (auto& list : inside) list.clear();
        const FloatBox hull = asking.leaf(l).hull();
        asked.leaves_meeting(hull, 0, [&](std::uint32_t m) {
          compare_leaves(asking, l, hull, asked, m, [&](std::uint32_t i, std::uint32_t j) {
            const std::uint32_t point = asked.box(m, j);
            if (boxes[asking.box(l, i)].contains(points[point])) inside[i].push_back(point);
          });
        });
        for (std::uint32_t i = 0; i < inside.size(); ++i)
          if (!inside[i].empty()) sink(asking.box(l, i), inside[i]);
      }
    });
  }
};

}  // namespace

std::unique_ptr<CandidateSearch> make_box_tree() { return std::make_unique<BoxTreeSearch>(); }

}  // namespace gapcheck::contact
