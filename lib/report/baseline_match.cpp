#include "report/baseline_match.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace gapcheck::report {
namespace {

using List = std::vector<KnownFinding>;
using Places = std::vector<std::uint32_t>;  // positions in a list

/// The words tell what is meant: there is no position, or it is one of many.
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

/// Findings by cells of a grid as wide as the search.
class Grid {
 public:
  using Cell = std::array<double, 3>;
  Grid(const List& list, const Places& places, double width) : list_(list), width_(width) {
    for (const std::uint32_t i : places) entries_.emplace_back(cell(*list[i].position), i);
    std::sort(entries_.begin(), entries_.end());
  }
  /// Calls visit(position) for what may be within a cell's width of x; of crowded cells only the first ones.
  template <class Visit>
  void around(const Vector& x, const Visit& visit) const {
    constexpr std::ptrdiff_t crowd = 64;
    const Cell middle = cell(x);
    for (int i = 0; i < 9; ++i) {
      const double u = middle[0] + i / 3 - 1, v = middle[1] + i % 3 - 1;
      auto entry = std::lower_bound(entries_.begin(), entries_.end(), std::pair(Cell{u, v, middle[2] - 1}, 0U));
      for (std::ptrdiff_t n = 0; entry != entries_.end() && n < 3 * crowd; ++entry, ++n) {
        const Cell& found = entry->first;
        if (found[0] != u || found[1] != v || found[2] > middle[2] + 1) break;
        visit(entry->second);
      }
    }
  }

 private:
  [[nodiscard]] Cell cell(const Vector& x) const {
    return {std::floor(x[0] / width_), std::floor(x[1] / width_), std::floor(x[2] / width_)};
  }
  const List& list_;
  double width_;
  std::vector<std::pair<Cell, std::uint32_t>> entries_;
};

/// The findings of one contact and family, as far as they have found nothing yet.
class Group {
 public:
  Group(const List& before, const List& now, double unknown_reach, Places& match)
      : before_(before), now_(now), unknown_reach_(unknown_reach), match_(match), taken_(before.size()) {}

  void run(Places old, Places fresh) {
    old_ = std::move(old);
    fresh_ = std::move(fresh);
    old_total_ = total(before_, old_);
    const std::uint64_t fresh_total = total(now_, fresh_);
    const bool counted = counts_rest(before_, old_) || counts_rest(now_, fresh_);
    in_order([](const KnownFinding& f) { return std::tuple(place_key(f), by_words(f) ? f.message : std::string()); });
    for (const double part : {1.0 / 16, 1.0 / 4, 1.0}) nearest(part);
    in_order([](const KnownFinding& f) { return without_numbers(f.message); }, true);
    if (counted) as_totals_allow(fresh_total);
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

  void pair(std::uint32_t old, std::uint32_t fresh) {
    match_[fresh] = old;
    taken_[old] = true;
  }

  /// Pairs findings of equal key one by one; `words_only`: of those that are known by their words.
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

  [[nodiscard]] double reach(const KnownFinding& a, const KnownFinding& b) const {
    const double h = std::max(a.contact_distance, b.contact_distance);
    return h > 0 ? h / 2 : unknown_reach_;
  }

  /// Pairs findings that are nearest to one another within `part` of their reach, the closest pairs first.
  void nearest(double part) {
    const auto placed = [](const List& list, const Places& places) {
      Places some;
      for (const std::uint32_t i : places)
        if (!by_words(list[i])) some.push_back(i);
      return some;
    };
    const Places old = placed(before_, old_), fresh = placed(now_, fresh_);
    if (old.empty() || fresh.empty()) return;
    double width = 0;
    for (const std::uint32_t i : old) width = std::max(width, reach(before_[i], before_[i]));
    for (const std::uint32_t i : fresh) width = std::max(width, reach(now_[i], now_[i]));
    width *= part;
    if (!(width > 0) || !std::isfinite(width)) return;
    const Grid grid(before_, old, width);
    std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> pairs;  // distance, fresh, old
    for (const std::uint32_t k : fresh) closest(grid, k, part, pairs);
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [distance, k, i] : pairs) {
      if (match_[k] == unmatched && !taken_[i]) pair(i, k);
    }
    std::erase_if(fresh_, [&](std::uint32_t k) { return match_[k] != unmatched; });
    std::erase_if(old_, [&](std::uint32_t i) { return taken_[i]; });
  }

  /// Adds the few nearest of the baseline.
  void closest(const Grid& grid, std::uint32_t k, double part,
               std::vector<std::tuple<double, std::uint32_t, std::uint32_t>>& pairs) const {
    constexpr std::size_t few = 8;
    std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> found;
    grid.around(*now_[k].position, [&](std::uint32_t i) {
      const double distance = (*before_[i].position - *now_[k].position).norm();
      if (distance <= part * reach(before_[i], now_[k])) found.emplace_back(distance, k, i);
    });
    std::sort(found.begin(), found.end());
    if (found.size() > few) found.resize(few);
    pairs.insert(pairs.end(), found.begin(), found.end());
  }

  /// Only the first of many are listed and the rest are counted, so which ones they are says nothing.
  void as_totals_allow(std::uint64_t fresh_total) {
    const std::size_t more = fresh_total > old_total_ ? fresh_total - old_total_ : 0;
    while (!old_.empty() && fresh_.size() > more) {
      pair(old_.back(), fresh_.back());
      old_.pop_back();
      fresh_.pop_back();
    }
  }

  const List &before_, &now_;
  double unknown_reach_;
  Places& match_;
  std::vector<bool> taken_;  // of `before_`
  Places old_, fresh_;
  std::uint64_t old_total_ = 0;
};

/// The end of the group that starts at `first`.
std::size_t group_end(const List& list, const Places& order, std::size_t first) {
  std::size_t end = first;
  while (end < order.size() && group_key(list[order[end]]) == group_key(list[order[first]])) ++end;
  return end;
}

}  // namespace

Degree degree_of(std::string_view id) {
  if (id == "GC106") return {"GC101", 0};
  if (id == "GC101") return {"GC101", 1};
  if (id == "GC102") return {"GC101", 2};
  if (id == "GC204") return {"GC201", 0};
  if (id == "GC202") return {"GC201", 1};
  if (id == "GC201") return {"GC201", 2};
  return {id, 0};
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

std::vector<std::uint32_t> match_findings(const List& before, const List& now) {
  Places match(now.size(), unmatched);
  const Places old = sorted(before), fresh = sorted(now);
  Group group(before, now, diagonal(before, now) / 1000, match);
  for (std::size_t i = 0, k = 0; i < old.size() && k < fresh.size();) {
    const std::size_t i_end = group_end(before, old, i), k_end = group_end(now, fresh, k);
    const auto a = group_key(before[old[i]]), b = group_key(now[fresh[k]]);
    if (a == b) group.run({old.begin() + i, old.begin() + i_end}, {fresh.begin() + k, fresh.begin() + k_end});
    if (a <= b) i = i_end;
    if (b <= a) k = k_end;
  }
  return match;
}

}  // namespace gapcheck::report
