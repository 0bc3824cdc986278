#include "audit/ignores.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string_view>
#include <tuple>
#include <unordered_map>

#include "audit/audit.hpp"
#include "audit/ignore_comment.hpp"
#include "audit/ignore_demand.hpp"
#include "audit/ignore_facts.hpp"

namespace gapcheck::audit {
namespace {

/// All demands in one place that say the same: a comment in a file that is included several times, an entry of settings
/// for several files.
struct Place {
  std::vector<Demand> demands;
  bool in_deck = true;
};

/// The ids of a comment in the model's numbering. Ids shifted out of range match nothing.
void move_ids(std::vector<IdRange>& ids, std::int64_t offset) {
  constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  std::erase_if(ids, [&](const IdRange& range) { return offset > 0 && range.first > largest - offset; });
  for (IdRange& range : ids) {
    range.first += offset;
    range.last = offset > 0 && range.last > largest - offset ? largest : range.last + offset;
  }
}

/// The rules of all demands, each once.
std::string rules_of(const Place& place) {
  constexpr std::size_t most = 5;
  std::vector<std::string_view> all;
  for (const Demand& demand : place.demands)
    for (const std::string& rule : demand.entry().rules)
      if (all.size() <= most && std::find(all.begin(), all.end(), rule) == all.end()) all.push_back(rule);
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), most); ++i) text += fmt::format("{}{}", i > 0 ? ", " : "", all[i]);
  return all.size() > most ? text + ", …" : text;
}

/// The visible text of an entry, except for its ids, which offsets change. One entry of settings may be several demands
/// of different rules.
std::string words_of(const IgnoreEntry& entry, bool in_deck) {
  std::string text =
      fmt::format("{}|", entry.until ? std::chrono::sys_days(*entry.until).time_since_epoch().count() : 0);
  if (in_deck)
    for (const std::string& rule : entry.rules) text += rule + ",";
  return text + "|" + entry.reason;
}

/// Decides on the findings that the demands match.
std::string conditions_of(const Place& place) {
  std::string text;
  for (const Demand& demand : place.demands) {
    const IgnoreEntry& e = demand.entry();
    for (const std::string& rule : e.rules) text += rule + ",";
    for (const std::vector<IdRange>* ids : {&e.contacts, &e.nodes, &e.parts, &e.elements}) {
      text += '|';
      for (const IdRange& range : *ids) text += fmt::format("{}-{},", range.first, range.last);
    }
    text += fmt::format("|{}|{}|{}|{}\n", e.files, e.base, e.ptol, e.ratio);
  }
  return text;
}

class Engine {
 public:
  Engine(Report& report, const AuditOptions& options) : report_(report), options_(options) {}

  void read(const keyword::Deck& deck);
  IgnoreOutcome run();

 private:
  void add(IgnoreEntry entry, bool in_deck) {
    const auto [known, is_new] =
        position_.try_emplace({entry.file, entry.line, words_of(entry, in_deck)}, places_.size());
    if (is_new) places_.push_back({{}, in_deck});
    places_[known->second].demands.emplace_back(std::move(entry), lists_);
  }
  void index();
  std::pair<FactIndex*, const std::vector<IdRange>*> index_for(const Demand& demand);
  void claim(Place& place, IgnoreSource source);
  bool matches_any(Place& place);
  std::uint64_t matched(Place& place);
  [[nodiscard]] bool tried(const Place& place) const;
  void leave_out();

  Report& report_;
  const AuditOptions& options_;
  std::map<std::tuple<std::string, std::uint32_t, std::string>, std::size_t> position_;
  RuleLists lists_;
  std::vector<Place> places_;
  std::vector<Fact> facts_;
  FactIndex all_{facts_}, by_contact_{facts_}, by_node_{facts_}, by_part_{facts_}, by_element_{facts_};
  IgnoreOutcome outcome_;
};

void Engine::read(const keyword::Deck& deck) {
  std::map<std::pair<std::string_view, std::uint32_t>, bool> bad;
  for (const keyword::Directive& directive : deck.directives()) {
    const std::string& file = deck.file(directive.file).path;
    IgnoreComment comment = read_ignore_comment(directive.text);
    if (!comment.entry) {
      if (bad.emplace(std::pair(std::string_view(file), directive.line), true).second)
        outcome_.bad.push_back({file, directive.line, std::move(comment.wrong)});
      continue;
    }
    IgnoreEntry& entry = *comment.entry;
    const auto move = [&](std::vector<IdRange>& ids, keyword::IdKind kind) {
      const std::size_t before = ids.size();
      move_ids(ids, deck.transform(directive.transform).offset[static_cast<std::size_t>(kind)]);
      if (before > 0 && ids.empty()) ids.push_back({0, 0});  // an empty list would match everything
    };
    move(entry.nodes, keyword::IdKind::node);
    move(entry.parts, keyword::IdKind::part);
    move(entry.elements, keyword::IdKind::element);
    move(entry.contacts, keyword::IdKind::other);
    entry.file = file;
    entry.line = directive.line;
    add(std::move(entry), true);
  }
}

void Engine::index() {
  facts_ = facts_of(report_);
  for (std::uint32_t i = 0; i < facts_.size(); ++i) {
    const Fact& fact = facts_[i];
    all_.add(1, i);
    by_contact_.add(fact.contact, i);
    by_node_.add(fact.node, i);
    by_part_.add(fact.part, i);
    if (fact.element_part != fact.part) by_part_.add(fact.element_part, i);
    by_element_.add(fact.element, i);
  }
  for (FactIndex* ids : {&all_, &by_contact_, &by_node_, &by_part_, &by_element_}) ids->finish();
}

/// The index in which the demand has the fewest findings to check, and what to look for there.
std::pair<FactIndex*, const std::vector<IdRange>*> Engine::index_for(const Demand& demand) {
  static const std::vector<IdRange> everything{{1, 1}};
  const IgnoreEntry& entry = demand.entry();
  std::pair<FactIndex*, const std::vector<IdRange>*> best{&all_, &everything};
  auto least = static_cast<std::size_t>(-1);
  for (const auto& [index, ids] : {std::pair(&by_node_, &entry.nodes), std::pair(&by_element_, &entry.elements),
                                   std::pair(&by_part_, &entry.parts), std::pair(&by_contact_, &entry.contacts)}) {
    if (ids->empty()) continue;
    if (const std::size_t count = index->count(demand.rules_wanted(), *ids); count < least)
      least = count, best = {index, ids};
  }
  return best;
}

/// Assigns the findings that the place matches to the source, except those that another one has.
void Engine::claim(Place& place, IgnoreSource source) {
  for (Demand& demand : place.demands) {
    const auto [index, ids] = index_for(demand);
    index->each_free(demand.rules_wanted(), *ids, [&](std::uint32_t i) {
      if (!demand.matches(facts_[i])) return;
      facts_[i].source = static_cast<std::uint32_t>(report_.ignored.sources.size());
      ++source.matched;
    });
  }
  if (source.matched > 0) report_.ignored.sources.push_back(std::move(source));
}

/// True if the place matches something, whoever has it.
bool Engine::matches_any(Place& place) {
  bool any = false;
  for (Demand& demand : place.demands) {
    const auto [index, ids] = index_for(demand);
    index->each(demand.rules_wanted(), *ids, [&](std::uint32_t i) { return any = demand.matches(facts_[i]), !any; });
    if (any) break;
  }
  return any;
}

/// Number of findings that the place matches, whoever has them.
std::uint64_t Engine::matched(Place& place) {
  std::vector<std::uint32_t> found;
  for (Demand& demand : place.demands) {
    const auto [index, ids] = index_for(demand);
    index->each(demand.rules_wanted(), *ids, [&](std::uint32_t i) {
      if (demand.matches(facts_[i])) found.push_back(i);
      return true;
    });
  }
  std::sort(found.begin(), found.end());
  return static_cast<std::uint64_t>(std::unique(found.begin(), found.end()) - found.begin());
}

IgnoreOutcome Engine::run() {
  for (const IgnoreEntry& entry : options_.ignores) add(entry, false);
  if (places_.empty()) return std::move(outcome_);
  index();
  // Repeating a demand finds nothing more; a deck may have the same comment everywhere.
  std::unordered_map<std::string, std::uint64_t> expired_matches;
  std::unordered_map<std::string, bool> unused;
  for (Place& place : places_) {
    const IgnoreEntry& entry = place.demands.front().entry();
    if (expired(entry, options_)) {
      const auto [count, is_new] = expired_matches.try_emplace(conditions_of(place), 0);
      if (is_new) count->second = matched(place);
      // Settings apply to many decks.
      if (place.in_deck || count->second > 0)
        outcome_.expired.push_back({entry.file, entry.line, rules_of(place), entry.until, count->second});
      continue;
    }
    const std::size_t sources = report_.ignored.sources.size();
    const auto [none, is_new] = unused.try_emplace(conditions_of(place), false);
    if (is_new) {
      claim(place, {entry.file, entry.line, entry.reason, place.in_deck, 0});
      none->second = report_.ignored.sources.size() == sources && tried(place) && !matches_any(place);
    }
    if (place.in_deck && none->second)
      outcome_.unused.push_back({entry.file, entry.line, rules_of(place), entry.until, 0});
  }
  leave_out();
  return std::move(outcome_);
}

bool Engine::tried(const Place& place) const {
  return std::all_of(place.demands.begin(), place.demands.end(),
                     [&](const Demand& demand) { return demand.tried(options_); });
}

/// Moves findings with a source out of the report.
void Engine::leave_out() {
  Ignored& ignored = report_.ignored;
  std::size_t number = 0;
  const auto move_out = [&](auto& list, auto& out) {
    std::size_t kept = 0;
    for (auto& record : list) {
      const std::uint32_t source = facts_[number++].source;
      if (source != no_position) {
        ignored.source.push_back(source);
        out.push_back(std::move(record));
      } else if (auto& place = list[kept++]; &place != &record) {
        place = std::move(record);
      }
    }
    list.resize(kept);
  };
  move_out(report_.penetrations, ignored.penetrations);
  move_out(report_.tie_failures, ignored.tie_failures);
  move_out(report_.findings, ignored.findings);
}

}  // namespace

IgnoreOutcome leave_out_ignored(Report& report, const keyword::Deck& deck, const AuditOptions& options) {
  Engine engine(report, options);
  engine.read(deck);
  return engine.run();
}

}  // namespace gapcheck::audit
