#include "audit/ignores.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <string_view>
#include <tuple>
#include <unordered_map>

#include "audit/audit.hpp"
#include "audit/ignore_comment.hpp"
#include "audit/registry.hpp"
#include "base/path_pattern.hpp"

namespace gapcheck::audit {
namespace {

constexpr std::uint32_t none_of_them = 0xffffffffU;

/// What ignores look at, of every finding alike.
struct Fact {
  std::uint32_t rule = none_of_them;  ///< position in rules()
  std::uint32_t source = none_of_them;
  std::int64_t contact = 0, node = 0, part = 0, element_part = 0, element = 0;
  double penetration = -1, contact_distance = -1;
  const std::string* file = nullptr;
};

std::vector<Fact> facts_of(const Report& report) {
  std::unordered_map<std::string_view, std::uint32_t> rule_of;
  for (std::uint32_t i = 0; i < rules().size(); ++i) rule_of.emplace(rules()[i].id, i);
  const auto rule = [&](std::string_view id) {
    const auto found = rule_of.find(id);
    return found == rule_of.end() || rules()[found->second].of_ignores ? none_of_them : found->second;
  };
  const auto file = [&](std::uint32_t position, std::uint32_t line) {
    return line != 0 && position < report.files.size() ? &report.files[position] : nullptr;
  };
  std::array<std::uint32_t, penetration_kinds> rule_of_kind{};
  for (std::size_t kind = 0; kind < penetration_kinds; ++kind)
    rule_of_kind[kind] = rule(rule_id(static_cast<PenetrationKind>(kind)));
  std::vector<Fact> facts;
  facts.reserve(report.penetrations.size() + report.tie_failures.size() + report.findings.size());
  for (const Penetration& p : report.penetrations)
    facts.push_back({rule_of_kind[static_cast<std::size_t>(p.kind)], none_of_them, report.contacts[p.contact].id, p.node,
                     p.part, p.element_part, p.element, p.depth, p.contact_distance, file(p.file, p.line)});
  for (const TieFailure& t : report.tie_failures)
    facts.push_back({rule(rule_id(t.reason)), none_of_them, report.contacts[t.contact].id, t.node, t.part, 0, 0, -1, -1,
                     file(t.file, t.line)});
  for (const Finding& f : report.findings)
    facts.push_back({rule(f.id), none_of_them, f.contact, f.node, f.part, f.element_part, f.element, f.penetration,
                     f.contact_distance, f.file.empty() ? nullptr : &f.file});
  return facts;
}

/// Sorts ranges and joins those that touch.
void join(std::vector<IdRange>& ranges) {
  std::sort(ranges.begin(), ranges.end(), [](const IdRange& a, const IdRange& b) { return a.first < b.first; });
  std::size_t kept = 0;
  for (const IdRange& range : ranges) {
    if (kept > 0 && range.first <= ranges[kept - 1].last)
      ranges[kept - 1].last = std::max(ranges[kept - 1].last, range.last);
    else
      ranges[kept++] = range;
  }
  ranges.resize(kept);
}

/// Ids of 0 are none, and in no range.
bool holds(const std::vector<IdRange>& ranges, std::int64_t id) {
  const auto behind = std::upper_bound(ranges.begin(), ranges.end(), id,
                                       [](std::int64_t value, const IdRange& range) { return value < range.first; });
  return id != 0 && behind != ranges.begin() && id <= std::prev(behind)->last;
}

/// Findings by one kind of id, so that an ignore with ids does not look at all of them.
class IdIndex {
 public:
  void add(std::int64_t id, std::uint32_t fact) {
    if (id != 0) entries_.emplace_back(id, fact);
  }
  void finish() { std::sort(entries_.begin(), entries_.end()); }
  /// Calls visit(fact) for everything with an id of the ranges; what has two of them may come twice.
  template <class Visit>
  void each(const std::vector<IdRange>& ranges, const Visit& visit) const {
    for (const IdRange& range : ranges)
      for (auto entry = std::lower_bound(entries_.begin(), entries_.end(), std::pair(range.first, std::uint32_t{0}));
           entry != entries_.end() && entry->first <= range.last; ++entry)
        visit(entry->second);
  }

 private:
  std::vector<std::pair<std::int64_t, std::uint32_t>> entries_;
};

/// The rules that lists of ids, names and beginnings pick; a deck may have the same list in every comment.
class RuleLists {
 public:
  /// By position in rules(). Lives as long as the lists.
  const std::vector<bool>& of(const std::vector<std::string>& patterns) {
    const auto [known, is_new] = known_.try_emplace(patterns);
    if (is_new)
      for (const RuleInfo& rule : rules()) known->second.push_back(!patterns.empty() && selected(rule, patterns, {}));
    return known->second;
  }

 private:
  std::map<std::vector<std::string>, std::vector<bool>> known_;
};

/// One demand with everything looked up that can be looked up once.
class Demand {
 public:
  Demand(IgnoreEntry entry, RuleLists& lists) : entry_(std::move(entry)), of_rule_(&lists.of(entry_.rules)) {
    for (std::vector<IdRange>* ids : {&entry_.contacts, &entry_.nodes, &entry_.parts, &entry_.elements}) join(*ids);
    if (!entry_.files.empty()) base_ = absolute(entry_.base);
  }
  [[nodiscard]] const IgnoreEntry& entry() const { return entry_; }

  [[nodiscard]] bool matches(const Fact& fact) {
    const auto lets = [](const std::vector<IdRange>& ids, std::int64_t id) { return ids.empty() || holds(ids, id); };
    return fact.rule != none_of_them && (*of_rule_)[fact.rule] && lets(entry_.contacts, fact.contact) &&
           lets(entry_.nodes, fact.node) && lets(entry_.elements, fact.element) &&
           (lets(entry_.parts, fact.part) || lets(entry_.parts, fact.element_part)) && shallow(fact) && in_files(fact);
  }

  /// True if everything that the demand could match was looked for.
  [[nodiscard]] bool tried(const AuditOptions& options) const {
    if (!options.parts.empty() || options.ptol >= 0 || options.rtol >= 0 || options.ratio >= 0) return false;
    const auto looked_at = [&](const IdRange& range) {
      return range.first == range.last &&
             std::find(options.contacts.begin(), options.contacts.end(), range.first) != options.contacts.end();
    };
    if (!options.contacts.empty() && (entry_.contacts.empty() || !std::all_of(entry_.contacts.begin(),
                                                                              entry_.contacts.end(), looked_at)))
      return false;
    for (std::size_t i = 0; i < rules().size(); ++i)
      if ((*of_rule_)[i] && !rules()[i].of_runs && !selected(rules()[i], options.select, options.ignore)) return false;
    return true;
  }

 private:
  static std::filesystem::path absolute(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path full = std::filesystem::absolute(path, error);
    return (error ? path : full).lexically_normal();
  }

  [[nodiscard]] bool shallow(const Fact& fact) const {
    if (entry_.ptol >= 0 && !(fact.penetration >= 0 && fact.penetration <= entry_.ptol)) return false;
    return entry_.ratio < 0 || (fact.penetration >= 0 && fact.contact_distance > 0 &&
                                fact.penetration <= entry_.ratio * fact.contact_distance);
  }

  bool in_files(const Fact& fact) {
    if (entry_.files.empty()) return true;
    if (fact.file == nullptr) return false;
    const auto [known, is_new] = of_file_.try_emplace(*fact.file, false);
    if (is_new)
      known->second =
          gapcheck::matches(entry_.files, absolute(*fact.file).lexically_relative(base_).generic_string());
    return known->second;
  }

  IgnoreEntry entry_;
  const std::vector<bool>* of_rule_;
  std::filesystem::path base_;
  std::unordered_map<std::string, bool> of_file_;
};

/// All demands that stand in one place and say the same: a comment in a file that is included several times, an entry of
/// settings for several files.
struct Place {
  std::vector<Demand> demands;
  bool in_deck = true;
};

/// The ids of a comment as the model has them. What moves beyond all ids matches nothing.
void move_ids(std::vector<IdRange>& ids, std::int64_t offset) {
  constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  std::erase_if(ids, [&](const IdRange& range) { return offset > 0 && range.first > largest - offset; });
  for (IdRange& range : ids) {
    range.first += offset;
    range.last = offset > 0 && range.last > largest - offset ? largest : range.last + offset;
  }
}

std::string rules_of(const IgnoreEntry& entry) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(entry.rules.size(), most); ++i) text += (i > 0 ? ", " : "") + entry.rules[i];
  return entry.rules.size() > most ? text + ", …" : text;
}

/// What a reader of an entry sees of it, but for its ids, which offsets change.
std::string words_of(const IgnoreEntry& entry) {
  std::string text = fmt::format("{}|", entry.until ? std::chrono::sys_days(*entry.until).time_since_epoch().count() : 0);
  for (const std::string& rule : entry.rules) text += rule + ",";
  return text + "|" + entry.reason;
}

/// What decides on the findings that the demands match.
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
    const auto [known, is_new] = position_.try_emplace({entry.file, entry.line, words_of(entry)}, places_.size());
    if (is_new) places_.push_back({{}, in_deck});
    places_[known->second].demands.emplace_back(std::move(entry), lists_);
  }
  [[nodiscard]] bool expired(const IgnoreEntry& entry) const {
    return entry.until && options_.today != std::chrono::sys_days{} && std::chrono::sys_days(*entry.until) < options_.today;
  }
  void index();
  std::vector<std::uint32_t> matched(Place& place) const;
  [[nodiscard]] bool tried(const Place& place) const;
  void claim(const std::vector<std::uint32_t>& found, IgnoreSource source);
  void leave_out();

  Report& report_;
  const AuditOptions& options_;
  std::map<std::tuple<std::string, std::uint32_t, std::string>, std::size_t> position_;
  RuleLists lists_;
  std::vector<Place> places_;
  std::vector<Fact> facts_;
  IdIndex by_contact_, by_node_, by_part_, by_element_;
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
      if (before > 0 && ids.empty()) ids.push_back({0, 0});  // an empty list would let everything through
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
    by_contact_.add(fact.contact, i);
    by_node_.add(fact.node, i);
    by_part_.add(fact.part, i);
    if (fact.element_part != fact.part) by_part_.add(fact.element_part, i);
    by_element_.add(fact.element, i);
  }
  for (IdIndex* ids : {&by_contact_, &by_node_, &by_part_, &by_element_}) ids->finish();
}

/// The findings that the demands of a place match, ascending.
std::vector<std::uint32_t> Engine::matched(Place& place) const {
  std::vector<std::uint32_t> found;
  for (Demand& demand : place.demands) {
    const IgnoreEntry& entry = demand.entry();
    const auto check = [&](std::uint32_t i) {
      if (demand.matches(facts_[i])) found.push_back(i);
    };
    if (!entry.nodes.empty()) {
      by_node_.each(entry.nodes, check);
    } else if (!entry.elements.empty()) {
      by_element_.each(entry.elements, check);
    } else if (!entry.parts.empty()) {
      by_part_.each(entry.parts, check);
    } else if (!entry.contacts.empty()) {
      by_contact_.each(entry.contacts, check);
    } else {
      for (std::uint32_t i = 0; i < facts_.size(); ++i) check(i);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

IgnoreOutcome Engine::run() {
  for (const IgnoreEntry& entry : options_.ignores) add(entry, false);
  if (places_.empty()) return std::move(outcome_);
  index();
  // The same demand a second time finds nothing more; a deck may have the same comment everywhere.
  std::unordered_map<std::string, std::uint64_t> known;
  for (Place& place : places_) {
    const IgnoreEntry& entry = place.demands.front().entry();
    const auto [count, is_new] = known.try_emplace((expired(entry) ? "x" : "") + conditions_of(place), 0);
    const std::vector<std::uint32_t> found = is_new ? matched(place) : std::vector<std::uint32_t>{};
    if (is_new) count->second = found.size();
    if (expired(entry)) {
      outcome_.expired.push_back({entry.file, entry.line, rules_of(entry), entry.until, count->second});
      continue;
    }
    // Settings hold for many decks.
    if (place.in_deck && count->second == 0 && tried(place))
      outcome_.unused.push_back({entry.file, entry.line, rules_of(entry), entry.until, 0});
    claim(found, {entry.file, entry.line, entry.reason, place.in_deck, 0});
  }
  leave_out();
  return std::move(outcome_);
}

bool Engine::tried(const Place& place) const {
  return std::all_of(place.demands.begin(), place.demands.end(),
                     [&](const Demand& demand) { return demand.tried(options_); });
}

/// Gives the findings to the source, but for those that another one has.
void Engine::claim(const std::vector<std::uint32_t>& found, IgnoreSource source) {
  for (const std::uint32_t i : found) {
    if (facts_[i].source != none_of_them) continue;
    facts_[i].source = static_cast<std::uint32_t>(report_.ignored.sources.size());
    ++source.matched;
  }
  if (source.matched > 0) report_.ignored.sources.push_back(std::move(source));
}

/// Moves what has found its source out of the report.
void Engine::leave_out() {
  Ignored& ignored = report_.ignored;
  std::size_t number = 0;
  const auto move_out = [&](auto& list, auto& out) {
    std::size_t kept = 0;
    for (auto& record : list) {
      const std::uint32_t source = facts_[number++].source;
      if (source != none_of_them) {
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
