#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "solver/element/beam.hpp"
#include "solver/element/beam_growth.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::integrated_beam_test {
namespace {

constexpr double young = 1000, poisson = 0.25, shear = 400, density = 2, pi = std::numbers::pi;

model::BeamProfile rectangle_of(double s, double t, std::int64_t rule) {
  model::BeamProfile profile;
  profile.s = {s, s};
  profile.t = {t, t};
  profile.rule = rule;
  return profile;
}

model::BeamProfile tube_of(double outer, double inner, std::int64_t rule) {
  model::BeamProfile profile = rectangle_of(outer, inner, rule);
  profile.tube = true;
  return profile;
}

BeamProperties properties_of(const model::BeamProfile& profile, double yield = 0) {
  BeamProperties properties;
  properties.material = yield > 0 ? plastic_kinematic(density, young, poisson, yield, 0, 1)
                                  : Material{MaterialKind::elastic, density, young, poisson, {}, 0, 0, 0, {}, 1};
  properties.fibers = section_fibers(profile);
  properties.section = section_constants(profile, properties.fibers);
  properties.shear_factor = profile.shear_factor;
  properties.torsion_free = profile.torsion_free;
  return properties;
}

/// A beam of length 2 from the origin along x; s is y, t is z.
struct Bench {
  BeamProperties properties;
  BeamState state;
  std::vector<BeamPoint> points;
  BeamEnds ends{{Vector(0, 0, 0), Vector(2, 0, 0)}, {Vector::Zero(), Vector::Zero()}, {Vector::Zero(), Vector::Zero()}};

  explicit Bench(BeamProperties all) : properties(std::move(all)), points(properties.fibers.size()) {
    state.length = 2;
    state.axis = Vector::UnitY();
  }
  /// Moves and turns end 2 in `steps`.
  BeamForces move(const Vector& way, const Vector& turn, int steps = 1) {
    BeamForces forces;
    for (int i = 0; i < steps; ++i) {
      ends.v = {Vector::Zero(), Vector(way / steps)};
      ends.w = {Vector::Zero(), Vector(turn / steps)};
      ends.x[1] += ends.v[1];
      forces = integrated_beam_forces(properties, ends, 1, nullptr, state, points);
    }
    return forces;
  }
};

TEST(IntegratedBeam, ConstantsOfTheSection) {
  const double s = 0.3, t = 0.2;
  for (const std::int64_t rule : {2, 3, 4, 5}) {
    const model::BeamProfile profile = rectangle_of(s, t, rule);
    const std::vector<Fiber> fibers = section_fibers(profile);
    const model::BeamSection section = section_constants(profile, fibers);
    EXPECT_EQ(fibers.size(), rule == 2 ? 4u : rule == 5 ? 16u : 9u);
    EXPECT_NEAR(section.area, s * t, 1e-15);
    EXPECT_NEAR(section.iss, s * t * t * t / 12, 1e-17);
    EXPECT_NEAR(section.itt, t * s * s * s / 12, 1e-17);
    const double outer = 0.5, inner = 0.2;
    const model::BeamSection tube = section_constants(profile, section_fibers(tube_of(outer, inner, rule)));
    const double second = pi / 64 * (std::pow(outer, 4) - std::pow(inner, 4));
    EXPECT_NEAR(tube.area, pi / 4 * (outer * outer - inner * inner), 1e-15);
    EXPECT_NEAR(tube.iss, second, 1e-16);
    EXPECT_NEAR(tube.itt, second, 1e-16);
    EXPECT_NEAR(tube.torsion, 2 * second, 1e-16);
  }
  EXPECT_EQ(section_fibers(rectangle_of(s, t, 1)).size(), 1u);
  EXPECT_TRUE(section_fibers(rectangle_of(s, t, -3)).empty());
  EXPECT_TRUE(section_fibers(rectangle_of(s, t, 6)).empty());
  model::BeamProfile tapered = rectangle_of(s, t, 2);
  tapered.s[1] = 0.5;
  EXPECT_NEAR(section_constants(tapered, section_fibers(tapered)).area, 0.4 * t, 1e-15);
}

// One element has its moment in its middle: w = P L³/4EI + P L/kGA and θ = P L²/2EI make the force P, no moment at the
// tip, P L at the root.
TEST(IntegratedBeam, Cantilever) {
  constexpr double load = 1e-9, length = 2;
  for (const double factor : {1.0, 5.0 / 6}) {
    model::BeamProfile profile = rectangle_of(0.3, 0.2, 2);
    profile.shear_factor = factor;
    const BeamProperties properties = properties_of(profile);
    for (const int direction : {1, 2}) {
      const double bending = young * (direction == 2 ? properties.section.iss : properties.section.itt);
      Vector way = Vector::Zero(), turn = Vector::Zero();
      way[direction] = load * std::pow(length, 3) / 4 / bending + load * length / (factor * shear * 0.06);
      turn[3 - direction] = (direction == 2 ? -1 : 1) * load * length * length / 2 / bending;
      const BeamForces forces = Bench(properties).move(way, turn);
      ASSERT_TRUE(forces.good);
      EXPECT_NEAR(forces.force[1][direction] / load, 1, 1e-6);
      EXPECT_NEAR(forces.moment[1].norm() / load, 0, 1e-6);
      EXPECT_NEAR(std::abs(forces.moment[0][3 - direction]) / (load * length), 1, 1e-6);
    }
  }
}

TEST(IntegratedBeam, TensionAndTorsion) {
  const BeamProperties tube = properties_of(tube_of(0.5, 0.2, 3));
  const BeamForces twisted = Bench(tube).move({0, 0, 0}, {0.01, 0, 0});
  EXPECT_NEAR(twisted.moment[1].x(), shear * tube.section.torsion / 2 * 0.01, 1e-15);
  EXPECT_NEAR(twisted.moment[0].x(), -twisted.moment[1].x(), 1e-18);
  const BeamForces pulled = Bench(tube).move({0.02, 0, 0}, {0, 0, 0}, 100);
  EXPECT_NEAR(pulled.axial, young * tube.section.area * std::log(1.01), 1e-8);
  model::BeamProfile free = tube_of(0.5, 0.2, 3);
  free.torsion_free = true;
  EXPECT_EQ(Bench(properties_of(free)).move({0, 0, 0}, {0.01, 0, 0}).moment[1].x(), 0);
}

// Fully plastic moments and torques are those of the points: Σ A |t| σ₀ and Σ A r σ₀/√3; the closed forms of the shapes
// are b h²/4, D³/6 and π D³/12.
TEST(IntegratedBeam, PlasticMomentAndTorque) {
  constexpr double yield = 2;
  const auto plastic = [](const model::BeamProfile& profile, const Vector& turn) {
    return Bench(properties_of(profile, yield)).move({0, 0, 0}, turn, 2000).moment[1];
  };
  for (const std::int64_t rule : {2, 3, 4, 5})
    for (const bool round : {false, true}) {
      const model::BeamProfile profile = round ? tube_of(0.2, 0, rule) : rectangle_of(0.3, 0.2, rule);
      double bending = 0, torque = 0;
      for (const Fiber& fiber : section_fibers(profile)) {
        bending += yield * fiber.area * std::abs(fiber.t);
        torque += yield / std::sqrt(3.0) * fiber.area * std::hypot(fiber.s, fiber.t);
      }
      // Symmetric ends keep it straight: both ends turn against each other.
      Bench bench(properties_of(profile, yield));
      BeamForces forces;
      for (int i = 0; i < 2000; ++i) {
        bench.ends.w = {Vector(0, -1e-3, 0), Vector(0, 1e-3, 0)};
        forces = integrated_beam_forces(bench.properties, bench.ends, 1, nullptr, bench.state, bench.points);
      }
      EXPECT_NEAR(forces.moment[1].y() / bending, 1, 1e-9) << rule << round;
      EXPECT_NEAR(plastic(profile, {4, 0, 0}).x() / torque, 1, 1e-9) << rule << round;
      const double exact = yield * (round ? 0.008 / 6 : 0.3 * 0.04 / 4);
      const double error = bending / exact - 1;
      EXPECT_LT(std::abs(error), rule == 2 ? 0.19 : rule == 3 ? 0.14 : rule == 4 ? 0.334 : 0.05) << rule << round;
    }
}

TEST(IntegratedBeam, ForcesAndMomentsBalance) {
  model::BeamProfile profile = rectangle_of(0.3, 0.2, 3);
  profile.shear_factor = 0.8;
  const Vector way(0.1, -0.2, 0.3), turn(0.2, 0.1, -0.3);
  const BeamForces forces = Bench(properties_of(profile, 5)).move(way, turn, 10);
  EXPECT_GT(forces.force[1].norm(), 0.01);
  EXPECT_NEAR((forces.force[0] + forces.force[1]).norm(), 0, 1e-15);
  const Vector arm = Vector(2, 0, 0) + way;
  EXPECT_NEAR((forces.moment[0] + forces.moment[1] + arm.cross(forces.force[1])).norm(), 0, 1e-14);
}

// A stressed beam in a full turn about any axis: its forces turn with it.
TEST(IntegratedBeam, RigidRotation) {
  const Vector axis = Vector(1, 2, -1).normalized();
  constexpr int steps = 100;
  constexpr double angle = 2 * pi / steps;
  Bench bench(properties_of(rectangle_of(0.3, 0.2, 2), 50));
  const BeamForces before = bench.move({0.1, 0.1, -0.2}, {-0.1, 0.2, 0.1}, 5);
  const std::vector<BeamPoint> stressed = bench.points;
  const Matrix step = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  BeamForces now = before;
  for (auto& x : bench.ends.x) x += Vector(3, -1, 2);
  for (int i = 0; i < steps; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector next = step * bench.ends.x[k];
      bench.ends.v[k] = next - bench.ends.x[k];
      bench.ends.x[k] = next;
      bench.ends.w[k] = 2 * std::tan(angle / 2) * axis;  // what spin_rotation() makes this turn of
    }
    now = integrated_beam_forces(bench.properties, bench.ends, 1, nullptr, bench.state, bench.points);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR((now.force[k] - before.force[k]).norm() / before.force[k].norm(), 0, 1e-10);
    EXPECT_NEAR((now.moment[k] - before.moment[k]).norm() / before.moment[k].norm(), 0, 1e-10);
  }
  for (std::size_t i = 0; i < stressed.size(); ++i)
    EXPECT_NEAR(bench.points[i].stress[0], stressed[i].stress[0], 1e-10);
}

const std::string round_section = "*SECTION_BEAM\n1,1,1.,3,1\n0.4,0.4\n";
const std::string flat_section = "*SECTION_BEAM\n1,1,0.8,2\n0.3,0.3,0.2,0.2\n";

std::string beam_line(int count, double length, const std::string& section,
                      const std::string& material = fmt::format("*MAT_ELASTIC\n1,{},{},{}\n", density, young,
                                                                poisson)) {
  std::string text = "*NODE\n";
  for (int i = 0; i <= count; ++i) text += fmt::format("{},{},0.,0.\n", i + 1, i * length / count);
  text += "999,0.,1.,0.\n*ELEMENT_BEAM\n";
  for (int i = 1; i <= count; ++i) text += fmt::format("{},1,{},{},999\n", i, i, i + 1);
  return text + "*PART\np\n1,1,1\n" + section + material;
}

/// Half a period of the first mode of a cantilever.
double half_period(int n, double about) {
  constexpr double length = 8;
  Structure beam = structure_of(beam_line(n, length, round_section));
  const double k = 1.875104069 / length, sigma = 0.734095514;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(n); ++i) {
    const double kx = k * beam.state.x[i].x();
    beam.state.v[i].y() = 1e-4 * (std::cosh(kx) - std::cos(kx) - sigma * (std::sinh(kx) - std::sin(kx)));
    beam.state.w[i].z() = 1e-4 * k * (std::sinh(kx) + std::sin(kx) - sigma * (std::cosh(kx) - std::cos(kx)));
  }
  beam.constraints.hold(NodeIndex{0}, 63);
  Stepper stepper(std::move(beam), {});
  const auto tip = [&] { return stepper.state().x[static_cast<std::size_t>(n)].y(); };
  double last = 0, before = 0;
  EXPECT_TRUE(run_until(stepper, 0.8 * about).ok());
  for (before = tip(); before > 0 && stepper.state().time < 2 * about;) {
    last = stepper.state().time;
    EXPECT_TRUE(stepper.step().ok());
    const double now = tip();
    if (now <= 0) last += stepper.state().dt * before / (before - now);
    before = now;
  }
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-6);
  return last;
}

// The frequency converges with order 2 to that of Timoshenko's beam with the lumped inertia's limit (Iss + Itt)/A: the
// period of Euler's beam, longer by shear and rotational inertia.
TEST(IntegratedBeamLine, FirstFrequency) {
  const double area = pi / 4 * 0.16, second = pi / 64 * 0.0256, length = 8;
  const double omega = 1.875104069 * 1.875104069 * std::sqrt(young * second / (density * area)) / (length * length);
  const double half = pi / omega;
  const double coarse = half_period(24, half) / half - 1, fine = half_period(48, half) / half - 1,
               finest = half_period(96, half) / half - 1;
  EXPECT_NEAR((coarse - fine) / (fine - finest), 4, 0.8) << coarse << " " << fine << " " << finest;
  // Of ω²: ∫w'²/∫w² = 4.648/L² times 2 I/A (inertia) and E I/(G A) (shear); half of it of the period.
  const double longer = 0.5 * 4.648 / (length * length) * (2 * second / area + young / shear * second / area);
  EXPECT_NEAR(finest - (fine - finest) / 3, longer, 4e-4) << longer;
}

// A loose line of beams, thrown, turned, bent and yielding: energy to rounding, momentum; the work is stored or flows.
TEST(IntegratedBeamLine, ConservesEnergyAndMomentum) {
  for (const std::string& material :
       {fmt::format("*MAT_ELASTIC\n1,{},{},{}\n", density, young, poisson),
        fmt::format("*MAT_PLASTIC_KINEMATIC\n1,{},{},{},10.,100.,0.5\n", density, young, poisson)}) {
    Structure loose = structure_of(beam_line(10, 4, flat_section, material));
    Vector momentum = Vector::Zero();
    for (std::size_t i = 0; i <= 10; ++i) {
      const Vector& x = loose.state.x[i];
      loose.state.v[i] = Vector(0.1, -0.2, 0.3) + Vector(0.5, 0.3, 1).cross(x) +
                         0.3 * Vector(0, std::sin(2 * x.x()), std::cos(3 * x.x()));
      loose.state.w[i] = Vector(0.5 + 0.1 * std::sin(x.x()), 0.3, 1);
      momentum += loose.state.mass[i] * loose.state.v[i];
    }
    StepSettings settings;
    settings.greatest_step = 1e-3;
    Stepper stepper(std::move(loose), settings);
    for (int i = 0; i < 2000; ++i) {
      ASSERT_TRUE(stepper.step().ok());
      ASSERT_NEAR(stepper.energies().ratio(), 1, 1e-10);
    }
    double kept = 0;
    const BeamElements& beams = stepper.structure().beams;
    for (std::size_t e = 0; e < 10; ++e) kept += beams.stored(e, stepper.state().x) + beams.energy(e).dissipated;
    EXPECT_NEAR(kept / stepper.energies().internal, 1, 0.02) << material;
    Vector now = Vector::Zero();
    for (std::size_t i = 0; i <= 10; ++i) now += stepper.state().mass[i] * stepper.state().v[i];
    EXPECT_NEAR((now - momentum).norm(), 0, 1e-12);
  }
}

// One beam alone has the element's own masses, so the bound is sharp: stable just below it, not above.
TEST(IntegratedBeamLine, StableStepIsSharp) {
  for (const std::string& section : {round_section, flat_section, std::string("*SECTION_BEAM\n1,9,1.,2,1\n3.,3.\n"),
                                     std::string("*SECTION_BEAM\n1,1,1.,1\n0.1,0.1,0.1,0.1\n"),
                                     std::string("*SECTION_BEAM\n1,1,9.,2\n0.1,0.1,0.1,0.1\n")}) {
    Structure beam = structure_of(beam_line(1, 1, section));
    const double step = beam_step(beam);
    beam.state.v[1] = Vector(1e-9, 2e-9, 3e-9);
    beam.state.w[0] = Vector(2e-9, 1e-9, -3e-9);
    expect_sharp_step(beam, step, section);
  }
}

// A tension far above the shear stiffness makes a string of the beam: 2/ω with ω² = 2 N/(l m) across.
TEST(IntegratedBeamLine, TensionShortensTheStep) {
  constexpr double tension = 1e4;
  Structure beam = structure_of(beam_line(1, 1, flat_section));
  AxialPreload pulled{TimeCurve({{0, tension}, {1e9, tension}}), 1e9, true};
  beam.beams.preload(0, beam.beams.add_preload(std::move(pulled)));
  const double step = beam_step(beam);
  EXPECT_NEAR(step / (2 / std::sqrt(2 * tension / beam.state.mass[0])), 1, 0.01);
  for (const NodeIndex node : {NodeIndex{0}, NodeIndex{1}}) beam.constraints.hold(node, 1);
  beam.state.v[1].y() = 1e-9;
  expect_sharp_step(beam, step);
}

// L/c limits the step of usual sections: neither bending, nor shear, nor torsion is faster.
TEST(IntegratedBeamLine, StepOfUsualSections) {
  for (const std::string& section : {round_section, flat_section, std::string("*SECTION_BEAM\n1,9,1.,2,1\n3.,3.\n")}) {
    Structure beam = structure_of(beam_line(1, 1, section));
    beam.beams.finish(beam.state.x.size());
    const Summary summary = beam.beams.update(beam.state);
    EXPECT_NEAR(summary.manual_step, 1 / std::sqrt(young / density), 1e-15);
    EXPECT_GT(summary.stable_step, 0.999 * summary.manual_step) << section;
  }
}

TEST(IntegratedBeamLine, FailsWithItsLastPoint) {
  Structure bar = structure_of(
      beam_line(1, 1, flat_section,
                fmt::format("*MAT_PLASTIC_KINEMATIC\n1,{},{},{},5.,0.,1.\n0.,0.,0.05\n", density, young, poisson)));
  bar.state.v[1].x() = 20;
  bar.constraints.hold(NodeIndex{0}, 63);
  StepSettings settings;
  settings.greatest_step = 1e-3;
  Stepper stepper(std::move(bar), settings);
  while (stepper.failures().empty() && stepper.state().time < 1) ASSERT_TRUE(stepper.step().ok());
  ASSERT_EQ(stepper.failures().size(), 1u);
  EXPECT_EQ(stepper.failures()[0].kind, StepControl::Kind::beam);
  // Strain 0.05 + σ/E = 0.055, the last step's 0.02 more at most.
  EXPECT_NEAR(std::log(stepper.state().x[1].x()), 0.065, 0.0301);
  const double speed = stepper.state().v[1].x();
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(stepper.step().ok());
  EXPECT_EQ(stepper.state().v[1].x(), speed);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-10);
  EXPECT_TRUE(stepper.structure().beams.failed(0));
}

TEST(IntegratedBeamLine, WhatCannotBeIsRefused) {
  const auto refused = [](const std::string& section, std::string_view text) {
    const Failure failure = failure_of(beam_line(1, 1, section));
    EXPECT_EQ(failure.kind, Failure::Kind::bad_element);
    EXPECT_NE(failure.message.find(text), std::string::npos) << failure.message;
    EXPECT_GT(failure.place.line, 0u);
  };
  refused("*SECTION_BEAM\n1,1,1.,2,1\n0.,0.\n", "TS1");
  refused("*SECTION_BEAM\n1,1,1.,2,1\n1.,1.,2.,2.\n", "TS1");
  refused("*SECTION_BEAM\n1,1,1.,2\n-1.,-1.,-1.,-1.\n", "TS1");
  refused("*SECTION_BEAM\n1,1,-1.,2\n1.,1.,1.,1.\n", "SHRF");
  refused("*SECTION_BEAM\n1,1,1.,-7\n1.,1.,1.,1.\n", "QR/IRID -7");
  refused("*SECTION_BEAM\n1,1,1.,2,2\n1.,1.,1.,1.\n", "arbitrary");
}

TEST(IntegratedBeamLine, SameBitsForAnyNumberOfThreads) {
  std::array<State, 2> result;
  for (std::size_t run = 0; run < 2; ++run) {
    const JobLimit jobs(run == 0 ? 1 : 4);
    Structure line = structure_of(beam_line(3000, 300, flat_section));
    for (std::size_t i = 0; i < line.state.v.size(); ++i)
      line.state.v[i] = {0.01 * std::sin(5.0 * static_cast<double>(i)), 0.02 * std::cos(3.0 * static_cast<double>(i)),
                         0.01};
    Stepper stepper(std::move(line), {});
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(stepper.step().ok());
    result[run] = stepper.state();
  }
  EXPECT_EQ(result[0].x, result[1].x);
  EXPECT_EQ(result[0].w, result[1].w);
}

}  // namespace
}  // namespace gapcheck::solver::integrated_beam_test
