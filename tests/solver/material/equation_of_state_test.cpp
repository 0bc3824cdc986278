#include "solver/material/equation_of_state.hpp"

#include <cmath>

#include "solver/output/state_balance.hpp"
#include "solver/run_scene.hpp"
#include "solver/stretched_element.hpp"

namespace gapcheck::solver::equation_of_state_test {
namespace {

const std::vector<EquationOfState>& laws() {
  static const std::vector<EquationOfState> all{
      {LinearPolynomial{{1, 1000, 300, 50, 0.4, 0.3, 0.2}}, 2},
      {Gruneisen{1000, 1.5, 0.2, 0.1, 2, 0.5}, 3},
      {PressureTable{{{-0.3, 700, 1.5}, {-0.1, 150, 1.2}, {0, 1, 1}, {0.1, -80, 0.9}}, 0.8}, 5}};
  return all;
}

// The modulus is the slope of the pressure along dE = −p dV, from both sides of V.
TEST(EquationOfState, BulkModulusIsTheSlopeOfTheIsentrope) {
  for (const EquationOfState& law : laws())
    for (const double v : {0.8, 0.93, 0.97, 1.04})
      for (const double e : {0.0, 40.0}) {
        constexpr double h = 1e-6;
        const double p = law.at(v).pressure(e);
        const double up = law.at(v + h).pressure(e - h * p), down = law.at(v - h).pressure(e + h * p);
        EXPECT_NEAR(law.bulk(v, e), -v * (up - down) / (2 * h), 1e-4 * law.bulk(v, e)) << v << " " << e;
        EXPECT_GE(law.bulk_bound(v, e), law.bulk(v, e) * (1 - 1e-12));
      }
}

// Rankine and Hugoniot: with E = p (1 − V) / 2 the pressure is ρ₀ C² η / (1 − S1 η)², η = 1 − V, whatever γ₀ and a.
TEST(EquationOfState, GruneisenMeetsItsHugoniot) {
  const Gruneisen law{1000, 1.49, 0, 0, 2, 0.47};
  for (const double eta : {0.01, 0.1, 0.3, 0.5}) {
    const double p = 1000 * eta / std::pow(1 - 1.49 * eta, 2);
    EXPECT_NEAR(law.at(1 - eta).pressure(p * eta / 2), p, 1e-12 * p);
  }
  EXPECT_TRUE(std::isinf(law.at(1 - 0.7).cold)) << "beyond the pole at η = 1 / S1";
}

TEST(EquationOfState, TableByHand) {
  const EquationOfState& law = laws()[2];
  EXPECT_NEAR(law.at(std::exp(-0.2)).pressure(0), 425, 1e-9);
  EXPECT_NEAR(law.at(std::exp(-0.4)).pressure(0), 975, 1e-9) << "the last slope goes on";
  EXPECT_NEAR(law.at(std::exp(0.2)).pressure(10), -161 + 0.8 * 0.8 * 10, 1e-9);
}

// The model's modulus at rest, which contacts take, is the solver's.
TEST(EquationOfState, ModulusAtRest) {
  const model::Read read = model::read_text(
      "*EOS_001\n1,1.,1000.,300.,50.,0.4,0.3,0.2\n2.,1.\n*EOS_GRUNEISEN\n2,20.,1.5,0.2,0.1,2.,0.5,3.\n1.\n"
      "*EOS_TABULATED\n3,0.8,5.,1.\n0.1,0.,-0.1,-0.3,0.\n0.,0.,0.,0.,0.\n-80.,1.,150.,700.,0.\n\n0.9,1.,1.2,1.5\n\n");
  EXPECT_EQ(read.text(), "");
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& law = laws()[i];
    const double expected = law.bulk(1, law.initial_energy);
    EXPECT_NEAR(model::initial_bulk_modulus(read.model.equations_of_state.at(static_cast<std::int64_t>(i + 1)), 2.5),
                expected, 1e-9 * expected);
  }
  EXPECT_EQ(read.model.equations_of_state.at(3).rows.size(), 4u);
}

const std::string no_viscosity = "*CONTROL_BULK_VISCOSITY\n1e-9,1e-9\n";

RunSettings steps_of(double dt) {
  RunSettings settings;
  settings.step.greatest_step = dt;
  return settings;
}

double pressure_of(const RunScene& scene) {
  return -trace(scene.run().stepper().structure().solids.point(0).stress) / 3;
}

// An ideal gas that is compressed to half its volume: p = p₀ V^−γ, and the work is what its energy grows by.
TEST(EquationOfState, AdiabatOfAnIdealGas) {
  for (const int elform : {1, 2}) {
    RunScene scene(
        stretched_cube("*MAT_NULL\n1,1.\n*EOS_LINEAR_POLYNOMIAL\n7,0.,0.,0.,0.,0.4,0.4,0.\n2.5,1.\n" + no_viscosity,
                       {-0.5, 0, 0, 0}, 1, elform, 7),
        steps_of(1e-3));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double first = 0;
    scene.go([&](const solver::Run& run) {
      if (run.stepper().state().cycle == 0) first = -trace(run.stepper().structure().solids.point(0).stress) / 3;
    });
    EXPECT_NEAR(first, 1, 1e-12);
    const double volume = 1 - 0.5 * scene.state().time;
    EXPECT_NEAR(pressure_of(scene), std::pow(volume, -1.4), 1e-5);
    EXPECT_NEAR(scene.energies().internal, 2.5 * (std::pow(volume, -0.4) - 1), 1e-5);
    EXPECT_NEAR(scene.energies().ratio(), 1, 1e-9);
    EXPECT_NEAR(state_balance(scene.run()).created(), 0, 1e-5);
  }
}

// ρ c² = γ p of the present state, not of that at rest.
TEST(EquationOfState, SoundSpeedOfAPressedGas) {
  Material material{MaterialKind::hydro, 1, 0, 0, {}, 0, 0, 0, {}, 1};
  Hydrodynamic hydro;
  hydro.state = {LinearPolynomial{{0, 0, 0, 0, 0.4, 0.4, 0}}, 2.5};
  hydro.bulk = 1.4;
  material.hydro = std::make_shared<const Hydrodynamic>(hydro);
  const double pressure = std::pow(0.5, -1.4);
  SolidState state;
  state.fluid.volume = 0.5;
  state.fluid.energy = pressure * 0.5 / 0.4;
  EXPECT_NEAR(solid_stiffness(material, state).wave, 1.4 * pressure, 1e-12);
  EXPECT_NEAR(solid_stiffness(material, state).bound, 3 * 1.4 * pressure, 1e-12);
}

/// A bar of bricks in uniaxial strain whose left end moves with v from the start.
std::string driven_bar(int bricks, double v, const std::string& cards, double end) {
  std::string deck = brick_bar(bricks, {0.01, 0.01, 0.01}) + "*PART\np\n1,1,1,7\n*SECTION_SOLID\n1,1\n" + cards +
                     fmt::format("*CONTROL_TERMINATION\n{}\n*DEFINE_CURVE\n1\n0.,1.\n1e3,1.\n", end);
  const int row = bricks + 1;
  for (int k = 0; k < 4; ++k) deck += fmt::format("*BOUNDARY_PRESCRIBED_MOTION_NODE\n{},1,0,1,{}\n", 1 + k * row, v);
  deck += "*SET_NODE_LIST_GENERATE\n1\n" + fmt::format("1,{}\n", 4 * row) + "*BOUNDARY_SPC_SET\n1,0,0,1,1\n";
  return deck;
}

// Behind a shock the pressure is ρ₀ Us up with Us = C + S1 up, and the volume 1 − up / Us.
TEST(EquationOfState, ShockInAGruneisenFluid) {
  constexpr double c = 1.5, s1 = 1.9, up = 0.5, us = c + s1 * up;
  RunScene scene(
      driven_bar(120, up, "*MAT_NULL\n1,1.,-1e3\n*EOS_GRUNEISEN\n7,1.5,1.9,0.,0.,0.5,0.,0.\n1.\n", 0.6 * 1.2 / us));
  scene.go();
  const auto& solids = scene.run().stepper().structure().solids;
  double pressure = 0;
  constexpr int first = 20, last = 50;
  for (std::size_t i = first; i < last; ++i) pressure -= trace(solids.point(i).stress) / 3 / (last - first);
  EXPECT_NEAR(pressure, us * up, 0.01 * us * up);
  const double shortened = (scene.state().x[last].x() - scene.state().x[first].x()) / (0.01 * (last - first));
  EXPECT_NEAR(shortened, 1 - up / us, 0.005);
  EXPECT_NEAR(scene.energies().ratio(), 1, 0.01);
  EXPECT_NEAR(scene.energies().internal, 1e-4 * us * scene.state().time * us * up * up / us / 2, 0.03 * 1e-4 * 0.6);
}

const std::string polynomial = "*EOS_001\n7,0.,1000.,500.,0.,1.5,1.5,0.\n0.,1.\n";

/// Material 010 in uniaxial strain as a slow twin: explicit steps a hundred times smaller.
struct Twin {
  double volume = 1, energy = 0, s = 0, strain = 0;  ///< s: deviator along the axis
  double yield, hardening, shear;
  [[nodiscard]] double pressure() const {
    const double mu = 1 / volume - 1;
    return 1000 * mu + (mu > 0 ? 500 * mu * mu : 0) + 1.5 * (1 + mu) * energy;
  }
  void step(double rate, double dt) {
    const double e = rate * dt / volume;  // d ln V
    const double before = s;
    s += 2 * shear * (e - e / 3);
    const double q = 1.5 * std::abs(s);
    if (const double excess = q - yield - hardening * strain; excess > 0) {
      strain += excess / (3 * shear + hardening);
      s *= 1 - 3 * shear * excess / (3 * shear + hardening) / q;
    }
    energy += -pressure() * rate * dt + (before + s) / 2 * e * volume;
    volume += rate * dt;
  }
};

TEST(Hydro, UniaxialStrainAgainstASlowTwin) {
  for (const int elform : {1, 2}) {
    RunScene scene(stretched_cube("*MAT_ELASTIC_PLASTIC_HYDRO\n1,1.,400.,20.,50.\n\n\n\n\n" + polynomial + no_viscosity,
                                  {-0.3, 0, 0, 0}, 1, elform, 7),
                   steps_of(1e-3));
    ASSERT_TRUE(scene.prepared()) << scene.message();
    scene.go();
    Twin twin{.yield = 20, .hardening = 50, .shear = 400};
    const double end = scene.state().time;
    for (int i = 0; i < 100000; ++i) twin.step(-0.3, end / 100000);
    const PointState point = scene.run().stepper().structure().solids.point(0);
    EXPECT_NEAR(-trace(point.stress) / 3, twin.pressure(), 1e-3 * twin.pressure());
    EXPECT_NEAR(deviator(point.stress)[xx], twin.s, 1e-4 * std::abs(twin.s));
    EXPECT_NEAR(point.plastic_strain, twin.strain, 1e-4 * twin.strain);
    EXPECT_NEAR(scene.energies().internal, twin.energy, 1e-3 * twin.energy);
    EXPECT_NEAR(state_balance(scene.run()).created(), 0, 1e-4 * twin.energy);
  }
}

// A cube pulled apart and pressed together again. Pressure 1000 (1/V − 1) with PC = −10.
TEST(Hydro, CutoffAndSpall) {
  const auto stress_at = [](const char* name, const char* spall, double velocity, double end) {
    const std::string head =
        fmt::format("*MAT_ELASTIC_PLASTIC_HYDRO{}\n1,1.,400.,20.,0.,-10.\n{}\n\n\n\n", name, spall);
    RunScene scene(
        stretched_cube(head + "*EOS_001\n7,0.,1000.\n0.,1.\n" + no_viscosity, {velocity, 0, 0, 0}, end, 1, 7),
        steps_of(1e-3));
    scene.go();
    return scene.run().stepper().structure().solids.point(0).stress;
  };
  for (const auto& [name, spall, stress] : {std::tuple("", "", 10 + 2.0 / 3 * 20),
                                            {"_SPALL", "0.,0.,1.\n", 10 + 2.0 / 3 * 20},
                                            {"_SPALL", "0.,0.,2.\n", 0.},
                                            {"_SPALL", "0.,0.,3.\n", 0.}})
    EXPECT_NEAR(stress_at(name, spall, 0.1, 1)[xx], stress, 1e-9) << spall;
  // Before: nothing is cut, and type 2 looks at the principal stress, which is larger than the tension.
  const double strain = 0.007;
  const Symmetric both = stress_at("_SPALL", "0.,0.,3.\n", strain, 1);
  EXPECT_NEAR(both[xx], 1000 * 0.007 + 4.0 / 3 * 400 * 0.007, 0.1);
  EXPECT_EQ(stress_at("_SPALL", "0.,0.,2.\n", strain, 1)[xx], 0);
}

TEST(Hydro, ShearOfAViscousFluid) {
  RunScene scene(stretched_cube("*MAT_NULL\n1,1.,0.,0.7\n*EOS_001\n7,0.,1000.\n0.,1.\n", {0, 0, 0, 2}, 0.1, 1, 7),
                 steps_of(1e-4));
  scene.go();
  const Symmetric stress = scene.run().stepper().structure().solids.point(0).stress;
  EXPECT_NEAR(stress[xy], 0.7 * 2, 1e-6);
  EXPECT_NEAR(scene.energies().internal, 0.7 * 4 * scene.state().time, 1e-3);
}

TEST(Hydro, VolumesAtWhichAFluidGoes) {
  for (const auto& [cards, velocity, time] :
       {std::tuple("0.,0.,1.5,0.", 1.0, 0.5), {"0.,0.,0.,0.7", -1.0, 0.3}, {"0.,0.,1.5,0.7", -0.1, 0.}}) {
    RunScene scene(stretched_cube(fmt::format("*MAT_NULL\n1,1.,{}\n*EOS_001\n7,0.,1000.\n0.,1.\n", cards),
                                  {velocity, 0, 0, 0}, 1, 1, 7),
                   steps_of(1e-3));
    double failed = 0;
    scene.go([&](const solver::Run& run) {
      if (failed == 0 && run.stepper().state().failed.count > 0) failed = run.stepper().state().time;
    });
    EXPECT_NEAR(failed, time, 1.1e-3) << cards;
  }
}

// A turning cube keeps its deviator and pressure in its own axes, and its energy.
TEST(Hydro, RigidTurn) {
  Material material{MaterialKind::hydro, 1, 0, 0, {}, 0, 0, 0, {}, 1};
  Hydrodynamic hydro;
  hydro.state.law = LinearPolynomial{{0, 1000, 0, 0, 0, 0, 0}};
  hydro.shear = 400;
  hydro.bulk = 1000;
  material.hydro = std::make_shared<const Hydrodynamic>(hydro);
  material.yield = {20, 0};
  PointState point;
  update_solid_stress(material, Vector(0.01, -0.005, 0.002).asDiagonal(), 1, point);
  const Symmetric before = deviator(point.stress);
  Matrix spin = Matrix::Zero();
  spin(1, 0) = 1;
  spin(0, 1) = -1;
  const double dt = 2 * std::tan(std::acos(-1.0) / 4 / 500);  // half of a quarter turn's 500th
  for (int i = 0; i < 500; ++i) update_solid_stress(material, spin, dt, point);
  EXPECT_NEAR(point.stress[xx], before[yy], 1e-9);
  EXPECT_NEAR(point.stress[yy], before[xx], 1e-9);
}

TEST(Hydro, HostileCards) {
  const std::string steel = "*MAT_010\n1,1.,400.,20.,50.\n\n\n\n\n", water = "*MAT_NULL\n1,1.\n";
  const std::pair<std::string, const char*> cases[] = {
      {steel + polynomial, ""},
      {steel, "there is no equation of state 7"},
      {steel + "*EOS_IDEAL_GAS\n7,1.\n", "none of 001, 004 and 009"},
      {steel + "*EOS_001\n7,0.,-5.\n0.,1.\n", "bulk modulus at rest"},
      {steel + "*EOS_001\n7\n", "bulk modulus at rest"},
      {steel + "*EOS_001\n7,0.,1e300\n", "is larger than 1e30"},
      {steel + "*EOS_001\n7,0.,nan\n", "is not a number"},
      {steel + "*EOS_001\n7,0.,1000.\n-1.,1.\n", "E0"},
      {steel + "*EOS_001\n7,0.,1000.\n0.,1.2\n", "V0"},
      {steel + "*EOS_GRUNEISEN\n7\n", "bulk modulus at rest"},
      {steel + "*EOS_TABULATED\n7,1.,0.,1.,5\n", "LCC"},
      {steel + "*EOS_TABULATED\n7,1.,0.,1.\n", "in order"},
      {steel + "*EOS_TABULATED\n7,1.,0.,1.\n-0.1,-0.2,0.1\n\n5.,6.,7.\n", "in order"},
      {steel + polynomial + "*EOS_001\n7,0.,5.\n", "equation of state 7 is defined again"},
      {"*MAT_010\n1,1.,0.,20.\n" + polynomial, "G = 0"},
      {"*MAT_010\n1,1.,400.,0.\n" + polynomial, "out of range"},
      {"*MAT_010\n1,0.,400.,20.\n" + polynomial, "out of range"},
      {"*MAT_010\n1,1.,400.,20.,0.,5.\n" + polynomial, "PC = 5"},
      {"*MAT_010\n1,1.,400.,20.,0.,0.,-1.\n" + polynomial, "FS = -1"},
      {"*MAT_010\n1,1.,400.,20.,0.,0.,0.,2.\n" + polynomial, "CHARL"},
      {"*MAT_010_SPALL\n1,1.,400.,20.\n0.1\n" + polynomial, "A1"},
      {"*MAT_010_SPALL\n1,1.,400.,20.,0.,-1.\n0.,0.,4.\n" + polynomial, "SPALL = 4"},
      {"*MAT_010_SPALL\n1,1.,400.,20.\n0.,0.,3.\n" + polynomial, "needs a PC"},
      {"*MAT_010_STOCHASTIC\n1,1.,400.,20.\n" + polynomial, "STOCHASTIC"},
      {"*MAT_NULL\n1,1.,5.\n" + polynomial, "PC = 5"},
      {"*MAT_NULL\n1,1.,0.,-1.\n" + polynomial, "MU = -1"},
      {"*MAT_NULL\n1,1.,0.,0.,0.5\n" + polynomial, "TEROD"},
      {"*MAT_NULL\n1,1.,0.,0.,0.,1.5\n" + polynomial, "CEROD"},
      {water, "there is no equation of state 7"},
  };
  for (const auto& [cards, says] : cases) {
    RunScene scene(stretched_cube(cards, {0.01, 0, 0, 0}, 0.01, 1, 7));
    std::string said = scene.message() + scene.read().text();
    for (const model::Fault& fault : scene.read().model.faults) said += fault.message;
    const bool refused = !scene.prepared() || scene.read().errors() > 0 || !scene.read().model.faults.empty();
    EXPECT_EQ(refused, std::string_view(says) != "") << cards << said;
    EXPECT_NE(said.find(says), std::string::npos) << cards << said;
  }
}

TEST(Hydro, ShellsAndBeamsAreRefused) {
  RunScene scene(stretched_square("*MAT_010\n1,1.,400.,20.\n", {0.01, 0, 0, 0}, 0.01));
  EXPECT_NE(scene.message().find("in solids only"), std::string::npos) << scene.message();
}

}  // namespace
}  // namespace gapcheck::solver::equation_of_state_test
