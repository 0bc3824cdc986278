#include "solver/mortar/mortar_search.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <span>

#include "base/parallel.hpp"
#include "contact/search/box_pairs.hpp"

namespace gapcheck::solver {
namespace {

/// Covers the rounding of distances between boxes.
constexpr double rounding_of_boxes = 1e-9;

/// All places where the corners of a face can be, however it turns.
contact::Bounds box_of(const MortarFace& face, const std::vector<Vector>& x) {
  contact::Bounds box;
  for (const NodeIndex node : face.nodes) {
    if (!x[node.value].allFinite()) return {};
    box.add(x[node.value]);
  }
  const double arm = (face.rim ? face.thickness / 2 : 0) + std::abs(face.shift);
  return arm > 0 ? contact::grown(box, arm) : box;
}

}  // namespace

MortarSearch::MortarSearch(const ContactSetting& setting, const model::Contact& contact, const MortarSurface& surface,
                           bool two_sided, bool own_part, double least_reach)
    : surface_(surface),
      exclusions_(setting.model, contact.id),
      ties_(setting.ties),
      two_sided_(two_sided),
      own_part_(own_part),
      least_reach_(least_reach) {}

bool MortarSearch::may_meet(const MortarFace& a, const MortarFace& b) const {
  if (two_sided_ && a.on_b == b.on_b) return false;
  if (!own_part_ && a.part == b.part) return false;
  if (are_joined(a, b)) return false;
  if (!exclusions_.empty() && exclusions_.excluded(a.part, b.part)) return false;
  if (ties_.size() == 0) return true;
  const auto tied = [&](const MortarFace& face, PartIndex part) {
    return std::any_of(face.nodes.begin(), face.nodes.end(), [&](NodeIndex n) { return ties_.tied(n, part); });
  };
  return !tied(a, b.part) && !tied(b, a.part);
}

std::vector<std::uint64_t> MortarSearch::find_pairs(const std::vector<Vector>& x, double margin) const {
  std::vector<contact::Bounds> boxes(surface_.size());
  parallel_for(boxes.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const MortarFace& face = surface_[static_cast<std::uint32_t>(i)];
      const contact::Bounds box = box_of(face, x);
      const double reach = std::max({face.half, face.reach, least_reach_ / 2}) + margin / 2;
      if (!box.empty()) boxes[i] = contact::grown(box, reach * (1 + rounding_of_boxes));
    }
  });
  tbb::enumerable_thread_specific<std::vector<std::uint64_t>> found;
  const auto visit = [&](std::uint32_t i, std::uint32_t k) {
    const MortarFace &a = surface_[i], &b = surface_[k];
    if (!may_meet(a, b)) return;
    // SURFA is tracked; of a single surface the softer face, of equal ones the first.
    const bool first = i < k;
    const std::uint32_t low = first ? i : k, high = first ? k : i;
    const bool swap = !two_sided_ && surface_[high].slope > 0 && surface_[high].slope < surface_[low].slope;
    found.local().push_back(std::uint64_t{swap ? high : low} << 32 | (swap ? low : high));
  };
  contact::for_each_box_pair(boxes, visit);
  std::vector<std::uint64_t> keys;
  for (const auto& mine : found) keys.insert(keys.end(), mine.begin(), mine.end());
  std::sort(keys.begin(), keys.end());
  return keys;
}

double MortarSearch::way_to_go(const MortarFace& a, const MortarFace& b, const std::vector<Vector>& x) const {
  const contact::Bounds first = box_of(a, x), second = box_of(b, x);
  const Vector apart = (first.low - second.high).cwiseMax(second.low - first.high).cwiseMax(0);
  return apart.norm() * (1 - rounding_of_boxes) - std::max(a.half + b.half, release_depth(a, b));
}

}  // namespace gapcheck::solver
