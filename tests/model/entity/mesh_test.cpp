#include "model/entity/mesh.hpp"

#include <map>
#include <random>

#include "model/entity/erase.hpp"
#include "model/read.hpp"

namespace gapcheck::model::mesh_test {
namespace {

TEST(Origins, GivesTheFileOfEachRange) {
  Origins origins;
  EXPECT_EQ(origins.file(0), none<FileIndex>);
  origins.add(0, FileIndex{3});
  origins.add(5, FileIndex{1});
  origins.add(5, FileIndex{2});
  EXPECT_EQ(origins.file(0), FileIndex{3});
  EXPECT_EQ(origins.file(4), FileIndex{3});
  EXPECT_EQ(origins.file(5), FileIndex{2});
  EXPECT_EQ(origins.file(4000000000u), FileIndex{2});
}

/// The slow twin of IdLookup: a map that keeps the first.
void compare_with_map(const std::vector<std::int64_t>& ids) {
  std::map<std::int64_t, std::uint32_t> expected;
  std::vector<std::uint32_t> repeated;
  for (std::uint32_t i = 0; i < ids.size(); ++i)
    if (!expected.try_emplace(ids[i], i).second) repeated.push_back(i);
  IdLookup lookup;
  EXPECT_EQ(lookup.build(ids), repeated);
  for (const std::int64_t id : ids)
    for (const std::int64_t near : {id - 1, id, id + 1}) {
      const auto found = expected.find(near);
      ASSERT_EQ(lookup.find(near), found == expected.end() ? std::nullopt : std::optional(found->second)) << near;
    }
  std::vector<std::pair<std::int64_t, std::uint32_t>> visited;
  lookup.for_each_in(-50, 700, [&](std::int64_t id, std::uint32_t position) {
    visited.emplace_back(id, position);
    return true;
  });
  const std::vector<std::pair<std::int64_t, std::uint32_t>> in_range(expected.lower_bound(-50),
                                                                     expected.upper_bound(700));
  EXPECT_EQ(visited, in_range);
}

TEST(IdLookup, AgreesWithAMapOnDenseAndSparseIds) {
  std::mt19937 random(1);
  for (const std::int64_t widest : {10, 300, 5000, 1000000000}) {
    std::vector<std::int64_t> ids;
    for (int i = 0; i < 400; ++i)
      ids.push_back(std::uniform_int_distribution<std::int64_t>(-widest / 4, widest)(random));
    compare_with_map(ids);
    std::sort(ids.begin(), ids.end());
    compare_with_map(ids);
  }
}

TEST(IdLookup, StandsTheExtremes) {
  constexpr auto low = std::numeric_limits<std::int64_t>::min(), high = std::numeric_limits<std::int64_t>::max();
  IdLookup lookup;
  EXPECT_FALSE(lookup.find(1));
  EXPECT_TRUE(lookup.build({}).empty());
  EXPECT_FALSE(lookup.find(0));
  EXPECT_TRUE(lookup.build({high, 7, low}).empty());
  EXPECT_EQ(lookup.find(low), 2u);
  EXPECT_EQ(lookup.find(high), 0u);
  int visits = 0;
  lookup.for_each_in(low, high, [&](std::int64_t, std::uint32_t) { return ++visits < 2; });
  EXPECT_EQ(visits, 2);
  lookup.build({5, 6});
  EXPECT_FALSE(lookup.find(low));
  EXPECT_FALSE(lookup.find(high));
  visits = 0;
  lookup.for_each_in(low, high, [&](std::int64_t, std::uint32_t) { return ++visits > 0; });
  EXPECT_EQ(visits, 2);
}

TEST(Erase, TakesEntriesOutOfAllColumns) {
  std::mt19937 random(2);
  for (int round = 0; round < 100; ++round) {
    Origins origins;
    std::vector<std::int64_t> ids;
    std::vector<double> other;
    std::vector<std::uint32_t> out;
    std::vector<std::pair<std::int64_t, FileIndex>> expected;
    for (std::uint32_t i = 0; i < 30; ++i) {
      if (i % 7 == 0) origins.add(i, FileIndex{i / 7});
      ids.push_back(i * i);
      other.push_back(i);
      if (random() % 3 == 0)
        out.push_back(i);
      else
        expected.emplace_back(i * i, FileIndex{i / 7});
    }
    const std::vector<std::int64_t> before = ids;
    erase_positions(out, origins, ids, other);
    ASSERT_EQ(ids.size(), expected.size());
    ASSERT_EQ(other.size(), expected.size());
    for (std::uint32_t i = 0; i < ids.size(); ++i) {
      EXPECT_EQ(ids[i], expected[i].first);
      EXPECT_EQ(origins.file(i), expected[i].second);
      EXPECT_EQ(position_after(out, static_cast<std::uint32_t>(other[i])), i);
    }
  }
}

TEST(Nodes, AreReadWithPlaces) {
  const Read read = read_text(
      "*KEYWORD\n*NODE\n$ comment\n       7             1.0            -2.5         3.0e-3       0       0\n"
      "8,4.,5.,6.\n*NODE\n       9\n*END\n");
  ASSERT_EQ(read.errors(), 0u) << read.text();
  const Nodes& nodes = read.model.mesh.nodes;
  ASSERT_EQ(nodes.size(), 3u);
  EXPECT_EQ(nodes.id, (std::vector<std::int64_t>{7, 8, 9}));
  EXPECT_EQ(nodes.x[0], Vector(1, -2.5, 0.003));
  EXPECT_EQ(nodes.x[1], Vector(4, 5, 6));
  EXPECT_EQ(nodes.x[2], Vector(0, 0, 0));
  EXPECT_EQ(nodes.line, (std::vector<std::uint32_t>{4, 5, 7}));
  EXPECT_EQ(nodes.lookup.find(9), 2u);
  EXPECT_EQ(nodes.origins.file(2), FileIndex{0});
}

TEST(Nodes, FirstDefinitionWins) {
  const Read read = read_text("*NODE\n1,1.,0.,0.\n2,2.,0.,0.\n1,3.,0.,0.\n4,4.,0.,0.\n");
  ASSERT_EQ(read.model.mesh.nodes.size(), 3u);
  EXPECT_EQ(read.model.mesh.nodes.x[0].x(), 1);
  EXPECT_EQ(read.model.mesh.nodes.lookup.find(4), 2u);
  ASSERT_EQ(read.model.faults.size(), 1u);
  EXPECT_EQ(read.model.faults[0].kind, Fault::Kind::duplicate_id);
  EXPECT_EQ(read.model.faults[0].message, "node 1 is defined again (first in line 2 of a.k)");
  EXPECT_EQ(read.model.faults[0].place.line, 4u);
}

TEST(Nodes, BadIdsAreErrors) {
  const Read read = read_text("*NODE\n0,1.,0.,0.\n-3,2.,0.,0.\nabc,2.,0.,0.\n4,4.,0.,0.\n");
  EXPECT_EQ(read.model.mesh.nodes.size(), 1u);
  EXPECT_EQ(read.errors(), 3u) << read.text();  // the letters are one more
}

}  // namespace
}  // namespace gapcheck::model::mesh_test
