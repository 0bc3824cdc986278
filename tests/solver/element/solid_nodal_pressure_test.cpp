// Tetrahedra of ELFORM 13: volume strains averaged at the nodes.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>

#include "solver/element/solid_elements.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::solid_nodal_pressure_test {
namespace {

using Tetrahedron = std::array<std::uint32_t, 4>;

/// A grid of cells, six tetrahedra each round a diagonal.
struct Mesh {
  std::array<int, 3> n;
  std::vector<Vector> x;
  std::vector<Tetrahedron> cells;

  Mesh(std::array<int, 3> counts, const Vector& size) : n(counts) {
    for (int k = 0; k <= n[2]; ++k)
      for (int j = 0; j <= n[1]; ++j)
        for (int i = 0; i <= n[0]; ++i) x.emplace_back(size.x() * i / n[0], size.y() * j / n[1], size.z() * k / n[2]);
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i) {
          const std::uint32_t a = id(i, j, k), g = id(i + 1, j + 1, k + 1);
          const std::uint32_t round[6] = {id(i + 1, j, k),     id(i + 1, j + 1, k), id(i, j + 1, k),
                                          id(i, j + 1, k + 1), id(i, j, k + 1),     id(i + 1, j, k + 1)};
          for (std::size_t m = 0; m < 6; ++m) cells.push_back({a, round[m], round[(m + 1) % 6], g});
        }
  }
  [[nodiscard]] std::uint32_t id(int i, int j, int k) const {
    return static_cast<std::uint32_t>(i + (n[0] + 1) * (j + (n[1] + 1) * k));
  }
  [[nodiscard]] bool inside(std::uint32_t node) const {
    const int i = static_cast<int>(node) % (n[0] + 1), j = static_cast<int>(node) / (n[0] + 1) % (n[1] + 1),
              k = static_cast<int>(node) / (n[0] + 1) / (n[1] + 1);
    return i > 0 && j > 0 && k > 0 && i < n[0] && j < n[1] && k < n[2];
  }
  void shake(double size) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> between(-size, size);
    for (std::uint32_t node = 0; node < x.size(); ++node)
      if (inside(node)) x[node] += Vector(between(random), between(random), between(random));
  }
};

SolidProperties elastic(double young, double poisson, int elform) {
  SolidProperties properties;
  properties.material = {MaterialKind::elastic, 1, young, poisson, {}, 0, 0, 0};
  properties.linear_viscosity = properties.quadratic_viscosity = 0;
  properties.rules = solid_rules(elform, 0);
  return properties;
}

/// All tetrahedra of a mesh, in one part or alternating between two.
struct Body {
  State state;
  SolidElements solids;

  Body(const Mesh& mesh, const SolidProperties& properties, std::uint32_t parts = 1) {
    state.x = mesh.x;
    state.v.assign(mesh.x.size(), Vector::Zero());
    state.w = state.v;
    state.mass.assign(mesh.x.size(), 0);
    for (std::uint32_t part = 0; part < parts; ++part) solids.add_properties(properties);
    for (std::uint32_t i = 0; i < mesh.cells.size(); ++i) {
      std::array<NodeIndex, 8> nodes;
      for (std::size_t k = 0; k < 8; ++k) nodes[k] = NodeIndex(mesh.cells[i][std::min<std::size_t>(k, 3)]);
      EXPECT_GT(solids.add(nodes, i / 6 % parts, i, state), 0);
    }
    solids.finish(mesh.x.size());
  }
  /// Moves all nodes by dt v.
  Summary move(double dt) {
    for (std::size_t i = 0; i < state.x.size(); ++i) state.x[i] += dt * state.v[i];
    state.dt = dt;
    return solids.update(state);
  }
  [[nodiscard]] Vector force(std::size_t node) const {
    Vector sum = Vector::Zero();
    solids.gather(node, sum);
    return -sum;
  }
};

void set_random_velocities(State& state) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> between(-1, 1);
  for (Vector& v : state.v) v = Vector(between(random), between(random), between(random));
}

TEST(SolidNodalPressure, LinearFieldIsExactInAPatchOfMovedNodes) {
  constexpr double young = 1000, nu = 0.3, dt = 1e-9;
  Matrix gradient;
  gradient << 1, 0.5, -0.2, 0.3, -0.4, 0.7, 0.1, -0.6, 0.8;
  Mesh mesh({3, 3, 3}, {3, 3, 1});
  mesh.shake(0.05);
  Body body(mesh, elastic(young, nu, 13));
  for (std::size_t i = 0; i < mesh.x.size(); ++i) body.state.v[i] = gradient * mesh.x[i];
  body.move(dt);
  const Symmetric rate = to_symmetric(gradient);
  for (std::size_t e = 0; e < body.solids.size(); ++e)
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(body.solids.points(e)[0].stress[c] / dt,
                  young / 1.3 * rate[c] + (c < 3 ? young * nu / 1.3 / 0.4 * gradient.trace() : 0), 1e-5);
  for (std::uint32_t node = 0; node < mesh.x.size(); ++node)
    if (mesh.inside(node)) {
      EXPECT_NEAR(body.force(node).norm() / dt, 0, 1e-4);
    }
}

// Mean stress by hand: K times the mean over the corners of Σ V tr L / Σ V over the tetrahedra of the part there.
TEST(SolidNodalPressure, MeanStressIsTheMeanOfTheNodesOfThePart) {
  constexpr double dt = 1e-8, young = 1000, nu = 0.4;
  for (const std::uint32_t parts : {1u, 2u}) {
    Mesh mesh({2, 2, 2}, {2, 2, 2});
    mesh.shake(0.1);
    Body body(mesh, elastic(young, nu, 13), parts);
    set_random_velocities(body.state);
    const std::vector<Vector> v = body.state.v;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<double, 2>> sums;
    const auto part_of = [&](std::size_t e) { return static_cast<std::uint32_t>(e / 6 % parts); };
    for (std::size_t e = 0; e < mesh.cells.size(); ++e) {
      const Tetrahedron& c = mesh.cells[e];
      Matrix edges, rates;
      for (int k = 0; k < 3; ++k) {
        edges.col(k) = mesh.x[c[static_cast<std::size_t>(k) + 1]] - mesh.x[c[0]];
        rates.col(k) = v[c[static_cast<std::size_t>(k) + 1]] - v[c[0]];
      }
      const double volume = edges.determinant() / 6;
      for (const std::uint32_t node : c) {
        sums[{part_of(e), node}][0] += volume;
        sums[{part_of(e), node}][1] += volume * (rates * edges.inverse()).trace();
      }
    }
    body.move(dt);
    const double bulk = young / (3 * (1 - 2 * nu));
    for (std::size_t e = 0; e < mesh.cells.size(); ++e) {
      double mean = 0;
      for (const std::uint32_t node : mesh.cells[e]) {
        const auto& [volume, growth] = sums[{part_of(e), node}];
        mean += growth / volume / 4;
      }
      EXPECT_NEAR(trace(body.solids.points(e)[0].stress) / 3 / dt, bulk * mean, 1e-4) << parts;
    }
  }
}

// The forces are the slopes of the stored energy: from rest their work is half of force times way.
TEST(SolidNodalPressure, StoredEnergyIsTheWorkOfTheForces) {
  Mesh mesh({2, 2, 2}, {2, 2, 2});
  mesh.shake(0.1);
  for (const int elform : {10, 13}) {
    Body body(mesh, elastic(1000, 0.45, elform));
    set_random_velocities(body.state);
    const Summary summary = body.move(1e-7);
    double stored = 0, work = 0;
    for (std::size_t e = 0; e < body.solids.size(); ++e) stored += body.solids.stored(e, body.state.x);
    for (std::size_t i = 0; i < mesh.x.size(); ++i) work += 1e-7 / 2 * body.force(i).dot(body.state.v[i]);
    EXPECT_NEAR(stored / work, 1, 1e-6) << elform;
    EXPECT_NEAR(summary.work / work, 1, 1e-12) << elform;
  }
}

TEST(SolidNodalPressure, AFullTurnKeepsTheStress) {
  Mesh mesh({2, 2, 1}, {2, 2, 1});
  Body body(mesh, elastic(1000, 0.3, 13));
  set_random_velocities(body.state);
  body.move(0.01);
  std::vector<Symmetric> before;
  for (std::size_t e = 0; e < body.solids.size(); ++e) before.push_back(body.solids.points(e)[0].stress);
  constexpr int steps = 400;
  const Vector axis = Vector(1, 2, 2) / 3;
  for (int step = 0; step < steps; ++step) {
    const Matrix turn = spin_rotation(2 * std::tan(std::numbers::pi / steps) * axis);
    for (std::size_t i = 0; i < mesh.x.size(); ++i) body.state.v[i] = turn * body.state.x[i] - body.state.x[i];
    body.move(1);
  }
  for (std::size_t e = 0; e < body.solids.size(); ++e)
    for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(body.solids.points(e)[0].stress[c], before[e][c], 1e-9);
}

/// ∂force / ∂position of all nodes at rest.
Eigen::MatrixXd stiffness(const Mesh& mesh, const SolidProperties& properties) {
  constexpr double dt = 1e-8;
  const auto size = static_cast<Eigen::Index>(3 * mesh.x.size());
  Eigen::MatrixXd matrix(size, size);
  const Body start(mesh, properties);
  for (Eigen::Index column = 0; column < size; ++column) {
    Body body = start;
    body.state.v[static_cast<std::size_t>(column / 3)][column % 3] = 1;
    body.state.dt = dt;
    (void)body.solids.update(body.state);
    for (std::size_t node = 0; node < mesh.x.size(); ++node)
      matrix.block<3, 1>(3 * static_cast<Eigen::Index>(node), column) = body.force(node) / dt;
  }
  return (matrix + matrix.transpose()) / 2;
}

/// A quarter of a thick tube, inner radius 1, outer 2, in plane strain under inner pressure 1; mean radial displacement
/// of the inner surface over the exact one.
double tube(int n, int elform, double nu) {
  constexpr double young = 1000;
  Mesh mesh({n, 2 * n, 1}, {1, 1, 1});
  for (Vector& x : mesh.x) {
    const double radius = 1 + x.x(), angle = std::numbers::pi / 2 * x.y();
    x = Vector(radius * std::cos(angle), radius * std::sin(angle), x.z() / n);
  }
  Eigen::MatrixXd matrix = stiffness(mesh, elastic(young, nu, elform));
  Eigen::VectorXd load = Eigen::VectorXd::Zero(matrix.rows());
  // The pressure acts on the facets, each a quad whose corners carry a quarter.
  for (int j = 0; j < 2 * n; ++j) {
    const Vector a = mesh.x[mesh.id(0, j, 0)], b = mesh.x[mesh.id(0, j + 1, 0)];
    const Vector force = Vector(b.y() - a.y(), a.x() - b.x(), 0) / n / 4;
    for (const int k : {0, 1})
      for (const int m : {j, j + 1}) load.segment<3>(3 * static_cast<Eigen::Index>(mesh.id(0, m, k))) += force;
  }
  const auto hold = [&](std::uint32_t node, int axis) {
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(node) + axis;
    matrix(row, row) += 1e6 * young;
  };
  for (int i = 0; i <= n; ++i)
    for (const int k : {0, 1}) {
      hold(mesh.id(i, 0, k), 1);
      hold(mesh.id(i, 2 * n, k), 0);
    }
  for (std::uint32_t node = 0; node < mesh.x.size(); ++node) hold(node, 2);
  const Eigen::VectorXd u = matrix.llt().solve(load);
  double mean = 0;
  for (int j = 0; j <= 2 * n; ++j)
    for (const int k : {0, 1}) {
      const std::uint32_t node = mesh.id(0, j, k);
      mean += u.segment<3>(3 * static_cast<Eigen::Index>(node)).dot(mesh.x[node]) / (2 * (2 * n + 1));
    }
  return mean / ((1 + nu) / young / 3 * (1 - 2 * nu + 4));
}

TEST(SolidNodalPressure, NoLockingInANearlyIncompressibleTube) {
  const double locked = tube(4, 10, 0.4999), coarse = tube(2, 13, 0.4999), fine = tube(4, 13, 0.4999);
  RecordProperty("locked", fmt::format("{:.4f}", locked));
  RecordProperty("coarse", fmt::format("{:.4f}", coarse));
  RecordProperty("fine", fmt::format("{:.4f}", fine));
  EXPECT_LT(locked, 0.75);
  EXPECT_NEAR(fine, 1, 0.08);
  EXPECT_LT(1 - fine, 0.3 * (1 - coarse)) << "second order";
  EXPECT_NEAR(tube(4, 13, 0.3), 1, 0.04);
}

TEST(SolidNodalPressure, FirstFrequencyOfARod) {
  for (const int n : {6, 12}) {
    const Mesh mesh({n, 1, 1}, {6, 0.1, 0.1});
    const SolidProperties properties = elastic(1000, 0, 13);
    const Body body(mesh, properties);
    const Eigen::MatrixXd k = stiffness(mesh, properties);
    Eigen::VectorXd root(k.rows());
    for (Eigen::Index i = 0; i < k.rows(); ++i)
      root[i] = 1 / std::sqrt(body.state.mass[static_cast<std::size_t>(i / 3)]);
    // The rod moves along itself only.
    Eigen::MatrixXd along(k.rows() / 3, k.rows() / 3);
    for (Eigen::Index i = 0; i < along.rows(); ++i)
      for (Eigen::Index j = 0; j < along.cols(); ++j) along(i, j) = root[3 * i] * k(3 * i, 3 * j) * root[3 * j];
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(along).eigenvalues();
    const double exact = std::numbers::pi * std::sqrt(1000.0) / 6;
    EXPECT_NEAR(std::sqrt(values[1]) / exact, 1, 0.75 / (n * n)) << n;
  }
}

/// Copper bar of 32.4 mm, 3.2 mm in radius, at 227 m/s against a wall that lets it slide; a quarter of n x n x 5 n
/// cells. Units mm, µs, kg: stress in 1e6 GPa. Returns length and greatest radius at 80 µs.
std::array<double, 2> taylor(int n, int elform) {
  Mesh mesh({n, n, 5 * n}, {1, 1, 32.4});
  std::string deck = "*NODE\n";
  for (std::uint32_t i = 0; i < mesh.x.size(); ++i) {
    Vector& x = mesh.x[i];
    const double most = std::max(x.x(), x.y()), length = std::hypot(x.x(), x.y());
    const double scale = length > 0 ? 3.2 * most / length : 0;
    deck += fmt::format("{},{:.10g},{:.10g},{:.10g},{},0\n", i + 1, scale * x.x(), scale * x.y(), x.z(),
                        std::array{0, 1, 2, 4, 3, 6, 5,
                                   7}[static_cast<std::size_t>((x.x() == 0) + 2 * (x.y() == 0) + 4 * (x.z() == 0))]);
  }
  deck += "*ELEMENT_SOLID\n";
  for (std::size_t e = 0; e < mesh.cells.size(); ++e) {
    const Tetrahedron& c = mesh.cells[e];
    deck += fmt::format("{},1,{},{},{},{},{},{},{},{}\n", e + 1, c[0] + 1, c[1] + 1, c[2] + 1, c[3] + 1, c[3] + 1,
                        c[3] + 1, c[3] + 1, c[3] + 1);
  }
  deck += fmt::format("*PART\nbar\n1,1,1\n*SECTION_SOLID\n1,{}\n", elform) +
          "*MAT_PLASTIC_KINEMATIC\n1,8.93e-6,1.17e-4,0.35,4.e-7,1.e-7,1.\n*INITIAL_VELOCITY\n0\n0.,0.,-0.227\n"
          "*CONTROL_TERMINATION\n80.\n";
  RunScene scene(deck, {});
  EXPECT_TRUE(scene.prepared()) << scene.message();
  double length = 0, radius = 0;
  if (!scene.prepared()) return {};
  scene.go();
  for (std::uint32_t i = 0; i < mesh.x.size(); ++i) {
    const Vector& x = scene.state().x[i];
    length = std::max(length, x.z());
    radius = std::max(radius, std::hypot(x.x(), x.y()));
  }
  return {length, radius};
}

// Bonet and Burton give 21.5 mm for all elements that do not lock, and radii of 6.9 to 7.1 mm on fine meshes.
TEST(SolidNodalPressure, TaylorBar) {
  const auto [length, radius] = taylor(3, 13);
  const auto [locked_length, locked_radius] = taylor(3, 10);
  RecordProperty("length", fmt::format("{:.3f}", length));
  RecordProperty("radius", fmt::format("{:.3f}", radius));
  RecordProperty("locked_length_radius", fmt::format("{:.3f} {:.3f}", locked_length, locked_radius));
  EXPECT_NEAR(length, 21.5, 0.5);
  EXPECT_GT(radius, locked_radius + 0.3);
}

/// A tetrahedron and a brick on one face, in a part each.
std::string deck(int elform, int esort, const std::string& material) {
  return "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.,0.\n4,0.,0.,1.\n*ELEMENT_SOLID\n1,1,1,2,3,4,4,4,4,4\n*PART\np\n1,1,"
         "1\n" +
         fmt::format("*SECTION_SOLID\n1,{}\n*CONTROL_SOLID\n{}\n", elform, esort) + material;
}

TEST(SolidNodalPressure, WhoIsAveragedAndWhoIsNamed) {
  const std::string elastic_material = "*MAT_ELASTIC\n1,1.,1000.,0.3\n";
  const std::string rubber = "*MAT_MOONEY-RIVLIN_RUBBER\n1,1e-6,0.49,1.,0.5\n";
  struct Case {
    int elform, esort;
    std::string material;
    SolidRule rule;
    std::string warning;
  };
  for (const Case& one : {
           Case{10, 0, elastic_material, SolidRule::one_point, ""},
           Case{13, 0, elastic_material, SolidRule::nodal_pressure, ""},
           Case{1, 1, elastic_material, SolidRule::one_point, ""},
           Case{1, 11, elastic_material, SolidRule::nodal_pressure, ""},
           Case{2, 12, elastic_material, SolidRule::nodal_pressure, ""},
           Case{10, 11, elastic_material, SolidRule::one_point, ""},
           Case{13, 0, rubber, SolidRule::one_point, "1 tetrahedra are calculated as ELFORM 10, not as ELFORM 13;"},
           Case{2, 13, rubber, SolidRule::one_point, "not as ELFORM 13 that ESORT asks for"},
           Case{4, 1, elastic_material, SolidRule::nodal_pressure, "ELFORM 4 is calculated as ELFORM 13"},
           Case{16, 1, elastic_material, SolidRule::nodal_pressure, "ELFORM 16 is calculated as ELFORM 13"},
       }) {
    const model::Read read = model::read_text(deck(one.elform, one.esort, one.material));
    Diagnostics diagnostics;
    const auto built = build_structure(read.model, {}, diagnostics);
    ASSERT_TRUE(built) << built.error().message;
    EXPECT_EQ(built.value().solids.rule(0), one.rule) << one.elform << " " << one.esort;
    std::string said;
    for (const Diagnostic& message : diagnostics.sorted()) said += message.message;
    EXPECT_EQ(said.empty(), one.warning.empty()) << said;
    EXPECT_NE(said.find(one.warning), std::string::npos) << said;
  }
}

// The top corner is pushed through the base, faster than the step can shrink.
TEST(SolidsWithoutVolume, FailInThePartsOfPsfail) {
  const std::string push =
      deck(10, 0, "*MAT_ELASTIC\n1,1.,1.,0.\n*CONTROL_BULK_VISCOSITY\n1e-20,1e-20\n") +
      "*BOUNDARY_PRESCRIBED_MOTION_NODE\n4,3,2,1,-1.\n*DEFINE_CURVE\n1\n0.,0.\n1.,2.\n*CONTROL_TERMINATION\n1.\n"
      "*BOUNDARY_SPC_NODE\n1,,1,1,1\n2,,1,1,1\n3,,1,1,1\n*SET_PART_LIST\n7\n1\n*SET_PART_LIST\n8\n2\n";
  const auto with = [&](const std::string& set) {
    std::string text = push;
    const std::string card = "*CONTROL_SOLID\n0";
    return text.replace(text.find(card), card.size(), card + ",,,," + set);
  };
  RunSettings settings;
  settings.step.energy_tolerance = 0;
  RunScene refused(with("0"), settings);
  EXPECT_EQ(refused.try_to_go(), RunEnd::failed);
  EXPECT_NE(refused.message().find("solid 1"), std::string::npos) << refused.message();
  RunScene kept(with("7"), settings);
  kept.go();
  EXPECT_EQ(kept.run().stepper().failures().size(), 1u);
  EXPECT_NE(failure_of(with("9")).message.find("PSFAIL of *CONTROL_SOLID names part set 9"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::solver::solid_nodal_pressure_test
