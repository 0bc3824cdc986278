#include "solver/element/beam.hpp"

#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "solver/element/beam_growth.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::beam_test {
namespace {

constexpr double young = 1000, poisson = 0.25, shear = 400, density = 2;

BeamProperties bar(bool truss = false, double shear_area = 0) {
  return {{MaterialKind::elastic, density, young, poisson, {}, 0, 0, 0, {}, 1},
          {0.02, 3e-5, 5e-5, 7e-5, shear_area, 0},
          truss};
}

/// A beam of length 2 from the origin along x; s is y, t is z.
BeamState start() {
  BeamState state;
  state.length = 2;
  state.axis = Vector::UnitY();
  return state;
}

/// Moves end 2 from its place at (2, 0, 0), end 1 stays.
BeamForces moved(const BeamProperties& properties, const Vector& way, const Vector& turn) {
  BeamState state = start();
  const BeamEnds ends{{Vector(0, 0, 0), Vector(2, 0, 0) + way}, {Vector(0, 0, 0), way}, {Vector(0, 0, 0), turn}};
  return properties.truss ? truss_forces(properties, ends, 1, state)
                          : resultant_beam_forces(properties, ends, 1, state);
}

// w = P L³ / 3 E I (+ P L / G A_s) and θ = P L² / 2 E I make the force P and no moment at the tip, P L at the root.
TEST(Beam, Cantilever) {
  constexpr double load = 1e-9, length = 2;
  for (const double shear_area : {0.0, 0.01}) {
    const BeamProperties properties = bar(false, shear_area);
    const double sheared = shear_area > 0 ? load * length / (shear * shear_area) : 0;
    for (const int direction : {1, 2}) {
      // Along z bends about s = y with Iss, along y about t = z with Itt.
      const double stiffness = young * (direction == 2 ? properties.section.iss : properties.section.itt);
      Vector way = Vector::Zero(), turn = Vector::Zero();
      way[direction] = load * std::pow(length, 3) / 3 / stiffness + sheared;
      turn[3 - direction] = (direction == 2 ? -1 : 1) * load * length * length / 2 / stiffness;
      const BeamForces forces = moved(properties, way, turn);
      ASSERT_TRUE(forces.good);
      EXPECT_NEAR(forces.force[1][direction] / load, 1, 1e-6);
      EXPECT_NEAR(forces.moment[1].norm() / load, 0, 1e-6);
      EXPECT_NEAR(std::abs(forces.moment[0][3 - direction]) / (load * length), 1, 1e-6);
      EXPECT_NEAR(forces.force[0][direction] / load, -1, 1e-6);
    }
  }
}

TEST(Beam, TorsionAndTension) {
  const BeamForces twisted = moved(bar(), {0, 0, 0}, {0.01, 0, 0});
  EXPECT_NEAR(twisted.moment[1].x(), shear * 7e-5 / 2 * 0.01, 1e-15);
  EXPECT_NEAR(twisted.moment[0].x(), -shear * 7e-5 / 2 * 0.01, 1e-15);
  const BeamForces pulled = moved(bar(), {0.02, 0, 0}, {0, 0, 0});
  EXPECT_NEAR(pulled.axial, young * 0.02 * 0.01, 1e-12);
  EXPECT_NEAR(pulled.force[1].x(), 0.2, 1e-12);
}

// ½ P w of the cantilever in both planes, ½ G J θ² / L of torsion, ½ E A u² / L of tension; of a truss σ² / 2E.
TEST(Beam, StoredEnergy) {
  constexpr double load = 1e-9, length = 2;
  const auto stored = [](const BeamProperties& properties, const Vector& way, const Vector& turn) {
    BeamState state = start();
    const BeamEnds ends{{Vector(0, 0, 0), Vector(2, 0, 0) + way}, {Vector(0, 0, 0), way}, {Vector(0, 0, 0), turn}};
    static_cast<void>(properties.truss ? truss_forces(properties, ends, 1, state)
                                       : resultant_beam_forces(properties, ends, 1, state));
    return stored_energy(properties, state, (ends.x[1] - ends.x[0]).norm());
  };
  for (const int direction : {1, 2}) {
    const double stiffness = young * (direction == 2 ? 3e-5 : 5e-5);
    Vector way = Vector::Zero(), turn = Vector::Zero();
    way[direction] = load * std::pow(length, 3) / 3 / stiffness;
    turn[3 - direction] = (direction == 2 ? -1 : 1) * load * length * length / 2 / stiffness;
    EXPECT_NEAR(stored(bar(), way, turn) / (load * way[direction] / 2), 1, 1e-6) << direction;
  }
  EXPECT_NEAR(stored(bar(), {0, 0, 0}, {0.01, 0, 0}), shear * 7e-5 * 0.01 * 0.01 / 2 / 2, 1e-16);
  EXPECT_NEAR(stored(bar(), {0.02, 0, 0}, {0, 0, 0}), young * 0.02 * 0.02 * 0.02 / 2 / 2, 1e-15);
  const double strain = 2 * 0.02 / 4.02;
  EXPECT_NEAR(stored(bar(true), {0.02, 0, 0}, {0, 0, 0}), young * strain * strain / 2 * 0.02 * 2.02, 1e-15);
}

TEST(Beam, ForcesAndMomentsBalance) {
  const Vector way(0.1, -0.2, 0.3), turn(0.2, 0.1, -0.3);
  for (const bool truss : {false, true}) {
    const BeamForces forces = moved(bar(truss, 0.01), way, turn);
    EXPECT_GT(forces.force[1].norm(), 0.01);
    EXPECT_NEAR((forces.force[0] + forces.force[1]).norm(), 0, 1e-15);
    const Vector arm = Vector(2, 0, 0) + way;
    EXPECT_NEAR((forces.moment[0] + forces.moment[1] + arm.cross(forces.force[1])).norm(), 0, 1e-14);
  }
}

// A stressed beam in a rigid turn about any axis: its forces turn with it.
TEST(Beam, RigidRotation) {
  const BeamProperties properties = bar(false, 0.01);
  const Vector axis = Vector(1, 2, -1).normalized(), shift(3, -1, 2);
  constexpr int steps = 100;
  constexpr double angle = 2 * std::numbers::pi / steps;
  BeamState state = start();
  BeamEnds ends{{shift, shift + Vector(2.1, 0.1, -0.2)}, {Vector::Zero(), Vector(0.1, 0.1, -0.2)}, {}};
  ends.w = {Vector(0.02, 0, 0.1), Vector(-0.1, 0.2, 0.1)};
  const BeamForces before = resultant_beam_forces(properties, ends, 1, state);
  const BeamState stressed = state;
  const Matrix step = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  BeamForces now = before;
  for (int i = 0; i < steps; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector next = step * ends.x[k];
      ends.v[k] = next - ends.x[k];
      ends.x[k] = next;
      ends.w[k] = 2 * std::tan(angle / 2) * axis;  // what spin_rotation() makes this turn of
    }
    now = resultant_beam_forces(properties, ends, 1, state);
    EXPECT_NEAR(now.axial, before.axial, 1e-10);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR((now.force[k] - before.force[k]).norm() / before.force[k].norm(), 0, 1e-10);
    EXPECT_NEAR((now.moment[k] - before.moment[k]).norm() / before.moment[k].norm(), 0, 1e-10);
  }
  EXPECT_NEAR((state.axis - stressed.axis).norm(), 0, 1e-12);
  EXPECT_NEAR(state.turn_s[0], stressed.turn_s[0], 1e-12);
  EXPECT_NEAR(state.twist, stressed.twist, 1e-12);
}

TEST(Truss, StressOfABarAndRotation) {
  const BeamForces forces = moved(bar(true), {0.002, 0, 0}, {1, 1, 1});
  EXPECT_NEAR(forces.axial, young * 0.02 * std::log(1.001), 2e-9);  // Δl / l of the middle
  EXPECT_EQ(forces.moment[1].norm(), 0);
  BeamState state = start();
  BeamEnds ends{{Vector(0, 0, 0), Vector(2.002, 0, 0)}, {Vector(0, 0, 0), Vector(0.002, 0, 0)}, {}};
  const double tension = truss_forces(bar(true), ends, 1, state).axial;
  const Vector turned(0, 0, 2.002);
  ends.v[1] = turned - ends.x[1];
  ends.x[1] = turned;
  const BeamForces after = truss_forces(bar(true), ends, 1, state);
  EXPECT_NEAR(after.axial, tension, 1e-14);
  EXPECT_NEAR(after.force[1].z(), tension, 1e-14);
}

// Yield at σ₀, then slope Eₜ; reversed yield 2 σ₀ below with a surface that shifts, at −top with one that grows.
TEST(Truss, YieldsAndHardens) {
  constexpr double yield = 5, tangent = 100;
  for (const double beta : {0.0, 1.0}) {
    BeamProperties properties = bar(true);
    properties.material = plastic_kinematic(density, young, poisson, yield, tangent, beta);
    BeamState state = start();
    double length = 2, strain = 0;
    const auto stretch = [&](double increment) {
      const double next = length * (2 + increment) / (2 - increment);  // Δl / l of the middle
      const BeamEnds ends{{Vector(0, 0, 0), Vector(next, 0, 0)}, {Vector(0, 0, 0), Vector(next - length, 0, 0)}, {}};
      length = next;
      strain += increment;
      return truss_forces(properties, ends, 1, state).axial / properties.section.area;
    };
    EXPECT_NEAR(stretch(0.004), 4, 1e-10);
    EXPECT_NEAR(stretch(0.004), yield + tangent * 0.003, 1e-10);
    const double top = stretch(0.002);
    EXPECT_NEAR(top, yield + tangent * 0.005, 1e-10);
    const double reversed = top - 2 * (beta == 0 ? yield : top);
    EXPECT_NEAR(stretch((reversed - top) / young - 0.001), reversed - 0.001 * tangent, 1e-9) << beta;
  }
}

std::string beam_line(int count, double length,
                      const std::string& section = "*SECTION_BEAM\n1,2\n0.02,3e-5,5e-5,7e-5\n") {
  std::string text = "*NODE\n";
  for (int i = 0; i <= count; ++i) text += fmt::format("{},{},0.,0.\n", i + 1, i * length / count);
  text += "999,0.,1.,0.\n*ELEMENT_BEAM\n";
  for (int i = 1; i <= count; ++i) text += fmt::format("{},1,{},{},999\n", i, i, i + 1);
  return text + elastic_deck(section, young, poisson, density);
}

/// Half a period of the first mode of a cantilever over its closed form.
double half_period(int n, int direction) {
  constexpr double length = 4;
  Structure beam = structure_of(beam_line(n, length));
  const double k = 1.875104069 / length, sigma = 0.734095514, sign = direction == 2 ? -1 : 1;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(n); ++i) {
    const double kx = k * beam.state.x[i].x();
    beam.state.v[i][direction] = 1e-4 * (std::cosh(kx) - std::cos(kx) - sigma * (std::sinh(kx) - std::sin(kx)));
    beam.state.w[i][3 - direction] =
        sign * 1e-4 * k * (std::sinh(kx) + std::sin(kx) - sigma * (std::cosh(kx) - std::cos(kx)));
  }
  beam.constraints.hold(NodeIndex{0}, 63);
  const double moment = direction == 2 ? 3e-5 : 5e-5;
  const double omega = 1.875104069 * 1.875104069 * std::sqrt(young * moment / (density * 0.02)) / (length * length);
  Stepper stepper(std::move(beam), {});
  const double half = std::numbers::pi / omega;
  double before = 0, last = 0;
  EXPECT_TRUE(run_until(stepper, 0.8 * half).ok());
  const auto tip = [&] { return stepper.state().x[static_cast<std::size_t>(n)][direction]; };
  for (before = tip(); before > 0 && stepper.state().time < 2 * half;) {
    last = stepper.state().time;
    const double now = (static_cast<void>(stepper.step()), tip());
    if (now <= 0) last += stepper.state().dt * before / (before - now);
    before = now;
  }
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-6);
  return last / half;
}

// ω = 1.8751² √(E I / ρ A L⁴), with an error that falls with the square of the elements' length.
TEST(BeamCantilever, FirstFrequency) {
  for (const int direction : {1, 2}) {
    const double coarse = half_period(16, direction) - 1, fine = half_period(32, direction) - 1,
                 finest = half_period(64, direction) - 1;
    EXPECT_LT(std::abs(fine), 0.01);
    EXPECT_NEAR((coarse - fine) / (fine - finest), 4, 0.6) << coarse << " " << fine << " " << finest;
    // What is left is the rotational inertia of the section, (Iss + Itt)/A per mass: half of it times ∫w'² / ∫w², which
    // is 4.648 / L² for this mode.
    EXPECT_NEAR(finest - (fine - finest) / 3, 0.5 * 8e-5 / 0.02 * 4.648 / 16, 3e-5);
    EXPECT_LT(std::abs(finest), 0.003);
  }
}

// A loose line of beams, thrown, turned and bent: energy to rounding, momentum.
TEST(BeamElements, ConserveEnergyAndMomentum) {
  Structure loose = structure_of(beam_line(10, 4, "*SECTION_BEAM\n1,2\n0.02,3e-5,5e-5,7e-5,0.01\n"));
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
  double bent = 0;
  for (int i = 0; i < 2000; ++i) {
    ASSERT_TRUE(stepper.step().ok());
    EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-10);
    bent = std::max(bent, stepper.energies().internal);
  }
  EXPECT_GT(bent, 1e-2 * stepper.energies().kinetic);
  // The works of the forces are what the shape of the beams stores.
  double stored = 0;
  for (std::size_t e = 0; e < 10; ++e) stored += stepper.structure().beams.stored(e, stepper.state().x);
  EXPECT_NEAR(stored / stepper.energies().internal, 1, 0.02);
  Vector now = Vector::Zero();
  for (std::size_t i = 0; i <= 10; ++i) now += stepper.state().mass[i] * stepper.state().v[i];
  EXPECT_NEAR((now - momentum).norm(), 0, 1e-12);
}

// One beam alone has the element's own masses, so the bound is sharp: stable just below it, not above.
TEST(BeamElements, StableStepIsSharp) {
  for (const char* section :
       {"*SECTION_BEAM\n1,2\n0.02,3e-5,5e-5,7e-5,0.01\n", "*SECTION_BEAM\n1,2\n0.02,3e-2,5e-3,7e-5\n",
        "*SECTION_BEAM\n1,2\n0.02,3e-5,5e-5,7e-2\n", "*SECTION_BEAM\n1,3\n0.02\n"}) {
    Structure beam = structure_of(beam_line(1, 1, section));
    const double step = beam_step(beam);
    beam.state.v[1] = Vector(1e-9, 2e-9, 3e-9);
    beam.state.w[0] = Vector(2e-9, 1e-9, -3e-9);
    expect_sharp_step(beam, step, section);
  }
}

// A rod of trusses hit at its end: the wave runs with √(E/ρ), behind it σ = ρ c v.
TEST(BeamElements, WaveInATrussRod) {
  Structure rod = structure_of(beam_line(100, 10, "*SECTION_BEAM\n1,3\n0.02\n"));
  constexpr double speed = 0.01;
  const double wave = std::sqrt(young / density);
  for (std::size_t i = 0; i <= 100; ++i) rod.state.v[i].x() = i == 0 ? 0 : -speed;
  for (std::uint32_t i = 0; i <= 100; ++i) rod.constraints.hold(NodeIndex{i}, i == 0 ? 7 : 6);
  Stepper stepper(std::move(rod), {});
  ASSERT_TRUE(run_until(stepper, 5 / wave).ok());
  double mean = 0;
  for (std::size_t e = 5; e < 35; ++e) mean += stepper.structure().beams.state(e).stress / 30;
  EXPECT_NEAR(mean / (-density * wave * speed), 1, 0.02);
  EXPECT_NEAR(stepper.structure().beams.state(70).stress, 0, 0.02 * density * wave * speed);
  EXPECT_NEAR(stepper.energies().ratio(), 1, 1e-3);
}

// s lies in the plane with the third node, across the beam, wherever in that plane the node is.
TEST(BeamElements, AxisAcrossTheBeam) {
  const auto axis = [](const char* third) {
    const Structure beam =
        structure_of(fmt::format("*NODE\n1,0.,0.,0.\n2,2.,0.,0.\n3,{}\n*ELEMENT_BEAM\n1,1,1,2,3\n", third) +
                     elastic_deck("*SECTION_BEAM\n1,2\n0.02,3e-5,5e-5,7e-5\n", young, poisson, density));
    return beam.beams.state(0).axis;
  };
  EXPECT_NEAR((axis("5.,0.,3.") - Vector::UnitZ()).norm(), 0, 1e-15);
  EXPECT_NEAR((axis("-7.,2.,2.") - Vector(0, 1, 1).normalized()).norm(), 0, 1e-15);
}

TEST(BeamElements, MassAndInertia) {
  const Structure beam = structure_of(beam_line(2, 4, "*SECTION_BEAM\n1,2,,,,,0.5\n0.02,3e-5,5e-5,7e-5\n"));
  const double half = (density * 0.02 + 0.5) * 2 / 2;
  EXPECT_NEAR(beam.state.mass[0], half, 1e-14);
  EXPECT_NEAR(beam.state.mass[1], 2 * half, 1e-14);
  EXPECT_NEAR(beam.state.inertia[0], half * 4 / 12, 1e-14);
  const Structure rigid = structure_of(
      "*NODE\n1,0.,0.,0.\n2,2.,0.,0.\n*ELEMENT_BEAM\n1,1,1,2\n*PART\np\n1,1,1\n"
      "*SECTION_BEAM\n1,2\n0.02,3e-5,3e-5,7e-5\n*MAT_RIGID\n1,3.,1000.,0.3\n");
  ASSERT_EQ(rigid.rigid.size(), 1u);
  EXPECT_NEAR(rigid.rigid[0].mass(), 3 * 0.02 * 2, 1e-14);
  EXPECT_NEAR(rigid.rigid[0].inertia()(2, 2), 0.12 * 4 / 12, 1e-14);
}

TEST(BeamElements, WhatIsNotCalculatedIsNamed) {
  const std::string nodes =
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,2.,0.,0.\n*ELEMENT_BEAM\n1,1,1,2,3,1\n*ELEMENT_BEAM_OFFSET\n"
      "2,1,2,3\n0.,0.,1.,0.,0.,1.\n*PART\np\n1,1,1\n";
  const model::Read read = model::read_text(nodes + "*SECTION_BEAM\n1,1\n0.2,0.2,0.1,0.1\n*MAT_ELASTIC\n1,1.,1.,0.3\n");
  Diagnostics diagnostics;
  EXPECT_EQ(build_structure(read.model, {}, diagnostics).value().beams.size(), 2u);
  std::string text;
  for (const Diagnostic& d : diagnostics.sorted()) text += d.message + "\n";
  EXPECT_EQ(text,
            "1 beams have pin releases (RT1, RR1, RT2, RR2), which are calculated in resultant beams only\n"
            "2 beams have no third node across; their axes s and t are chosen freely\n");
  EXPECT_EQ(failure_of(nodes + "*SECTION_BEAM\n1,2\n0.2,1.,1.\n*MAT_003\n1,1.,1.,0.3,1.\n").kind,
            Failure::Kind::bad_material);
  EXPECT_EQ(failure_of(nodes + "*SECTION_BEAM\n1,2\n0.,1.,1.\n*MAT_ELASTIC\n1,1.,1.,0.3\n").kind,
            Failure::Kind::bad_element);
  EXPECT_EQ(failure_of(nodes + "*SECTION_SHELL\n1,2\n1.\n*MAT_ELASTIC\n1,1.,1.,0.3\n").kind,
            Failure::Kind::missing_material);
  EXPECT_EQ(failure_of("*NODE\n1,0.,0.,0.\n2,0.,0.,0.\n*ELEMENT_BEAM\n1,1,1,2\n*PART\np\n1,1,1\n"
                       "*SECTION_BEAM\n1,3\n1.\n*MAT_ELASTIC\n1,1.,1.,0.3\n")
                .kind,
            Failure::Kind::bad_element);
}

// Beams of a null material carry mass only.
TEST(BeamElements, NullBeams) {
  Structure beam = structure_of(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n*ELEMENT_BEAM\n1,1,1,2\n*PART\np\n1,1,1\n"
      "*SECTION_BEAM\n1,2\n0.02,3e-5,3e-5,7e-5\n*MAT_NULL\n1,3.\n");
  beam.state.v[1] = {0.1, 0.2, 0};
  StepSettings settings;
  settings.greatest_step = 0.1;
  Stepper stepper(std::move(beam), settings);
  ASSERT_TRUE(run_until(stepper, 2).ok());
  EXPECT_EQ(stepper.state().v[1], Vector(0.1, 0.2, 0));
}

TEST(BeamElements, SameBitsForAnyNumberOfThreads) {
  std::array<State, 2> result;
  for (std::size_t run = 0; run < 2; ++run) {
    const JobLimit jobs(run == 0 ? 1 : 4);
    Structure line = structure_of(beam_line(5000, 500));
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
}  // namespace gapcheck::solver::beam_test
