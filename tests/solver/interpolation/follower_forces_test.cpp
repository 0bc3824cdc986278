#include "solver/interpolation/follower_forces.hpp"

#include <cmath>
#include <random>

#include "solver/interpolation/followed.hpp"

namespace gapcheck::solver::follower_forces_test {
namespace {

/// Four masses of 2 on a square of side 2 about the origin (nodes 1 to 4), and node 9.
std::string square(const std::string& place, const std::string& mass = "") {
  return "*NODE\n1,1.,1.,0.\n2,-1.,1.,0.\n3,-1.,-1.,0.\n4,1.,-1.,0.\n9," + place +
         "\n*ELEMENT_MASS\n1,1,2.\n2,2,2.\n3,3,2.\n4,4,2.\n" + (mass.empty() ? "" : "9,9," + mass + "\n");
}
const std::string follow_all = "*CONSTRAINED_INTERPOLATION\n5,9,123456\n1,123\n2,123\n3,123\n4,123\n";
const std::string follow_places = "*CONSTRAINED_INTERPOLATION\n5,9,123\n1,123\n2,123\n3,123\n4,123\n";
const std::string constant = "*DEFINE_CURVE\n1\n0.,1.\n100.,1.\n";

// A load on a node without mass: at the centre each of the four nodes gets a quarter; a moment comes as a couple.
TEST(FollowerForces, LoadIsSharedAndMomentBecomesCouples) {
  Followed scene(square("0.,0.,0.") + follow_all + constant + "*LOAD_NODE_POINT\n9,3,1,8.\n9,7,1,4.\n", 1e-3);
  ASSERT_TRUE(scene.ready()) << scene.status().error().message;
  run(scene.stepper(), 1);
  const double impulse = 1e-3 / 2 / 2;  // over the first half step, by mass
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector at = scene.state().x[i];
    const Vector couple = 0.5 * Vector(0, 0, 1).cross(Vector(at.x(), at.y(), 0));  // M r / (4 r²), r² = 2
    EXPECT_NEAR((scene.state().v[i] - impulse * (Vector(0, 0, 2) + couple)).norm(), 0, 1e-9);
  }
  EXPECT_NEAR((scene.forces().load(0) + (Twist() << 0, 0, 8, 0, 0, 4).finished()).norm(), 0, 1e-13);
  EXPECT_NEAR(scene.state().v[4].z(), impulse * 2, 1e-15);
  EXPECT_NEAR(scene.state().w[4].z(), impulse * 0.5, 1e-9);
}

// Weights 3 and 1 on a beam of two nodes and one in line between them: the force is shared as by levers only by moment,
// the mean of the motion is weighted.
TEST(FollowerForces, WeightsShareTheForce) {
  Followed scene(
      "*NODE\n1,0.,0.,0.\n2,0.,0.,0.\n9,0.,0.,0.\n*ELEMENT_MASS\n1,1,2.\n2,2,2.\n"
      "*CONSTRAINED_INTERPOLATION\n5,9,123\n1,123,3.\n2,123\n" +
          constant + "*LOAD_NODE_POINT\n9,1,1,8.\n",
      1e-3);
  ASSERT_TRUE(scene.ready()) << scene.status().error().message;
  run(scene.stepper(), 1);
  EXPECT_NEAR(scene.state().v[0].x(), 1e-3 / 2 / 2 * 6, 1e-15);
  EXPECT_NEAR(scene.state().v[1].x(), 1e-3 / 2 / 2 * 2, 1e-15);
  EXPECT_NEAR(scene.state().v[2].x(), 1e-3 / 2 / 2 * (0.75 * 6 + 0.25 * 2), 1e-15);
}

/// Positions of a point on a circle, as a curve of displacement at the ends of equal steps.
std::string circle(int id, double start, double first, double second, double step, double angle, int steps) {
  std::string text = fmt::format("*DEFINE_CURVE\n{}\n", id);
  for (int i = 0; i <= steps; ++i)
    text +=
        fmt::format("{:.17g},{:.17g}\n", i * step, first * std::cos(i * angle) + second * std::sin(i * angle) - start);
  return text;
}

// Nodes that are moved on circles, nine degrees per step: the follower goes round with them, over two turns.
TEST(FollowerForces, FiniteRotationsPassExactly) {
  constexpr int steps = 80;
  const double step = 1.0 / 1024, angle = std::acos(-1.0) / 20;
  const std::vector<Vector> start{{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
  for (const std::string& mass : {std::string(), std::string("0.5")}) {
    std::string deck = square("4.,1.,0.5", mass) + follow_all;
    for (std::size_t i = 0; i < 4; ++i) {
      const int x_curve = 10 + 2 * static_cast<int>(i), y_curve = x_curve + 1;
      deck += circle(x_curve, start[i].x(), start[i].x(), -start[i].y(), step, angle, steps + 2);
      deck += circle(y_curve, start[i].y(), start[i].y(), start[i].x(), step, angle, steps + 2);
      deck += fmt::format("*BOUNDARY_PRESCRIBED_MOTION_NODE\n{},1,2,{}\n{},2,2,{}\n", i + 1, x_curve, i + 1, y_curve);
      deck += fmt::format("*BOUNDARY_SPC_NODE\n{},0,0,0,1\n", i + 1);
    }
    Followed scene(deck, step);
    ASSERT_TRUE(scene.ready()) << scene.status().error().message;
    for (int i = 0; i < steps; ++i) {
      run(scene.stepper(), 1);
      const double turned = (i + 1) * angle;
      const Vector expected(4 * std::cos(turned) - std::sin(turned), 4 * std::sin(turned) + std::cos(turned), 0.5);
      EXPECT_NEAR((scene.state().x[4] - expected).norm(), 0, 1e-11) << i;
    }
    EXPECT_NEAR(scene.state().w[4].z(), 2 * std::tan(angle / 2) / step, 1e-8);
  }
}

/// A spinning elastic block with a follower of the given mass beside it, fixed to the four nodes of its top.
std::string spinning_block(const std::string& freedoms, const std::string& place, const std::string& mass) {
  return brick_bar(1, {1, 1, 1}) + elastic_deck(solid_section, 1000, 0.3, 1) + "*NODE\n9," + place + "\n" +
         (mass.empty() ? "" : "*ELEMENT_MASS\n9,9," + mass + "\n") + "*CONSTRAINED_INTERPOLATION\n5,9," + freedoms +
         "\n5,123\n6,123,2.\n7,123\n8,123,1.,0.5\n" + "*SET_NODE_LIST\n1\n1,2,3,4,5,6,7,8\n" +
         "*INITIAL_VELOCITY_GENERATION\n1,3,3.,1.,2.,3.\n0.5,0.5,0.5,0.2,0.3,1.\n";
}

struct Conserved {
  Vector momentum = Vector::Zero(), turning = Vector::Zero();
  explicit Conserved(const State& state) {
    for (std::size_t i = 0; i < state.x.size(); ++i) {
      momentum += state.mass[i] * state.v[i];
      turning += state.mass[i] * (state.x[i] - state.dt / 2 * state.v[i]).cross(state.v[i]);
    }
  }
};

TEST(FollowerForces, MomentumAndEnergyStay) {
  for (const std::string& mass : {std::string(), std::string("0.4")}) {
    Followed scene(spinning_block("123", "2.,0.2,1.5", mass), 1e-3);
    ASSERT_TRUE(scene.ready()) << scene.status().error().message;
    run(scene.stepper(), 1);
    const Conserved before(scene.state());
    run(scene.stepper(), 2000);
    const Conserved after(scene.state());
    EXPECT_NEAR((after.momentum - before.momentum).norm(), 0, 1e-11);
    EXPECT_NEAR((after.turning - before.turning).norm(), 0, 1e-8 * before.turning.norm()) << mass;
    const Energies& energies = scene.stepper().energies();
    EXPECT_NEAR(energies.ratio(), 1, 1e-6);
    EXPECT_NEAR(scene.forces().residue(), 0, 1e-5 * energies.initial) << mass;
  }
}

// At the weighted centre the loads' arms do not turn: no work at all is left, at any step.
TEST(FollowerForces, NoWorkAtTheCentre) {
  const std::string deck = square("0.,0.,0.", "3.") + follow_places + constant +
                           "*LOAD_NODE_POINT\n9,3,1,8.\n1,1,1,5.\n2,2,1,-3.\n*INITIAL_VELOCITY_NODE\n1,4.\n3,0.,2.\n";
  Followed scene(deck, 1e-2);
  ASSERT_TRUE(scene.ready()) << scene.status().error().message;
  run(scene.stepper(), 50);
  EXPECT_GT(std::abs(scene.stepper().energies().external), 1);
  EXPECT_NEAR(scene.forces().residue(), 0, 1e-12);
}

// What a finite step leaves of zero falls with the square of the step.
TEST(FollowerForces, ResidueIsOfSecondOrder) {
  const auto residue = [](double step) {
    Followed scene(spinning_block("123", "2.,0.2,1.5", "0.4"), step);
    EXPECT_TRUE(run_until(scene.stepper(), 0.5).ok());
    return std::abs(scene.forces().residue());
  };
  const double coarse = residue(1.0 / 256), fine = residue(1.0 / 1024);
  EXPECT_LT(fine, coarse / 8);
}

/// Random masses, some held, followed by one or two nodes with random freedoms, weights and loads.
struct RandomScene {
  std::string deck;
  std::vector<double> mass;
  std::vector<Vector> place, load;
  std::vector<unsigned> held;
  struct Follow {
    std::size_t node;
    unsigned freedoms;
    std::vector<std::size_t> nodes;
    std::vector<Vector> weights;
  };
  std::vector<Follow> follows;
};

RandomScene random_scene(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1, 1), positive(0.5, 3);
  std::uniform_int_distribution<int> coin(0, 3);
  RandomScene scene;
  std::string nodes = "*NODE\n", masses = "*ELEMENT_MASS\n", loads, held;
  const std::size_t count = 7;
  for (std::size_t i = 0; i < count + 2; ++i) {
    const Vector x(any(random), any(random), any(random)), f(any(random), any(random), any(random));
    const double m = i >= count && coin(random) == 0 ? 0 : positive(random);
    nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", i + 1, x.x(), x.y(), x.z());
    if (m > 0) masses += fmt::format("{},{},{:.17g}\n", i + 1, i + 1, m);
    for (int k = 0; k < 3; ++k) loads += fmt::format("*LOAD_NODE_POINT\n{},{},1,{:.17g}\n", i + 1, k + 1, f[k]);
    unsigned mask = 0;
    if (i < count && coin(random) == 0) {
      mask = 1u << (i % 3);
      held += fmt::format("*BOUNDARY_SPC_NODE\n{},0,{},{},{}\n", i + 1, mask & 1u, mask >> 1 & 1u, mask >> 2 & 1u);
    }
    scene.mass.push_back(m);
    scene.place.push_back(x);
    scene.load.push_back(f);
    scene.held.push_back(mask);
  }
  std::string cards;
  for (std::size_t f = 0; f < 2; ++f) {
    RandomScene::Follow follow{count + f, 7, {}, {}};
    cards += fmt::format("*CONSTRAINED_INTERPOLATION\n{},{},123\n", f + 1, follow.node + 1);
    for (std::size_t i = 2 * f; i < 2 * f + 5; ++i) {
      const Vector w(positive(random), positive(random), positive(random));
      cards += fmt::format("{},123,{:.17g},{:.17g},{:.17g}\n", i + 1, w.x(), w.y(), w.z());
      follow.nodes.push_back(i);
      follow.weights.push_back(w);
    }
    scene.follows.push_back(follow);
  }
  scene.deck = nodes + masses + loads + held + cards + constant;
  return scene;
}

/// Accelerations at rest from all equations of motion at once, with the loads of the followers as unknowns and C by an
/// orthogonal decomposition.
std::vector<Vector> twin(const RandomScene& scene) {
  const auto nodes = static_cast<Eigen::Index>(scene.mass.size());
  const Eigen::Index rows = 3 * static_cast<Eigen::Index>(scene.follows.size()), all = 3 * nodes;
  Eigen::MatrixXd g = Eigen::MatrixXd::Zero(rows, all);
  for (std::size_t f = 0; f < scene.follows.size(); ++f) {
    const RandomScene::Follow& follow = scene.follows[f];
    const auto count = static_cast<Eigen::Index>(follow.nodes.size());
    Eigen::MatrixXd fit(3 * count, 6), root = Eigen::MatrixXd::Zero(3 * count, 3 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Vector r = scene.place[follow.nodes[static_cast<std::size_t>(i)]] - scene.place[follow.node];
      Matrix cross;
      cross << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0;
      fit.block<3, 3>(3 * i, 0) = Matrix::Identity();
      fit.block<3, 3>(3 * i, 3) = cross;
      root.block<3, 3>(3 * i, 3 * i) = follow.weights[static_cast<std::size_t>(i)].cwiseSqrt().asDiagonal();
    }
    const Eigen::MatrixXd c = (root * fit).colPivHouseholderQr().solve(root);
    const auto row = 3 * static_cast<Eigen::Index>(f);
    for (Eigen::Index i = 0; i < count; ++i)
      g.block<3, 3>(row, 3 * static_cast<Eigen::Index>(follow.nodes[static_cast<std::size_t>(i)])) =
          c.block<3, 3>(0, 3 * i);
    g.block<3, 3>(row, 3 * static_cast<Eigen::Index>(follow.node)) -= Matrix::Identity();
  }
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(all + rows, all + rows);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(all + rows);
  for (Eigen::Index i = 0; i < all; ++i) {
    const auto n = static_cast<std::size_t>(i / 3);
    const int k = static_cast<int>(i % 3);
    if ((scene.held[n] >> k & 1u) != 0) {
      system(i, i) = 1;
      continue;
    }
    system(i, i) = scene.mass[n];
    right[i] = scene.load[n][k];
    system.block(i, all, 1, rows) = g.col(i).transpose();
  }
  system.block(all, 0, rows, all) = g;
  const Eigen::VectorXd solution = system.fullPivLu().solve(right);
  std::vector<Vector> accelerations;
  for (Eigen::Index i = 0; i < nodes; ++i) accelerations.emplace_back(solution.segment<3>(3 * i));
  return accelerations;
}

TEST(FollowerForces, AgreesWithAllEquationsAtOnce) {
  std::mt19937 random(3);
  constexpr double step = 1e-6;
  for (int round = 0; round < 40; ++round) {
    const RandomScene scene = random_scene(random);
    Followed calculated(scene.deck, step);
    ASSERT_TRUE(calculated.ready()) << calculated.status().error().message;
    run(calculated.stepper(), 1);
    const std::vector<Vector> expected = twin(scene);
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR((calculated.state().v[i] / (step / 2) - expected[i]).norm(), 0, 1e-9 * (1 + expected[i].norm()))
          << round << " node " << i + 1;
  }
}

}  // namespace
}  // namespace gapcheck::solver::follower_forces_test
