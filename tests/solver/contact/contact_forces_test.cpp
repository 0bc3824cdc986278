#include "solver/contact/contact_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/parallel.hpp"
#include "solver/contact_scene.hpp"

namespace gapcheck::solver::contact_forces_test {
namespace {

constexpr double pi = std::numbers::pi;
// Optional cards A, B, C: SNLOG = 1, and IGNORE.
const std::string no_shooting = "0,0.1\n0.,0,0,1\n";
const std::string tracking = "0,0.1\n0.\n1,1\n";
const std::string shooting = "0,0.1\n0.\n1,0\n";
// K = E / (3 (1 - 2ν)) = 1000 / 1.5; k = 0.1 K A / longest diagonal.
const double stiffness = 0.1 * 1000 / 1.5 / std::sqrt(2.0);

StepSettings steps(double dt) {
  StepSettings settings;
  settings.greatest_step = dt;
  settings.bounded_step = false;
  settings.time_step_factor = 1e30;
  return settings;
}

void hold_quad(Structure& structure) {
  for (std::uint32_t i = 0; i < 4; ++i) structure.constraints.hold(NodeIndex{i}, 63);
}

/// Angular frequency of central differences: sin(w dt / 2) = w0 dt / 2.
double discrete(double frequency, double dt) { return 2 / dt * std::asin(frequency * dt / 2); }

// A node of mass m meets a held segment: half a period of sqrt(k/m), deepest point v / w, and it leaves as fast as it
// came.
TEST(ContactForces, NodeReboundsFromHeldSegment) {
  const double v = 0.1, h = 0.05, dt = 1e-3;
  ContactScene scene(
      node_over_quad(h, 2 * h, no_shooting),
      [&](Structure& s) {
        hold_quad(s);
        s.state.v[4].z() = -v;
      },
      steps(dt));
  const double w = discrete(std::sqrt(stiffness), dt);
  double deepest = 0, inside = 0;
  for (int i = 0; i < 2000; ++i) {
    scene.step();
    if (scene.result().touching > 0) inside += dt;
    for (const ContactNode& node : scene.contacts->nodes(0)) deepest = std::max(deepest, node.penetration);
  }
  EXPECT_NEAR(inside, pi / w, 1.5 * dt);
  EXPECT_NEAR(deepest, v / w, 1e-4 * v / w);
  // What is missing is the part of a step between the surface and the first point inside.
  EXPECT_NEAR(scene.state().v[4].z(), v, 1e-5 * v);
  EXPECT_NEAR(scene.stepper->energies().absorbed.contact_normal, 0, 1e-5 * v * v);
}

// Two free bodies: the segment's nodes of 1 each move as one of 4, the frequency is that of the reduced mass.
TEST(ContactForces, TwoMassesReboundAndKeepMomentum) {
  const double v = 0.1, h = 0.05, dt = 1e-3;
  ContactScene scene(
      node_over_quad(h + 1e-4, 2 * h, no_shooting), [&](Structure& s) { s.state.v[4].z() = -v; }, steps(dt));
  const Vector before = scene.momentum();
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    scene.step();
    inside += scene.result().touching > 0;
    ASSERT_NEAR(scene.momentum().z(), before.z(), 1e-14);
  }
  const double reduced = 4.0 / 5;
  EXPECT_NEAR(inside * dt, pi / discrete(std::sqrt(stiffness / reduced), dt), 2 * dt);
  // Elastic impact of 1 on 4 at rest.
  EXPECT_NEAR(scene.state().v[4].z(), -v * (1 - 4.0) / 5, 1e-4 * v);
  EXPECT_NEAR(scene.state().v[0].z(), -v * 2.0 / 5, 1e-4 * v);
  EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 1e-10);
}

// Shooting-node logic: a node that jumps into the contact distance from beyond twice that distance is moved 1.002
// penetrations out, without force.
TEST(ContactForces, ShootingNodeIsMoved) {
  const double v = 6.05, h = 0.05, dt = 1e-2;
  ContactScene scene(
      node_over_quad(h + 0.06, 2 * h, shooting),
      [&](Structure& s) {
        hold_quad(s);
        s.state.v[4].z() = -v;
      },
      steps(dt));
  scene.step(2);  // at the second force evaluation the node is 0.0005 inside
  EXPECT_EQ(scene.result().moved, 1u);
  EXPECT_EQ(scene.result().touching, 0u);
  EXPECT_NEAR(scene.state().x[4].z(), h - 0.0005 + 1.002 * 0.0005 - v * dt, 1e-12);
}

// A node that the segment has in sight is forced from its first overlap on, whatever the start demands.
TEST(ContactForces, FollowedNodeIsForcedFromItsFirstOverlap) {
  const double v = 0.1, h = 0.05, dt = 1e-2;
  for (const std::string& start : {shooting, no_shooting}) {
    ContactScene scene(
        node_over_quad(h + 0.0005, 2 * h, start),
        [&](Structure& s) {
          hold_quad(s);
          s.state.v[4].z() = -v;
        },
        steps(dt));
    scene.step(2);  // at the second force evaluation the node is 0.0005 inside
    EXPECT_EQ(scene.result().moved, 0u);
    EXPECT_EQ(scene.result().touching, 1u);
    EXPECT_NEAR(scene.stepper->external().force[4].z(), stiffness * 0.0005, 1e-9);
  }
}

// Touching is no penetration, within the tolerance of 1e-9 h: a node that comes back to it has left.
TEST(ContactForces, FollowedNodeLeavesWithinTheTolerance) {
  const double v = 0.1, h = 0.05;
  StepSettings settings = steps(1e-2);
  settings.energy_tolerance = 0;  // the node is put elsewhere
  for (const double share : {0.5, 2.0}) {
    ContactScene scene(
        node_over_quad(h + 0.0005, 2 * h, no_shooting),
        [&](Structure& s) {
          hold_quad(s);
          s.state.v[4].z() = -v;
        },
        settings);
    scene.step(4);
    ASSERT_EQ(scene.result().touching, 1u);
    auto& state = const_cast<State&>(scene.state());
    state.x[4].z() = h - share * 1e-9 * h;
    state.v[4].z() = 0;
    scene.step();
    EXPECT_EQ(scene.contacts->nodes(0).size(), share < 1 ? 0u : 1u);
    EXPECT_EQ(scene.stepper->external().force[4].z() > 0, share > 1);
  }
}

TEST(ContactForces, FollowedNodeRebounds) {
  const double h = 0.05, dt = 1e-2;
  ContactScene scene(
      node_over_quad(h, 2 * h, shooting),
      [&](Structure& s) {
        hold_quad(s);
        s.state.v[4].z() = -0.01;
      },
      steps(dt));
  scene.step(400);
  EXPECT_EQ(scene.result().moved, 0u);
  EXPECT_NEAR(scene.state().v[4].z(), 0.01, 1e-3 * 0.01);
}

// At the start the record of the initialisation decides: a node that was moved is on the surface and free of force.
TEST(ContactForces, InitialPenetrationIsMovedWithoutForce) {
  const double h = 0.05;
  ContactScene scene(node_over_quad(0.8 * h, 2 * h, shooting), hold_quad, steps(1e-3));
  ASSERT_EQ(scene.initial.penetrations.size(), 1u);
  scene.step(50);
  EXPECT_EQ(scene.result().touching, 0u);
  EXPECT_NEAR(scene.state().x[4].z(), h + 0.002 * 0.2 * h, 1e-15);
  EXPECT_EQ(scene.state().v[4].norm(), 0);
}

// SNLOG = 1: full force at once; the energy that appears shows as negative contact energy.
TEST(ContactForces, InitialPenetrationIsForcedWithSnlog) {
  const double h = 0.05, p = 0.2 * h;
  ContactScene scene(node_over_quad(h - p, 2 * h, no_shooting), hold_quad, steps(1e-3));
  scene.step();
  EXPECT_NEAR(scene.stepper->external().force[4].z(), stiffness * p, 1e-12);
  scene.step(2000);
  EXPECT_NEAR(scene.stepper->energies().absorbed.contact_normal, -stiffness * p * p / 2, 2e-3 * stiffness * p * p);
  EXPECT_NEAR(scene.state().v[4].z(), p * std::sqrt(stiffness), 1e-3 * p * std::sqrt(stiffness));
}

// IGNORE = 1: no force at the depth that was there; what goes deeper is forced from there; once out, all thickness is
// back.
TEST(ContactForces, IgnoredDepthIsForgivenUntilTheNodeLeaves) {
  const double h = 0.05, p = 0.2 * h, dt = 1e-3, v = 0.005;
  ContactScene scene(
      node_over_quad(h - p, 2 * h, tracking),
      [&](Structure& s) {
        hold_quad(s);
        s.state.v[4].z() = -v;
      },
      steps(dt));
  scene.step();
  EXPECT_NEAR(scene.contacts->nodes(0).at(0).forgiven, p, 1e-15);
  EXPECT_EQ(scene.stepper->external().force[4].z(), 0);
  scene.step();
  EXPECT_NEAR(scene.stepper->external().force[4].z(), stiffness * v * dt, 1e-9);
  scene.step(4000);  // sprung back, and out
  ASSERT_GT(scene.state().x[4].z(), h);
  EXPECT_NEAR(scene.state().v[4].z(), v, 1e-3 * v);
  EXPECT_TRUE(scene.contacts->nodes(0).empty());
}

// Too deep: no force on the way through to the other side; the node comes back only after it has left the whole zone.
TEST(ContactForces, ReleasedNodePassesAndReturnsOutside) {
  const double h = 0.05, v = 0.05, dt = 1e-2;
  ContactScene scene(
      node_over_quad(0.1 * h, 2 * h, no_shooting),
      [&](Structure& s) {
        hold_quad(s);
        s.state.v[4].z() = -v;
      },
      steps(dt));
  ASSERT_EQ(scene.initial.penetrations.at(0).outcome, Outcome::released);
  while (scene.state().x[4].z() > -h) {
    scene.step();
    ASSERT_EQ(scene.result().touching, 0u);
    ASSERT_EQ(scene.result().released, 1u);
  }
  scene.step(2);
  EXPECT_EQ(scene.result().released, 0u);
  EXPECT_EQ(scene.state().v[4].z(), -v);
}

// A released node that turns back before it has left is let through again.
TEST(ContactForces, ReleasedNodeThatTurnsBackIsNotCaught) {
  const double h = 0.05, v = 0.05;
  ContactScene scene(
      node_over_quad(0.1 * h, 2 * h, no_shooting),
      [&](Structure& s) {
        hold_quad(s);
        s.state.v[4].z() = -v;
      },
      steps(1e-2));
  scene.step(80);  // on the other side of the mid-surface, in the zone
  ASSERT_LT(scene.state().x[4].z(), -0.5 * h);
  const_cast<State&>(scene.state()).v[4].z() = v;
  while (scene.state().x[4].z() < 1.2 * h) {
    scene.step();
    ASSERT_EQ(scene.result().touching, 0u);
  }
  EXPECT_EQ(scene.state().v[4].z(), v);
}

/// Presses node 5 down with a constant force.
class Weight : public Force {
 public:
  explicit Weight(double force) : force_(force) {}
  void add(State&, Forces& forces) override { forces.force[4].z() -= force_; }

 private:
  double force_;
};

// A block sliding under its weight stops after v² / (2 μ g).
TEST(ContactForces, BlockSlidesToRest) {
  const double h = 0.05, weight = 0.02, mu = 0.3, v = 0.03, dt = 1e-3;
  const double settled = h - weight / stiffness;
  ContactScene scene(
      node_over_quad(settled, 2 * h, no_shooting, "", fmt::format("{0},{0}", mu)),
      [&](Structure& s) {
        hold_quad(s);
        s.state.v[4].x() = v;
      },
      steps(dt));
  scene.stepper->add(std::make_unique<Weight>(weight));
  const double way = v * v / (2 * mu * weight);
  scene.step(8000);
  // At rest it swings about the place where the friction spring held it, by what the spring stretches.
  EXPECT_NEAR(scene.state().x[4].x(), 0.5 + way, 2 * mu * weight / stiffness);
  EXPECT_NEAR(scene.result().friction, v * v / 2, 0.02 * v * v / 2);
  EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 1e-6);
}

// A weight slides over a row of quads far from the origin: the contact follows it from one to the next, and its force
// is the weight all the way.
TEST(ContactForces, SlidesFromSegmentToSegment) {
  constexpr double h = 0.05, weight = 0.02, speed = 1, dt = 1e-3;
  for (const int direction : {1, -1}) {
    std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
    for (int i = 0; i < 5; ++i) {
      nodes += fmt::format("{0},{2}.,0.,0.\n{1},{2}.,1.,0.\n", 2 * i + 1, 2 * i + 2, 100 + i);
      if (i < 4) shells += fmt::format("{},1,{},{},{},{}\n", i + 1, 2 * i + 1, 2 * i + 3, 2 * i + 4, 2 * i + 2);
    }
    ContactScene scene(
        nodes + fmt::format("100,{},0.3,{:.17g}\n", direction > 0 ? 100.2 : 103.8, h - weight / stiffness) + shells +
            "*ELEMENT_MASS\n1,100,1.\n*PART\np\n1,1,1\n*SECTION_SHELL\n1,2\n0.1\n"
            "*MAT_ELASTIC\n1,1.,1000.,0.25\n*SET_NODE_LIST\n1\n100\n*SET_PART_LIST\n1\n1\n"
            "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n1,1,4,2\n0.\n1.,1.\n" +
            no_shooting,
        [&](Structure& s) {
          for (std::uint32_t i = 0; i < 10; ++i) s.constraints.hold(NodeIndex{i}, 63);
          s.state.v[10].x() = direction * speed;
        },
        steps(dt));
    class Push : public Force {
     public:
      void add(State&, Forces& forces) override { forces.force[10].z() -= 0.02; }
    };
    scene.stepper->add(std::make_unique<Push>());
    for (int i = 0; i < 3500; ++i) {
      scene.step();
      ASSERT_EQ(scene.result().touching, 1u) << scene.state().x[10].x();
      ASSERT_NEAR(scene.result().force_a.z() / weight, 1, 1e-3) << scene.state().x[10].x();
    }
    EXPECT_NEAR(scene.state().v[10].x(), direction * speed, 1e-9);
  }
}

// The coefficient falls from FS to FD with the speed: dv/dt = -g (FD + (FS - FD) exp(-DC v)).
TEST(ContactForces, FrictionDecaysWithTheSpeed) {
  const double h = 0.05, weight = 0.02, fs = 0.3, fd = 0.1, dc = 60, v = 0.03, dt = 1e-3;
  ContactScene scene(
      node_over_quad(h - weight / stiffness, 2 * h, no_shooting, "", fmt::format("{},{},{}", fs, fd, dc)),
      [&](Structure& s) {
        hold_quad(s);
        s.state.v[4].x() = v;
      },
      steps(dt));
  scene.stepper->add(std::make_unique<Weight>(weight));
  double speed = v;
  for (int i = 0; i < 5000; ++i) {
    const auto slope = [&](double u) { return -weight * (fd + (fs - fd) * std::exp(-dc * u)); };
    speed += dt * slope(speed + dt / 2 * slope(speed));
  }
  scene.step(5000);
  ASSERT_GT(speed, 0.3 * v) << "it still slides";
  EXPECT_NEAR(scene.state().v[4].x(), speed, 0.01 * v);
}

// Below μ N a force does not move it, above it does.
TEST(ContactForces, StickLimit) {
  class Pull : public Force {
   public:
    explicit Pull(double force) : force_(force) {}
    void add(State&, Forces& forces) override { forces.force[4].x() += force_; }

   private:
    double force_;
  };
  const double h = 0.05, weight = 0.2, mu = 0.3;
  for (const double share : {0.45, 1.05}) {
    ContactScene scene(node_over_quad(h - weight / stiffness, 2 * h, no_shooting, "", "0.3,0.3"), hold_quad,
                       steps(1e-3));
    scene.stepper->add(std::make_unique<Weight>(weight));
    scene.stepper->add(std::make_unique<Pull>(share * mu * weight));
    scene.step(1000);
    // The friction spring swings about its stretch; at its limit the node slides with what is left of the pull.
    const double limit = mu * weight, pull = share * limit, w = std::sqrt(stiffness), time = 1;
    double expected = pull / stiffness * (1 - std::cos(w * time));
    if (share > 1) {
      const double angle = std::acos(1 - 1 / share), rest = time - angle / w;
      expected = limit / stiffness + pull / stiffness * w * std::sin(angle) * rest + (pull - limit) / 2 * rest * rest;
    }
    EXPECT_NEAR(scene.state().x[4].x() - 0.5, expected, 0.01 * pull / stiffness) << share;
  }
}

// VC limits the friction force to VC times the segment's area.
TEST(ContactForces, ViscousLimitOfFriction) {
  const double h = 0.05, weight = 0.2, limit = 0.01;
  ContactScene scene(
      node_over_quad(h - weight / stiffness, 2 * h, no_shooting, "", fmt::format("0.3,0.3,0.,{}", limit)),
      [&](Structure& s) {
        hold_quad(s);
        s.state.v[4].x() = 0.05;
      },
      steps(1e-3));
  scene.stepper->add(std::make_unique<Weight>(weight));
  scene.step(1000);
  EXPECT_NEAR(scene.stepper->external().force[4].x(), -limit, 1e-12);
}

// VDC percent of critical damping: the ratio of the speeds after and before of a damped half period.
TEST(ContactForces, DampedRebound) {
  const double v = 0.1, h = 0.05, dt = 1e-4, percent = 20;
  ContactScene scene(
      node_over_quad(h, 2 * h, no_shooting, "", fmt::format("0.,0.,0.,0.,{}", percent)),
      [&](Structure& s) {
        hold_quad(s);
        s.state.v[4].z() = -v;
      },
      steps(dt));
  scene.step(20000);
  // m = min(1, 4), reduced mass 4/5 in the frequency, as the rule has it; against a held segment the mass that moves
  // is 1.
  const double constant = percent / 100 * 2 * std::sqrt(stiffness * 5 / 4), damping = constant / 2,
               w0 = std::sqrt(stiffness);
  const double w = std::sqrt(w0 * w0 - damping * damping);
  // The force is zero where k p = -c v: it leaves then, before the spring is straight.
  const double t = (pi - std::atan2(2 * damping * w, w0 * w0 - 2 * damping * damping)) / w;
  const double expected = std::exp(-damping * t) * (-std::cos(w * t) + damping / w * std::sin(w * t)) * v;
  EXPECT_NEAR(scene.state().v[4].z(), expected, 1e-3 * v);
  EXPECT_NEAR(scene.result().damping, (v * v - expected * expected) / 2, 1e-3 * v * v);
  EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 1e-6);
}

// Outside its time a contact does nothing.
TEST(ContactForces, BirthAndDeath) {
  const double h = 0.05, v = 0.05;
  // Card 2: BT and DT are its seventh and eighth field.
  for (const auto& [times, free] :
       {std::pair{"0.,0.,0.,0.,0.,0,5.,0.", true}, std::pair{"0.,0.,0.,0.,0.,0,0.,.5", true},
        std::pair{"0.,0.,0.,0.,0.,0,0.,100.", false}}) {
    ContactScene scene(
        node_over_quad(2 * h, 2 * h, no_shooting, "", times),
        [&](Structure& s) {
          hold_quad(s);
          s.state.v[4].z() = -v;
        },
        steps(1e-2));
    scene.step(400);
    EXPECT_EQ(scene.state().v[4].z() == -v, free) << times;
  }
}

// LCIDAB: the contact grows thicker with time and pushes a node that rests above the surface; the same with a search in
// every cycle.
TEST(ContactForces, ThicknessOverTime) {
  const auto run = [&](int bsort) {
    const std::string deck = fmt::format(
        "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n11,.4,.4,0.2\n12,.6,.4,0.2\n13,.6,.6,.2\n14,.4,.6,.2\n"
        "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,11,12,13,14\n*PART\np\n1,1,1\n*PART\nq\n2,1,1\n*SECTION_SHELL\n1,2\n0.01\n"
        "*MAT_ELASTIC\n1,100.,1000.,0.25\n*DEFINE_CURVE\n7\n0.,0.1\n0.1,0.1\n0.3,0.25\n"
        "*CONTACT_AIRBAG_SINGLE_SURFACE\n0,0,2\n\n\n0,0.1,7,1.025,0.,2,{}\n0.,0,0,1\n",
        bsort);
    ContactScene scene(deck, hold_quad, steps(1e-3));
    double first = -1;
    for (int i = 0; i < 400; ++i) {
      scene.step();
      if (first < 0 && scene.result().touching > 0) first = scene.state().time;
    }
    // The zone reaches 0.2 when the thickness is 0.2, two thirds of the way up.
    EXPECT_NEAR(first, 0.1 + 0.2 * 2 / 3, 2e-3);
    EXPECT_GT(scene.state().v[4].z(), 0);
    return scene.state().x;
  };
  EXPECT_EQ(run(0), run(1));
}

// A contact that grows thicker lets a node go at 0.4 (ts + tm) of its present thickness, not of that at its start: from
// 0.2 to 0.6 a node at 0.15 is deeper than 0.4 · 0.4 soon, and never as deep as 0.8 t.
TEST(ContactForces, ReleaseDepthFollowsTheThickness) {
  ContactScene scene(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n11,.4,.4,.15\n12,.6,.4,.15\n13,.6,.6,.15\n14,.4,.6,.15\n"
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,11,12,13,14\n*PART\np\n1,1,1\n*PART\nq\n2,1,1\n*SECTION_SHELL\n1,2\n0.01\n"
      "*MAT_ELASTIC\n1,100.,1000.,0.25\n*DEFINE_CURVE\n7\n0.,0.1\n0.5,0.6\n1.5,0.6\n1.6,0.9\n"
      "*CONTACT_AIRBAG_SINGLE_SURFACE\n0,0,2\n\n\n0,0.1,7\n0.,0,0,1\n",
      [](Structure& s) {
        for (std::uint32_t i = 0; i < 8; ++i) s.constraints.hold(NodeIndex{i}, 63);
      },
      steps(1e-2));
  scene.step(120);
  EXPECT_EQ(scene.result().touching, 4u);
  EXPECT_EQ(scene.result().released, 0u);
  ASSERT_EQ(scene.contacts->nodes(0).size(), 4u);
  EXPECT_NEAR(scene.contacts->nodes(0)[0].penetration, 0.45, 1e-12);
  scene.step(60);  // 0.9 - 0.15 is beyond 0.8 · 0.9
  EXPECT_EQ(scene.result().released, 4u);
}

// Candidates are kept while nothing has moved by more than the margin, or for BSORT cycles.
TEST(ContactForces, SearchesWhenItMust) {
  const auto counters = [](const std::string& options, double speed) {
    ContactScene scene(
        node_over_quad(0.08, 0.1, options), [&](Structure& s) { s.state.v[4].x() = speed; }, steps(1e-3));
    scene.step(101);
    return scene.contacts->counters();
  };
  for (const auto& [options, times] :
       {std::pair{"0,0.1\n", 1u}, {"0,0.1,0,1.025,0.,2,10\n", 11u}, {"0,0.1,0,1.025,0.,2,1\n", 101u}}) {
    EXPECT_EQ(counters(options, 1e-3).searches, times) << options;
    EXPECT_EQ(counters(options, 1e-3).candidates, times) << "one pair in each search, and none between them";
  }
  const std::uint64_t fast = counters("0,0.1\n", 10).searches;  // by the side of the segment in a hundred cycles
  EXPECT_GT(fast, 1u);
  EXPECT_LT(fast, 11u);
}

/// Two plates of elastic shells, 6 x 6 and 5 x 7, one thrown at the other.
std::string two_plates(const std::string& keyword, const std::string& options) {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  const auto plate = [&](int part, int n, int m, double size, double z, int id) {
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i)
        nodes += fmt::format("{},{},{},{}\n", id + j * (n + 1) + i, size * i / n, size * j / m,
                             z + 0.003 * std::sin(5.0 * i + 3.0 * j));
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = id + j * (n + 1) + i;
        shells += fmt::format("{},{},{},{},{},{}\n", a, part, a, a + 1, a + n + 2, a + n + 1);
      }
  };
  plate(1, 6, 6, 1, 0, 1);
  plate(2, 5, 7, 0.9, 0.06, 1001);
  return nodes + shells +
         "*PART\np\n1,1,1\n*PART\nq\n2,1,1\n*SECTION_SHELL\n1,2\n0.04\n*MAT_ELASTIC\n1,1.,1000.,0.3\n"
         "*CONTROL_CONTACT\n0.1,0.\n*CONTACT_" +
         keyword + options;
}

const std::string single = "AUTOMATIC_SINGLE_SURFACE\n0,0,2\n0.2,0.1,3.\n\n";
const std::string two_way = "AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n0.2,0.1,3.\n\n";

void throw_plate(Structure& structure) {
  for (std::size_t i = 49; i < structure.state.x.size(); ++i) structure.state.v[i] = {0.3, 0.1, -2};
}

/// Positions and velocities after some steps.
std::vector<Vector> run_plates(const std::string& keyword, const std::string& options, int steps_count) {
  ContactScene scene(two_plates(keyword, options), throw_plate);
  scene.step(steps_count);
  EXPECT_GT(scene.result().energy_a + scene.result().energy_b, 0);
  std::vector<Vector> all = scene.state().x;
  all.insert(all.end(), scene.state().v.begin(), scene.state().v.end());
  return all;
}

// Candidates of a search that is kept for many cycles, and pairs that sleep, change nothing: searching in each cycle
// gives the same bits.
TEST(ContactForces, SearchInEveryCycleChangesNothing) {
  for (const std::string& keyword : {single, two_way})
    for (const int soft : {0, 1}) {
      const std::string seldom = fmt::format("{}\n", soft), always = fmt::format("{},0.1,0,1.025,0.,2,1\n", soft);
      EXPECT_EQ(run_plates(keyword, seldom, 150), run_plates(keyword, always, 150)) << keyword << soft;
    }
}

TEST(ContactForces, SameBitsForAnyJobs) {
  std::vector<Vector> one;
  {
    const JobLimit limit(1);
    one = run_plates(two_way, "", 150);
  }
  EXPECT_EQ(one, run_plates(two_way, "", 150));
}

TEST(ContactForces, PlatesKeepMomentumAndEnergy) {
  for (const std::string& keyword : {single, two_way}) {
    ContactScene scene(two_plates(keyword, ""), throw_plate);
    const Vector before = scene.momentum();
    scene.step(1500);
    EXPECT_LT((scene.momentum() - before).norm(), 1e-12 * before.norm());
    EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 0.01) << keyword;
    EXPECT_GT(scene.result().friction, 0.0);
    // The upper plate was stopped: it has given momentum to the lower one.
    double lower = 0;
    for (std::size_t i = 0; i < 49; ++i) lower += scene.state().v[i].z();
    EXPECT_LT(lower, 0.0);
  }
}

// What is far away is not looked at, however much of it there is.
TEST(ContactForces, FarPartsAddNoWork) {
  std::string far = "*NODE\n";
  for (int i = 0; i < 4000; ++i)
    far += fmt::format("{},{},{},{}\n", 10001 + i, 100 + 0.16 * (i % 2), 0.16 * (i / 2), 0.0);
  far += "*ELEMENT_SHELL\n";
  for (int i = 0; i + 3 < 4000; i += 2)
    far += fmt::format("{},3,{},{},{},{}\n", 10001 + i, 10001 + i, 10002 + i, 10004 + i, 10003 + i);
  far += "*PART\nfar\n3,1,1\n";
  const auto counters = [&](const std::string& more) {
    ContactScene scene(more + two_plates(single, ""), [&](Structure& s) {
      for (std::size_t i = 0; i < s.state.x.size(); ++i)
        if (s.state.x[i].z() > 0.05) s.state.v[i] = {0.3, 0.1, -2};
    });
    scene.step(100);
    return scene.contacts->counters();
  };
  const ContactCounters alone = counters(""), with = counters(far);
  EXPECT_GT(alone.pairs, 0u);
  EXPECT_NEAR(static_cast<double>(with.nodes), static_cast<double>(alone.nodes),
              0.1 * static_cast<double>(alone.nodes));
  EXPECT_LE(with.candidates, 1.1 * static_cast<double>(alone.candidates));
}

// Nodes that stay in a segment are followed; those that come, go or lie on edges are decided in the long way.
TEST(ContactForces, NodesInContactAreFollowed) {
  for (const std::string& keyword : {single, two_way}) {
    ContactScene scene(two_plates(keyword, ""), throw_plate);
    scene.step(400);
    const ContactCounters& counters = scene.contacts->counters();
    EXPECT_GT(counters.followed, 100u) << keyword;
    EXPECT_LT(counters.followed, counters.pairs) << keyword;
  }
}

// A plate at rest nearer than the margin of the search is in the candidates, but nobody looks at it, and nothing that
// moves elsewhere changes by a bit.
TEST(ContactForces, PartsAtRestSleep) {
  std::string rest = "*NODE\n";
  for (int i = 0; i < 1200; ++i)
    rest += fmt::format("{},{},{},{}\n", 5001 + i, 20 + 0.16 * (i % 20), 0.16 * (i / 20 % 30), i < 600 ? 0.0 : 0.1);
  rest += "*ELEMENT_SHELL\n";
  for (int i = 0; i < 1200; ++i)
    if (i % 20 < 19 && i / 20 % 30 < 29)
      rest += fmt::format("{},3,{},{},{},{}\n", 5001 + i, 5001 + i, 5002 + i, 5022 + i, 5021 + i);
  rest += "*PART\nrest\n3,1,1\n";
  struct Result {
    std::vector<Vector> moving, start, still;
    ContactCounters counters;
  };
  const auto run = [](const std::string& deck) {
    ContactScene scene(deck, [](Structure& s) {
      for (std::size_t i = 0; i < s.state.x.size(); ++i)
        if (s.state.x[i].z() > 0.05 && s.state.x[i].x() < 10) s.state.v[i] = {0.3, 0.1, -2};
    });
    const std::vector<Vector> before = scene.state().x;
    scene.step(200);
    Result result;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const bool at_rest = before[i].x() > 10;
      (at_rest ? result.still : result.moving).push_back(scene.state().x[i]);
      if (at_rest) result.start.push_back(before[i]);
    }
    result.counters = scene.contacts->counters();
    return result;
  };
  const Result alone = run(two_plates(single, "")), both = run(rest + two_plates(single, ""));
  EXPECT_EQ(both.moving, alone.moving);
  EXPECT_EQ(both.still, both.start);
  const ContactCounters &few = alone.counters, &counters = both.counters;
  constexpr std::uint64_t all = 1200 * 200;  // nodes and cycles
  EXPECT_GT(counters.asleep, few.asleep + all / 2);
  EXPECT_LT(counters.nodes, few.nodes + all / 3);
}

}  // namespace
}  // namespace gapcheck::solver::contact_forces_test
