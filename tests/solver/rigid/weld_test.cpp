#include <cmath>

#include "solver/build/build_welds.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::weld_test {
namespace {

/// Pulls node 0 with `force` and node 1 with its opposite, plus `both` on each.
class Pull : public Force {
 public:
  Pull(Vector force, Vector both, double rise) : force_(std::move(force)), both_(std::move(both)), rise_(rise) {}
  void add(State& state, Forces& forces) override {
    const double scale = rise_ > 0 ? state.time / rise_ : 1;
    forces.force[0] += scale * force_ + both_;
    forces.force[1] += -scale * force_ + both_;
  }

 private:
  Vector force_, both_;
  double rise_;
};

const std::string masses = "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n*ELEMENT_MASS\n1,1,2.\n2,2,3.\n";

Stepper stepper_of(const std::string& deck, double step) {
  StepSettings settings;
  settings.greatest_step = step;
  return {structure_of(deck), settings};
}

void run_cycles(Stepper& stepper, int steps) {
  for (int i = 0; i < steps; ++i) {
    const SolverStatus status = stepper.step();
    ASSERT_TRUE(status.ok()) << status.error().message;
  }
}

// Two masses move as one, whatever pulls them apart; a = 2 F / (m1 + m2).
TEST(Welds, MoveAsOne) {
  Stepper stepper = stepper_of(masses + "*CONSTRAINED_SPOTWELD\n1,2\n", 1e-2);
  ASSERT_EQ(stepper.structure().rigid.size(), 1u);
  stepper.add(std::make_unique<Pull>(Vector(-50, 0, 0), Vector(4, 0, 0), 0));
  run_cycles(stepper, 100);
  const State& state = stepper.state();
  EXPECT_NEAR((state.x[1] - state.x[0] - Vector(1, 0, 0)).norm(), 0, 1e-13);
  EXPECT_NEAR(state.v[0].x(), 8.0 / 5 * (1 - 0.005), 1e-12);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-12);
}

// A link in free rotation keeps its length, momentum and energy.
TEST(Welds, Rotation) {
  Structure structure = structure_of(masses + "*SET_NODE_LIST\n1\n1,2\n*CONSTRAINED_GENERALIZED_WELD_SPOT\n1\n\n");
  structure.rigid.set_motion(0, {1, 0, 0}, {0, 0, 2}, structure.state);
  StepSettings settings;
  settings.greatest_step = 1e-2;
  Stepper stepper(std::move(structure), settings);
  run_cycles(stepper, 1000);
  EXPECT_NEAR((stepper.state().x[1] - stepper.state().x[0]).norm(), 1, 1e-12);
  EXPECT_NEAR(stepper.energies().kinetic, 0.5 * 5 + 0.5 * (2.0 * 3 / 5) * 4, 1e-9);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-11);
}

// Pulled apart with a force that rises: the link opens at its strength; energies stay in balance, the parts fly on.
TEST(Welds, NormalFailure) {
  Stepper stepper = stepper_of(masses + "*CONSTRAINED_SPOTWELD\n1,2,10.,0.,2.,2.\n", 1e-3);
  stepper.add(std::make_unique<Pull>(Vector(-20, 0, 0), Vector(0, 0, 0), 1));
  while (!stepper.structure().rigid.failed(0) && stepper.state().time < 2) run_cycles(stepper, 1);
  EXPECT_NEAR(stepper.state().time, 0.5, 2e-3);
  run_cycles(stepper, 100);
  EXPECT_GT(stepper.state().x[1].x() - stepper.state().x[0].x(), 1.01);
  EXPECT_NEAR(2 * stepper.state().v[0].x() + 3 * stepper.state().v[1].x(), 0, 1e-12);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-10);
}

// Pressed together it holds. Point masses turn freely, so there is no force across a link of some length; of nodes on
// one another the whole force counts as shear.
TEST(Welds, CompressionAndShear) {
  const auto failure_time = [](const std::string& place, const std::string& strength, const Vector& force) {
    Stepper stepper = stepper_of("*NODE\n1,0.,0.,0.\n2," + place + "\n*ELEMENT_MASS\n1,1,2.\n2,2,3.\n" +
                                     "*CONSTRAINED_SPOTWELD\n1,2," + strength + "\n",
                                 1e-3);
    stepper.add(std::make_unique<Pull>(force, Vector(0, 0, 0), 1));
    while (!stepper.structure().rigid.failed(0) && stepper.state().time < 2) run_cycles(stepper, 1);
    return stepper.state().time;
  };
  EXPECT_GE(failure_time("1.,0.,0.", "10.,0.,2.,2.", {20, 0, 0}), 2);
  EXPECT_GE(failure_time("1.,0.,0.", "0.,0.,2.,2.", {-20, 0, 0}), 2);
  EXPECT_GE(failure_time("1.,0.,0.", "0.,1.,2.,2.", {0, 20, 0}), 2);
  EXPECT_NEAR(failure_time("0.,0.,0.", "0.,5.,2.,2.", {0, 20, 0}), 0.25, 2e-3);
  EXPECT_GE(failure_time("0.,0.,0.", "5.,0.,2.,2.", {0, 20, 0}), 2);
}

TEST(Welds, FailureTime) {
  Stepper stepper = stepper_of(masses + "*CONSTRAINED_SPOTWELD\n1,2,0.,0.,0.,0.,0.05\n", 1e-3);
  stepper.add(std::make_unique<Pull>(Vector(-20, 0, 0), Vector(0, 0, 0), 0));
  run_cycles(stepper, 49);
  EXPECT_FALSE(stepper.structure().rigid.failed(0));
  EXPECT_NEAR(stepper.state().x[1].x() - stepper.state().x[0].x(), 1, 1e-13);
  run_cycles(stepper, 3);
  EXPECT_TRUE(stepper.structure().rigid.failed(0));
  EXPECT_FALSE(stepper.structure().rigid.holds(0));
}

// In the cycle whose time is the failure time, not one later: both are whole numbers of 1/1024 here.
TEST(Welds, FailsAtItsTimeAndNotLater) {
  Stepper stepper = stepper_of(masses + "*CONSTRAINED_SPOTWELD\n1,2,0.,0.,0.,0.,0.0078125\n", 1.0 / 1024);
  run_cycles(stepper, 8);
  EXPECT_EQ(stepper.state().time, 8.0 / 1024);
  EXPECT_FALSE(stepper.structure().rigid.failed(0));
  run_cycles(stepper, 1);
  EXPECT_TRUE(stepper.structure().rigid.failed(0));
}

TEST(Welds, SharedNodesAndWhatIsNotCalculatedAreNamed) {
  const model::Read read = model::read_text(
      masses +
      "*NODE\n3,2.,0.,0.\n4,3.,0.,0.\n*SET_NODE_LIST\n1\n1,2\n*SET_NODE_LIST\n2\n2,3,4\n*SET_NODE_LIST\n3\n3,4\n" +
      "*CONSTRAINED_NODAL_RIGID_BODY\n9,,1\n*CONSTRAINED_GENERALIZED_WELD_SPOT\n2\n\n"
      "*CONSTRAINED_GENERALIZED_WELD_SPOT_ID\n8\n3\n0.,0.3,1.,1.,1.,1.\n*CONSTRAINED_SPOTWELD\n3,4\n");
  Diagnostics diagnostics;
  const Structure structure = build_structure(read.model, {}, diagnostics).value();
  EXPECT_EQ(structure.rigid.size(), 2u);
  std::string text;
  for (const Diagnostic& d : diagnostics.sorted()) text += d.message + "\n";
  EXPECT_EQ(text,
            "weld 1: node 2 is in another rigid body or weld; the weld takes no part in the calculation\n"
            "weld 8: failure by plastic strain is not calculated\n"
            "weld 3: node 3 is in another rigid body or weld; the weld takes no part in the calculation\n");
}

}  // namespace
}  // namespace gapcheck::solver::weld_test
