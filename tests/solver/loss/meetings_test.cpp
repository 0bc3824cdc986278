// Which nodes meet what: the search over swept boxes against brute force, and against all pairs.
#include "solver/loss/meetings.hpp"

#include <random>

#include "solver/loss/impact_scene.hpp"

namespace gapcheck::solver::meetings_test {
namespace {

/// The passes of a deck whose run has calculated its first cycle.
struct Passes : private Run::Observer {
  explicit Passes(const std::string& deck) : read(model::read_text(deck)), surfaces(read.model) {
    RunSettings settings;
    settings.cycles = 1;
    auto prepared = Run::prepare(read.model, surfaces, settings, diagnostics);
    if (!prepared) {
      ADD_FAILURE() << prepared.error().message;
      return;
    }
    run.emplace(std::move(prepared).value());
    run->go(*this);
    list = node_passes(run->contact_forces());
  }
  SolverStatus observe(const Run&, std::optional<RunEnd>) override { return {}; }
  model::Read read;
  contact::SurfaceStore surfaces;
  Diagnostics diagnostics;
  std::optional<Run> run;
  std::vector<NodePass> list;
};

std::string scene(const std::string& type) {
  return shell_sheet(1, 5, 3, 0) + shell_sheet(2, 4, 2, 4) + brick_block(3, 2, 2, 2, 7) +
         shell_part(1, 1, elastic_steel(1)) + shell_part(2, 0.5, elastic_steel(2)) + solid_part(3, elastic_steel(3)) +
         "*SET_PART_LIST\n9\n1,2,3\n" +
         (type == "AUTOMATIC_SINGLE_SURFACE" ? ImpactContact{type}.text()
                                             : ImpactContact{type, 2, 1}.text() + ImpactContact{type, 3, 2}.text()) +
         ends_at(1);
}

void expect_same(const std::vector<Meeting>& a, const std::vector<Meeting>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].slot, b[i].slot);
    EXPECT_EQ(a[i].segment, b[i].segment);
    EXPECT_EQ(a[i].contact.time, b[i].contact.time);
    EXPECT_EQ(a[i].contact.normal, b[i].contact.normal);
  }
}

/// The first meeting of each node by asking every pair.
std::vector<Meeting> all_pairs(const TrackedPairs& pairs, const Flight& flight, double until) {
  std::vector<Meeting> list;
  const contact::PairScene& scene = pairs.scene();
  for (std::uint32_t slot = 0; slot < scene.nodes.size(); ++slot) {
    std::optional<Meeting> first;
    bool begun = false;
    for (std::uint32_t s = 0; s < scene.segments.size(); ++s) {
      if (contact::is_corner(scene.segments.nodes[s], scene.nodes.node[slot])) continue;
      if (pairs.rule_of(SlotIndex{slot}, SegmentIndex{s}) != contact::PairRule::counts) continue;
      bool alike = true;
      for (const NodeIndex corner : scene.segments.nodes[s])
        alike = alike && flight.alike(corner, scene.nodes.node[slot]);
      if (alike) continue;
      const TimeOfContact contact = meet_segment(pairs, flight, SlotIndex{slot}, SegmentIndex{s}, until);
      begun = begun || contact.kind == TimeOfContact::Kind::begun;
      if (contact.kind == TimeOfContact::Kind::met && contact.speed() > 0 &&
          (!first || contact.time < first->contact.time))
        first = Meeting{SlotIndex{slot}, SegmentIndex{s}, contact};
    }
    if (first && !begun) list.push_back(*first);
  }
  return list;
}

TEST(Meetings, TheSearchFindsWhatAllPairsFind) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uint64_t found = 0, candidates = 0;
  for (const std::string type : {"AUTOMATIC_SINGLE_SURFACE", "AUTOMATIC_SURFACE_TO_SURFACE"}) {
    const Passes passes(scene(type));
    ASSERT_FALSE(passes.list.empty());
    for (int n = 0; n < 12; ++n) {
      // By part; every third time by node, which fills the mixed groups.
      std::vector<Vector> v(passes.read.model.mesh.nodes.size());
      std::array<Vector, 4> of_part;
      for (std::size_t part = 1; part < 4; ++part)
        of_part[part] = Vector(3 * unit(random), 3 * unit(random), -6.0 * static_cast<double>(part) * (n % 4 != 1));
      for (std::size_t i = 0; i < v.size(); ++i) {
        v[i] = of_part[static_cast<std::size_t>(passes.read.model.mesh.nodes.id[i] / 1000)];
        if (n % 3 == 2) v[i] += 0.2 * Vector(unit(random), unit(random), unit(random));
      }
      const Flight flight(v);
      for (const NodePass& pass : passes.list) {
        double until = 1, brute_until = 1;
        MeetingCounters counters, brute;
        const auto tree = find_meetings(pass.pass->pairs(), flight, until, counters);
        expect_same(tree,
                    find_meetings(pass.pass->pairs(), flight, brute_until, brute, contact::BoxSearch::brute_force));
        EXPECT_EQ(counters.candidates, brute.candidates);
        EXPECT_EQ(until, 1);
        const auto all = all_pairs(pass.pass->pairs(), flight, until);
        ASSERT_EQ(tree.size(), all.size());
        for (std::size_t i = 0; i < tree.size(); ++i) {
          EXPECT_EQ(tree[i].slot, all[i].slot);
          EXPECT_NEAR(tree[i].contact.time, all[i].contact.time, 1e-9);
        }
        found += tree.size();
        candidates += counters.candidates;
      }
    }
  }
  fmt::print("{} meetings among {} candidates\n", found, candidates);
  EXPECT_GT(found, 300u);
}

TEST(Meetings, WhatMovesTogetherIsNotSearched) {
  const Passes passes(scene("AUTOMATIC_SINGLE_SURFACE"));
  const Flight flight(std::vector<Vector>(passes.read.model.mesh.nodes.size(), Vector(1, 2, 3)));
  double until = 1;
  MeetingCounters counters;
  EXPECT_TRUE(find_meetings(passes.list.front().pass->pairs(), flight, until, counters).empty());
  EXPECT_EQ(counters.candidates, 0u);
  EXPECT_EQ(counters.steps, 0u);
  EXPECT_EQ(counters.still, 1u);
}

TEST(Meetings, TooManyCandidatesShortenTheSearch) {
  // Each of 6400 nodes sweeps all 6241 segments in the end.
  const Passes passes(shell_sheet(1, 79, 1, 0) + shell_sheet(9, 79, 1, 100) + shell_part(1, 1, elastic_steel(1)) +
                      shell_part(9, 1, elastic_steel(9)) + ImpactContact{"AUTOMATIC_NODES_TO_SURFACE", 9}.text() +
                      ends_at(1));
  std::vector<Vector> v(passes.read.model.mesh.nodes.size(), Vector::Zero());
  for (std::size_t i = 0; i < v.size(); ++i)
    if (passes.read.model.mesh.nodes.x[i].z() > 50) v[i] = Vector(1e4, 1e4, -1e4);
  double until = 1;
  MeetingCounters counters;
  const auto list = find_meetings(passes.list.front().pass->pairs(), Flight(v), until, counters);
  fmt::print("{} candidates until {}\n", counters.candidates, until);
  EXPECT_LT(until, 1) << "it looks less far ahead";
  EXPECT_LT(counters.candidates, 30'000'000u);
  for (const Meeting& meeting : list) EXPECT_LE(meeting.contact.time, until);
}

}  // namespace
}  // namespace gapcheck::solver::meetings_test
