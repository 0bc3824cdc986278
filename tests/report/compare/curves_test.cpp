#include "report/compare/curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gapcheck::report::curves_test {
namespace {

const Curve* named(const std::vector<Curve>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Curve& c) { return c.name == name; });
  return found == list.end() ? nullptr : &*found;
}

TEST(Curves, EveryFileGivesItsOwn) {
  results::RunResults run;
  for (const double time : {0.0, 1.0}) {
    auto& global = run.glstat.emplace_back();
    global.time = time;
    global.kinetic = 5 + time;
    global.ratio = 0.5;
    results::InterfaceState forces, energies;
    forces.contact = energies.contact = 7;
    forces.force = {Vector(3, 0, 4 * time), Vector(-3, 0, 0)};
    energies.energy = {time, 2};
    energies.friction = 0.25;
    run.rcforc.states.push_back({time, 0, {forces}});
    run.sleout.states.push_back({time, 1, {energies}});
    results::NodeState node;
    node.node = 12;
    node.velocity = {0, 0, time};
    run.nodout.states.push_back({1, time, {node}});
  }
  const std::vector<Curve> list = curves(run);
  EXPECT_EQ(list.size(), 7u + 8u + 3u + 8u);
  ASSERT_NE(named(list, "glstat kinetic energy"), nullptr);
  EXPECT_EQ(named(list, "glstat kinetic energy")->values, (std::vector{5.0, 6.0}));
  EXPECT_EQ(named(list, "glstat energy ratio")->quantity, "ratio");
  EXPECT_EQ(named(list, "rcforc contact 7 side A resultant force")->values, (std::vector{3.0, 5.0}));
  EXPECT_EQ(named(list, "rcforc contact 7 side B x-force")->values, (std::vector{-3.0, -3.0}));
  EXPECT_EQ(named(list, "rcforc contact 7 side B x-force")->contact, 7);
  EXPECT_EQ(named(list, "sleout contact 7 energy of side A")->values, (std::vector{0.0, 1.0}));
  EXPECT_EQ(named(list, "sleout contact 7 friction energy")->digits, 4);
  EXPECT_EQ(named(list, "nodout node 12 z-velocity")->values, (std::vector{0.0, 1.0}));
  EXPECT_EQ(named(list, "nodout node 12 z-displacement")->quantity, "displacement");
  EXPECT_TRUE(curves({}).empty());
}

TEST(Curves, PartsHaveTheirEnergiesAndMomenta) {
  results::PartHistory history;
  for (const double time : {0.0, 1.0}) {
    results::PartState part;
    part.part = 4;
    part.kinetic = 2 + time;
    part.momentum = {3, 0, 4};
    part.velocity = {0, time, 0};
    history.states.push_back({time, {part}});
  }
  const std::vector<Curve> list = part_curves(history);
  EXPECT_EQ(list.size(), 5u + 4u + 4u);
  ASSERT_NE(named(list, "matsum part 4 kinetic energy"), nullptr);
  EXPECT_EQ(named(list, "matsum part 4 kinetic energy")->values, (std::vector{2.0, 3.0}));
  EXPECT_EQ(named(list, "matsum part 4 resultant momentum")->values, (std::vector{5.0, 5.0}));
  EXPECT_EQ(named(list, "matsum part 4 y-velocity")->values, (std::vector{0.0, 1.0}));
  results::RunResults run;
  run.matsum = history;
  EXPECT_TRUE(curves(run).empty()) << "what is compared";
}

TEST(Curves, ARestartTakesThePlaceOfWhatItRepeats) {
  Curve curve;
  for (const auto& [time, value] : std::vector<std::pair<double, double>>{{0, 1}, {1, 2}, {2, 3}, {1, 20}, {3, 30}})
    curve.add(time, value);
  EXPECT_EQ(curve.times, (std::vector{0.0, 1.0, 3.0}));
  EXPECT_EQ(curve.values, (std::vector{1.0, 20.0, 30.0}));
}

TEST(Curves, ValuesThatAreNoNumbersAreCounted) {
  Curve curve;
  curve.add(0, 1);
  curve.add(1, std::nan(""));
  curve.add(2, INFINITY);
  EXPECT_EQ(curve.times.size(), 1u);
  EXPECT_EQ(curve.not_numbers, 2u);
}

}  // namespace
}  // namespace gapcheck::report::curves_test
