// Beams whose ends are off their nodes, and beams with hinges.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/element/beam_elements.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::beam_joint_test {
namespace {

constexpr double young = 1000, area = 0.02, iss = 3e-5, itt = 5e-5, torsion = 7e-5, length = 2;

BeamProperties resultant() {
  return {{MaterialKind::elastic, 2, young, 0.25, {}, 0, 0, 0, {}, 1}, {area, iss, itt, torsion, 0, 0}};
}

/// Moves end 2 of a beam along x (s is y, t is z) by a turn only.
BeamForces turned(const BeamReleases& released, const Vector& turn, double& stored) {
  BeamState state;
  state.length = length;
  state.axis = Vector::UnitY();
  state.released = released;
  const Vector still = Vector::Zero();
  const BeamEnds ends{{still, Vector(length, 0, 0)}, {still, still}, {still, turn}};
  const BeamForces forces = resultant_beam_forces(resultant(), ends, 1, state);
  stored = stored_energy(resultant(), state, length);
  return forces;
}

// With a hinge at the other end a turn θ meets 3 E I θ / L instead of 4 E I θ / L, and stores half of that times θ.
TEST(BeamHinge, StiffnessOfTheOtherEnd) {
  constexpr double angle = 1e-5;
  for (const bool about_s : {true, false})
    for (const int hinges : {0, 1, 2, 3}) {
      BeamReleases released;
      (about_s ? released.turn_s : released.turn_t) = {(hinges & 1) != 0, (hinges & 2) != 0};
      double stored = 0;
      const Vector turn = angle * (about_s ? Vector::UnitY() : Vector::UnitZ());
      const BeamForces forces = turned(released, turn, stored);
      const double stiffness = young * (about_s ? iss : itt) / length;
      const double factor = hinges == 0 ? 4 : hinges == 1 ? 3 : 0, other = hinges == 0 ? 2 : 0;
      const int axis = about_s ? 1 : 2;
      EXPECT_NEAR(forces.moment[1][axis] / (stiffness * angle), factor, 1e-6) << hinges;
      EXPECT_NEAR(forces.moment[0][axis] / (stiffness * angle), other, 1e-6) << hinges;
      EXPECT_NEAR(stored / (stiffness * angle * angle / 2), factor, 1e-6) << hinges;
      // Shear balances the moments.
      const double shear = (forces.moment[0][axis] + forces.moment[1][axis]) / length;
      EXPECT_NEAR(forces.force[1][3 - axis], about_s ? shear : -shear, 1e-12);
    }
}

TEST(BeamHinge, TorsionAndTension) {
  BeamReleases released;
  released.twist = true;
  double stored = 0;
  EXPECT_EQ(turned(released, {1e-3, 0, 0}, stored).moment[1].x(), 0);
  EXPECT_EQ(stored, 0);
  EXPECT_GT(turned({}, {1e-3, 0, 0}, stored).moment[1].x(), 1e-6);
  EXPECT_GT(stored, 0);
  BeamState state;
  state.length = length;
  state.axis = Vector::UnitY();
  state.released.axial = true;
  const Vector nothing = Vector::Zero();
  const BeamEnds stretched{{nothing, Vector(length + 0.1, 0, 0)}, {nothing, Vector(0.1, 0, 0)}, {nothing, nothing}};
  EXPECT_EQ(resultant_beam_forces(resultant(), stretched, 1, state).axial, 0);
  EXPECT_EQ(stored_energy(resultant(), state, length + 0.1), 0);
}

/// A deck that comes to rest under what acts in its relaxation.
std::string at_rest(const std::string& deck) {
  return deck +
         "*CONTROL_TERMINATION\n1e-4\n*CONTROL_DYNAMIC_RELAXATION\n250,1e-14,0.98,400.\n*DEFINE_CURVE\n9,1\n0.,0.\n1.,"
         "1.\n"
         "1000.,1.\n";
}

// Two beams between clamps with a hinge beside the loaded middle: two cantilevers, P = 2 · 3 E I w / L³.
TEST(BeamHinge, LoadBetweenTwoCantilevers) {
  for (const bool hinged : {false, true}) {
    RunScene scene(at_rest("*NODE\n1,0.,0.,0.\n2,2.,0.,0.\n3,4.,0.,0.\n4,0.,1.,0.\n*ELEMENT_BEAM\n1,1,1,2,4,0,0,0," +
                           std::string(hinged ? "2" : "0") +
                           "\n2,1,2,3,4\n*PART\np\n1,1,1\n*SECTION_BEAM\n1,2\n0.02,3e-5,5e-5,7e-5\n"
                           "*MAT_ELASTIC\n1,2.,1000.,0.25\n*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n3,0,1,1,1,1,1,1\n"
                           "*LOAD_NODE_POINT\n2,3,9,1e-6\n"));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    std::optional<double> shift;
    scene.go([&](const solver::Run& run) {
      if (!shift) shift = run.stepper().state().x[1].z();
    });
    const double stiffness = young * iss / std::pow(length, 3) * (hinged ? 6 : 24);
    EXPECT_NEAR(*shift * stiffness / 1e-6, 1, 1e-4) << hinged;
    RecordProperty(hinged ? "hinged" : "clamped", fmt::format("{:.6f}", *shift * stiffness / 1e-6));
  }
}

/// A beam along x, clamped at its first node, pulled at its second one.
std::string pulled(const std::string& element, const std::string& section) {
  return "*NODE\n1,0.,0.,0.\n2,2.,0.,0.\n4,0.,1.,0.\n" + element + "*PART\np\n1,1,1\n*SECTION_BEAM\n" + section +
         "*MAT_ELASTIC\n1,2.,1000.,0.25\n*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n*LOAD_NODE_POINT\n2,1,9,1e-6\n";
}

// The axis is off the line of the force by e: P L/EA + P e² L/EI along it, θ = P e L/EI about s or t.
TEST(BeamOffset, EccentricTension) {
  struct Case {
    const char* name;
    std::string element, section;
    Vector arm;
    double area, iss, itt;
  };
  const std::string plain = "*ELEMENT_BEAM\n1,1,1,2,4\n", rectangle = "0.2,0.2,0.3,0.3";
  const double b = 0.2, h = 0.3;
  for (const Case& one : {Case{"resultant",
                               "*ELEMENT_BEAM_OFFSET\n1,1,1,2,4\n0.,0.,0.1,0.,0.,0.1\n",
                               "1,2\n0.02,3e-5,5e-5,7e-5\n",
                               {0, 0, 0.1},
                               area,
                               iss,
                               itt},
                          Case{"resultant_s",
                               "*ELEMENT_BEAM_OFFSET\n1,1,1,2,4\n0.,-0.1,0.,0.,-0.1,0.\n",
                               "1,2\n0.02,3e-5,5e-5,7e-5\n",
                               {0, -0.1, 0},
                               area,
                               iss,
                               itt},
                          Case{"integrated",
                               "*ELEMENT_BEAM_OFFSET\n1,1,1,2,4\n0.,0.,0.1,0.,0.,0.1\n",
                               "1,1\n" + rectangle + "\n",
                               {0, 0, 0.1},
                               b * h,
                               b * h * h * h / 12,
                               h * b * b * b / 12},
                          Case{"nsloc",
                               plain,
                               "1,1\n" + rectangle + ",1.,0.\n",
                               {0, -b / 2, 0},
                               b * h,
                               b * h * h * h / 12,
                               h * b * b * b / 12},
                          Case{"ntloc",
                               plain,
                               "1,1\n" + rectangle + ",0.,-1.\n",
                               {0, 0, h / 2},
                               b * h,
                               b * h * h * h / 12,
                               h * b * b * b / 12}}) {
    RunScene scene(at_rest(pulled(one.element, one.section)));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    std::optional<Vector> shift;
    double moment = 0, axial = 0;
    scene.go([&](const solver::Run& run) {
      if (shift) return;
      shift = run.stepper().state().x[1] - Vector(length, 0, 0);
      moment = run.stepper().structure().beams.moment_at_end(0, 1).norm();
      axial = run.stepper().structure().beams.axial(0);
    });
    const double load = 1e-6, distance = one.arm.norm();
    const double stiffness = young * (one.arm.z() != 0 ? one.iss : one.itt);
    const double along = load * length * (1 / (young * one.area) + distance * distance / stiffness);
    EXPECT_NEAR(shift->x() / along, 1, 1e-4) << one.name;
    // The fibres on the side of the force are the longer ones, so the end moves to the other side: w = θ L / 2.
    EXPECT_NEAR(shift->dot(one.arm) / distance / (load * distance * length * length / (2 * stiffness)), 1, 1e-3)
        << one.name;
    EXPECT_NEAR(moment / (load * distance), 1, 1e-4) << one.name;
    EXPECT_NEAR(axial / load, 1, 1e-4) << one.name;
    RecordProperty(one.name, fmt::format("{:.6f}", shift->x() / along));
  }
}

/// A state of two nodes with one beam on arms, stressed by a small turn of the second node.
struct OneBeam {
  State state;
  BeamElements beams;
  explicit OneBeam(const BeamJoint& joint, bool integrated) {
    state.x = {Vector(0, 0, 0), Vector(length, 0, 0)};
    for (auto* list : {&state.v, &state.w}) list->assign(2, Vector::Zero());
    for (auto* list : {&state.mass, &state.inertia}) list->assign(2, 0);
    BeamProperties properties = resultant();
    if (integrated) {
      model::BeamProfile profile;
      profile.s = {0.2, 0.2};
      profile.t = {0.3, 0.3};
      properties.fibers = section_fibers(profile);
      properties.section = section_constants(profile, properties.fibers);
    }
    EXPECT_GT(beams.add({NodeIndex{0}, NodeIndex{1}}, beams.add_properties(properties), Vector::UnitY(), 0, state, {},
                        nullptr, joint),
              0);
    beams.finish(2);
  }
  Summary step(const std::array<Vector, 2>& v, const std::array<Vector, 2>& w, double dt) {
    state.dt = dt;
    for (std::size_t k = 0; k < 2; ++k) {
      state.v[k] = v[k];
      state.w[k] = w[k];
      state.x[k] += dt * v[k];
    }
    return beams.update(state);
  }
};

const BeamJoint skew{{Vector(0.1, 0.3, -0.2), Vector(-0.2, 0.1, 0.4)}, {}, {}};

// A full turn of a stressed beam on skew arms: its forces turn with it.
TEST(BeamOffset, FullTurnKeepsTheForces) {
  for (const bool integrated : {false, true}) {
    OneBeam beam(skew, integrated);
    (void)beam.step({Vector(0, 0, 0), Vector(1e-5, 2e-5, -1e-5)}, {Vector(0, 0, 0), Vector(2e-5, 1e-5, 3e-5)}, 1);
    const Vector force = beam.beams.end_force(0), moment = beam.beams.end_moment(0);
    constexpr int steps = 400;
    const Vector axis = Vector(1, -2, 0.5).normalized();
    const Vector w = 2 * std::tan(std::numbers::pi / steps) * axis;  // that of spin_rotation()
    Matrix turned = Matrix::Identity();
    for (int i = 0; i < steps; ++i) {
      turned = spin_rotation(w) * turned;
      std::array<Vector, 2> v;
      for (std::size_t k = 0; k < 2; ++k) v[k] = spin_rotation(w) * beam.state.x[k] - beam.state.x[k];
      (void)beam.step(v, {w, w}, 1);
      if (i == steps / 3) {
        EXPECT_LT((beam.beams.end_force(0) - turned * force).norm(), 1e-6 * force.norm());
        EXPECT_LT((beam.beams.end_moment(0) - turned * moment).norm(), 1e-6 * moment.norm());
      }
    }
    EXPECT_LT((beam.beams.end_force(0) - force).norm(), 1e-6 * force.norm());
    EXPECT_LT((beam.beams.end_moment(0) - moment).norm(), 1e-6 * moment.norm());
  }
}

// Forces and moments on both nodes balance, and their work is what is stored.
TEST(BeamOffset, BalanceAndEnergy) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1e-5, 1e-5);
  const auto vector = [&] { return Vector(any(random), any(random), any(random)); };
  for (const bool integrated : {false, true}) {
    OneBeam beam(skew, integrated);
    double work = 0;
    for (int i = 0; i < 20; ++i) work += beam.step({vector(), vector()}, {vector(), vector()}, 1).work;
    Vector sum = Vector::Zero(), turn = Vector::Zero();
    for (std::size_t k = 0; k < 2; ++k) {
      sum += beam.beams.end_force(0, k);
      turn += beam.beams.end_moment(0, k) + beam.state.x[k].cross(beam.beams.end_force(0, k));
    }
    EXPECT_LT(sum.norm(), 1e-15);
    EXPECT_LT(turn.norm(), 1e-9 * beam.beams.end_moment(0).norm());
    EXPECT_NEAR(beam.beams.stored(0, beam.state.x) / work, 1, 1e-3);
  }
}

// The step stays below 2 / ω of the highest frequency, by the stiffness of the forces and the masses of the nodes.
TEST(BeamOffset, StableStep) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> any(-1.5, 1.5);
  double sharpest = 0;
  for (int i = 0; i < 60; ++i) {
    BeamJoint joint;
    if (i > 0)
      for (Vector& offset : joint.offset) offset = Vector(any(random) / 2, any(random), any(random));
    for (const bool integrated : {false, true}) {
      Eigen::Matrix<double, 12, 12> k;
      double allowed = 0;
      State masses;
      for (int column = 0; column < 12; ++column) {
        OneBeam beam(joint, integrated);
        std::array<Vector, 2> v{Vector::Zero(), Vector::Zero()}, w = v;
        (column % 6 < 3 ? v : w)[static_cast<std::size_t>(column / 6)][column % 3] = 1e-7;
        allowed = beam.step(v, w, 1).stable_step;
        for (std::size_t node = 0; node < 2; ++node) {
          k.block<3, 1>(6 * static_cast<int>(node), column) = beam.beams.end_force(0, node) / 1e-7;
          k.block<3, 1>(6 * static_cast<int>(node) + 3, column) = beam.beams.end_moment(0, node) / 1e-7;
        }
        masses = beam.state;
      }
      Eigen::Matrix<double, 12, 1> root;
      for (int row = 0; row < 12; ++row)
        root[row] = 1 / std::sqrt((row % 6 < 3 ? masses.mass : masses.inertia)[static_cast<std::size_t>(row / 6)]);
      const Eigen::Matrix<double, 12, 12> scaled = root.asDiagonal() * (k + k.transpose()) / 2 * root.asDiagonal();
      const double highest =
          std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 12, 12>>(scaled).eigenvalues()[11]);
      EXPECT_LE(allowed, 2 / highest * (1 + 1e-4)) << i << integrated;
      sharpest = std::max(sharpest, allowed * highest / 2);
    }
  }
  EXPECT_GT(sharpest, 0.7);
}

TEST(BeamJoint, Refused) {
  const auto refused = [](const std::string& deck, std::string_view text) {
    const Failure failure = failure_of(deck);
    EXPECT_NE(failure.message.find(text), std::string::npos) << failure.message;
    EXPECT_GT(failure.place.line, 0u);
  };
  const std::string section = "1,2\n0.02,3e-5,5e-5,7e-5\n";
  refused(pulled("*ELEMENT_BEAM\n1,1,1,2,4,0,2,0,0,1\n", section), "LOCAL = 1");
  refused(pulled("*ELEMENT_BEAM\n1,1,1,2,4,2\n", section), "RT1");
  refused(pulled("*ELEMENT_BEAM\n1,1,1,2,4,0,0,7\n", section), "RT1");
  refused(pulled("*ELEMENT_BEAM\n1,1,1,2,4\n", "1,1\n0.2,0.4,0.3,0.3,1.\n"), "NSLOC");
  refused(pulled("*ELEMENT_BEAM_OFFSET\n1,1,1,2,4\n0.,0.,0.,-2.,0.,0.\n", section), "no length");
}

}  // namespace
}  // namespace gapcheck::solver::beam_joint_test
