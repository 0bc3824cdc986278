// Points and boxes out of bytes: every search finds the pairs that brute force finds, each once.
#include <utility>
#include <vector>

#include "contact/search/search.hpp"
#include "fuzz.hpp"
#include "numbers.hpp"

namespace gapcheck::fuzz::search_target {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs pairs_of(contact::SearchKind kind, const std::vector<Vector>& points, const std::vector<contact::Bounds>& boxes) {
  Pairs pairs;
  contact::make_search(kind)->run(points, boxes, [&](std::uint32_t box, std::span<const std::uint32_t> inside) {
    for (const std::uint32_t point : inside) pairs.emplace_back(box, point);
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

GAPCHECK_FUZZ_TARGET(search) {
  Numbers numbers(input);
  std::vector<Vector> points;
  std::vector<contact::Bounds> boxes;
  while (numbers.left() && points.size() + boxes.size() < 200) {
    if (numbers.byte() % 2 == 0) {
      points.push_back(numbers.vector());
    } else {
      const Vector low = numbers.vector();
      boxes.push_back({low, low + numbers.vector()});
    }
  }
  const Pairs expected = pairs_of(contact::SearchKind::brute_force, points, boxes);
  for (const auto kind :
       {contact::SearchKind::bucket_grid, contact::SearchKind::sorted_sweep, contact::SearchKind::box_tree})
    require(pairs_of(kind, points, boxes) == expected);
}

}  // namespace gapcheck::fuzz::search_target
