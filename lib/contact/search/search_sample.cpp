#include "contact/search/search_sample.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::contact {
namespace {

constexpr std::size_t most_points = 256, most_boxes = 32;

}  // namespace

SearchSample::SearchSample(std::span<const Vector> points, std::span<const Bounds> boxes) {
  std::array<std::vector<double>, 3> coordinates;
  for (auto& list : coordinates) list.reserve(most_points);
  const std::size_t point_step = points.size() / std::clamp<std::size_t>(points.size() / 8, 16, most_points) + 1;
  for (std::size_t i = 0; i < points.size(); i += point_step)
    if (points[i].allFinite())
      for (int k = 0; k < 3; ++k) coordinates[static_cast<std::size_t>(k)].push_back(points[i][k]);
  const std::size_t box_step = boxes.size() / std::clamp<std::size_t>(boxes.size() / 8, 8, most_boxes) + 1;
  std::vector<double> lengths;
  std::array<std::size_t, 3> inside{};
  for (std::size_t i = 0; i < boxes.size(); i += box_step) {
    const Bounds& box = boxes[i];
    if (box.empty() || !box.low.allFinite() || !box.high.allFinite()) continue;
    lengths.push_back((box.high - box.low).maxCoeff());
    for (int k = 0; k < 3; ++k)
      for (const double x : coordinates[static_cast<std::size_t>(k)])
        inside[static_cast<std::size_t>(k)] += static_cast<std::size_t>(x >= box.low[k] && x <= box.high[k]);
  }
  if (lengths.empty() || coordinates[0].empty()) return;
  for (std::size_t k = 0; k < 3; ++k) {
    auto& list = coordinates[k];
    slabs_[k] =
        static_cast<double>(inside[k]) / (static_cast<double>(lengths.size()) * static_cast<double>(list.size()));
    const auto at = [&](std::size_t position) {
      const auto place = list.begin() + static_cast<std::ptrdiff_t>(position);
      std::nth_element(list.begin(), place, list.end());
      return *place;
    };
    const std::size_t margin = list.size() / 100;
    extents_[k] = at(list.size() - 1 - margin) - at(margin);
  }
  const auto median = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), median, lengths.end());
  box_length_ = *median;
}

int SearchSample::sweep_axis() const {
  return static_cast<int>(std::min_element(slabs_.begin(), slabs_.end()) - slabs_.begin());
}

}  // namespace gapcheck::contact
