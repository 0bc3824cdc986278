#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "records/report.hpp"

namespace gapcheck::report {

/// One finding as lists show it, whatever record it comes from. Ids of 0, lengths below zero, an empty file: not known
/// or without a meaning. The views live as long as the report.
struct Item {
  std::string_view id, rule;  ///< "GC101", "initial-penetration"
  Severity severity = Severity::warning;
  std::string message;
  std::uint32_t contact_position = no_contact;  ///< in Report::contacts
  std::int64_t contact = 0, node = 0, part = 0, element = 0, element_part = 0;
  double penetration = -1, contact_distance = -1;
  std::optional<Vector> position;  ///< where to look
  std::string_view outcome;        ///< what the solver does with the node
  std::string_view file;
  std::uint32_t line = 0;
  std::uint64_t count = 1;         ///< things that the line stands for
  std::uint64_t fingerprint = 0;
  std::optional<BaselineState> state;  ///< only where there is a baseline

  static constexpr std::uint32_t no_contact = 0xffffffffU;
  /// Not in the baseline as bad as this: what counts for exit codes and failures.
  [[nodiscard]] bool counts() const { return state != BaselineState::unchanged; }
  [[nodiscard]] bool of_contact() const { return contact_position != no_contact; }
};

[[nodiscard]] Item item_of(const Report& report, const Penetration& record);
[[nodiscard]] Item item_of(const Report& report, const TieFailure& failure);
/// Does not look its contact's position up.
[[nodiscard]] Item item_of(const Finding& finding);

/// Of the finding with this number, counted as for_each_item() hands them over; none without a baseline.
[[nodiscard]] std::optional<BaselineState> state_of(const Report& report, std::size_t number);

/// Hands over every finding: penetrations, ties, then the others, each in the report's order. Ends when `visit` gives
/// false.
void for_each_item(const Report& report, const std::function<bool(const Item&)>& visit);

/// The findings of one rule in one contact (or in none).
struct ItemGroup {
  std::uint32_t contact_position = Item::no_contact;
  std::string_view id, rule;
  Severity severity = Severity::note;  ///< the gravest of `items`
  std::size_t items = 0;    ///< those that the baseline does not know as they are
  std::size_t known = 0;    ///< the others
  std::vector<Item> shown;  ///< the first of `items`
};

/// All findings in groups, contacts in deck order and what belongs to none last, rules in the order of their ids; of each
/// group the first `top` findings.
[[nodiscard]] std::vector<ItemGroup> item_groups(const Report& report, std::size_t top);

}  // namespace gapcheck::report
