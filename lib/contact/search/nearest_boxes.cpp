// The boxes go into a tree, and every point visits its leaves by distance until it has enough of them. Pairs are handed
// on for blocks of points, so that memory is bounded by the block.
#include "contact/search/nearest_boxes.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "contact/search/box_tree.hpp"

namespace gapcheck::contact {
namespace {

/// Points whose pairs are held at a time.
constexpr std::size_t points_per_block = 20000;
/// How many boxes and points are sampled: first, and to confirm that there are too many.
constexpr std::array<std::array<std::size_t, 2>, 2> samples{{{64, 1024}, {256, 65536}}};

/// Some of the positions below `count`, the same at each call. Not evenly spaced: nodes and elements are numbered
/// alike, and equal steps through both would meet too often.
std::vector<std::size_t> sampled_positions(std::size_t count, std::size_t most, std::uint64_t seed) {
  std::vector<std::size_t> list(std::min(count, most));
  for (std::size_t i = 0; i < list.size(); ++i) {
    std::uint64_t z = seed + (i + 1) * 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    list[i] = count <= most ? i : static_cast<std::size_t>((z ^ (z >> 31)) % count);
  }
  return list;
}

/// Whether the share of pairs that `meet(box, point)` finds among samples is too large: more than `most` in all.
template <class Meet>
bool too_many(std::size_t points, std::size_t boxes, double most, const Meet& meet) {
  const double all = static_cast<double>(points) * static_cast<double>(boxes);
  if (!(all > most)) return false;
  return std::all_of(samples.begin(), samples.end(), [&](const auto& size) {
    const std::vector<std::size_t> some_boxes = sampled_positions(boxes, size[0], size[0]);
    const std::vector<std::size_t> some_points = sampled_positions(points, size[1], size[1]);
    std::size_t met = 0;
    for (const std::size_t b : some_boxes)
      for (const std::size_t p : some_points) met += meet(b, p) ? 1 : 0;
    const double share = static_cast<double>(met) / static_cast<double>(some_boxes.size() * some_points.size());
    return share * all > most && share * static_cast<double>(boxes) > crowd_pairs_each;
  });
}

double squared_distance(const Bounds& box, const Vector& x) {
  return (box.low - x).cwiseMax(x - box.high).cwiseMax(0).squaredNorm();
}

/// The boxes nearest to a point so far: the farthest of them first.
class Nearest {
 public:
  explicit Nearest(std::uint32_t most) : most_(most) {}
  void clear() { heap_.clear(); }
  [[nodiscard]] bool full() const { return heap_.size() >= most_; }
  /// A box at this distance or beyond changes nothing.
  [[nodiscard]] bool enough_at(double squared) const { return full() && squared >= heap_.front().first; }
  void add(double squared, std::uint32_t box) {
    if (enough_at(squared)) return;
    if (full()) {
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.pop_back();
    }
    heap_.emplace_back(squared, box);
    std::push_heap(heap_.begin(), heap_.end());
  }
  [[nodiscard]] const std::vector<std::pair<double, std::uint32_t>>& list() const { return heap_; }

 private:
  std::size_t most_;
  std::vector<std::pair<double, std::uint32_t>> heap_;
};

/// Sorted pairs of one block, as numbers with the box above the point.
using PairKeys = std::vector<std::uint64_t>;

std::uint64_t pair_key(std::uint32_t above, std::uint32_t below) { return std::uint64_t{above} << 32 | below; }

/// Boxes to choose from.
struct Choice {
  std::span<const Bounds> cores;
  std::uint32_t each;  ///< to choose for a point
  double farthest;     ///< squared: none is farther away
  const FloatMap map;
  const BoxTree tree;
  Choice(std::span<const Vector> points, std::span<const Bounds> boxes, std::uint32_t most, double squared)
      : cores(boxes), each(most), farthest(squared), map(points, boxes), tree(boxes, map) {}
};

/// The nearest boxes of each of a block of points: `accept(box, point)` says whether a box counts.
template <class Accept>
PairKeys nearest_pairs(const Choice& choice, std::span<const Vector> points, std::size_t begin, std::size_t end,
                       const Accept& accept) {
  tbb::enumerable_thread_specific<PairKeys> found;
  parallel_for(end - begin, 64, [&](std::size_t from, std::size_t to) {
    PairKeys& mine = found.local();
    Nearest nearest(choice.each);
    for (std::size_t p = begin + from; p < begin + to; ++p) {
      if (!points[p].allFinite()) continue;
      nearest.clear();
      const auto consider = [&](std::uint32_t leaf, float squared) {
        if (squared > choice.farthest || nearest.enough_at(squared)) return false;
        for (std::uint32_t i = 0; i < choice.tree.filled(leaf); ++i) {
          const std::uint32_t box = choice.tree.box(leaf, i);
          if (accept(box, p)) nearest.add(squared_distance(choice.cores[box], points[p]), box);
        }
        return true;
      };
      choice.tree.leaves_by_distance(choice.map.box({points[p], points[p]}).low, consider);
      for (const auto& [squared, box] : nearest.list()) mine.push_back(pair_key(box, static_cast<std::uint32_t>(p)));
    }
  });
  PairKeys all;
  for (const PairKeys& some : found) all.insert(all.end(), some.begin(), some.end());
  parallel_sort(all.begin(), all.end());
  return all;
}

}  // namespace

bool crowded(std::span<const Vector> points, std::span<const Bounds> boxes, double most) {
  return too_many(points.size(), boxes.size(), most,
                  [&](std::size_t b, std::size_t p) { return boxes[b].contains(points[p]); });
}

bool crowded(std::span<const Bounds> boxes) {
  return too_many(boxes.size(), boxes.size(), crowd_pairs,
                  [&](std::size_t a, std::size_t b) { return boxes[a].meets(boxes[b]); });
}

void run_nearest(std::span<const Vector> points, std::span<const Bounds> boxes, std::span<const Bounds> cores,
                 const CandidateSink& sink) {
  if (points.empty() || boxes.empty()) return;
  double reach = 0;
  for (std::size_t b = 0; b < boxes.size(); ++b)
    if (!boxes[b].empty()) reach = std::max(reach, (cores[b].low - boxes[b].low).maxCoeff());
  // From corner to corner of a cube, and more than single precision takes away.
  const Choice choice(points, cores, most_candidates, 3.1 * reach * reach);
  const auto contains = [&](std::uint32_t box, std::size_t p) { return boxes[box].contains(points[p]); };
  for (std::size_t begin = 0; begin < points.size(); begin += points_per_block) {
    const std::size_t end = std::min(points.size(), begin + points_per_block);
    const PairKeys pairs = nearest_pairs(choice, points, begin, end, contains);
    std::vector<std::size_t> starts;  // of the pairs of one box
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (i == 0 || pairs[i] >> 32 != pairs[i - 1] >> 32) starts.push_back(i);
    starts.push_back(pairs.size());
    parallel_for(starts.size() - 1, 64, [&](std::size_t first, std::size_t last) {
      std::vector<std::uint32_t> inside;
      for (std::size_t b = first; b < last; ++b) {
        inside.clear();
        for (std::size_t i = starts[b]; i < starts[b + 1]; ++i) inside.push_back(static_cast<std::uint32_t>(pairs[i]));
        sink(static_cast<std::uint32_t>(pairs[starts[b]] >> 32), inside);
      }
    });
  }
}

void for_each_near_box_pair(std::span<const Bounds> boxes, std::uint32_t each, const NearPairVisit& visit) {
  std::vector<Vector> centres;
  std::vector<Bounds> cores;
  for (const Bounds& box : boxes) {
    centres.emplace_back(0.5 * box.low + 0.5 * box.high);
    cores.push_back(box.empty() ? Bounds{} : Bounds{centres.back(), centres.back()});
    if (box.empty()) centres.back() = Vector::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  const Choice choice(centres, cores, each, std::numeric_limits<double>::infinity());
  const auto meets = [&](std::uint32_t box, std::size_t p) { return box != p && boxes[box].meets(boxes[p]); };
  PairKeys pairs;
  for (std::size_t begin = 0; begin < boxes.size(); begin += points_per_block)
    for (const std::uint64_t key :
         nearest_pairs(choice, centres, begin, std::min(boxes.size(), begin + points_per_block), meets)) {
      const auto a = static_cast<std::uint32_t>(key >> 32), b = static_cast<std::uint32_t>(key);
      pairs.push_back(pair_key(std::min(a, b), std::max(a, b)));
    }
  parallel_sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  parallel_for(pairs.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      visit(static_cast<std::uint32_t>(pairs[i] >> 32), static_cast<std::uint32_t>(pairs[i]));
  });
}

}  // namespace gapcheck::contact
