#include "report/baseline/baseline_match.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <tuple>
#include <utility>

#include "records/record_rules.hpp"
#include "report/item/nearest_points.hpp"

namespace gapcheck::report {
namespace {

using List = std::vector<KnownFinding>;
using Places = std::vector<std::uint32_t>;  // positions in a list

/// The text identifies it: there is no position, or it is one of many.
bool by_words(const KnownFinding& f) { return !f.position || f.count > 1; }

auto group_key(const KnownFinding& f) { return std::tuple(f.contact, degree_of(f.id).family); }

auto place_key(const KnownFinding& f) {
  const Vector x = f.position.value_or(Vector::Zero());
  return std::tuple(f.position.has_value(), x[0], x[1], x[2]);
}

/// Ascending by group, words before places, place; the deepest first.
Places sorted(const List& list) {
  Places order(list.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const KnownFinding &l = list[a], &r = list[b];
    if (group_key(l) != group_key(r)) return group_key(l) < group_key(r);
    if (place_key(l) != place_key(r)) return place_key(l) < place_key(r);
    return std::tuple(l.message, -l.penetration, a) < std::tuple(r.message, -r.penetration, b);
  });
  return order;
}

/// The diagonal of the box around all positions; 0: there are none.
double diagonal(const List& before, const List& now) {
  Vector low = Vector::Constant(HUGE_VAL), high = -low;
  for (const List* list : {&before, &now})
    for (const KnownFinding& f : *list)
      if (f.position) low = low.cwiseMin(*f.position), high = high.cwiseMax(*f.position);
  const double length = (high - low).norm();
  return std::isfinite(length) ? length : 0;
}

/// The findings of one contact and family without a match so far.
class Group {
 public:
  Group(const List& before, const List& now, double unknown_reach, Places& match)
      : before_(before), now_(now), widest_reach_(unknown_reach), match_(match), taken_(before.size()) {}

  /// `shown` come before `ignored`: only an entry in exactly the place of an ignored one is kept for it.
  void run(Places old, Places shown, Places ignored) {
    old_total_ = total(before_, old);
    const std::uint64_t all = total(now_, shown) + total(now_, ignored);
    counted_ = counts_rest(before_, old) || counts_rest(now_, shown) || counts_rest(now_, ignored);
    set_unknown_reach({{&before_, &old}, {&now_, &shown}, {&now_, &ignored}});
    old_ = std::move(old);
    in_one_place(shown);
    const std::uint64_t waiting = (in_one_place(ignored), total(now_, ignored));
    match_rest(std::move(shown), all - waiting);
    match_rest(std::move(ignored), all);
  }

 private:
  static std::uint64_t total(const List& list, const Places& places) {
    std::uint64_t sum = 0;
    for (const std::uint32_t i : places) sum += std::min(list[i].count, std::uint64_t{1} << 32);
    return sum;
  }
  static bool counts_rest(const List& list, const Places& places) {
    return std::any_of(places.begin(), places.end(), [&](std::uint32_t i) { return list[i].count > 1; });
  }

  /// Pairs findings in the same place or with the same text; `fresh` becomes the rest.
  void in_one_place(Places& fresh) {
    fresh_ = std::move(fresh);
    in_order([](const KnownFinding& f) { return std::tuple(place_key(f), by_words(f) ? f.message : std::string()); });
    fresh = std::move(fresh_);
  }

  /// `fresh_total`: number of things that the findings up to these represent.
  void match_rest(Places fresh, std::uint64_t fresh_total) {
    fresh_ = std::move(fresh);
    for (const double part : {1.0 / 16, 1.0 / 4, 1.0}) nearest(part);
    // Lines with the same count as before match first; then the largest ones.
    in_order([](const KnownFinding& f) { return std::tuple(without_numbers(f.message), f.count); }, true);
    for (auto& [list, places] : {std::pair(&before_, &old_), std::pair(&now_, &fresh_)})
      std::stable_sort(places->begin(), places->end(),
                       [list = list](std::uint32_t a, std::uint32_t b) { return (*list)[a].count > (*list)[b].count; });
    in_order([](const KnownFinding& f) { return without_numbers(f.message); }, true);
    if (counted_) as_totals_allow(fresh_total);
  }

  void pair(std::uint32_t old, std::uint32_t fresh) {
    match_[fresh] = old;
    taken_[old] = true;
  }

  /// Pairs findings of equal key one by one; `words_only`: those identified by their text.
  template <class Key>
  void in_order(const Key& key, bool words_only = false) {
    using Entry = std::pair<decltype(key(before_[0])), std::uint32_t>;
    const auto entries = [&](const List& list, const Places& places, Places& others) {
      std::vector<Entry> made;
      for (const std::uint32_t i : places) {
        if (words_only && !by_words(list[i]))
          others.push_back(i);
        else
          made.emplace_back(key(list[i]), i);
      }
      std::stable_sort(made.begin(), made.end(), [](const Entry& a, const Entry& b) { return a.first < b.first; });
      return made;
    };
    Places old_left, fresh_left;
    const auto old = entries(before_, old_, old_left), fresh = entries(now_, fresh_, fresh_left);
    std::size_t i = 0, k = 0;
    while (i < old.size() && k < fresh.size()) {
      if (old[i].first < fresh[k].first)
        old_left.push_back(old[i++].second);
      else if (fresh[k].first < old[i].first)
        fresh_left.push_back(fresh[k++].second);
      else
        pair(old[i++].second, fresh[k++].second);
    }
    for (; i < old.size(); ++i) old_left.push_back(old[i].second);
    for (; k < fresh.size(); ++k) fresh_left.push_back(fresh[k].second);
    old_ = std::move(old_left);
    fresh_ = std::move(fresh_left);
  }

  /// How far a finding may have moved.
  [[nodiscard]] double reach(const KnownFinding& f) const {
    if (f.contact_distance > 0) return f.contact_distance / 2;
    return f.segment_size > 0 ? share_of_segment * f.segment_size : unknown_reach_;
  }

  /// Unknown values of a tie are taken from the others of its contact.
  void set_unknown_reach(std::initializer_list<std::pair<const List*, const Places*>> all) {
    double widest = 0;
    for (const auto& [list, places] : all)
      for (const std::uint32_t i : *places) widest = std::max(widest, share_of_segment * (*list)[i].segment_size);
    unknown_reach_ = widest > 0 ? std::min(widest, widest_reach_) : widest_reach_;
  }

  static Places placed(const List& list, const Places& places) {
    Places some;
    for (const std::uint32_t i : places)
      if (!by_words(list[i])) some.push_back(i);
    return some;
  }

  static NearestPoints points(const List& list, const Places& places) {
    std::vector<NearestPoints::Point> points;
    for (const std::uint32_t i : places) points.emplace_back(*list[i].position, i);
    return NearestPoints(std::move(points));
  }

  /// Pairs findings nearest to each other within `part` of the reach of either, the closest pairs first.
  void nearest(double part) {
    constexpr std::size_t few = 8;
    const Places old = placed(before_, old_), fresh = placed(now_, fresh_);
    if (old.empty() || fresh.empty()) return;
    const NearestPoints old_points = points(before_, old), fresh_points = points(now_, fresh);
    std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> pairs;  // distance, fresh, old
    std::vector<std::pair<double, std::uint32_t>> found;
    for (const std::uint32_t k : fresh) {
      old_points.nearest(*now_[k].position, part * reach(now_[k]), few, found);
      for (const auto& [distance, i] : found) pairs.emplace_back(distance, k, i);
    }
    for (const std::uint32_t i : old) {
      fresh_points.nearest(*before_[i].position, part * reach(before_[i]), few, found);
      for (const auto& [distance, k] : found) pairs.emplace_back(distance, k, i);
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [distance, k, i] : pairs) {
      if (match_[k] == unmatched && !taken_[i]) pair(i, k);
    }
    std::erase_if(fresh_, [&](std::uint32_t k) { return match_[k] != unmatched; });
    std::erase_if(old_, [&](std::uint32_t i) { return taken_[i]; });
  }

  /// Only the first of many are listed and the rest are counted, so it does not matter which ones are listed.
  void as_totals_allow(std::uint64_t fresh_total) {
    const std::size_t more = fresh_total > old_total_ ? fresh_total - old_total_ : 0;
    while (!old_.empty() && fresh_.size() > more) {
      pair(old_.back(), fresh_.back());
      old_.pop_back();
      fresh_.pop_back();
    }
  }

  const List &before_, &now_;
  /// Of the shorter diagonal: the nodes of a mesh as fine as the segments are farther apart.
  static constexpr double share_of_segment = 0.1;
  double widest_reach_, unknown_reach_ = 0;
  Places& match_;
  std::vector<bool> taken_;  // of `before_`
  Places old_, fresh_;
  std::uint64_t old_total_ = 0;
  bool counted_ = false;  // some are only counted
};

/// The end of the group that starts at `first`.
std::size_t group_end(const List& list, const Places& order, std::size_t first) {
  std::size_t end = first;
  while (end < order.size() && group_key(list[order[end]]) == group_key(list[order[first]])) ++end;
  return end;
}

}  // namespace

Degree degree_of(std::string_view id) {
  const RecordRule* rule = find_record_rule(id);
  return rule == nullptr ? Degree{id, 0} : Degree{rule->family, rule->degree};
}

std::string without_numbers(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool digit = c >= '0' && c <= '9';
    if (!digit)
      out += c;
    else if (out.empty() || out.back() != '#')
      out += '#';
  }
  return out;
}

std::vector<std::uint32_t> match_findings(const List& before, const List& now, std::size_t shown) {
  Places match(now.size(), unmatched);
  const Places old = sorted(before), fresh = sorted(now);
  Group group(before, now, diagonal(before, now) / 1000, match);
  for (std::size_t i = 0, k = 0; i < old.size() && k < fresh.size();) {
    const std::size_t i_end = group_end(before, old, i), k_end = group_end(now, fresh, k);
    const auto a = group_key(before[old[i]]), b = group_key(now[fresh[k]]);
    if (a == b) {
      Places of_group[2];  // shown, ignored
      for (std::size_t at = k; at < k_end; ++at) of_group[fresh[at] < shown ? 0 : 1].push_back(fresh[at]);
      group.run({old.begin() + i, old.begin() + i_end}, std::move(of_group[0]), std::move(of_group[1]));
    }
    if (a <= b) i = i_end;
    if (b <= a) k = k_end;
  }
  return match;
}

}  // namespace gapcheck::report
