// Bricks of material 100: their resultants, failure, mass by DT, and cards that make no sense.
#include <cmath>
#include <functional>
#include <random>

#include "solver/structure_of.hpp"

namespace gapcheck::solver::weld_brick_test {
namespace {

constexpr double young = 1000, density = 2, width = 0.4, depth = 0.5, height = 0.25, area = width * depth;
using Corners = std::array<Vector, 8>;

/// A box with its faces across z, its corner 1 at the origin.
Corners box() {
  Corners x;
  for (std::size_t k = 0; k < 8; ++k)
    x[k] = {k % 4 == 1 || k % 4 == 2 ? width : 0, k % 4 > 1 ? depth : 0, k > 3 ? height : 0};
  return x;
}

/// The forces of a brick at x whose corners have moved by `displacement` from there, times 1e6.
Corners forces_after(SolidRule rule, double poisson, const std::function<Vector(const Vector&)>& displacement) {
  SolidProperties properties;
  properties.material = {MaterialKind::elastic, density, young, poisson, {}, 0, 0, 0, {}, 1};
  SolidCorners corners{box(), {}};
  for (std::size_t k = 0; k < 8; ++k) {
    corners.v[k] = 1e-6 * displacement(corners.x[k]);
    corners.x[k] += corners.v[k];
  }
  SolidState state;
  state.mass = density * area * height;
  std::vector<PointState> points(8);
  const SolidForces forces = rule == SolidRule::one_point ? brick_forces(properties, corners, 1, state, points[0])
                                                          : eight_point_forces(properties, rule, corners, 1, state,
                                                                               std::span<PointState, 8>(points));
  Corners force = forces.force;
  for (Vector& one : force) one *= 1e6;
  return force;
}

void expect_near(const WeldResultants& found, const WeldResultants& wanted, double tolerance) {
  constexpr const char* names[] = {"N", "Qs", "Qt", "T", "Ms", "Mt"};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[i], wanted[i], tolerance) << names[i];
}

// Stress times area, in one component each.
TEST(WeldBrick, ResultantsOfUniformStress) {
  const double shear = young / 2;  // without lateral contraction
  const auto resultants = [](const std::function<Vector(const Vector&)>& u) {
    return brick_resultants(box(), forces_after(SolidRule::one_point, 0, u));
  };
  constexpr double small = 1e-3;  // of 1e6 times strains of 1e-6, linear theory and viscosity
  expect_near(resultants([](const Vector& x) { return Vector(0, 0, x.z()); }), {young * area, 0, 0, 0, 0, 0}, small);
  expect_near(resultants([](const Vector& x) { return Vector(x.z(), 0, 0); }), {0, shear * area, 0, 0, 0, 0}, small);
  expect_near(resultants([](const Vector& x) { return Vector(0, x.z(), 0); }), {0, 0, shear * area, 0, 0, 0}, small);
  expect_near(resultants([](const Vector& x) { return Vector(x.x(), 2 * x.y(), 0); }), {}, small);
}

// The upper face turned about each axis by an angle of one, the lower one held, with eight points (ELFORM 2). Axial
// stress has the modulus 4 G / 3 there, and the shear of an element that bends so varies along its height.
TEST(WeldBrick, MomentsOfATurnedFace) {
  const double shear = young / 2, about_x = area * depth * depth / 12, about_y = area * width * width / 12;
  const auto resultants = [&](const Vector& axis) {
    const Vector top(width / 2, depth / 2, height);
    return brick_resultants(box(), forces_after(SolidRule::eight_points, 0, [&](const Vector& x) {
                              return Vector(x.z() / height * axis.cross(x - top));
                            }));
  };
  const double bent = 4.0 / 3 * shear / height, sheared = shear * area * height / 12;
  expect_near(resultants({0, 0, 1}), {0, 0, 0, shear * (about_x + about_y) / height, 0, 0}, 1e-3);
  expect_near(resultants({1, 0, 0}), {0, 0, shear * area / 2, 0, bent * about_x + sheared, 0}, 1e-3);
  expect_near(resultants({0, 1, 0}), {0, -shear * area / 2, 0, 0, 0, bent * about_y + sheared}, 1e-3);
}

/// The means of force and moment at the middles of both faces, as the manual describes them.
WeldResultants slow_resultants(const Corners& x, const Corners& force) {
  Vector middles[2], pull[2], moment[2];
  for (std::size_t face = 0; face < 2; ++face) {
    middles[face] = pull[face] = moment[face] = Vector::Zero();
    for (std::size_t k = 4 * face; k < 4 * face + 4; ++k) middles[face] += x[k] / 4;
    for (std::size_t k = 4 * face; k < 4 * face + 4; ++k) {
      pull[face] += force[k];
      moment[face] += (x[k] - middles[face]).cross(force[k]);
    }
  }
  const Vector r = (x[2] + x[6] - x[0] - x[4]).cross(x[3] + x[7] - x[1] - x[5]).normalized();
  Vector s = x[1] + x[2] + x[5] + x[6] - x[0] - x[3] - x[4] - x[7];
  s = (s - s.dot(r) * r).normalized();
  const Vector n = (pull[1] - pull[0]) / 2, m = (moment[1] - moment[0]) / 2;
  return {n.dot(r), n.dot(s), n.dot(r.cross(s)), m.dot(r), m.dot(s), m.dot(r.cross(s))};
}

/// Random forces without a resultant, and without a moment.
Corners balanced(const Corners& x, std::mt19937& random) {
  std::normal_distribution<double> number;
  Corners force;
  Vector centre = Vector::Zero(), sum = Vector::Zero();
  for (std::size_t k = 0; k < 8; ++k) {
    force[k] = {number(random), number(random), number(random)};
    centre += x[k] / 8;
    sum += force[k] / 8;
  }
  Vector moment = Vector::Zero();
  Matrix inertia = Matrix::Zero();
  for (std::size_t k = 0; k < 8; ++k) {
    force[k] -= sum;
    const Vector arm = x[k] - centre;
    moment += arm.cross(force[k]);
    inertia += arm.squaredNorm() * Matrix::Identity() - arm * arm.transpose();
  }
  const Vector turn = inertia.inverse() * moment;
  for (std::size_t k = 0; k < 8; ++k) force[k] -= turn.cross(x[k] - centre);
  return force;
}

// Warped bricks: as the slow twin, the same after a turn of everything, and with the faces exchanged.
TEST(WeldBrick, ResultantsOfWarpedBricks) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-0.05, 0.05);
  for (int trial = 0; trial < 200; ++trial) {
    Corners x = box();
    for (Vector& corner : x) corner += Vector(shift(random), shift(random), shift(random));
    const Corners force = balanced(x, random);
    const WeldResultants found = brick_resultants(x, force);
    expect_near(found, slow_resultants(x, force), 1e-12);
    Vector axis(shift(random), shift(random), shift(random));
    const Matrix turn = Eigen::AngleAxisd(60 * axis.norm(), axis.normalized()).toRotationMatrix();
    Corners turned_x, turned_force, other_x, other_force;
    for (std::size_t k = 0; k < 8; ++k) {
      turned_x[k] = turn * x[k] + Vector(3, 1, 2);
      turned_force[k] = turn * force[k];
      // Seen from the other side: n5 n8 n7 n6 below, n1 n4 n3 n2 above, so that s and t change places.
      const std::size_t from = k < 4 ? 4 + (4 - k) % 4 : (8 - k) % 4;
      other_x[k] = x[from];
      other_force[k] = force[from];
    }
    expect_near(brick_resultants(turned_x, turned_force), found, 1e-12);
    const WeldResultants other = brick_resultants(other_x, other_force);
    EXPECT_NEAR(other[0], found[0], 1e-12);
    EXPECT_NEAR(other[3], found[3], 1e-12);
    // Across, lengths are kept only where the sides are at right angles: the axes s of both are then each other's t.
    EXPECT_NEAR(std::hypot(other[1], other[2]), std::hypot(found[1], found[2]), 1e-12);
    EXPECT_NEAR(std::hypot(other[4], other[5]), std::hypot(found[4], found[5]), 1e-12);
  }
}

std::string brick_deck(const std::string& material, const std::string& elform = "1",
                       const std::string& order = "1,2,3,4,5,6,7,8") {
  std::string text = "*NODE\n";
  int id = 0;
  for (const Vector& x : box()) text += fmt::format("{},{},{},{}\n", ++id, x.x(), x.y(), x.z());
  return text + "*ELEMENT_SOLID\n7,1," + order + "\n*PART\nweld\n1,1,1\n*SECTION_SOLID\n1," + elform + "\n" + material;
}

std::string mat_100(const std::string& limits = "", const std::string& rest = "1e6,1e6", double poisson = 0) {
  return fmt::format("*MAT_SPOTWELD\n1,{},{},{},{}\n{}\n", density, young, poisson, rest, limits);
}

struct Pulled {
  double time = -1;  ///< of failure; below zero: none
  PointState point;
  double ratio = 0, worst_force = 0;  ///< of energies; on any node after the failure
};

/// Moves the upper face with `velocity`, the lower one held, until the brick fails.
Pulled pull(const std::string& deck, const Vector& velocity, double end) {
  Structure brick = structure_of(deck);
  for (std::uint32_t n = 0; n < 8; ++n) {
    brick.constraints.hold(NodeIndex{n}, n < 4 ? 7 : 0);
    if (n < 4) continue;
    brick.state.mass[n] = 1e9;
    brick.state.v[n] = velocity;
  }
  StepSettings settings;
  settings.greatest_step = 1e-4;
  settings.energy_tolerance = 0;
  Stepper stepper(std::move(brick), settings);
  Pulled pulled;
  while (stepper.failures().empty() && stepper.state().time < end) {
    pulled.point = stepper.structure().solids.point(0);
    EXPECT_TRUE(stepper.step().ok());
  }
  if (!stepper.failures().empty()) {
    pulled.time = stepper.failures()[0].time;
    EXPECT_TRUE(stepper.structure().solids.failed(0));
    for (std::size_t n = 0; n < 8; ++n) {
      Vector force = Vector::Zero();
      stepper.structure().solids.gather(n, force);
      pulled.worst_force = std::max(pulled.worst_force, force.norm());
    }
  }
  pulled.ratio = stepper.energies().ratio();
  return pulled;
}

// Without lateral contraction N = E A ln(l / l₀); compression does not count. Whichever way round the sheets are.
TEST(WeldBrickRun, BreaksAtTheAxialForce) {
  const double strength = young * area * 0.01, wanted = (std::exp(0.01) - 1) * height / 0.1;
  const std::string limits = fmt::format("0.,{}", strength);
  for (const char* elform : {"1", "2", "-1", "-2"})
    for (const char* order : {"1,2,3,4,5,6,7,8", "5,8,7,6,1,4,3,2"}) {
      const Pulled pulled = pull(brick_deck(mat_100(limits), elform, order), {0, 0, 0.1}, 0.1);
      EXPECT_NEAR(pulled.time, wanted, 2e-4) << elform;
      EXPECT_NEAR(pulled.point.stress[2] * area / strength, 1, 5e-3) << elform;
      EXPECT_EQ(pulled.worst_force, 0);
      EXPECT_NEAR(pulled.ratio, 1, 1e-9);
    }
  EXPECT_LT(pull(brick_deck(mat_100(limits)), {0, 0, -0.1}, 0.1).time, 0);
  // Faces across the pull: the same force is a shear force of theirs.
  EXPECT_LT(pull(brick_deck(mat_100(limits), "1", "1,4,8,5,2,3,7,6"), {0, 0, 0.1}, 0.1).time, 0);
}

// Q = G γ A. The sides 1-2 and 1-4 are s and t.
TEST(WeldBrickRun, BreaksAtTheShearForces) {
  const double strength = young / 2 * area * 0.01;
  const std::string along_s = fmt::format("0.,0.,{}", strength), along_t = fmt::format("0.,0.,0.,{}", strength);
  const double wanted = 0.01 * height / 0.1;
  EXPECT_NEAR(pull(brick_deck(mat_100(along_s)), {0.1, 0, 0}, 0.1).time, wanted, 2e-4);
  EXPECT_NEAR(pull(brick_deck(mat_100(along_t)), {0, -0.1, 0}, 0.1).time, wanted, 2e-4);
  EXPECT_LT(pull(brick_deck(mat_100(along_t)), {0.1, 0, 0}, 0.05).time, 0);
  EXPECT_LT(pull(brick_deck(mat_100(along_s)), {0, 0.1, 0}, 0.05).time, 0);
  EXPECT_NEAR(pull(brick_deck(mat_100(along_t), "1", "2,3,4,1,6,7,8,5"), {0.1, 0, 0}, 0.1).time, wanted, 2e-4);
}

// Shear: γ = √3 εₚ + τ / G with τ = (SIGY + EH εₚ) / √3, but for terms of γ².
TEST(WeldBrickRun, BreaksAtThePlasticStrain) {
  const double yield = (10 + 50 * 0.02) / std::sqrt(3.0), gamma = std::sqrt(3.0) * 0.02 + yield / (young / 2);
  for (const char* elform : {"1", "2"}) {
    const Pulled pulled = pull(brick_deck(mat_100("0.02", "10.,50."), elform), {0.1, 0, 0}, 0.2);
    EXPECT_NEAR(pulled.time, gamma * height / 0.1, 2e-3 * gamma * height / 0.1 + 1e-4) << elform;
    EXPECT_LT(pulled.point.plastic_strain, 0.02);
    EXPECT_NEAR(pulled.point.plastic_strain, 0.02, 5e-5);
    EXPECT_NEAR(pulled.point.stress[5] / yield, 1, 3e-3);
    EXPECT_NEAR(pulled.ratio, 1, 1e-6);
  }
  EXPECT_NEAR(pull(brick_deck(mat_100("", "10.,50.,0.,0.0321")), {0.1, 0, 0}, 0.1).time, 0.0321, 1.1e-4);
}

// NF = n delays a force that grows steadily by (n − 1) / 2 evaluations.
TEST(WeldBrickRun, FilterDelays) {
  const double strength = young / 2 * area * 0.01;
  const auto time = [&](int filter) {
    return pull(brick_deck(mat_100(fmt::format("0.,0.,{},0.,0.,0.,0.,{}", strength, filter))), {0.1, 0, 0}, 0.2).time;
  };
  EXPECT_NEAR(time(101) - time(0), 50e-4, 1.1e-4);
}

TEST(WeldBrickRun, MassForTheTimeStep) {
  const double mass = density * area * height;
  Structure plain = structure_of(brick_deck(mat_100()));
  plain.solids.finish(plain.state.x.size());
  const double own = plain.solids.update(plain.state).manual_step;
  EXPECT_EQ(plain.added_mass, 0);
  for (const double factor : {0.5, 3.0}) {
    Structure brick = structure_of(brick_deck(mat_100("", fmt::format("10.,50.,{:.15g}", factor * own))));
    const double grown = std::max(1.0, factor * factor);
    EXPECT_NEAR(brick.state.mass[0] / (grown * mass / 8), 1, 1e-12);
    EXPECT_NEAR(brick.added_mass, (grown - 1) * mass, 1e-12);
    brick.solids.finish(brick.state.x.size());
    EXPECT_NEAR(brick.solids.update(brick.state).manual_step / (std::max(1.0, factor) * own), 1, 1e-12);
  }
}

TEST(WeldBrick, HostileCards) {
  const auto refused = [](const std::string& deck, Failure::Kind kind, std::string_view text) {
    const Failure failure = failure_of(deck);
    EXPECT_EQ(failure.kind, kind) << text;
    EXPECT_NE(failure.message.find(text), std::string::npos) << failure.message;
    EXPECT_GT(failure.place.line, 0u);
  };
  using Kind = Failure::Kind;
  refused(brick_deck(mat_100("0.,-5.")), Kind::not_calculated, "curve over the rate");
  refused(brick_deck(mat_100("-1.")), Kind::bad_material, "EFAIL is -1");
  refused(brick_deck(mat_100("0.,0.,0.,0.,0.,0.,0.,1e9")), Kind::bad_material, "NF is 1e+09");
  refused(brick_deck(mat_100("", "10.,50.,-1.")), Kind::bad_material, "DT is -1");
  refused(brick_deck(mat_100("", "0.,0.")), Kind::bad_material, "yield stress");
  refused(brick_deck("*MAT_SPOTWELD_DAMAGE-FAILURE\n1,2.,1000.,0.25,10.,50.\n0.\n\n"), Kind::bad_material,
          "variant SPOTWELD_DAMAGE-FAILURE");
  refused(brick_deck(mat_100(), "1", "1,2,3,4,5,5,8,8"), Kind::bad_element, "no faces n1 to n4 and n5 to n8");
  refused(brick_deck(mat_100(), "1", "1,2,4,5,5,5,5,5"), Kind::bad_element, "no faces n1 to n4 and n5 to n8");
  structure_of(brick_deck(mat_100(), "1", "1,2,3,3,5,6,7,7"));
  for (const char* limits : {"0.,1e300", "nan", "0.,0.,inf"})
    EXPECT_EQ(model::read_text(brick_deck(mat_100(limits))).errors(), 1u) << limits;
}

// Bending and torsion of a one-point brick are hourglass modes.
TEST(WeldBrick, FreeBendingIsNamed) {
  const auto warnings = [](const std::string& deck) {
    const model::Read read = model::read_text(deck);
    Diagnostics diagnostics;
    EXPECT_TRUE(build_structure(read.model, {}, diagnostics));
    std::string text;
    for (const Diagnostic& one : diagnostics.sorted()) text += one.message + "\n";
    return text;
  };
  const std::string moment = mat_100("0.,0.,0.,0.,0.,5.");
  EXPECT_NE(warnings(brick_deck(moment)).find("MRR, MSS and MTT hardly count"), std::string::npos);
  EXPECT_EQ(warnings(brick_deck(moment) + "*CONTROL_HOURGLASS\n5,0.1\n").find("hardly"), std::string::npos);
  EXPECT_EQ(warnings(brick_deck(moment, "2")).find("hardly"), std::string::npos);
  EXPECT_EQ(warnings(brick_deck(mat_100("0.,5."))).find("hardly"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::solver::weld_brick_test
