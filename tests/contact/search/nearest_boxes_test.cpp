#include "contact/search/nearest_boxes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <random>
#include <set>
#include <vector>

#include "contact/edge/edge_pairs.hpp"
#include "contact/scene.hpp"

namespace gapcheck::contact::nearest_boxes_test {
namespace {

using Lists = std::map<std::uint32_t, std::vector<std::uint32_t>>;  // boxes by point

const Vector ex{1, 0, 0}, ey{0, 1, 0};

double squared(const Bounds& box, const Vector& x) {
  return (box.low - x).cwiseMax(x - box.high).cwiseMax(0).squaredNorm();
}

/// Small boxes in a cube, of which the first tenth lie in one point.
std::vector<Bounds> random_cores(std::mt19937_64& random, std::size_t count) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Bounds> cores;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector at = i < count / 10 ? Vector(0.1, 0.2, 0.3) : Vector(unit(random), unit(random), unit(random));
    const Vector half = 0.02 * Vector(unit(random), unit(random), unit(random)).cwiseAbs();
    cores.push_back({at - half, at + half});
  }
  return cores;
}

std::vector<Bounds> all_grown(const std::vector<Bounds>& cores, double reach) {
  std::vector<Bounds> boxes;
  for (const Bounds& core : cores) boxes.push_back(grown(core, reach));
  return boxes;
}

Lists nearest(const std::vector<Vector>& points, const std::vector<Bounds>& boxes, const std::vector<Bounds>& cores) {
  std::mutex mutex;
  Lists lists;
  run_nearest(points, boxes, cores, [&](std::uint32_t box, std::span<const std::uint32_t> inside) {
    const std::lock_guard lock(mutex);
    EXPECT_FALSE(inside.empty());
    ASSERT_LT(box, boxes.size());
    for (const std::uint32_t p : inside) lists[p].push_back(box);
  });
  return lists;
}

TEST(NearestBoxes, EachPointGetsTheNearestOfThoseThatContainIt) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1.5, 1.5);
  for (const double reach : {0.05, 0.4, 5.0}) {
    const std::vector<Bounds> cores = random_cores(random, 700), boxes = all_grown(cores, reach);
    std::vector<Vector> points;
    for (int i = 0; i < 200; ++i) points.emplace_back(unit(random), unit(random), unit(random));
    points.push_back(Vector::Constant(std::numeric_limits<double>::quiet_NaN()));
    points.emplace_back(1e9, 0, 0);
    Lists lists = nearest(points, boxes, cores);
    for (std::uint32_t p = 0; p < points.size(); ++p) {
      std::vector<double> all, found;
      for (std::size_t b = 0; b < boxes.size(); ++b)
        if (boxes[b].contains(points[p])) all.push_back(squared(cores[b], points[p]));
      std::sort(all.begin(), all.end());
      all.resize(std::min<std::size_t>(all.size(), most_candidates));
      std::set<std::uint32_t> once;
      for (const std::uint32_t b : lists[p]) {
        EXPECT_TRUE(once.insert(b).second) << "twice";
        EXPECT_TRUE(boxes[b].contains(points[p]));
        found.push_back(squared(cores[b], points[p]));
      }
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found.size(), all.size()) << reach << ' ' << p;
      for (std::size_t i = 0; i < all.size(); ++i) EXPECT_NEAR(found[i], all[i], 1e-5) << reach << ' ' << p;
    }
  }
}

TEST(NearestBoxes, CrowdedOnlyIfManyPairsAndManyToEach) {
  std::vector<Vector> points(4000, Vector(0, 0, 0));
  std::vector<Bounds> boxes(4000, Bounds{{-1, -1, -1}, {1, 1, 1}});
  EXPECT_TRUE(crowded(points, boxes));
  EXPECT_TRUE(crowded(boxes));
  EXPECT_FALSE(crowded(std::span(points).first(400), boxes)) << "a tenth of the pairs";
  EXPECT_FALSE(crowded(points, std::span(boxes).first(300))) << "300 to each";
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vector at(3.0 * static_cast<double>(i / 4), 0, 0);
    boxes[i] = {at - Vector::Ones(), at + Vector::Ones()};
    points[i] = at;
  }
  EXPECT_FALSE(crowded(points, boxes));
  EXPECT_FALSE(crowded(boxes));
}

// Boxes in the order of the points: any step through both lists must not meet more often than all of them do.
TEST(NearestBoxes, AMeshInOrderIsNotCrowded) {
  for (const std::size_t count : {1U << 18, 262'080U, 1'000'000U}) {
    std::vector<Vector> points(count);
    std::vector<Bounds> boxes(count);
    for (std::size_t i = 0; i < count; ++i) {
      points[i] = Vector(static_cast<double>(i), 0, 0);
      boxes[i] = {points[i] - Vector(6, 1, 1), points[i] + Vector(6, 1, 1)};
    }
    EXPECT_FALSE(crowded(points, boxes)) << count;
    EXPECT_FALSE(crowded(boxes)) << count;
  }
}

TEST(NearestBoxes, PairsOfBoxesHoldTheNearestOfEach) {
  std::mt19937_64 random(9);
  const std::vector<Bounds> cores = random_cores(random, 300), boxes = all_grown(cores, 0.5);
  std::mutex mutex;
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  constexpr std::uint32_t each = 7;
  for_each_near_box_pair(boxes, each, [&](std::uint32_t a, std::uint32_t b) {
    const std::lock_guard lock(mutex);
    EXPECT_LT(a, b);
    EXPECT_TRUE(boxes[a].meets(boxes[b]));
    EXPECT_TRUE(pairs.emplace(a, b).second) << "twice";
  });
  std::size_t clear = 0;
  for (std::uint32_t i = 30; i < boxes.size(); ++i) {
    std::vector<std::pair<double, std::uint32_t>> others;
    const auto centre = [&](std::uint32_t b) { return Vector(0.5 * (boxes[b].low + boxes[b].high)); };
    for (std::uint32_t k = 0; k < boxes.size(); ++k)
      if (k != i && boxes[i].meets(boxes[k])) others.emplace_back((centre(k) - centre(i)).norm(), k);
    std::sort(others.begin(), others.end());
    if (others.size() > each && others[each].first - others[each - 1].first < 1e-5) continue;
    ++clear;
    for (std::size_t n = 0; n < std::min<std::size_t>(each, others.size()); ++n)
      EXPECT_TRUE(pairs.contains(std::minmax(i, others[n].second))) << i << ' ' << others[n].second;
  }
  EXPECT_GT(clear, 250u);
}

/// Two plates, 3 apart, of n × n elements of 5.
Scene thick_plates(std::uint32_t n, double thickness, const char* keyword) {
  Scene scene;
  scene.plate(scene.part(1, thickness), {0, 0, 0}, 5 * ex, 5 * ey, n, n);
  scene.plate(scene.part(2, thickness), {0, 0, 3}, 5 * ex, 5 * ey, n, n);
  scene.contact(keyword);
  scene.model.controls.ssthk = 1;
  return scene;
}

// A thickness in the wrong unit: every node is compared to the nearest segments, among which are those above it.
TEST(NearestBoxes, AThicknessInTheWrongUnitIsJudgedByTheNearestSegments) {
  Scene scene = thick_plates(30, 1000, "AUTOMATIC_SINGLE_SURFACE");
  InitialOptions options;
  options.nodes_stay = true;
  EXPECT_EQ(scene.run(options).contacts[0].judged_nearest, 0U) << "3.5 million pairs of a deck";
  options.most_pairs = crowd_pairs;
  const InitialState state = scene.run(options);
  ASSERT_EQ(state.penetrations.size(), 2U * 31 * 31);
  for (const Penetration& p : state.penetrations) EXPECT_NEAR(p.depth, 997, 1e-9);
  EXPECT_EQ(state.contacts[0].judged_nearest, 2U * 31 * 31);
  ASSERT_EQ(state.notes.size(), 1U);
  EXPECT_NE(state.notes[0].find("1922 nodes are within the contact distance of more than 400 segments each"),
            std::string::npos)
      << state.notes[0];
  // By brute force everything is compared, and the result is the same here.
  options.brute_force = true;
  const InitialState slow = scene.run(options);
  EXPECT_EQ(slow.contacts[0].judged_nearest, 0U);
  EXPECT_TRUE(slow.notes.empty());
  ASSERT_EQ(slow.penetrations.size(), state.penetrations.size());
  for (std::size_t i = 0; i < slow.penetrations.size(); ++i) {
    EXPECT_EQ(slow.penetrations[i].node, state.penetrations[i].node);
    EXPECT_EQ(slow.penetrations[i].segment, state.penetrations[i].segment);
    EXPECT_EQ(slow.penetrations[i].depth, state.penetrations[i].depth);
  }
}

TEST(NearestBoxes, ContactsThatSuitTheirMeshAreJudgedWhole) {
  Scene scene = thick_plates(40, 4, "AUTOMATIC_SINGLE_SURFACE");
  const InitialState state = scene.run();
  EXPECT_EQ(state.contacts[0].judged_nearest, 0U);
  EXPECT_TRUE(state.notes.empty());
}

TEST(NearestBoxes, EdgesOfAnAbsurdThicknessAreComparedToTheNearest) {
  Scene scene = thick_plates(30, 1000, "AUTOMATIC_GENERAL_INTERIOR");
  InitialOptions options;
  options.edges = options.nodes_stay = true;
  options.most_pairs = crowd_pairs;
  const InitialState state = scene.run(options);
  const std::uint64_t edges = 4 * 30 * 31;
  EXPECT_EQ(state.contacts[0].judged_nearest, 2U * 31 * 31 + edges);
  ASSERT_EQ(state.notes.size(), 2U);
  EXPECT_NE(state.notes[1].find(fmt::format("{} edges", edges)), std::string::npos) << state.notes[1];
}

}  // namespace
}  // namespace gapcheck::contact::nearest_boxes_test
