// Hierarchical bucket grid. Points are sorted once along a Z-order curve over a fine grid; a bucket of any power-of-two
// size is then a contiguous range of that order. A box asks the few buckets of about its own size; a crowded bucket is
// split into its eight children on the way. Element sizes may therefore differ by any factor, and empty space (a stray
// part far away) costs nothing.
//
// Both points and boxes go through the same monotone map from coordinates to integer cells, so rounding can put a point
// into a neighbouring cell but never outside the cells of a box that contains it.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "base/parallel.hpp"
#include "contact/search.hpp"

namespace gapcheck::contact {
namespace {

constexpr int bits = 21;  // per axis: 3 × 21 fit one key
constexpr std::uint32_t crowded = 48;
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
  void build(const std::vector<std::uint64_t>& keys, int level) {
    const int shift = 3 * level;
    std::size_t buckets = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) buckets += i == 0 || keys[i] >> shift != keys[i - 1] >> shift;
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
  [[nodiscard]] bool built() const { return !slots_.empty(); }
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
  [[nodiscard]] std::size_t hash(std::uint64_t key) const { return (key * 0x9E3779B97F4A7C15ULL >> 20) & mask_; }
  std::vector<Slot> slots_;
  std::size_t mask_ = 0;
};

class Grid {
 public:
  explicit Grid(std::span<const Vector> points) {
    for (const Vector& p : points) bounds_.add(p);
    const Bounds core = core_of(points);
    origin_ = core.low;
    const double extent = (core.high - core.low).maxCoeff();
    cells_per_length_ = extent > 0 ? (1 << bits) / extent : 0;
    sort(points);
  }

  void build_level(int level) {
    if (!levels_[level].built()) levels_[level].build(keys_, level);
  }

  [[nodiscard]] Cell cell(const Vector& x) const {
    Cell c{};
    for (int i = 0; i < 3; ++i) {
      const double v = (x[i] - origin_[i]) * cells_per_length_;
      c[i] = v > 0 ? static_cast<std::uint32_t>(std::min(v, double((1 << bits) - 1))) : 0;
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
    const Cell low = cell(box.low), high = cell(box.high);
    const int level = level_of(low, high);
    for (std::uint32_t i = low[0] >> level; i <= high[0] >> level; ++i)
      for (std::uint32_t j = low[1] >> level; j <= high[1] >> level; ++j)
        for (std::uint32_t k = low[2] >> level; k <= high[2] >> level; ++k) {
          const Range range = levels_[level].find(z_order({i, j, k}));
          if (range.end != 0) visit(range, level, {i, j, k}, box, low, high, inside);
        }
  }

 private:
  /// The box that the cells cover: nearly all points with room around them. What lies outside (a node at 1e20 in a car)
  /// falls into the cells at the rim instead of making all cells huge.
  [[nodiscard]] Bounds core_of(std::span<const Vector> points) const {
    constexpr std::size_t samples = 1024, margin = 20;  // 2 % on either side
    Bounds core = bounds_;
    if (points.size() < samples) return core;
    std::vector<double> sample(samples);
    for (int i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < samples; ++k) sample[k] = points[k * (points.size() / samples)][i];
      std::sort(sample.begin(), sample.end());
      const double low = sample[margin], high = sample[samples - 1 - margin], room = 2 * (high - low);
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
    std::vector<Item> items(points.size()), spare(points.size());
    parallel_for(points.size(), 16384, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) items[i] = {z_order(cell(points[i])), static_cast<std::uint32_t>(i)};
    });
    constexpr int digit = 11;
    constexpr std::size_t radix = std::size_t{1} << digit;
    for (int shift = 0; shift < 3 * bits; shift += digit) {
      std::array<std::uint32_t, radix + 1> start{};
      for (const Item& item : items) ++start[(item.key >> shift & (radix - 1)) + 1];
      if (std::any_of(start.begin(), start.end(), [&](std::uint32_t n) { return n == items.size(); })) continue;
      for (std::size_t d = 1; d <= radix; ++d) start[d] += start[d - 1];
      for (const Item& item : items) spare[start[item.key >> shift & (radix - 1)]++] = item;
      items.swap(spare);
    }
    keys_.resize(items.size());
    index_.resize(items.size());
    sorted_.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      keys_[i] = items[i].key;
      index_[i] = items[i].point;
      sorted_[i] = points[items[i].point];
    }
  }

  void visit(Range range, int level, const Cell& at, const Bounds& box, const Cell& low, const Cell& high,
             std::vector<std::uint32_t>& inside) const {
    if (range.end - range.begin <= crowded || level == 0) {
      for (std::uint32_t p = range.begin; p < range.end; ++p) {
        const auto x = sorted_[p].array();
        if ((x >= box.low.array()).all() && (x <= box.high.array()).all()) inside.push_back(index_[p]);
      }
      return;
    }
    const int child_level = level - 1;  // at most `bits` deep
    std::uint32_t begin = range.begin;
    for (std::uint32_t octant = 0; octant < 8 && begin < range.end; ++octant) {
      const Cell child{at[0] << 1 | (octant & 1), at[1] << 1 | (octant >> 1 & 1), at[2] << 1 | octant >> 2};
      const std::uint64_t past = z_order(child) + 1;
      const auto end = static_cast<std::uint32_t>(
          std::partition_point(keys_.begin() + begin, keys_.begin() + range.end,
                               [&](std::uint64_t key) { return key >> 3 * child_level < past; }) -
          keys_.begin());
      bool meets = end > begin;
      for (int i = 0; i < 3; ++i)
        meets = meets && child[i] >= low[i] >> child_level && child[i] <= high[i] >> child_level;
      if (meets) visit({begin, end}, child_level, child, box, low, high, inside);
      begin = end;
    }
  }

  Bounds bounds_;                      // of all points
  Vector origin_ = Vector::Zero();     // corner of the first cell
  double cells_per_length_ = 0;
  std::vector<std::uint64_t> keys_;    // sorted
  std::vector<std::uint32_t> index_;   // beside keys_: position of the point in the input
  std::vector<Vector> sorted_;         // beside keys_
  std::array<Level, bits + 1> levels_;
};

class BucketGrid final : public CandidateSearch {
 public:
  [[nodiscard]] std::string_view name() const override { return "bucket grid"; }

  void run(std::span<const Vector> points, std::span<const Bounds> boxes, const CandidateSink& sink) const override {
    if (points.empty() || boxes.empty()) return;
    Grid grid(points);
    std::array<bool, bits + 1> used{};
    for (const Bounds& box : boxes)
      if (!box.empty() && grid.meets(box)) used[Grid::level_of(grid.cell(box.low), grid.cell(box.high))] = true;
    for (int level = 0; level <= bits; ++level)
      if (used[level]) grid.build_level(level);
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
