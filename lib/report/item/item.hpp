#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/ids.hpp"
#include "records/report.hpp"

namespace gapcheck::report {

/// One finding as lists show it, from any kind of record. Ids of 0, lengths below zero, an empty file: not known or
/// meaningless. The views live as long as the report.
struct Item {
  std::string_view id, rule;  ///< "GC101", "initial-penetration"
  Severity severity = Severity::warning;
  std::string message;
  std::uint32_t contact_position = no_position;  ///< in Report::contacts
  std::int64_t contact = 0, node = 0, part = 0, element = 0, element_part = 0;
  double penetration = -1, contact_distance = -1;
  double segment_size = -1;        ///< for ties: the shorter diagonal of the segment
  std::optional<Vector> position;  ///< where to look
  std::string_view outcome;        ///< what the solver does with the node
  std::string_view file;
  std::uint32_t line = 0;
  std::uint64_t count = 1;  ///< number of things that the line represents
  std::uint64_t fingerprint = 0;
  std::size_t number = 0;                 ///< among all findings, from 1, in the order of for_each_item(); 0: not known
  std::optional<BaselineState> state;     ///< only where there is a baseline
  const IgnoreSource* ignored = nullptr;  ///< what leaves it out; nullptr: nothing

  /// Not left out, and not equally bad in the baseline: what counts for exit codes and failures.
  [[nodiscard]] bool counts() const { return ignored == nullptr && state != BaselineState::unchanged; }
  [[nodiscard]] bool of_contact() const { return contact_position != no_position; }
};

[[nodiscard]] Item item_of(const Report& report, const Penetration& record);
[[nodiscard]] Item item_of(const Report& report, const TieFailure& failure);
/// Does not look up its contact's position.
[[nodiscard]] Item item_of(const Finding& finding);

/// For the finding with this number, in the order of for_each_item(); none without a baseline.
[[nodiscard]] std::optional<BaselineState> state_of(const Report& report, std::size_t number);

/// The findings of a report by number: penetrations, ties, then the others, each in the report's order. Refers to the
/// report; several threads may ask for items.
class Items {
 public:
  explicit Items(const Report& report);
  /// Those that were left out on purpose; Item::ignored says by what, Item::number is 0.
  [[nodiscard]] static Items ignored(const Report& report);
  [[nodiscard]] std::size_t size() const { return penetrations_.size() + tie_failures_.size() + findings_.size(); }
  /// `i` < size().
  [[nodiscard]] Item operator[](std::size_t i) const;

 private:
  template <class Lists>
  Items(const Report& report, const Lists& lists, const Ignored* ignored);
  [[nodiscard]] Item entry(std::size_t i) const;

  const Report* report_;
  std::span<const Penetration> penetrations_;
  std::span<const TieFailure> tie_failures_;
  std::span<const Finding> findings_;
  const Ignored* ignored_;                                    ///< nullptr: the findings that count
  std::unordered_map<std::int64_t, std::uint32_t> position_;  ///< of a contact's id; the first of equal ones
};

/// Visits every finding in the order of Items. Stops when `visit` returns false.
void for_each_item(const Report& report, const std::function<bool(const Item&)>& visit);

/// The same for the findings that were left out on purpose; Item::ignored says by what.
void for_each_ignored(const Report& report, const std::function<bool(const Item&)>& visit);

/// "page.html#f12": the finding with this number in the page of --html; empty without a page.
[[nodiscard]] std::string link_to(const Report& report, std::size_t number);

/// How much of a reason is shown where it may be shortened.
inline constexpr std::size_t reason_shown = 200;

/// "deck.k:14", and the reason if there is one: "deck.k:14: welded on purpose"; a long one is cut.
[[nodiscard]] std::string describe(const IgnoreSource& source);

/// The findings of one rule in one contact (or in none).
struct ItemGroup {
  std::uint32_t contact_position = no_position;
  std::string_view id, rule;
  Severity severity = Severity::note;        ///< the most severe of `items`
  std::size_t items = 0;                     ///< those that are new or worse than the baseline
  std::size_t known = 0;                     ///< the others
  std::size_t ignored = 0;                   ///< left out on purpose, in neither of the two
  std::vector<Item> shown;                   ///< the first of `items`
  std::vector<const IgnoreSource*> sources;  ///< of `ignored`, each once, at most ignore_sources_shown
};

inline constexpr std::size_t ignore_sources_shown = 10;

/// All findings in groups, including those left out on purpose: contacts in deck order, findings without a contact
/// last, rules in the order of their ids; the first `top` findings of each group.
[[nodiscard]] std::vector<ItemGroup> item_groups(const Report& report, std::size_t top);

}  // namespace gapcheck::report
