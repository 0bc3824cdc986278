// The statements of docs/workshop/ties.md and transducers.md, on the decks of data/workshop/. What is expected are
// closed forms of beams.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>

#include "model/read.hpp"
#include "solver/run.hpp"

namespace gapcheck::solver::workshop_ties_test {
namespace {

// As in scripts/make_workshop.py: mm, ms, kN; lateral contraction zero.
constexpr double young = 210, width = 20, thickness = 1, length = 40;
constexpr double bending = young * width * thickness * thickness * thickness / 12;
constexpr std::int64_t tip = 2009, joint = 1009;  // corners of the loaded edge and of the first half's front edge

/// Motion of a node, and forces, at the end of a run.
class Last : public Run::Observer {
 public:
  [[nodiscard]] SolverStatus observe(const Run& run, std::optional<RunEnd> end) override {
    const State& state = run.stepper().state();
    if (start.empty()) start = state.x;
    for (const ContactState& transducer : run.transducers())
      greatest = std::max(greatest, std::abs(transducer.force_a.z()));
    forces.push_back(run.transducers());
    if (!end) return {};
    const auto& ids = run.model().mesh.nodes.id;
    for (std::size_t i = 0; i < ids.size(); ++i) way[ids[i]] = state.x[i] - start[i];
    return {};
  }
  std::vector<Vector> start;
  std::map<std::int64_t, Vector> way;  ///< by node id
  std::vector<std::vector<ContactState>> forces;
  double greatest = 0;
};

struct Calculated {
  Last last;
  contact::InitialState initial;
};

Calculated calculate(const std::string& name) {
  std::ifstream file(fmt::format("{}/data/workshop/{}.k", GAPCHECK_ROOT, name));
  EXPECT_TRUE(file) << name;
  const model::Read read = model::read_text({std::istreambuf_iterator<char>(file), {}});
  EXPECT_EQ(read.text(), "") << name;
  contact::SurfaceStore surfaces(read.model);
  Diagnostics diagnostics;
  auto prepared = Run::prepare(read.model, surfaces, {}, diagnostics);
  EXPECT_TRUE(diagnostics.sorted().empty()) << name;
  Calculated result;
  if (!prepared) {
    ADD_FAILURE() << name << ": " << prepared.error().message;
    return result;
  }
  Run& run = prepared.value();
  EXPECT_EQ(run.go(result.last), RunEnd::time) << name;
  result.initial = run.initial();
  return result;
}

/// Nodes by what became of them.
std::map<std::string, int> outcomes(const contact::InitialState& initial) {
  std::map<std::string, int> count;
  for (const contact::JudgedNode& node : initial.judged)
    ++count[node.tied() ? "tied" : std::string(name(*node.reason))];
  count["out of reach"] = static_cast<int>(initial.contacts[0].out_of_reach);
  return count;
}

// Load across the tip: F L³ / 3 E I of the whole length.
TEST(WorkshopTies, RotationsTiedAreACantilever) {
  const double expected = 1e-4 * std::pow(2 * length, 3) / (3 * bending);
  EXPECT_NEAR(calculate("joint_rotations").last.way.at(tip).z(), expected, 0.005 * expected);
}

TEST(WorkshopTies, TranslationsAloneAreAHinge) {
  const Calculated run = calculate("joint_translations");
  EXPECT_GT(run.last.way.at(tip).z(), 4 * 1e-4 * std::pow(2 * length, 3) / (3 * bending)) << "and it goes on falling";
  EXPECT_LT(std::abs(run.last.way.at(joint).z()), 0.1 * run.last.way.at(tip).z());
}

// Load F along the upper half: the moment F e of the offset e bends the first half to F e L² / 2 E I and turns the
// second.
TEST(WorkshopTies, BeamOffsetCarriesTheMomentOfTheOffset) {
  const double moment = 0.001 * 1.0, bent = moment * length * length / (2 * bending),
               turned = moment * length / bending * length;
  const Calculated carried = calculate("joint_beam_offset"), ignored = calculate("joint_offset");
  EXPECT_NEAR(-carried.last.way.at(joint).z(), bent, 0.02 * bent);
  EXPECT_NEAR(-carried.last.way.at(tip).z(), bent + turned, 0.02 * (bent + turned));
  EXPECT_LT(std::abs(ignored.last.way.at(joint).z()), 1e-6 * bent);
  EXPECT_LT(std::abs(ignored.last.way.at(tip).z()), 1e-6 * bent);
}

TEST(WorkshopTies, WhichNodesAPartASetAndThicknessesTie) {
  using Count = std::map<std::string, int>;
  EXPECT_EQ(outcomes(calculate("tie_by_part").initial), (Count{{"tied", 21}, {"out of reach", 6}}));
  EXPECT_EQ(outcomes(calculate("tie_by_set").initial), (Count{{"tied", 9}, {"out of reach", 0}}));
  EXPECT_EQ(outcomes(calculate("tie_negative").initial), (Count{{"far", 12}, {"tied", 9}, {"out of reach", 6}}));
  double farthest = 0;
  for (const contact::JudgedNode& node : calculate("tie_by_part").initial.judged)
    farthest = std::max(farthest, node.distance);
  EXPECT_NEAR(farthest, 2.2, 1e-12) << "the flange is pulled down";
}

// The reach may be given on either side: the springs do not know it.
TEST(WorkshopTies, ReachOnEitherSideIsTheSame) {
  const Calculated sst = calculate("tie_reach_sst"), mst = calculate("tie_reach_mst");
  EXPECT_EQ(outcomes(sst.initial).at("tied"), 3);
  for (const auto& [node, way] : sst.last.way) EXPECT_EQ(way, mst.last.way.at(node)) << node;
}

TEST(WorkshopTransducers, PartsAddUpToTheWhole) {
  const Calculated run = calculate("transducer_sum");
  EXPECT_GT(run.last.greatest, 100);
  for (const auto& forces : run.last.forces) {
    ASSERT_EQ(forces.size(), 3u);
    EXPECT_NEAR((forces[0].force_a - forces[1].force_a - forces[2].force_a).norm(), 0, 1e-10 * run.last.greatest);
    EXPECT_EQ(forces[1].force_b, Vector(-forces[1].force_a));
  }
}

}  // namespace
}  // namespace gapcheck::solver::workshop_ties_test
