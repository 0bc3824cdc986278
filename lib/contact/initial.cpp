#include "contact/initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/stopwatch.hpp"
#include "base/work_watch.hpp"
#include "contact/definition/exclusions.hpp"
#include "contact/definition/repeated_contacts.hpp"
#include "contact/edge/edge_pairs.hpp"
#include "contact/initial_penetrations.hpp"
#include "contact/present_surfaces.hpp"
#include "contact/search/nearest_boxes.hpp"

namespace gapcheck::contact {
namespace {

/// Many contacts that all name the nodes of a large mesh must not fill the memory with their lists.
constexpr std::size_t judged_limit = 20'000'000;

std::unique_ptr<CandidateSearch> search_by_options(const InitialOptions& options, SearchTally& tally) {
  if (options.brute_force) return make_counted_search(SearchKind::brute_force, tally);
  return options.search ? make_counted_search(*options.search, tally) : make_chosen_search(tally);
}

bool is_searched(const ContactType& type, const InitialOptions& options) {
  if (type.pairing == Pairing::segments) return options.segments;
  return type.pairing == Pairing::mortar ? options.mortar : type.checked();
}

ContactSummary summary_of(const model::Contact& contact, const ContactType& type) {
  ContactSummary s;
  s.id = contact.id.value;
  s.order = contact.order;
  s.title = contact.title;
  s.keyword = contact.keyword;
  s.type = type.printed();
  s.not_checked = type.not_checked;
  s.line = contact.place.line;
  return s;
}

/// How many nodes and segments are searched.
void count_surfaces(const ContactSurfaces& sides, ContactSummary& summary) {
  const ContactSide &a = sides.a, &b = sides.b;
  summary.tracked_nodes = a.nodes.size();
  summary.segments =
      sides.two_sided() ? b.selection.segments.size() : a.selection.segments.size() - (sides.type.edges ? 0 : a.lines);
  if (!searches_both_sides(sides.type)) return;
  summary.tracked_nodes += b.nodes.size();
  summary.segments += a.selection.segments.size();
}

/// What a search counts besides its own work.
struct FoundCounts {
  std::uint64_t crowded_nodes = 0, crowded_edges = 0, tied_pairs = 0, excluded_pairs = 0;

  FoundCounts() = default;
  explicit FoundCounts(const InitialCounters& counters)
      : crowded_nodes(counters.sweep.crowded_nodes),
        crowded_edges(counters.sweep.crowded_edges),
        tied_pairs(counters.tied_pairs),
        excluded_pairs(counters.excluded_pairs) {}
  [[nodiscard]] FoundCounts operator-(const FoundCounts& before) const {
    FoundCounts since = *this;
    since.crowded_nodes -= before.crowded_nodes;
    since.crowded_edges -= before.crowded_edges;
    since.tied_pairs -= before.tied_pairs;
    since.excluded_pairs -= before.excluded_pairs;
    return since;
  }
  void add_to(InitialCounters& counters) const {
    counters.sweep.crowded_nodes += crowded_nodes;
    counters.sweep.crowded_edges += crowded_edges;
    counters.tied_pairs += tied_pairs;
    counters.excluded_pairs += excluded_pairs;
  }
};

/// Takes the contacts one after the other and keeps the books.
class Initialiser {
 public:
  Initialiser(const model::Model& model, SurfaceStore& surfaces, const InitialOptions& options,
              InitialCounters& counters, InitialState& state)
      : model_(model),
        options_(options),
        counters_(counters),
        state_(state),
        search_(search_by_options(options, counters.searches_by_kind)),
        ties_(model),
        present_(surfaces, state.x, counters),
        first_(repeated_contacts(model)),
        chosen_(options.contacts) {
    std::sort(chosen_.begin(), chosen_.end());
    for (const ContactIndex first : first_)
      if (first != none<ContactIndex>) found_.try_emplace(first);
  }

  void run() {
    state_.contacts.reserve(model_.contacts.size());
    for (const ContactIndex c : positions<ContactIndex>(model_.contacts.size())) {
      const model::Contact& contact = model_.contact(c);
      const ContactType type = classify(contact);
      state_.contacts.push_back(summary_of(contact, type));
      if (work_stopped()) continue;
      const SweepCounters before = counters_.sweep;
      if (!chosen_.empty() && !std::binary_search(chosen_.begin(), chosen_.end(), contact.id.value))
        state_.contacts.back().not_checked = "not selected";
      else if (type.family == Family::tied)
        tie_nodes(c);
      else if (!options_.repeated && first_[c.value] != none<ContactIndex>)
        leave_out(c);
      else if (is_searched(type, options_))
        list_penetrations(c);
      else if (type.can(Ability::interference) && options_.overlaps)
        list_overlaps(c);
      count_searches_since(before);
      note_crowd_since(c, before);
    }
    if (left_out_ > 0)
      state_.notes.push_back(
          fmt::format("{} contacts have the same cards as an earlier one, contact {} for instance; "
                      "they find the same nodes, which are counted once",
                      left_out_, example_));
  }

 private:
  void tie_nodes(ContactIndex c) {
    const ContactSurfaces& sides = present_.at(c);
    state_.contacts[c.value].not_checked.clear();
    report_empty(c, sides);
    state_.contacts[c.value].ties_judged = state_.contacts[c.value].not_checked.empty();
    const Stopwatch watch(counters_.search_s);
    const TieScene scene{model_, *search_, options_.mode, counters_.sweep, counters_.decisions};
    const TieResult result = present_.tie(scene, c, sides, ties_);
    ContactSummary& summary = state_.contacts[c.value];
    summary.tracked_nodes = result.nodes;
    summary.segments = result.segments;
    summary.ties = result.tied;
    summary.untied = static_cast<std::uint64_t>(
        std::count_if(result.judged.begin(), result.judged.end(), [](const JudgedNode& node) { return !node.tied(); }));
    summary.out_of_reach = result.out_of_reach.size();
    for (const NodeIndex n : result.out_of_reach) summary.nodes_out_of_reach.push_back(model_.mesh.nodes.id[n.value]);
    std::sort(summary.nodes_out_of_reach.begin(), summary.nodes_out_of_reach.end());
    counters_.tied_nodes += result.tied;
    if (result.judged.size() > judged_limit - state_.judged.size())
      note(c, fmt::format("its {} tied and untied nodes are counted, not listed", result.judged.size()));
    else
      state_.judged.insert(state_.judged.end(), result.judged.begin(), result.judged.end());
  }

  void leave_out(ContactIndex c) {
    const std::int64_t id = model_.contact(c).id.value;
    if (left_out_++ == 0) example_ = id;
    state_.contacts[c.value].not_checked =
        fmt::format("it repeats contact {}", model_.contact(first_[c.value]).id.value);
  }

  void list_penetrations(ContactIndex c) {
    const ContactSurfaces& sides = present_.at(c);
    const Exclusions exclusions(model_, model_.contact(c).id);
    if (!exclusions.not_honoured().empty()) state_.notes.push_back(exclusions.not_honoured());
    ContactSummary& summary = state_.contacts[c.value];
    summary.not_checked.clear();
    summary.by_segments = sides.type.by_segments();
    report_empty(c, sides);
    const std::int64_t depth = model_.contact(c).depth;
    if (sides.type.pairing == Pairing::segments && depth % 10 == 5)
      note(c, fmt::format("DEPTH = {} also holds edges against edges, which was not done", depth));
    count_surfaces(sides, summary);
    PenetrationList list(state_.penetrations);
    if (!repeat_penetrations(c, list)) search_penetrations(c, sides, exclusions, list);
    for (const Penetration& p : list.records()) count(p, summary);
    if (state_.penetrations.size() > options_.most_listed) list_fewer(c, list.records().size());
  }

  /// What the first of several equal contacts has found, or the last of them that was searched.
  struct Found {
    std::optional<std::uint64_t> moves;  ///< PresentSurfaces::moves() before the search; nothing: not known
    std::size_t ties = 0;                ///< tied pairs then
    std::size_t begin = 0, end = 0;      ///< in InitialState::penetrations
    FoundCounts counts;
  };

  void search_penetrations(ContactIndex c, const ContactSurfaces& sides, const Exclusions& exclusions,
                           PenetrationList& list) {
    const std::size_t begin = state_.penetrations.size();
    const FoundCounts before(counters_);
    const std::uint64_t moves = present_.moves();
    find_penetrations({model_, options_, *search_, ties_, present_, counters_}, c, sides, exclusions, list,
                      state_.moved_into);
    if (const auto found = found_of(c); found != found_.end())
      found->second = {moves, ties_.size(), begin, state_.penetrations.size(), FoundCounts(counters_) - before};
  }

  [[nodiscard]] std::map<ContactIndex, Found>::iterator found_of(ContactIndex c) {
    const ContactIndex first = first_[c.value];
    return found_.find(first == none<ContactIndex> ? c : first);
  }

  /// Lists what a contact with the same cards has found, if neither nodes nor ties have changed since it was searched.
  bool repeat_penetrations(ContactIndex c, PenetrationList& list) {
    const auto known = found_of(c);
    if (known == found_.end() || known->second.moves != present_.moves() || known->second.ties != ties_.size())
      return false;
    const Found& found = known->second;
    const std::span<Penetration> records = list.add(found.end - found.begin);
    for (std::size_t i = 0; i < records.size(); ++i) {
      records[i] = state_.penetrations[found.begin + i];
      records[i].contact = c.value;
    }
    found.counts.add_to(counters_);
    return true;
  }

  /// Drops the shallowest of a contact's penetrations, which are the last ones.
  void list_fewer(ContactIndex c, std::size_t found) {
    ContactSummary& summary = state_.contacts[c.value];
    summary.reported_penetrations = summary.penetrations + summary.released;
    const std::size_t before = state_.penetrations.size() - found;
    state_.penetrations.resize(std::max(before, options_.most_listed));
    for (auto& known : found_) known.second.moves.reset();
    note(c, fmt::format("of its {} penetrations the {} deepest are listed, since all contacts have more than {}; the "
                        "others are counted",
                        found, state_.penetrations.size() - before, options_.most_listed));
  }

  /// The nodes stay: the solver lets the overlap grow from nothing (contact rules, section 7).
  void list_overlaps(ContactIndex c) {
    const ContactSurfaces& sides = present_.at(c);
    report_empty(c, sides);
    InitialOptions options = options_;
    options.nodes_stay = true;
    std::vector<MovedInto> nothing;
    PenetrationList list(state_.overlaps);
    find_penetrations({model_, options, *search_, ties_, present_, counters_}, c, sides,
                      Exclusions(model_, model_.contact(c).id), list, nothing);
  }

  void report_empty(ContactIndex c, const ContactSurfaces& surfaces) {
    const auto report = [&](char side, const Selection& selection) {
      if (!selection.empty_reason.empty())
        state_.contacts[c.value].not_checked = fmt::format("surface {} is empty: {}", side, selection.empty_reason);
      if (!selection.note.empty()) note(c, selection.note);
    };
    report('A', surfaces.a.selection);
    report('B', surfaces.b.selection);
  }

  void note(ContactIndex c, const std::string& text) {
    state_.notes.push_back(fmt::format("contact {}: {}", model_.contact(c).id.value, text));
  }

  /// `before`: the counts before this contact.
  void count_searches_since(const SweepCounters& before) {
    const std::uint64_t searches = counters_.sweep.searches - before.searches;
    if (searches == 0) return;
    ++counters_.contacts_searched;
    if (counters_.sweep.searches_culled - before.searches_culled == searches) ++counters_.contacts_culled;
  }

  void note_crowd_since(ContactIndex c, const SweepCounters& before) {
    const std::uint64_t nodes = counters_.sweep.crowded_nodes - before.crowded_nodes;
    const std::uint64_t edges = counters_.sweep.crowded_edges - before.crowded_edges;
    state_.contacts[c.value].judged_nearest = nodes + edges;
    const auto say = [&](std::uint64_t count, const char* what, const char* others, std::uint32_t most) {
      if (count > 0)
        note(c, fmt::format("{} {} are within the contact distance of more than {:g} {} each on average; each was "
                            "compared to the {} nearest only: reduce the contact thickness to less than an element",
                            count, what, crowd_pairs_each, others, most));
    };
    say(nodes, "nodes", "segments", most_candidates);
    say(edges, "edges", "others", most_edges_each);
  }

  const model::Model& model_;
  const InitialOptions& options_;
  InitialCounters& counters_;
  InitialState& state_;
  std::unique_ptr<CandidateSearch> search_;
  TiedPairs ties_;
  PresentSurfaces present_;
  std::vector<ContactIndex> first_;      ///< by contact, that which it repeats
  std::vector<std::int64_t> chosen_;     ///< ids, ascending; empty: all
  std::map<ContactIndex, Found> found_;  ///< by the first of equal contacts
  std::size_t left_out_ = 0;
  std::int64_t example_ = 0;  ///< id of the first one left out
};

}  // namespace

InitialState initialise_contacts(const model::Model& model, SurfaceStore& surfaces, const InitialOptions& options,
                                 InitialCounters& counters) {
  InitialState state;
  state.x = model.mesh.nodes.x;
  Initialiser(model, surfaces, options, counters, state).run();
  return state;
}

}  // namespace gapcheck::contact
