#include "contact/search/choose_search.hpp"

#include <algorithm>
#include <optional>

#include "contact/search/search_sample.hpp"

namespace gapcheck::contact {
namespace {

class TalliedSearch final : public CandidateSearch {
 public:
  TalliedSearch(std::optional<SearchKind> kind, SearchTally& tally) : kind_(kind), tally_(tally) {}
  [[nodiscard]] std::string_view name() const override { return kind_ ? make_search(*kind_)->name() : "chosen"; }
  [[nodiscard]] bool exhaustive() const override { return kind_ == SearchKind::brute_force; }

  void run(std::span<const Vector> points, std::span<const Bounds> boxes, const CandidateSink& sink) const override {
    const SearchKind kind = kind_.value_or(choose_search(points, boxes));
    ++tally_.of(kind);
    make_search(kind)->run(points, boxes, sink);
  }

 private:
  std::optional<SearchKind> kind_;
  SearchTally& tally_;
};

class RepeatedSearch final : public CandidateSearch {
 public:
  [[nodiscard]] std::string_view name() const override { return "repeated"; }
  void run(std::span<const Vector> points, std::span<const Bounds> boxes, const CandidateSink& sink) const override {
    make_search(choose_repeated_search(points, boxes))->run(points, boxes, sink);
  }
};

/// Up to so many points a sweep costs less than building a grid or tree.
constexpr std::size_t few_points = 3000;

/// The grid has 2²¹ cells along the longest extent with its room (bucket_grid.cpp). Boxes about as small as a cell
/// would share it with everything near them.
bool grid_is_coarse(std::span<const Vector> points, std::span<const Bounds> boxes) {
  constexpr double cells = 1 << 21, room = 5, cells_per_box = 4;
  const SearchSample sample(points, boxes);
  const double extent = std::max({sample.extent(0), sample.extent(1), sample.extent(2)});
  return sample.box_length() * cells < cells_per_box * room * extent;
}

}  // namespace

SearchKind choose_search(std::span<const Vector> points, std::span<const Bounds> boxes) {
  if (points.size() <= few_points) return SearchKind::sorted_sweep;
  return grid_is_coarse(points, boxes) ? SearchKind::box_tree : SearchKind::bucket_grid;
}

SearchKind choose_repeated_search(std::span<const Vector> points, std::span<const Bounds> boxes) {
  return points.size() > few_points && grid_is_coarse(points, boxes) ? SearchKind::box_tree : SearchKind::bucket_grid;
}

std::unique_ptr<CandidateSearch> make_repeated_search() { return std::make_unique<RepeatedSearch>(); }

std::unique_ptr<CandidateSearch> make_search(SearchKind kind) {
  switch (kind) {
    case SearchKind::sorted_sweep:
      return make_sorted_sweep();
    case SearchKind::box_tree:
      return make_box_tree();
    case SearchKind::brute_force:
      return make_brute_force();
    case SearchKind::bucket_grid:
      break;
  }
  return make_bucket_grid();
}

std::unique_ptr<CandidateSearch> make_chosen_search(SearchTally& tally) {
  return std::make_unique<TalliedSearch>(std::nullopt, tally);
}

std::unique_ptr<CandidateSearch> make_counted_search(SearchKind kind, SearchTally& tally) {
  return std::make_unique<TalliedSearch>(kind, tally);
}

}  // namespace gapcheck::contact
