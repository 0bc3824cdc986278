#include "report/item/sums.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "report/sample.hpp"

namespace gapcheck::report::sums_test {
namespace {

/// The slow twin: every pair of parts asks all records.
void expect_pairs(std::span<const Penetration> records, std::span<const PartPair> pairs, bool edges,
                  std::size_t total) {
  std::size_t in_pairs = 0;
  for (const PartPair& pair : pairs) {
    std::size_t nodes = 0;
    double deepest = 0;
    for (const Penetration& record : records) {
      if (record.kind == PenetrationKind::edge_zone || (record.kind == PenetrationKind::edge) != edges ||
          record.part != pair.part || record.element_part != pair.element_part)
        continue;
      ++nodes;
      deepest = std::max(deepest, record.depth);
    }
    EXPECT_EQ(pair.nodes, nodes);
    EXPECT_EQ(pair.deepest->depth, deepest);
    in_pairs += nodes;
  }
  EXPECT_EQ(in_pairs, total);
}

void expect_like_plain_count(std::span<const Penetration> records, const Sums& result) {
  std::map<PenetrationKind, std::size_t> count;
  for (const Penetration& record : records) ++count[record.kind];
  for (std::size_t kind = 0; kind < penetration_kinds; ++kind)
    EXPECT_EQ(result.of(static_cast<PenetrationKind>(kind)), count[static_cast<PenetrationKind>(kind)]);
  const std::size_t edges = count[PenetrationKind::edge];
  EXPECT_EQ(result.penetrations(), records.size() - count[PenetrationKind::edge_zone]);
  EXPECT_EQ(result.nodes(), result.penetrations() - edges);
  expect_pairs(records, result.pairs, false, result.nodes());
  expect_pairs(records, result.edge_pairs, true, edges);
}

TEST(Sums, EqualThePlainCount) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{7}, std::size_t{3000}}) {
    const Report report = random_report(count, 1, static_cast<unsigned>(count));
    const Sums result = sums(report.penetrations);
    expect_like_plain_count(report.penetrations, result);
    EXPECT_TRUE(std::is_sorted(result.pairs.begin(), result.pairs.end(), [](const PartPair& a, const PartPair& b) {
      return a.deepest->depth > b.deepest->depth;
    }));
    EXPECT_EQ(result.deepest == nullptr, count == 0);
    if (result.deepest != nullptr) {
      const double node = result.pairs.empty() ? 0 : result.pairs.front().deepest->depth;
      const double edge = result.edge_pairs.empty() ? 0 : result.edge_pairs.front().deepest->depth;
      EXPECT_EQ(result.deepest->depth, std::max(node, edge));
    }
  }
}

TEST(Sums, RecordsOfAContactAreAllOfThem) {
  const Report report = random_report(1000, 7, 3);
  std::size_t total = 0;
  for (std::uint32_t contact = 0; contact < 9; ++contact) {
    const auto records = records_of(report, contact);
    const auto expected = std::count_if(report.penetrations.begin(), report.penetrations.end(),
                                        [&](const Penetration& record) { return record.contact == contact; });
    EXPECT_EQ(records.size(), static_cast<std::size_t>(expected));
    for (const Penetration& record : records) EXPECT_EQ(record.contact, contact);
    total += records.size();
  }
  EXPECT_EQ(total, 1000u);
}

}  // namespace
}  // namespace gapcheck::report::sums_test
