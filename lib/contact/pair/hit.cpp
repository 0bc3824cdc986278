#include "contact/pair/hit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace gapcheck::contact {
namespace {

/// True if the hit lies behind a facet that is not the nearest of its body.
bool behind_another(const PairScene& scene, const Hit& hit, std::span<const Hit> hits, std::span<const Hit> measured) {
  if (!std::signbit(hit.distance)) return false;
  const auto body = [&](const Hit& of) { return scene.solids.empty() ? 0 : scene.solids.body[of.segment.value]; };
  const auto nearer = [&](const Hit& other) {
    return body(other) == body(hit) && std::abs(hit.distance) > std::abs(other.distance) * (1 + equally_near);
  };
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

}  // namespace gapcheck::contact
