#include "report/sums.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace gapcheck::report {

Sums sums(std::span<const Penetration> records) {
  Sums result;
  std::map<std::pair<std::int64_t, std::int64_t>, PartPair> pairs;
  PartPair* last = nullptr;  // neighbours in the list mostly belong to the same pair
  for (const Penetration& record : records) {
    if (record.kind == PenetrationKind::edge_zone) {
      ++result.edge_zone;
      continue;
    }
    ++(record.kind == PenetrationKind::released ? result.released : result.initial);
    if (result.deepest == nullptr || record.depth > result.deepest->depth) result.deepest = &record;
    if (last == nullptr || last->part != record.part || last->element_part != record.element_part) {
      last = &pairs[{record.part, record.element_part}];
      last->part = record.part;
      last->element_part = record.element_part;
    }
    ++last->nodes;
    if (last->deepest == nullptr || record.depth > last->deepest->depth) last->deepest = &record;
  }
  for (const auto& [key, pair] : pairs) result.pairs.push_back(pair);
  std::stable_sort(result.pairs.begin(), result.pairs.end(),
                   [](const PartPair& a, const PartPair& b) { return a.deepest->depth > b.deepest->depth; });
  return result;
}

std::span<const Penetration> records_of(const Report& report, std::uint32_t contact) {
  const auto [first, last] =
      std::equal_range(report.penetrations.begin(), report.penetrations.end(), Penetration{.contact = contact},
                       [](const Penetration& a, const Penetration& b) { return a.contact < b.contact; });
  return {first, last};
}

}  // namespace gapcheck::report
