#include "records/repair.hpp"

#include <algorithm>

namespace gapcheck {

std::string_view name(RepairKind kind) {
  switch (kind) {
    case RepairKind::move:
      return "move";
    case RepairKind::part_thickness:
      return "optt";
    case RepairKind::contact_thickness:
      return "sst";
    case RepairKind::sections:
      return "sections";
    case RepairKind::ignore:
      return "ignore";
    case RepairKind::tie:
      return "tie";
    case RepairKind::exclude:
      return "exclude";
    case RepairKind::swap:
      return "swap";
    case RepairKind::reach:
      return "reach";
  }
  return "";
}

void RepairSettings::add(const RepairSettings& other) {
  move = move || other.move;
  for (const auto& [contact, thickness] : other.contact_thickness) {
    const auto [entry, is_new] = contact_thickness.emplace(contact, thickness);
    if (is_new) continue;
    for (std::size_t side = 0; side < 2; ++side) entry->second[side] = std::min(entry->second[side], thickness[side]);
  }
  const auto smaller = [](std::map<std::int64_t, double>& all, const std::map<std::int64_t, double>& more) {
    for (const auto& [id, thickness] : more) {
      const auto [entry, is_new] = all.emplace(id, thickness);
      if (!is_new) entry->second = std::min(entry->second, thickness);
    }
  };
  smaller(part_thickness, other.part_thickness);
  smaller(section_thickness, other.section_thickness);
  ignore.insert(other.ignore.begin(), other.ignore.end());
  swapped.insert(other.swapped.begin(), other.swapped.end());
  tied.insert(other.tied.begin(), other.tied.end());
  excluded.insert(other.excluded.begin(), other.excluded.end());
}

bool RepairSettings::only_moves() const {
  return contact_thickness.empty() && part_thickness.empty() && section_thickness.empty() && ignore.empty() &&
         swapped.empty() && tied.empty() && excluded.empty();
}

}  // namespace gapcheck
