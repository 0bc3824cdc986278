#include "solver/rigid/rigid_joints.hpp"

#include <cmath>
#include <numbers>

#include "solver/conditioned.hpp"

namespace gapcheck::solver::rigid_joints_test {
namespace {

constexpr double pi = std::numbers::pi;

/// Decks of nodal rigid bodies: each node has a mass of its own.
class Bodies {
 public:
  /// A body of the nodes at these places; `spc`: codes of CON1 and CON2, -1 for a free one. Their first node's id is
  /// 10 · id.
  Bodies& add(int id, const std::vector<Vector>& places, double mass, const std::string& spc = "") {
    std::string set;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const int node = 10 * id + static_cast<int>(k);
      nodes_ += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", node, places[k].x(), places[k].y(), places[k].z());
      if (mass > 0) masses_ += fmt::format("{},{},{}\n", node, node, mass);
      set += (k == 0 ? "" : ",") + std::to_string(node);
    }
    rest_ += fmt::format("*SET_NODE_LIST\n{}\n{}\n*CONSTRAINED_NODAL_RIGID_BODY{}\n{},0,{}\n", id, set,
                         spc.empty() ? "" : "_SPC", id, id);
    if (!spc.empty()) rest_ += "1.," + spc + "\n";
    return *this;
  }
  Bodies& text(const std::string& text) {
    rest_ += text;
    return *this;
  }
  [[nodiscard]] std::string deck() const { return "*NODE\n" + nodes_ + "*ELEMENT_MASS\n" + masses_ + rest_; }

 private:
  std::string nodes_, masses_, rest_;
};

const std::string fixed = "7,7", falls = "*LOAD_BODY_Z\n8,10.\n*DEFINE_CURVE\n8\n0.,1.\n1.,1.\n";
const std::vector<Vector> cross = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}};

/// Between a fixed body 1 at the origin and a body 2.
Bodies pair(const std::vector<Vector>& second, const std::string& joint) {
  return Bodies().add(1, cross, 1, fixed).add(2, second, 2).text(joint);
}

/// A stepper that checks its energies loosely: at turning arms works are of second order in the step.
Stepper loosely(const Bodies& bodies) {
  StepSettings settings = fixed_step(1e-3);
  settings.energy_tolerance = 1e-3;
  return good(bodies.deck()).stepper(settings);
}

double most_error(const Stepper& stepper) { return stepper.structure().rigid.joint_error(); }

// A pendulum that starts at 90 degrees: a quarter of its period is √(I / m g d) K(sin 45°), the force at the lowest
// point m g + m ω² d.
TEST(RigidJoints, Pendulum) {
  for (const std::string kind : {"SPHERICAL", "REVOLUTE"}) {
    const std::string joint = kind == "SPHERICAL" ? "*CONSTRAINED_JOINT_SPHERICAL\n10,20\n"
                                                  : "*CONSTRAINED_JOINT_REVOLUTE_ID\n3,pin\n10,20,12,25\n";
    Bodies bodies =
        pair({{0, 0, 0}, {2, 0.3, 0}, {2, -0.3, 0}, {2, 0, 0.3}, {2, 0, -0.3}, {0, 0.5, 0}, {0, -0.5, 0}}, joint);
    Stepper stepper = loosely(bodies.text(falls));
    const double mass = 14, arm = 16.0 / 14, inertia = 2 * (4 * 4 + 2 * 0.09);
    const double reference = std::sqrt(inertia / (mass * 10 * arm)) * std::comp_ellint_1(std::sin(pi / 4));
    double before = 0, crossed = 0, force = 0;
    while (crossed == 0 && stepper.state().time < 2 * reference) {
      before = stepper.state().bodies[1].center.x();
      force = stepper.structure().rigid.joints()[0].force.z();
      run(stepper, 1);
      const double now = stepper.state().bodies[1].center.x();
      if (now < 0) crossed = stepper.state().time - 1e-3 * now / (now - before);
      EXPECT_LT(most_error(stepper), 1e-12);
    }
    RecordProperty("pendulum_" + kind, fmt::format("{:.8f}", crossed / reference));
    EXPECT_NEAR(crossed / reference, 1, 1e-5);
    const double spin_squared = 2 * mass * 10 * arm / inertia;
    EXPECT_NEAR(force / (mass * 10 + mass * spin_squared * arm), 1, 1e-4);
    EXPECT_NEAR(stepper.energies().total(), stepper.energies().external, 1e-3);
    EXPECT_NEAR(stepper.state().bodies[1].center.y(), 0, 1e-9);
  }
}

// Crank and slider: x = r cos ωt + √(l² − r² sin² ωt) over two turns.
TEST(RigidJoints, SliderCrank) {
  constexpr double r = 1, l = 3, omega = 2 * pi;
  Bodies bodies;
  bodies.add(1, {{0, 0, 0}, {0, 0, 0.5}, {0.5, 0, 0}, {0, 0.5, 0}}, 1, fixed);
  bodies.add(2, {{0, 0, 0}, {0, 0, 0.5}, {r, 0, 0}, {r, 0, 0.5}, {0, 0.5, 0}}, 1);
  bodies.add(3, {{r, 0, 0}, {r, 0, 0.5}, {r + l, 0, 0}, {r + l, 0, 0.5}, {r, 0.5, 0}}, 1);
  bodies.add(4, {{r + l, 0, 0}, {r + l, 0, 0.5}, {r + l, 0.5, 0}, {r + l + 0.5, 0, 0}}, 1, "5,7");
  bodies.text(
      "*CONSTRAINED_JOINT_REVOLUTE\n10,20,11,21\n22,30,23,31\n32,40,33,41\n"
      "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,7,0,9\n*DEFINE_CURVE\n9\n0.,6.283185307179586\n");
  StepSettings settings = fixed_step(1e-3);
  settings.energy_tolerance = 0;
  Stepper stepper = good(bodies.deck()).stepper(settings);
  const double start = stepper.state().bodies[3].center.x() - (r + l);
  double most = 0;
  for (int i = 0; i < 2000; ++i) {
    run(stepper, 1);
    const double angle = omega * stepper.state().time;
    const double x = r * std::cos(angle) + std::sqrt(l * l - r * r * std::sin(angle) * std::sin(angle));
    most = std::max(most, std::abs(stepper.state().bodies[3].center.x() - start - x));
  }
  RecordProperty("slider_crank_error", fmt::format("{:.2e}", most));
  EXPECT_LT(most, 1e-7);
  EXPECT_LT(most_error(stepper), 1e-7);
  // After whole turns all is as at the start: the work of the crank is the kinetic energy.
  const Energies& e = stepper.energies();
  EXPECT_NEAR(e.total() - e.initial, e.external, 1e-2 * e.kinetic);
}

// Cardan's shafts at 40 degrees: tan φ₂ = tan φ₁ cos β.
TEST(RigidJoints, UniversalJoint) {
  const double beta = 40 * pi / 180;
  const Vector axis(std::cos(beta), std::sin(beta), 0), side(-std::sin(beta), std::cos(beta), 0);
  Bodies bodies;
  bodies.add(1, {2 * axis, 2.5 * axis, 2 * axis + side, Vector(0, 0, 1)}, 1, fixed);
  bodies.add(2, {{0, 0, 0}, {0, 0, 0.5}, {0, 0, -0.5}, {0, 0.5, 0}, {0, -0.5, 0}}, 1, "7,5");
  bodies.add(3, {{0, 0, 0}, 0.5 * side, 2 * axis, 2.5 * axis, Vector(0, 0, 0.5)}, 1);
  bodies.text(
      "*CONSTRAINED_JOINT_UNIVERSAL\n20,30,21,31\n*CONSTRAINED_JOINT_REVOLUTE\n10,32,11,33\n"
      "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,5,0,9\n*DEFINE_CURVE\n9\n0.,6.283185307179586\n");
  StepSettings settings = fixed_step(1e-3);
  settings.energy_tolerance = 0;
  Stepper stepper = good(bodies.deck()).stepper(settings);
  double most = 0;
  for (int i = 0; i < 1000; ++i) {
    run(stepper, 1);
    const Vector arm = stepper.structure().rigid[2].rotation() * side;
    const double driven = 2 * pi * stepper.state().time, turned = std::atan2(arm.z(), arm.dot(side));
    const double expected = std::atan2(std::sin(driven) * std::cos(beta), std::cos(driven));
    most = std::max(most, std::abs(std::remainder(turned - expected, 2 * pi)));
  }
  RecordProperty("universal_joint_error", fmt::format("{:.2e}", most));
  EXPECT_LT(most, 1e-6);
}

/// Forces and torques on the centre of body 2.
const std::string pushes =
    "*LOAD_RIGID_BODY\n2,1,8,3.\n2,2,8,4.\n2,3,8,5.\n2,5,8,0.3\n2,6,8,0.4\n2,7,8,0.5\n"
    "*DEFINE_CURVE\n8\n0.,1.\n1.,1.\n";

// What a joint leaves free follows the load alone, what it holds rests: for three kinds of joints.
TEST(RigidJoints, FreeAndHeldDirections) {
  // Body 2: its centre is on the axis z of the joint, so that the freedoms are independent.
  const std::vector<Vector> second = {{0, 0, 0}, {0, 0, 0.5}, {0.5, 0, 0}, {-0.5, 0, 0}, {0, 0.5, 0}, {0, -0.5, 0}};
  const double mass = 12, about_z = 2 * 4 * 0.25, time = 0.1;
  const auto moved = [&](const std::string& joint) {
    Bodies bodies = pair(second, joint);
    Stepper stepper = loosely(bodies.text(pushes));
    const Vector start = stepper.state().bodies[1].center;
    run(stepper, 100);
    EXPECT_LT(most_error(stepper), 1e-12);
    const RigidBody& body = stepper.structure().rigid[1];
    const Matrix& turn = body.rotation();
    return std::pair(Vector(body.center() - start), Vector(turn(2, 1), turn(0, 2), turn(1, 0)));
  };
  const auto way = [&](double force) { return force / mass * time * time / 2; };
  const double turned = std::sin(0.5 / about_z * time * time / 2);
  const auto [cylinder, cylinder_turn] = moved("*CONSTRAINED_JOINT_CYLINDRICAL\n10,20,13,21\n");
  EXPECT_NEAR((cylinder - Vector(0, 0, way(5))).norm(), 0, 1e-12);
  EXPECT_NEAR((cylinder_turn - Vector(0, 0, turned)).norm(), 0, 1e-7);
  const auto [plane, plane_turn] = moved("*CONSTRAINED_JOINT_PLANAR\n10,20,13,21\n");
  EXPECT_NEAR((plane - Vector(way(3), way(4), 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((plane_turn - Vector(0, 0, turned)).norm(), 0, 1e-7);
  const auto [slide, slide_turn] = moved("*CONSTRAINED_JOINT_TRANSLATIONAL\n10,20,13,21,11,22\n");
  EXPECT_NEAR((slide - Vector(0, 0, way(5))).norm(), 0, 1e-12);
  EXPECT_NEAR(slide_turn.norm(), 0, 1e-12);
}

// Two free bodies on one joint tumble: momentum, angular momentum and energy stay; twice the same joint is one.
TEST(RigidJoints, TumblingPair) {
  std::vector<Vector> last;
  for (const std::string again : {"", "10,20\n"}) {
    Bodies bodies;
    bodies.add(1, {{0, 0, 0}, {-1, 0, 0}, {-0.5, 0.3, 0}, {-0.5, 0, 0.6}}, 1);
    bodies.add(2, {{0, 0, 0}, {1, 0.2, 0}, {0.5, 0.3, 0}, {0.5, 0, 0.6}}, 2);
    bodies.text("*CONSTRAINED_JOINT_SPHERICAL\n10,20\n" + again +
                "*INITIAL_VELOCITY_RIGID_BODY\n1,1.,0.,0.,1.,2.,3.\n2,0.,2.,0.,-1.,0.5,0.\n");
    Stepper stepper = loosely(bodies);
    const auto sums = [&] {
      Vector momentum = Vector::Zero(), angular = Vector::Zero();
      for (const BodyState& body : stepper.state().bodies) {
        momentum += body.mass * body.velocity;
        angular += body.angular_momentum + body.mass * body.center.cross(body.velocity);
      }
      return std::pair(momentum, angular);
    };
    run(stepper, 1);
    const auto [momentum, angular] = sums();
    const double energy = [&] {
      run(stepper, 1);
      return stepper.energies().kinetic;
    }();
    run(stepper, 2000);
    EXPECT_NEAR((sums().first - momentum).norm(), 0, 1e-11);
    EXPECT_NEAR((sums().second - angular).norm(), 0, 1e-9);
    EXPECT_NEAR(stepper.energies().kinetic / energy, 1, 1e-5);
    EXPECT_LT(most_error(stepper), 1e-11);
    last.push_back(stepper.state().x[1]);
  }
  EXPECT_NEAR((last[0] - last[1]).norm(), 0, 1e-6);
}

TEST(RigidJoints, ContradictionsEndTheRun) {
  const auto said = [](const Bodies& bodies) {
    const Conditioned result = conditioned(bodies.deck());
    return result.status.ok() ? std::string() : result.status.error().message;
  };
  const auto with = [&](const std::string& joint) { return said(pair(cross, joint)); };
  EXPECT_EQ(with("*CONSTRAINED_JOINT_REVOLUTE\n10,20,11,21\n"), "");
  for (const auto& [joint, expected] : std::initializer_list<std::pair<std::string, std::string>>{
           {"*CONSTRAINED_JOINT_SPHERICAL\n10,99\n", "node 99 is not defined"},
           {"*CONSTRAINED_JOINT_SPHERICAL\n10\n", "node 0 is not defined"},
           {"*CONSTRAINED_JOINT_SPHERICAL\n10,11\n", "same rigid body"},
           {"*CONSTRAINED_JOINT_REVOLUTE\n10,20,21,11\n", "N1, N3 and N5"},
           {"*CONSTRAINED_JOINT_REVOLUTE\n10,20,10,20\n", "give no axis"},
           {"*CONSTRAINED_JOINT_REVOLUTE\n10,20\n", "node 0 is not defined"},
           {"*CONSTRAINED_JOINT_UNIVERSAL\n10,20,11,21\n", "must cross"},
           {"*NODE\n5,0.,0.,0.\n*ELEMENT_MASS\n5,5,1.\n*CONSTRAINED_JOINT_SPHERICAL\n10,5\n", "no rigid body"}})
    EXPECT_NE(with(joint).find(expected), std::string::npos) << joint << with(joint);
  EXPECT_NE(said(Bodies().add(1, cross, 1, fixed).add(2, cross, 0).text("*CONSTRAINED_JOINT_SPHERICAL\n10,20\n"))
                .find("no rigid body with a mass"),
            std::string::npos);
  Conditioned apart =
      good(pair({{0.25, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}, "*CONSTRAINED_JOINT_SPHERICAL\n10,20\n").deck());
  EXPECT_NE(apart.warnings.find("0.25 apart"), std::string::npos) << apart.warnings;
}

// Between two bodies that cannot move there is nothing to do; numbers without sense must not bring it down.
TEST(RigidJoints, BetweenFixedBodiesAndHostileNumbers) {
  Bodies held;
  held.add(1, cross, 1, fixed).add(2, cross, 1, fixed).text("*CONSTRAINED_JOINT_REVOLUTE\n10,20,11,21\n" + falls);
  Stepper rests = good(held.deck()).stepper(fixed_step(1e-3));
  run(rests, 10);
  EXPECT_EQ(rests.state().bodies[1].velocity, Vector::Zero());
  Stepper wild =
      good(pair(cross,
                "*CONSTRAINED_JOINT_REVOLUTE\n10,20,11,21\n*INITIAL_VELOCITY_RIGID_BODY\n2,1e29,1e25,0.,1e29,"
                "1e10,3.\n")
               .deck())
          .stepper(fixed_step(1e-3));
  SolverStatus status;
  for (int i = 0; i < 5 && status.ok(); ++i) status = wild.step();
  if (!status.ok()) {
    EXPECT_FALSE(status.error().message.empty());
  }
}

}  // namespace
}  // namespace gapcheck::solver::rigid_joints_test
