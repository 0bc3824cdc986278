#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "audit/ignores.hpp"
#include "base/ids.hpp"

namespace gapcheck::audit {

/// What ignores check, the same for every finding.
struct Fact {
  std::uint32_t rule = no_position;  ///< position in rules(); none of those on ignores
  std::uint32_t source = no_position;
  std::int64_t contact = 0, node = 0, part = 0, element_part = 0, element = 0;
  double penetration = -1, contact_distance = -1;
  const std::string* file = nullptr;
};

/// Of the penetrations, ties and other findings, in that order.
[[nodiscard]] std::vector<Fact> facts_of(const Report& report);

/// Sorts ranges and joins those that touch.
void join(std::vector<IdRange>& ranges);

/// True if one of the joined ranges has the id. Ids of 0 are none, and in no range.
[[nodiscard]] bool holds(const std::vector<IdRange>& ranges, std::int64_t id);

/// Findings by rule and one kind of id, so that an ignore does not check all of them. Those that already have a source
/// are skipped, so many ignores of the same findings check each only once.
class FactIndex {
 public:
  explicit FactIndex(const std::vector<Fact>& facts) : facts_(facts) {}

  /// Ids of 0 and facts of no rule are left out.
  void add(std::int64_t id, std::uint32_t fact) {
    if (id != 0 && facts_[fact].rule != no_position) entries_.push_back({facts_[fact].rule, id, fact});
  }
  void finish();

  /// How many entries have an id of the ranges and a rule that is set in `rules`.
  [[nodiscard]] std::size_t count(const std::vector<bool>& rules, const std::vector<IdRange>& ranges) const;

  /// Calls visit(fact) for these until it returns false; a fact with two such ids may come twice.
  template <class Visit>
  void each(const std::vector<bool>& rules, const std::vector<IdRange>& ranges, const Visit& visit) const {
    for_each_run(rules, ranges, [&](std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i)
        if (!visit(entries_[i].fact)) return false;
      return true;
    });
  }

  /// The same for those without a source; `visit` may give them one.
  template <class Visit>
  void each_free(const std::vector<bool>& rules, const std::vector<IdRange>& ranges, const Visit& visit) {
    for_each_run(rules, ranges, [&](std::size_t first, std::size_t end) {
      for (std::size_t i = next_free(first); i < end; i = next_free(i + 1)) visit(entries_[i].fact);
      return true;
    });
  }

 private:
  struct Entry {
    std::uint32_t rule;
    std::int64_t id;
    std::uint32_t fact;
    auto operator<=>(const Entry&) const = default;
  };

  template <class Run>
  void for_each_run(const std::vector<bool>& rules, const std::vector<IdRange>& ranges, const Run& run) const {
    for (const std::uint32_t rule : rules_) {
      if (!rules[rule]) continue;
      for (const IdRange& range : ranges)
        if (!run(first_from({rule, range.first, 0}), first_behind({rule, range.last, no_position}))) return;
    }
  }
  [[nodiscard]] std::size_t first_from(const Entry& entry) const;
  [[nodiscard]] std::size_t first_behind(const Entry& entry) const;
  std::size_t next_free(std::size_t at);

  const std::vector<Fact>& facts_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> rules_;  // that there are
  std::vector<std::size_t> next_;     // where to look for the next one without a source
};

}  // namespace gapcheck::audit
