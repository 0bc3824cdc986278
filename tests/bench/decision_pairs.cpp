#include "decision_pairs.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>

#include "base/parallel.hpp"
#include "contact/pair/closest_segment.hpp"
#include "contact/pair/side_scene.hpp"
#include "families.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"

namespace gapcheck::bench {
namespace {

/// `margin`: how much farther to look, in shorter diagonals of the segment.
void add_pairs(const contact::PairScene& scene, const contact::CandidateSearch& search, double margin,
               std::vector<DecisionPair>& pairs) {
  double largest_half = 0;
  for (const double half : scene.nodes.half) largest_half = std::max(largest_half, half);
  contact::SweepCounters counters;
  contact::for_each_candidate(
      scene, search,
      [&](SegmentIndex s) {
        return scene.reach(s, largest_half) + (margin > 0 ? margin * contact::min_diagonal(scene.facet(s)) : 0);
      },
      counters,
      [&](SegmentIndex s, std::span<const SlotIndex> slots) {
        if (scene.line(s)) return;
        const geometry::Facet facet = scene.facet(s);
        for (const SlotIndex slot : slots) {
          const Vector query = scene.position(slot);
          const double h = scene.nodes.half[slot.value] + scene.segments.half[s.value];
          const double bound = h - contact::default_tolerance(h, contact::largest_coordinate(facet, query));
          pairs.push_back({facet, query, std::abs(bound)});
        }
      });
}

void add_contact(const model::Model& model, contact::SurfaceStore& store, ContactIndex c, double margin,
                 std::vector<DecisionPair>& pairs) {
  const contact::ContactType type = contact::classify(model.contact(c));
  if (!type.checked()) return;
  const contact::ContactSurfaces& sides = store.at(c);
  const auto search = contact::make_bucket_grid();
  const auto sweep = [&](bool exchanged) {
    const auto& nodes = (exchanged ? sides.b : sides.a).nodes;
    const auto& reference = exchanged || !sides.two_sided() ? sides.a : sides.b;
    if (nodes.size() == 0 || reference.selection.segments.size() == 0) return;
    const contact::SideScene side(model, c, sides, exchanged, model.mesh.nodes.x);
    add_pairs(side.scene(), *search, margin, pairs);
  };
  sweep(false);
  if (type.treatment == contact::Treatment::two_way) sweep(true);
}

enum class Bounds : std::uint8_t { around, last_bit };

PairSet family_set(geometry::test::Family family, Bounds bounds, std::size_t count) {
  geometry::test::Maker maker(101 + static_cast<std::uint64_t>(family));
  PairSet set;
  set.name = std::string(name(family)) + (bounds == Bounds::last_bit ? ", bound to the last bit" : "");
  while (set.pairs.size() < count) {
    const geometry::test::Pair pair = maker.make(family);
    const double distance = std::sqrt(geometry::closest_point(pair.facet, pair.query).squared_distance);
    double bound = distance * maker.uniform(0.5, 2);
    if (bounds == Bounds::last_bit) {
      bound = distance;
      const int ulps = maker.integer(-1, 1);
      if (ulps != 0) bound = std::nextafter(bound, ulps * std::numeric_limits<double>::infinity());
    }
    if (!(bound > 0)) bound = 1e-3;  // the node lies on the facet
    set.pairs.push_back({pair.facet, pair.query, bound});
  }
  return set;
}

}  // namespace

PairSet pairs_of_deck(const std::string& path, double margin) {
  const JobLimit one(1);  // the same order in every run
  PairSet set;
  set.name = path.substr(path.find_last_of('/') + 1) + (margin > 0 ? ", wider" : "");
  Diagnostics diagnostics;
  auto deck = keyword::read_deck(path, {}, diagnostics);
  if (!deck) return set;
  auto model = model::read_model(deck.value(), diagnostics);
  if (!model) return set;
  contact::SurfaceStore store(model.value());
  for (const ContactIndex c : positions<ContactIndex>(model.value().contacts.size()))
    add_contact(model.value(), store, c, margin, set.pairs);
  return set;
}

std::vector<PairSet> pairs_of_families(std::size_t count) {
  std::vector<PairSet> sets;
  for (const Bounds bounds : {Bounds::around, Bounds::last_bit})
    for (const geometry::test::Family family : geometry::test::all_families)
      sets.push_back(family_set(family, bounds, bounds == Bounds::around ? count : count / 16));
  return sets;
}

}  // namespace gapcheck::bench
