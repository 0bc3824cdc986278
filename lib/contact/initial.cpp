#include "contact/initial.hpp"

#include <fmt/format.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "contact/edge/edge_pairs.hpp"
#include "contact/definition/exclusions.hpp"
#include "contact/mesh/faces.hpp"
#include "contact/pair/orientation.hpp"
#include "contact/definition/outcome.hpp"
#include "contact/pair/pair_rules.hpp"
#include "contact/pair/release.hpp"
#include "contact/pair/side_scene.hpp"

namespace gapcheck::contact {
namespace {

/// Many contacts that all name the nodes of a large mesh must not fill the memory with their lists.
constexpr std::size_t judged_limit = 20'000'000;

/// Coordinates are written with some eight digits: facets of solids that touch, as those of press fits and bolts do, seem
/// to penetrate by this share of their size.
constexpr double written_digits = 1e-6;

/// True if a facet without thickness is penetrated by no more than the digits of the deck can tell.
bool only_touches(const PairScene& scene, const Hit& hit) {
  const double h = scene.nodes.half[hit.slot] + scene.segments.half[hit.segment];
  return h == 0 && scene.tolerance < 0 && -hit.distance <= written_digits * min_diagonal(scene.facet(hit.segment));
}

std::unique_ptr<CandidateSearch> search_by_options(const InitialOptions& options, SearchTally& tally) {
  if (options.brute_force) return make_counted_search(SearchKind::brute_force, tally);
  return options.search ? make_counted_search(*options.search, tally) : make_chosen_search(tally);
}

class Initialiser {
 public:
  Initialiser(const model::Model& model, SurfaceStore& surfaces, const InitialOptions& options,
              InitialCounters& counters, InitialState& state)
      : model_(model),
        store_(surfaces),
        options_(options),
        counters_(counters),
        state_(state),
        search_(search_by_options(options, counters.searches_by_kind)),
        ties_(model) {}

  void run() {
    state_.x = model_.mesh.nodes.x;
    for (std::uint32_t c = 0; c < model_.contacts.size(); ++c) {
      const model::Contact& contact = model_.contacts[c];
      const ContactType type = classify(contact);
      state_.contacts.push_back(summary(contact, type));
      const SweepCounters before = counters_.sweep;
      if (!chosen(contact))
        state_.contacts.back().not_checked = "not selected";
      else if (type.family == Family::tied)
        tie(c);
      else if (wanted(type))
        check(c);
      count_contact(before);
    }
  }

 private:
  /// `before`: what had been counted before the contact's turn.
  void count_contact(const SweepCounters& before) {
    const std::uint64_t searches = counters_.sweep.searches - before.searches;
    if (searches == 0) return;
    ++counters_.contacts_searched;
    if (counters_.sweep.searches_culled - before.searches_culled == searches) ++counters_.contacts_culled;
  }

  [[nodiscard]] bool chosen(const model::Contact& contact) const {
    return options_.contacts.empty() ||
           std::find(options_.contacts.begin(), options_.contacts.end(), contact.id.value) != options_.contacts.end();
  }

  [[nodiscard]] bool wanted(const ContactType& type) const {
    if (type.pairing == Pairing::segments) return options_.segments;
    return type.pairing == Pairing::mortar ? options_.mortar : type.checked();
  }

  static ContactSummary summary(const model::Contact& contact, const ContactType& type) {
    ContactSummary s;
    s.id = contact.id.value;
    s.order = contact.order;
    s.title = contact.title;
    s.keyword = contact.keyword;
    s.type = type.code;
    s.not_checked = type.not_checked;
    s.line = contact.place.line;
    return s;
  }

  void tie(std::uint32_t c) {
    const ContactSurfaces& sides = surfaces(c);
    report_empty(c, sides);
    const Stopwatch watch(counters_.search_s);
    const TieScene scene{model_, *search_, options_.mode, counters_.sweep, counters_.decisions};
    const TieResult result = apply_ties(scene, c, sides, state_.x, ties_);
    moved_ = moved_ || result.moved > 0;
    ContactSummary& summary = state_.contacts[c];
    summary.tracked_nodes = result.nodes;
    summary.segments = result.segments;
    summary.ties = result.tied;
    summary.untied = static_cast<std::uint64_t>(
        std::count_if(result.judged.begin(), result.judged.end(), [](const JudgedNode& node) { return !node.tied(); }));
    summary.out_of_reach = result.out_of_reach;
    counters_.tied_nodes += result.tied;
    if (result.judged.size() > judged_limit - state_.judged.size()) {
      state_.notes.push_back(fmt::format("contact {}: its {} tied and untied nodes are counted, not listed",
                                         model_.contacts[c].id.value, result.judged.size()));
      return;
    }
    state_.judged.insert(state_.judged.end(), result.judged.begin(), result.judged.end());
  }

  void report_empty(std::uint32_t c, const ContactSurfaces& surfaces) {
    const auto report = [&](char side, const Selection& selection) {
      if (!selection.empty_reason.empty())
        state_.contacts[c].not_checked = fmt::format("surface {} is empty: {}", side, selection.empty_reason);
      if (!selection.note.empty())
        state_.notes.push_back(fmt::format("contact {}: {}", model_.contacts[c].id.value, selection.note));
    };
    report('A', surfaces.a.selection);
    report('B', surfaces.b.selection);
  }

  /// The surfaces of a contact on the present coordinates; valid until the next call.
  const ContactSurfaces& surfaces(std::uint32_t c) {
    if (!moved_) return store_.at(c);
    const Stopwatch watch(counters_.surface_s);
    ++counters_.surfaces_built;
    return own_.emplace(store_.build(c, state_.x));
  }

  void check(std::uint32_t c) {
    const ContactSurfaces& sides = surfaces(c);
    const ContactType& type = sides.type;
    const Exclusions exclusions(model_, model_.contacts[c].id);
    if (!exclusions.not_honoured().empty()) state_.notes.push_back(exclusions.not_honoured());
    ContactSummary& summary = state_.contacts[c];
    summary.not_checked.clear();
    summary.by_segments = type.by_segments();
    report_empty(c, sides);
    const std::int64_t depth = model_.contacts[c].depth;
    if (type.pairing == Pairing::segments && depth % 10 == 5)
      state_.notes.push_back(fmt::format("contact {}: DEPTH = {} also holds edges against edges, which was not done",
                                         model_.contacts[c].id.value, depth));
    const std::size_t first = state_.penetrations.size();
    const ContactSide &a = sides.a, &b = sides.b;
    summary.tracked_nodes = a.nodes.size();
    if (type.treatment == Treatment::single_surface) {
      summary.segments = a.selection.segments.size() - (type.edges ? 0 : a.lines);
      sweep(c, sides, exclusions, false, first);
    } else {
      summary.segments = b.selection.segments.size();
      sweep(c, sides, exclusions, false, first);
      if (type.treatment == Treatment::two_way || type.by_segments()) {
        summary.tracked_nodes += b.nodes.size();
        summary.segments += a.selection.segments.size();
        sweep(c, sides, exclusions, true, first);
      }
    }
    for (std::size_t i = first; i < state_.penetrations.size(); ++i) count(state_.penetrations[i], summary);
    sort_deepest_first(first);
  }

  /// `exchanged`: side B's nodes in side A's segments.
  void sweep(std::uint32_t c, const ContactSurfaces& sides, const Exclusions& exclusions, bool exchanged,
             std::size_t first_record) {
    const ContactType& type = sides.type;
    const TrackedNodes& nodes = (exchanged ? sides.b : sides.a).nodes;
    const ContactSide& reference = exchanged || !sides.two_sided() ? sides.a : sides.b;
    if (nodes.size() == 0 || reference.selection.segments.size() == 0) return;
    std::optional<SideScene> side;
    {
      const Stopwatch watch(counters_.surface_s);
      side.emplace(model_, c, sides, exchanged, state_.x);
    }
    PairScene& scene = side->scene();
    scene.tolerance = options_.tolerance;
    scene.mode = options_.mode;
    std::vector<Hit> hits;
    {
      const Stopwatch watch(counters_.search_s);
      scene.flipped = flipped_segments(scene, *search_);
      std::atomic<std::uint64_t> tied_pairs{0}, excluded{0};
      const PairRules rules(scene, side->tracked(), exclusions, ties_);
      const auto allowed = [&](std::uint32_t slot, std::uint32_t segment, bool penetrates) {
        const PairRule rule = rules(slot, segment);
        if (rule == PairRule::excluded) excluded += penetrates;
        if (rule == PairRule::tied) tied_pairs += penetrates;
        return rule == PairRule::counts;
      };
      hits = closest_segments(scene, *search_, allowed, counters_.sweep, counters_.decisions);
      counters_.tied_pairs += tied_pairs;
      counters_.excluded_pairs += excluded;
    }
    if (type.by_segments()) std::erase_if(hits, [&](const Hit& hit) { return !hit.in_band || only_touches(scene, hit); });
    one_record_per_node(hits, nodes, first_record);
    if (options_.edges && type.edges) check_edges(c, scene, exclusions);
    const std::size_t first = state_.penetrations.size();
    state_.penetrations.resize(first + hits.size());
    parallel_for(hits.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) state_.penetrations[first + i] = record(c, scene, hits[i]);
    });
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const Penetration& p = state_.penetrations[first + i];
      if (p.outcome != Outcome::moved || options_.nodes_stay) continue;
      state_.x[nodes.node[hits[i].slot].value] = p.moved_to;
      moved_ = true;
    }
  }

  /// A node that the first side has listed is not listed again; but a penetration replaces a note on the edge zone.
  void one_record_per_node(std::vector<Hit>& hits, const TrackedNodes& nodes, std::size_t first_record) {
    auto& all = state_.penetrations;
    if (all.size() == first_record) return;
    const auto id = [&](const Hit& hit) { return model_.mesh.nodes.id[nodes.node[hit.slot].value]; };
    std::unordered_map<std::int64_t, PenetrationKind> listed;
    for (std::size_t i = first_record; i < all.size(); ++i) listed.emplace(all[i].node, all[i].kind);
    std::unordered_set<std::int64_t> replaced;
    std::erase_if(hits, [&](const Hit& hit) {
      const auto found = listed.find(id(hit));
      if (found == listed.end()) return false;
      if (found->second != PenetrationKind::edge_zone || !hit.in_band) return true;
      replaced.insert(found->first);
      return false;
    });
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first_record);
    all.erase(std::remove_if(begin, all.end(), [&](const Penetration& p) { return replaced.contains(p.node); }), all.end());
  }

  void check_edges(std::uint32_t c, const PairScene& scene, const Exclusions& exclusions) {
    const Stopwatch watch(counters_.search_s);
    const std::vector<SurfaceEdge> edges = surface_edges(scene, scene.type.interior_edges);
    counters_.edges += edges.size();
    const BoxSearch search = options_.brute_force ? BoxSearch::brute_force : BoxSearch::tree;
    const auto hits = penetrating_edges(scene, edges, EdgeRules(scene, exclusions, ties_), search, counters_.decisions);
    const auto records = edge_records(scene, c, edges, hits);
    state_.penetrations.insert(state_.penetrations.end(), records.begin(), records.end());
  }

  Penetration record(std::uint32_t c, const PairScene& scene, const Hit& hit) const {
    const Segments& s = scene.segments;
    const model::Nodes& all = model_.mesh.nodes;
    const NodeIndex node = scene.nodes.node[hit.slot];
    const PairResult pair = measure_pair(scene, hit.slot, hit.segment);
    Penetration p;
    p.contact = c;
    p.segment_number = hit.segment + 1;
    p.node = all.id[node.value];
    if (const PartIndex part = scene.nodes.part[hit.slot]; part != none<PartIndex>) p.part = model_.part(part).id.value;
    for (std::size_t i = 0; i < 4; ++i) p.segment[i] = all.id[s.nodes[hit.segment][i].value];
    p.element = element_id(model_.mesh, s, hit.segment);
    if (const PartIndex part = part_of(model_.mesh, s, hit.segment); part != none<PartIndex>)
      p.element_part = model_.part(part).id.value;
    p.contact_distance = scene.nodes.half[hit.slot] + s.half[hit.segment];
    p.depth = p.contact_distance - pair.distance;
    p.s = pair.closest.s;
    p.t = pair.closest.t;
    p.original = scene.x[node.value];
    p.point = pair.closest.point;
    p.feature = pair.closest.feature;
    p.node_rule = scene.nodes.rule[hit.slot];
    p.segment_rule = s.rule[hit.segment];
    p.file = all.origins.file(node.value).value;
    p.line = all.line[node.value];
    decide_outcome(p, scene, hit, pair);
    return p;
  }

  void decide_outcome(Penetration& p, const PairScene& scene, const Hit& hit, const PairResult& pair) const {
    p.moved_to = p.original;
    if (scene.type.by_segments()) {
      // The state at the start is the one without force.
      p.kind = scene.type.pairing == Pairing::mortar ? PenetrationKind::mortar : PenetrationKind::segment;
      p.outcome = Outcome::kept;
      return;
    }
    if (!pair.in_band) {
      p.kind = PenetrationKind::edge_zone;
      p.outcome = Outcome::reported;
      return;
    }
    if (p.depth > release_depth(scene, hit.slot, hit.segment)) {
      p.kind = PenetrationKind::released;
      p.outcome = Outcome::released;
      return;
    }
    p.outcome = outcome(scene.settings);
    if (p.outcome == Outcome::moved)
      p.moved_to = p.original + shooting_move * p.depth * free_direction(scene, hit.slot, hit.segment, pair);
  }

  void sort_deepest_first(std::size_t first) {
    auto& all = state_.penetrations;
    const auto deeper = [](const Penetration& l, const Penetration& r) {
      return l.depth != r.depth ? l.depth > r.depth : l.node < r.node;
    };
    tbb::parallel_sort(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(), deeper);
  }

  const model::Model& model_;
  SurfaceStore& store_;
  const InitialOptions& options_;
  InitialCounters& counters_;
  InitialState& state_;
  std::unique_ptr<CandidateSearch> search_;
  TiedPairs ties_;
  bool moved_ = false;  ///< some node is no longer where the deck has it
  std::optional<ContactSurfaces> own_;
};

}  // namespace

InitialState initialise_contacts(const model::Model& model, SurfaceStore& surfaces, const InitialOptions& options,
                                 InitialCounters& counters) {
  InitialState state;
  Initialiser(model, surfaces, options, counters, state).run();
  return state;
}

}  // namespace gapcheck::contact
