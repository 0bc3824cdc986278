#include "contact/initial_penetrations.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "contact/definition/exclusions.hpp"
#include "contact/edge/edge_pairs.hpp"
#include "contact/pair/orientation.hpp"
#include "contact/pair/pair_rules.hpp"
#include "contact/pair/penetration_record.hpp"
#include "contact/pair/side_scene.hpp"

namespace gapcheck::contact {
namespace {

/// Coordinates are written with some eight digits: touching facets of solids, as in press fits and bolts, seem to
/// penetrate by this share of their size.
constexpr double written_digits = 1e-6;

/// True if a facet without thickness is penetrated by no more than the deck's digits resolve.
bool only_touches(const PairScene& scene, const Hit& hit) {
  const double h = scene.nodes.half[hit.slot.value] + scene.segments.half[hit.segment.value];
  return h == 0 && scene.tolerance < 0 && -hit.distance <= written_digits * min_diagonal(scene.facet(hit.segment));
}

/// The sides of one contact, one after the other.
class SideSearch {
 public:
  SideSearch(const InitialSearch& scene, ContactIndex contact, const ContactSurfaces& surfaces,
             const Exclusions& exclusions, PenetrationList& list)
      : of_(scene), contact_(contact), surfaces_(surfaces), exclusions_(exclusions), list_(list) {}

  /// Once all nodes are moved: those that have landed in another segment.
  void find_moved_into(bool exchanged, std::vector<MovedInto>& list) {
    const std::vector<Left>& left = left_[exchanged];
    if (left.empty()) return;
    const SideScene side(of_.model, contact_, surfaces_, exchanged, of_.present.x(), &neighbours_);
    sides_[exchanged].reset();
    const PairScene& all = side.scene();
    TrackedNodes nodes;
    nodes.node.reserve(left.size());
    nodes.half.reserve(left.size());
    nodes.rule.reserve(left.size());
    nodes.part.reserve(left.size());
    for (const Left& hit : left) {
      nodes.node.push_back(all.nodes.node[hit.slot.value]);
      nodes.half.push_back(all.nodes.half[hit.slot.value]);
      nodes.rule.push_back(all.nodes.rule[hit.slot.value]);
      nodes.part.push_back(all.nodes.part[hit.slot.value]);
      if (!all.nodes.shift.empty()) nodes.shift.push_back(all.nodes.shift[hit.slot.value]);
    }
    PairScene scene{all.model, all.contact,    all.type,         all.settings, all.x, all.segments,
                    nodes,     all.neighbours, all.surface_type, all.solids,   {}};
    scene.tolerance = of_.options.tolerance;
    scene.mode = of_.options.mode;
    scene.flush = of_.options.flush;
    scene.most_pairs = of_.options.most_pairs;
    scene.own = all.own;
    scene.own_neighbours = all.own_neighbours;
    const model::Mesh& mesh = of_.model.mesh;
    for (const Hit& hit : search(scene, side.tracked())) {
      const SegmentIndex from = left[hit.slot.value].segment;
      const auto& a = all.segments.nodes[from.value];
      const auto& b = all.segments.nodes[hit.segment.value];
      if (std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end()) continue;
      MovedInto found;
      found.node = nodes.node[hit.slot.value];
      found.element = element_id(mesh, all.segments, from.value);
      if (const PartIndex part = part_of(mesh, all.segments, from.value); part != none<PartIndex>)
        found.element_part = of_.model.part(part).id.value;
      found.into = penetration_record(scene, contact_, hit);
      found.moved = (scene.x[found.node.value] - mesh.nodes.x[found.node.value]).norm();
      list.push_back(found);
    }
  }

  /// `exchanged`: side B's nodes in side A's segments.
  void run(bool exchanged) {
    const ContactType& type = surfaces_.type;
    const TrackedNodes& nodes = (exchanged ? surfaces_.b : surfaces_.a).nodes;
    const ContactSide& reference = exchanged || !surfaces_.two_sided() ? surfaces_.a : surfaces_.b;
    if (nodes.size() == 0 || reference.selection.segments.size() == 0) return;
    std::optional<SideScene>& side = sides_[exchanged];
    {
      const Stopwatch watch(of_.counters.surface_s);
      side.emplace(of_.model, contact_, surfaces_, exchanged, of_.present.x(), &neighbours_);
    }
    PairScene& scene = side->scene();
    scene.tolerance = of_.options.tolerance;
    scene.flush = of_.options.flush;
    scene.most_pairs = of_.options.most_pairs;
    scene.mode = of_.options.mode;
    std::vector<Hit> hits;
    if (!type.only_edges()) hits = search(scene, side->tracked());
    if (type.by_segments())
      std::erase_if(hits, [&](const Hit& hit) { return !hit.in_band || only_touches(scene, hit); });
    list_.keep_one_per_node(hits, nodes, of_.model.mesh.nodes.id);
    if (of_.options.edges && type.edges) add_edges(scene);
    const std::span<const Penetration> records = add_nodes(scene, hits);
    if (!of_.options.nodes_stay) move_nodes(scene, hits, records, left_[exchanged]);
    if (left_[exchanged].empty()) side.reset();
  }

 private:
  /// The nodes that penetrate a segment with which they may be in contact.
  std::vector<Hit> search(PairScene& scene, const ContactSide& tracked) const {
    const Stopwatch watch(of_.counters.search_s);
    scene.flipped = flipped_segments(scene, of_.search);
    std::atomic<std::uint64_t> tied_pairs{0}, excluded{0};
    const PairRules rules(scene, tracked, exclusions_, of_.ties);
    const auto allowed = [&](SlotIndex slot, SegmentIndex segment, bool penetrates) {
      const PairRule rule = rules(slot, segment);
      if (rule == PairRule::excluded) excluded += penetrates;
      if (rule == PairRule::tied) tied_pairs += penetrates;
      return rule == PairRule::counts;
    };
    const auto only_in_band = [&](SlotIndex slot, SegmentIndex segment) { return rules.only_in_band(slot, segment); };
    const PairFilter filter{allowed, !exclusions_.empty() || of_.ties.size() > 0, only_in_band};
    std::vector<Hit> hits = closest_segments(scene, of_.search, filter, of_.counters.sweep, of_.counters.decisions);
    of_.counters.tied_pairs += tied_pairs;
    of_.counters.excluded_pairs += excluded;
    return hits;
  }

  void add_edges(const PairScene& scene) {
    const Stopwatch watch(of_.counters.search_s);
    const std::vector<SurfaceEdge> edges = surface_edges(scene, scene.type.interior_edges);
    of_.counters.edges += edges.size();
    const BoxSearch search = of_.options.brute_force ? BoxSearch::brute_force : BoxSearch::tree;
    const EdgeRules rules(scene, exclusions_, of_.ties);
    const auto hits =
        penetrating_edges(scene, edges, rules, search, of_.counters.decisions, of_.counters.sweep.crowded_edges);
    list_.add(edge_records(scene, contact_, edges, hits));
  }

  /// A record for each hit, in the same order.
  std::span<const Penetration> add_nodes(const PairScene& scene, std::span<const Hit> hits) {
    const std::span<Penetration> records = list_.add(hits.size());
    parallel_for(hits.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) records[i] = penetration_record(scene, contact_, hits[i]);
    });
    return records;
  }

  /// A node that is moved, and the segment out of which it is moved.
  struct Left {
    SlotIndex slot;
    SegmentIndex segment;
  };

  /// `left`: gets the nodes that are moved, if that is asked for.
  void move_nodes(const PairScene& scene, std::span<const Hit> hits, std::span<const Penetration> records,
                  std::vector<Left>& left) {
    if (of_.options.moved_into) left.reserve(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (records[i].outcome != Outcome::moved) continue;
      of_.present.move(scene.nodes.node[hits[i].slot.value], records[i].moved_to);
      if (of_.options.moved_into) left.push_back({hits[i].slot, hits[i].segment});
    }
  }

  const InitialSearch& of_;
  const ContactIndex contact_;
  const ContactSurfaces& surfaces_;
  const Exclusions& exclusions_;
  PenetrationList& list_;
  NeighbourCache neighbours_;
  std::array<std::optional<SideScene>, 2> sides_;  ///< by side of the nodes: kept while its neighbours are needed again
  std::array<std::vector<Left>, 2> left_;          ///< by side of the nodes: those that were moved, ascending by slot
};

}  // namespace

bool searches_both_sides(const ContactType& type) {
  return type.treatment == Treatment::two_way || (type.treatment != Treatment::single_surface && type.by_segments());
}

void find_penetrations(const InitialSearch& scene, ContactIndex contact, const ContactSurfaces& surfaces,
                       const Exclusions& exclusions, PenetrationList& list, std::vector<MovedInto>& moved_into) {
  SideSearch search(scene, contact, surfaces, exclusions, list);
  search.run(false);
  if (searches_both_sides(surfaces.type)) search.run(true);
  for (const bool exchanged : {false, true}) search.find_moved_into(exchanged, moved_into);
  list.sort_deepest_first();
}

}  // namespace gapcheck::contact
