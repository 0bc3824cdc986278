#include "report/item/sums.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace gapcheck::report {
namespace {

/// Part pairs as they come up.
class Pairs {
 public:
  void add(const Penetration& record) {
    if (last_ == nullptr || last_->part != record.part || last_->element_part != record.element_part) {
      last_ = &pairs_[{record.part, record.element_part}];
      last_->part = record.part;
      last_->element_part = record.element_part;
    }
    ++last_->nodes;
    if (last_->deepest == nullptr || record.depth > last_->deepest->depth) last_->deepest = &record;
  }
  [[nodiscard]] std::vector<PartPair> deepest_first() const {
    std::vector<PartPair> list;
    for (const auto& [key, pair] : pairs_) list.push_back(pair);
    std::stable_sort(list.begin(), list.end(),
                     [](const PartPair& a, const PartPair& b) { return a.deepest->depth > b.deepest->depth; });
    return list;
  }

 private:
  std::map<std::pair<std::int64_t, std::int64_t>, PartPair> pairs_;
  PartPair* last_ = nullptr;  // neighbours in the list mostly belong to the same pair
};

}  // namespace

Sums& Sums::operator+=(const Sums& other) {
  for (std::size_t k = 0; k < count.size(); ++k) count[k] += other.count[k];
  if (other.deepest != nullptr && (deepest == nullptr || other.deepest->depth > deepest->depth))
    deepest = other.deepest;
  return *this;
}

Sums sums(std::span<const Penetration> records) {
  Sums result;
  Pairs nodes, edges;
  for (const Penetration& record : records) {
    ++result.count[static_cast<std::size_t>(record.kind)];
    if (record.kind == PenetrationKind::edge_zone) continue;
    if (result.deepest == nullptr || record.depth > result.deepest->depth) result.deepest = &record;
    (record.kind == PenetrationKind::edge ? edges : nodes).add(record);
  }
  result.pairs = nodes.deepest_first();
  result.edge_pairs = edges.deepest_first();
  return result;
}

std::span<const Penetration> records_of(const Report& report, std::uint32_t contact) {
  const auto [first, last] =
      std::equal_range(report.penetrations.begin(), report.penetrations.end(), Penetration{.contact = contact},
                       [](const Penetration& a, const Penetration& b) { return a.contact < b.contact; });
  return {first, last};
}

}  // namespace gapcheck::report
