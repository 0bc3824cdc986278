#include "contact/pair/hit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "contact/pair/nearer_segments.hpp"

namespace gapcheck::contact {
namespace {

/// True if the hit lies behind a facet that is not the nearest of its body.
bool behind_another(const PairScene& scene, const Hit& hit, std::span<const Hit> hits, std::span<const Hit> measured) {
  if (!std::signbit(hit.distance)) return false;
  const auto nearer = [&](const Hit& other) { return nearer_of_body(scene, hit, other); };
  return std::any_of(measured.begin(), measured.end(), nearer) ||
         std::any_of(hits.begin(), hits.end(), [&](const Hit& h) { return scene.oriented(h.segment) && nearer(h); });
}

std::optional<Hit> choose_among(const PairScene& scene, std::span<const Hit> hits, std::span<const Hit> measured) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double in_band = infinity, outside = infinity;
  for (const Hit& hit : hits) {
    if (behind_another(scene, hit, hits, measured)) continue;
    double& distance = hit.in_band ? in_band : outside;
    distance = std::min(distance, std::abs(hit.distance));
  }
  const bool any_in_band = in_band < infinity;
  std::optional<Hit> chosen;
  for (const Hit& hit : hits) {
    if (any_in_band && !hit.in_band) continue;
    if (std::abs(hit.distance) > (any_in_band ? in_band : outside) * (1 + equally_near)) continue;
    if (chosen && chosen->segment < hit.segment) continue;
    if (!behind_another(scene, hit, hits, measured)) chosen = hit;
  }
  return chosen;
}

}  // namespace

std::optional<Hit> choose_hit(const PairScene& scene, std::span<const Hit> hits, std::span<const Hit> measured) {
  // Hits in front need no comparison with others.
  if (hits.size() == 1 && !std::signbit(hits[0].distance)) return hits[0];
  if (scene.own_neighbours == nullptr) return choose_among(scene, hits, measured);
  const auto slides = [&](const Hit& hit) { return scene.slides(hit.slot, hit.segment, hit.distance); };
  const auto any_slides = [&](std::span<const Hit> list) { return std::any_of(list.begin(), list.end(), slides); };
  const bool all_slide = std::all_of(hits.begin(), hits.end(), slides);
  if (all_slide || !(any_slides(hits) || any_slides(measured))) return choose_among(scene, hits, measured);
  std::vector<Hit> met, met_in_front;
  std::remove_copy_if(hits.begin(), hits.end(), std::back_inserter(met), slides);
  std::remove_copy_if(measured.begin(), measured.end(), std::back_inserter(met_in_front), slides);
  return choose_among(scene, met, met_in_front);
}

namespace {

/// A hit in the order in which drop_farther() looks at them.
struct OrderedHit {
  enum class Kind : std::uint8_t { kept, in_band, outside } kind;
  std::uint32_t body;  ///< none: two-sided, and never the nearest facet of a body
  Hit hit;
};

/// The hits of one slot in that order.
void put_in_order(const PairScene& scene, std::span<const Hit> hits, std::vector<OrderedHit>& list) {
  list.clear();
  for (const Hit& hit : hits) {
    using Kind = OrderedHit::Kind;
    const bool always = std::signbit(hit.distance) || scene.slides(hit.slot, hit.segment, hit.distance);
    const std::uint32_t body = !scene.oriented(hit.segment) ? no_position
                               : scene.solids.empty()       ? 0
                                                            : scene.solids.body[hit.segment.value];
    list.push_back({always ? Kind::kept : hit.in_band ? Kind::in_band : Kind::outside, body, hit});
  }
  std::sort(list.begin(), list.end(), [](const OrderedHit& l, const OrderedHit& r) {
    return std::tuple(l.kind, l.body, std::abs(l.hit.distance), l.hit.segment) <
           std::tuple(r.kind, r.body, std::abs(r.hit.distance), r.hit.segment);
  });
}

/// Those of one slot that may count.
void keep_nearest(std::span<const OrderedHit> list, std::vector<Hit>& kept) {
  using Kind = OrderedHit::Kind;
  SegmentIndex least = none<SegmentIndex>;  // of the nearer ones of one kind and body
  bool any_in_band = false;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto& [kind, body, hit] = list[i];
    const bool nearest = i == 0 || list[i - 1].kind != kind || list[i - 1].body != body;
    any_in_band = any_in_band || kind == Kind::in_band;
    // Of equally near segments the first counts; hits outside the band count where none is in it.
    const bool chosen_by_segment = kind == Kind::in_band || !any_in_band;
    const bool of_body = nearest && body != no_position;
    if (nearest || hit.segment < least) {
      least = hit.segment;
      if (kind == Kind::kept || chosen_by_segment || of_body) kept.push_back(hit);
    } else if (kind == Kind::kept) {
      kept.push_back(hit);
    }
  }
}

}  // namespace

void drop_farther(const PairScene& scene, std::vector<Hit>& hits) {
  // Slot and position as one number sort fast.
  std::vector<std::uint64_t> order(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) order[i] = std::uint64_t{hits[i].slot.value} << 32 | i;
  std::sort(order.begin(), order.end());
  std::vector<Hit> kept, of_slot;
  std::vector<OrderedHit> list;
  for (std::size_t i = 0; i < order.size();) {
    of_slot.clear();
    const std::uint64_t slot = order[i] >> 32;
    for (; i < order.size() && order[i] >> 32 == slot; ++i)
      of_slot.push_back(hits[static_cast<std::uint32_t>(order[i])]);
    put_in_order(scene, of_slot, list);
    keep_nearest(list, kept);
  }
  hits = std::move(kept);
}

}  // namespace gapcheck::contact
