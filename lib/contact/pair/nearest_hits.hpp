#pragma once
#include <atomic>
#include <limits>
#include <vector>

#include "contact/pair/hit.hpp"

namespace gapcheck::contact {

/// By tracked node, the distance of the nearest two-sided segment found so far that has the node in its band. It tells
/// hits that choose_hit() cannot choose as soon as they are found, so a node among many layers keeps few of them. May
/// be used from any thread: the order in which hits come decides which are dropped, but not which one is chosen.
class NearestHits {
 public:
  explicit NearestHits(const PairScene& scene) : scene_(scene), nearest_(scene.nodes.size()) {
    for (std::atomic<double>& distance : nearest_) distance.store(infinity, std::memory_order_relaxed);
  }

  /// The hits in the band of two-sided segments that are farther from the node cannot be chosen. Infinity: none is
  /// known.
  [[nodiscard]] double limit(SlotIndex slot) const {
    return nearest_[slot.value].load(std::memory_order_relaxed) * (1 + equally_near);
  }
  /// False if the hit cannot be chosen among those that were added, itself included.
  [[nodiscard]] bool may_count(const Hit& hit) const {
    if (scene_.oriented(hit.segment)) return true;
    return hit.in_band ? !(hit.distance > limit(hit.slot)) : limit(hit.slot) == infinity;
  }
  /// Adds a hit. False if it cannot be chosen.
  [[nodiscard]] bool add(const Hit& hit) {
    if (!may_count(hit)) return false;
    if (!hit.in_band || scene_.oriented(hit.segment)) return true;
    std::atomic<double>& nearest = nearest_[hit.slot.value];
    double known = nearest.load(std::memory_order_relaxed);
    while (hit.distance < known && !nearest.compare_exchange_weak(known, hit.distance, std::memory_order_relaxed)) {
    }
    return true;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  const PairScene& scene_;
  std::vector<std::atomic<double>> nearest_;
};

}  // namespace gapcheck::contact
