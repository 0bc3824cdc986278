// A short run before and after a correction: springs in closed form, forces that appear and vanish, decks that cannot
// be run.
#include "solver/trial/run_trial.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace gapcheck::solver::run_trial_test {
namespace {

/// A shell of 1 x 1 at z = 0 and one of 0.5 x 0.5 at `z`, both 0.2 thick, in a contact between them.
std::string two_shells(double z, const std::string& contact, const std::string& more = "") {
  std::string deck =
      "*KEYWORD\n*CONTROL_TERMINATION\n1.\n*PART\na\n1,1,1\n*PART\nb\n2,1,1\n*SECTION_SHELL\n1,2\n0.2\n"
      "*MAT_ELASTIC\n1,1.,100.,0.3\n*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n";
  for (int i = 0; i < 4; ++i)
    deck += fmt::format("{},{},{},{}\n", 5 + i, i == 1 || i == 2 ? 0.75 : 0.25, i > 1 ? 0.75 : 0.25, z);
  return deck + "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,5,6,7,8\n" + contact + more + "*END\n";
}

/// SNLOG = 1: penetrating nodes are pushed, and not moved.
const std::string pushing = "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n2,1,3,3\n\n\n\n0,0,0,1\n";

class Trial : public testing::Test {
 protected:
  FixProof prove(const std::string& text, const std::vector<MovedNode>& moved, const TrialSettings& settings) {
    auto deck = keyword::read_deck_text(text, "trial.k", {}, diagnostics_);
    EXPECT_TRUE(deck);
    auto model = model::read_model(deck.value(), diagnostics_);
    EXPECT_TRUE(model);
    return prove_fix(deck.value(), model.value(), moved, settings, diagnostics_);
  }
  /// All nodes of the upper shell to this height.
  static std::vector<MovedNode> lift(double from, double to) {
    std::vector<MovedNode> moved;
    for (int i = 0; i < 4; ++i) {
      const double x = i == 1 || i == 2 ? 0.75 : 0.25, y = i > 1 ? 0.75 : 0.25;
      moved.push_back({5 + i, {x, y, from}, {x, y, to}});
    }
    return moved;
  }

  Diagnostics diagnostics_;
};

TEST_F(Trial, EnergyThatContactsStartWithIsGoneOnceTheNodesAreOut) {
  TrialSettings settings;
  settings.cycles = 20;
  const FixProof proof = prove(two_shells(0.15, pushing), lift(0.15, 0.21), settings);
  const RunTrial &before = proof.before, &after = proof.after;
  ASSERT_TRUE(before.ran && after.ran);
  EXPECT_EQ(before.forced_at_start(), 4U);
  // Four equal springs, 0.05 deep: each pushes with 0.05 k and holds 0.05² k / 2.
  ASSERT_GT(before.largest_force, 0);
  EXPECT_NEAR(before.start.energy, 4 * before.largest_force * 0.05 / 2, 1e-9 * before.start.energy);
  // What the springs give becomes motion, and bends the shells.
  EXPECT_GT(before.largest_kinetic, 0.1 * before.start.energy);
  EXPECT_LT(before.least_sliding, -0.1 * before.start.energy);
  EXPECT_LE(before.largest_kinetic, before.start.energy);
  EXPECT_EQ(before.cycles, 20U);
  EXPECT_EQ(after.forced_at_start(), 0U);
  EXPECT_EQ(after.start.energy, 0);
  EXPECT_EQ(after.largest_force, 0);
  EXPECT_EQ(after.largest_kinetic, 0);
  EXPECT_EQ(after.least_sliding, 0);
  EXPECT_EQ(after.cycles, 20U);
  EXPECT_EQ(after.end, "cycles");
  EXPECT_TRUE(proof.holds());
}

TEST_F(Trial, DoesNotHoldWhileNodesStayInside) {
  TrialSettings settings;
  settings.cycles = 5;
  EXPECT_FALSE(prove(two_shells(0.15, pushing), lift(0.15, 0.19), settings).holds());
  EXPECT_FALSE(prove(two_shells(0.15, pushing), {}, settings).holds());
}

TEST_F(Trial, EndsAtTheTimeAskedFor) {
  TrialSettings settings;
  settings.until = 0.01;
  const FixProof proof = prove(two_shells(0.21, pushing), {}, settings);
  EXPECT_EQ(proof.after.end, "end time");
  EXPECT_GE(proof.after.time, 0.01);
  EXPECT_LT(proof.after.time, 0.01 + 2 * proof.after.start.first_step.value_or(0));
}

TEST_F(Trial, CountsNodesThatARunMoves) {
  // The upper shell starts beside the first one, 0.05 too low, and slides into its zone, where contact finds it.
  TrialSettings settings;
  settings.until = 0.3;
  const std::string contact = "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n2,1,3,3\n\n\n";
  const std::string motion =
      "*DEFINE_CURVE\n9\n0.,8.\n1.,8.\n*BOUNDARY_PRESCRIBED_MOTION_SET\n1,1,0,9\n*SET_NODE_LIST\n1\n5,6,7,8\n";
  std::vector<MovedNode> moved = lift(0.15, 0.15);
  for (MovedNode& node : moved) node.to.x() -= 1.5;
  const FixProof proof = prove(two_shells(0.15, contact, motion), moved, settings);
  ASSERT_TRUE(proof.before.ran && proof.after.ran) << proof.before.end << proof.after.end;
  EXPECT_EQ(proof.before.start.moved, 4U) << "found at the start, and moved";
  EXPECT_EQ(proof.before.shot, 0U);
  EXPECT_EQ(proof.after.start.moved, 0U);
  EXPECT_GE(proof.after.shot, 2U);
  EXPECT_LE(proof.after.shot, 4U);
}

TEST_F(Trial, SaysWhyADeckIsNotRun) {
  TrialSettings settings;
  settings.cycles = 3;
  const std::string deck = two_shells(0.15, pushing, "*AIRBAG_ADIABATIC_GAS_MODEL\n1,0\n1.,1.\n");
  const FixProof refused = prove(deck, lift(0.15, 0.21), settings);
  EXPECT_FALSE(refused.before.ran || refused.after.ran);
  ASSERT_EQ(refused.after.start.refused.size(), 1U);
  EXPECT_EQ(refused.after.start.refused[0].keyword, "AIRBAG_ADIABATIC_GAS_MODEL");
  EXPECT_EQ(refused.before.forced_at_start(), 4U) << "the start is followed all the same";
  EXPECT_FALSE(refused.holds()) << "what was not run is not proven";
  settings.leave_out = true;
  EXPECT_TRUE(prove(deck, lift(0.15, 0.21), settings).holds());
}

}  // namespace
}  // namespace gapcheck::solver::run_trial_test
