// Hierarchical bucket grid. Points are sorted once along a Z-order curve over a fine grid; a bucket of any power-of-two
// size is then a contiguous range of that order. A box queries the few buckets of about its own size; a crowded bucket
// is split into its eight children on the way. So element sizes may differ by any factor, and empty space (a stray part
// far away) costs nothing.
//
// Both points and boxes go through the same monotone map from coordinates to integer cells, so rounding can put a point
// into a neighbouring cell but never outside the cells of a box that contains it.
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <vector>

#include "base/large_array.hpp"
#include "base/parallel.hpp"
#include "base/pieces.hpp"
#include "base/radix_sort.hpp"
#include "contact/search/float_box.hpp"
#include "contact/search/search.hpp"

namespace gapcheck::contact {
namespace {

constexpr int bits_per_axis = 21;  // 3 × 21 fit one key
/// Buckets with more points are split on the way: checking fewer costs less than finding the halves.
constexpr std::uint32_t crowded_bucket = 256;
using Cell = std::array<std::uint32_t, 3>;

std::uint64_t spread(std::uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x1f00000000ffffULL;
  v = (v | v << 16) & 0x1f0000ff0000ffULL;
  v = (v | v << 8) & 0x100f00f00f00f00fULL;
  v = (v | v << 4) & 0x10c30c30c30c30c3ULL;
  return (v | v << 2) & 0x1249249249249249ULL;
}

std::uint64_t z_order(const Cell& c) { return spread(c[0]) | spread(c[1]) << 1 | spread(c[2]) << 2; }

struct Range {
  std::uint32_t begin = 0, end = 0;
};

/// Buckets of one size: Z-order key of the bucket → range of points. Open addressing.
class Level {
 public:
  /// `buckets`: of this size.
  void build(const std::vector<std::uint64_t>& keys, int level, std::size_t buckets) {
    const int shift = 3 * level;
    slots_.assign(std::bit_ceil(2 * buckets + 1), Slot{});
    mask_ = slots_.size() - 1;
    for (std::size_t i = 0; i < keys.size();) {
      const std::uint64_t key = keys[i] >> shift;
      std::size_t j = i + 1;
      while (j < keys.size() && keys[j] >> shift == key) ++j;
      std::size_t at = hash(key);
      while (slots_[at].range.end != 0) at = (at + 1) & mask_;
      slots_[at] = {key, {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)}};
      i = j;
    }
  }
  [[nodiscard]] Range find(std::uint64_t key) const {
    for (std::size_t at = hash(key); slots_[at].range.end != 0; at = (at + 1) & mask_)
      if (slots_[at].key == key) return slots_[at].range;
    return {};
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    Range range;  // end 0: free
  };
  /// The eight children of one bucket lie side by side: a box queries several of them.
  [[nodiscard]] std::size_t hash(std::uint64_t key) const {
    return (((key >> 3) * 0x9E3779B97F4A7C15ULL >> 20) << 3 | (key & 7)) & mask_;
  }
  std::vector<Slot> slots_;
  std::size_t mask_ = 0;
};

class Grid {
 public:
  Grid(std::span<const Vector> points, std::span<const Bounds> boxes) : input_(points), map_(points, boxes) {
    for (const Vector& p : points)
      if ((p.array() == p.array()).all()) bounds_.add(p);
    const Bounds core = core_of(points);
    origin_ = core.low;
    const double extent = (core.high - core.low).maxCoeff();
    cells_per_length_ = extent > 0 ? (1 << bits_per_axis) / extent : 0;
    sort(points);
    build_levels(levels_asked(boxes));
  }

  [[nodiscard]] Cell cell(const Vector& x) const {
    Cell c{};
    for (int i = 0; i < 3; ++i) {
      const double v = (x[i] - origin_[i]) * cells_per_length_;
      c[i] = v > 0 ? static_cast<std::uint32_t>(std::min(v, double((1 << bits_per_axis) - 1))) : 0;
    }
    return c;
  }

  /// Size class of a box: the level whose buckets are at least as long as the box.
  [[nodiscard]] static int level_of(const Cell& low, const Cell& high) {
    const std::uint32_t longest = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    return std::bit_width(longest);
  }

  [[nodiscard]] bool meets(const Bounds& box) const { return bounds_.meets(box); }

  void collect(const Bounds& box, std::vector<std::uint32_t>& inside) const {
    const Query query{box, map_.box(box), cell(box.low), cell(box.high)};
    const auto& [same, mapped, low, high] = query;
    const int level = level_of(low, high);
    const Cell first{low[0] >> level, low[1] >> level, low[2] >> level};
    const Cell last{high[0] >> level, high[1] >> level, high[2] >> level};
    // At most two buckets along each axis.
    std::array<std::array<std::uint64_t, 2>, 3> part{};
    for (std::size_t axis = 0; axis < 3; ++axis) part[axis] = {spread(first[axis]) << axis, spread(last[axis]) << axis};
    for (std::uint32_t i = first[0]; i <= last[0]; ++i)
      for (std::uint32_t j = first[1]; j <= last[1]; ++j)
        for (std::uint32_t k = first[2]; k <= last[2]; ++k) {
          const Range range =
              levels_[level].find(part[0][i - first[0]] | part[1][j - first[1]] | part[2][k - first[2]]);
          if (range.end != 0) visit(range, level, {i, j, k}, query, inside);
        }
  }

 private:
  struct Query {
    const Bounds& box;
    FloatBox mapped;
    Cell low, high;
  };

  /// The box that the cells cover: nearly all points with a margin. Points outside (a node at 1e20 in a car) fall into
  /// the cells at the rim instead of making all cells huge.
  [[nodiscard]] Bounds core_of(std::span<const Vector> points) const {
    constexpr std::size_t samples = 1024, margin = 20;  // 2 % on either side
    constexpr double limit = 1e300;
    Bounds core{bounds_.low.cwiseMax(-limit), bounds_.high.cwiseMin(limit)};
    if (points.size() < samples) return core;
    std::vector<double> sample;
    for (int i = 0; i < 3; ++i) {
      sample.clear();
      for (std::size_t k = 0; k < samples; ++k)
        if (const double x = points[k * (points.size() / samples)][i]; std::abs(x) < limit) sample.push_back(x);
      if (sample.size() < samples / 2) continue;
      std::sort(sample.begin(), sample.end());
      const double low = sample[margin], high = sample[sample.size() - 1 - margin], room = 2 * (high - low);
      if (!(room > 0)) continue;
      core.low[i] = std::max(core.low[i], low - room);
      core.high[i] = std::min(core.high[i], high + room);
    }
    return core;
  }

  void sort(std::span<const Vector> points) {
    struct Item {
      std::uint64_t key;
      std::uint32_t point;
    };
    std::vector<Item> items = large_array<Item>(points.size());
    parallel_for(points.size(), 16384, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) items[i] = {z_order(cell(points[i])), static_cast<std::uint32_t>(i)};
    });
    {
      // Few points share the upper bits of their keys; those are sorted by the lower ones among themselves.
      constexpr int lower_bits = 30;
      constexpr std::size_t many = 4096;
      std::vector<Item> spare = large_array<Item>(items.size());
      radix_sort(std::span(items), std::span(spare), 3 * bits_per_axis - lower_bits,
                 [](const Item& item) { return item.key >> lower_bits; });
      const auto upper = [&](std::size_t i) { return items[i].key >> lower_bits; };
      const auto sort_runs = [&](std::size_t first, std::size_t last) {
        for (std::size_t begin = first, end = first; begin < last; begin = end) {
          end = begin + 1;
          while (end < last && upper(end) == upper(begin)) ++end;
          const auto run = std::span(items).subspan(begin, end - begin);
          if (run.size() > many)
            radix_sort(run, std::span(spare).subspan(begin, run.size()), lower_bits,
                       [](const Item& item) { return item.key; });
          else if (run.size() > 1)
            std::sort(run.begin(), run.end(),
                      [](const Item& a, const Item& b) { return a.key != b.key ? a.key < b.key : a.point < b.point; });
        }
      };
      const std::vector<std::size_t> pieces =
          pieces_of_runs(items.size(), 16384, [&](std::size_t i) { return upper(i) == upper(i - 1); });
      parallel_for(pieces.size() - 1, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sort_runs(pieces[i], pieces[i + 1]);
      });
    }
    resize_in_parallel(keys_, items.size());
    resize_in_parallel(index_, items.size());
    sorted_ = FloatPoints(items.size());
    parallel_for(items.size(), 16384, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        keys_[i] = items[i].key;
        index_[i] = items[i].point;
        sorted_.set(i, points[items[i].point], map_);
      }
    });
  }

  /// Bit l: some box queries buckets of level l.
  [[nodiscard]] std::uint32_t levels_asked(std::span<const Bounds> boxes) const {
    std::atomic<std::uint32_t> asked{0};
    parallel_for(boxes.size(), 8192, [&](std::size_t begin, std::size_t end) {
      std::uint32_t mine = 0;
      for (std::size_t b = begin; b < end; ++b)
        if (!boxes[b].empty() && meets(boxes[b])) mine |= 1U << level_of(cell(boxes[b].low), cell(boxes[b].high));
      asked.fetch_or(mine);
    });
    return asked;
  }

  void build_levels(std::uint32_t asked) {
    // Two neighbours on the curve are in different buckets of all levels below their highest different bit.
    std::array<std::size_t, bits_per_axis + 1> parted{};
    for (std::size_t i = 1; i < keys_.size(); ++i)
      if (keys_[i] != keys_[i - 1])
        ++parted[static_cast<std::size_t>((std::bit_width(keys_[i] ^ keys_[i - 1]) - 1) / 3)];
    for (std::size_t level = bits_per_axis; level-- > 0;) parted[level] += parted[level + 1];
    parallel_for(levels_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t level = begin; level < end; ++level)
        if ((asked >> level & 1) != 0) levels_[level].build(keys_, static_cast<int>(level), 1 + parted[level]);
    });
  }

  void visit(Range range, int level, const Cell& at, const Query& query, std::vector<std::uint32_t>& inside) const {
    if (range.end - range.begin <= crowded_bucket || level == 0) {
      sorted_.inside(range.begin, range.end, query.mapped, [&](std::size_t p) {
        if (query.box.contains(input_[index_[p]])) inside.push_back(index_[p]);
      });
      return;
    }
    const int child_level = level - 1;  // at most `bits_per_axis` deep
    const int shift = 3 * child_level;
    std::uint32_t begin = range.begin;
    for (std::uint32_t octant = 0; octant < 8 && begin < range.end; ++octant) {
      const Cell child{at[0] << 1 | (octant & 1), at[1] << 1 | (octant >> 1 & 1), at[2] << 1 | octant >> 2};
      bool meets = true;
      for (std::size_t i = 0; i < 3; ++i)
        meets = meets && child[i] >= query.low[i] >> child_level && child[i] <= query.high[i] >> child_level;
      if (!meets) continue;
      const std::uint64_t key = z_order(child);
      const auto past = [&](std::uint64_t limit) {
        return static_cast<std::uint32_t>(std::partition_point(keys_.begin() + begin, keys_.begin() + range.end,
                                                               [&](std::uint64_t k) { return k >> shift < limit; }) -
                                          keys_.begin());
      };
      begin = past(key);
      const std::uint32_t end = past(key + 1);
      if (end > begin) visit({begin, end}, child_level, child, query, inside);
      begin = end;
    }
  }

  std::span<const Vector> input_;
  FloatMap map_;
  Bounds bounds_;                   // of all points
  Vector origin_ = Vector::Zero();  // corner of the first cell
  double cells_per_length_ = 0;
  std::vector<std::uint64_t> keys_;   // sorted
  std::vector<std::uint32_t> index_;  // beside keys_: position of the point in the input
  FloatPoints sorted_;                // beside keys_
  std::array<Level, bits_per_axis + 1> levels_;
};

class BucketGrid final : public CandidateSearch {
 public:
  [[nodiscard]] std::string_view name() const override { return "bucket grid"; }

  void run(std::span<const Vector> points, std::span<const Bounds> boxes, const CandidateSink& sink) const override {
    if (points.empty() || boxes.empty()) return;
    // A deck may have thousands of contacts of a few segments each: comparing them costs less than building a grid.
    constexpr std::size_t few_pairs = 512;
    if (points.size() * boxes.size() <= few_pairs) return make_brute_force()->run(points, boxes, sink);
    const Grid grid(points, boxes);
    parallel_for(boxes.size(), 1024, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> inside;
      for (std::size_t b = begin; b < end; ++b) {
        if (boxes[b].empty() || !grid.meets(boxes[b])) continue;
        inside.clear();
        grid.collect(boxes[b], inside);
        if (!inside.empty()) sink(static_cast<std::uint32_t>(b), inside);
      }
    });
  }
};

}  // namespace

std::unique_ptr<CandidateSearch> make_bucket_grid() { return std::make_unique<BucketGrid>(); }

}  // namespace gapcheck::contact
