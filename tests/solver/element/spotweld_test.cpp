// Material 100 and beams that fail: limits, mass by DT, contact lines of beams.
#include <cmath>
#include <numbers>

#include "solver/contact_scene.hpp"
#include "solver/structure_of.hpp"

namespace gapcheck::solver::spotweld_test {
namespace {

constexpr double young = 1000, density = 2;

/// Fails with these resultants in its axes?
bool fails(const WeldLimits& limits, const WeldResultants& resultants, double time = 0) {
  WeldHistory history;
  return weld_fails(limits, resultants, time, 0, history);
}

TEST(SpotWeld, FailsAtItsResultants) {
  WeldLimits limits;
  limits.strength = {2, 3, 4, 5, 6, 7};
  for (std::size_t i = 0; i < 6; ++i)
    for (const double sign : {1.0, -1.0}) {
      WeldResultants alone{};
      alone[i] = sign * limits.strength[i] * (1 - 1e-12);
      EXPECT_FALSE(fails(limits, alone)) << i;
      alone[i] = sign * limits.strength[i] * (1 + 1e-12);
      EXPECT_EQ(fails(limits, alone), i > 0 || sign > 0) << "compression does not count";
    }
  // The squares add up.
  const double sixth = std::sqrt(1.0 / 6);
  WeldResultants all;
  for (std::size_t i = 0; i < 6; ++i) all[i] = (i % 2 == 0 ? 1 : -1) * limits.strength[i] * sixth * (1 - 1e-12);
  EXPECT_FALSE(fails(limits, all));
  for (double& value : all) value *= 1 + 1e-11;
  EXPECT_TRUE(fails(limits, all));
  // A strength of zero leaves its term out.
  limits.strength = {0, 3, 0, 0, 0, 0};
  EXPECT_FALSE(fails(limits, {1e9, 2.9, 1e9, 1e9, 1e9, 1e9}));
  EXPECT_FALSE(fails({}, {1e9, 1e9, 1e9, 1e9, 1e9, 1e9}));
}

TEST(SpotWeld, FailsAtItsTimeAndPlasticStrain) {
  WeldLimits limits;
  limits.time = 2;
  EXPECT_FALSE(fails(limits, {}, 1.999));
  EXPECT_TRUE(fails(limits, {}, 2));
  limits.time = 0;
  limits.plastic_strain = 0.1;
  std::vector<BeamPoint> points(4);
  WeldHistory history;
  const auto torn = [&] {
    return weld_fails(limits, {}, 0, least_plastic_strain(std::span<const BeamPoint>(points)), history);
  };
  for (std::size_t i = 0; i < 3; ++i) points[i].plastic_strain = 0.2;
  EXPECT_FALSE(torn()) << "one point is left";
  points[3].plastic_strain = 0.1;
  EXPECT_TRUE(torn());
}

// With NF the mean of the last vectors counts: a peak of one evaluation does not break the weld.
TEST(SpotWeld, FilterAveragesResultants) {
  WeldLimits limits;
  limits.strength = {10, 0, 0, 0, 0, 0};
  limits.filter = 4;
  WeldHistory history;
  const auto next = [&](double force) { return weld_fails(limits, {force, 0, 0, 0, 0, 0}, 0, 0, history); };
  for (int i = 0; i < 6; ++i) EXPECT_FALSE(next(6));
  EXPECT_FALSE(next(21.9));  // (18 + 21.9) / 4
  EXPECT_FALSE(next(6));
  EXPECT_TRUE(next(6.2));  // (6 + 21.9 + 6 + 6.2) / 4
}

/// A beam of ELFORM 9 along x of a length, diameter 0.4.
std::string weld(const std::string& material, double length = 1) {
  return fmt::format("*NODE\n1,0.,0.,0.\n2,{},0.,0.\n3,0.,1.,0.\n*ELEMENT_BEAM\n7,1,1,2,3\n*PART\np\n1,1,1\n", length) +
         "*SECTION_BEAM\n1,9,1.,2,1\n0.4,0.4\n" + material;
}

std::string mat_100(const std::string& rest = "", const std::string& limits = "") {
  return fmt::format("*MAT_SPOTWELD\n1,{},{},0.25,{}\n{}\n", density, young, rest.empty() ? "10.,50." : rest, limits);
}

constexpr double area = std::numbers::pi * 0.04;

/// Moves end 2 with `velocity` until the beam has failed.
struct Pulled {
  double time = 0, force = 0;  ///< when it failed; the axial force of the step before
  Energies energies;
};
Pulled pull(const std::string& deck, const Vector& velocity, double end = 1) {
  Structure beam = structure_of(deck);
  for (auto& v : {NodeIndex{0}, NodeIndex{1}}) beam.constraints.hold(v, v.value == 0 ? 63 : 56);
  beam.state.mass[1] = 1e9;
  beam.state.v[1] = velocity;
  StepSettings settings;
  settings.greatest_step = 1e-4;
  settings.energy_tolerance = 0;
  Stepper stepper(std::move(beam), settings);
  Pulled pulled;
  while (stepper.failures().empty() && stepper.state().time < end) {
    pulled.force = stepper.structure().beams.axial(0);
    EXPECT_TRUE(stepper.step().ok());
  }
  pulled.time = stepper.failures().empty() ? -1 : stepper.failures()[0].time;
  pulled.energies = stepper.energies();
  return pulled;
}

// Under slow tension: NRR is reached in the step that the force would pass it.
TEST(SpotWeldRun, BreaksAtTheAxialForce) {
  const double strength = 0.7 * 10 * area;
  const Pulled pulled = pull(weld(mat_100("", fmt::format("0.,{}", strength))), {0.1, 0, 0});
  EXPECT_LT(pulled.force, strength);
  EXPECT_GT(pulled.force, strength - young * area * 0.1 * 2.1e-4);
  EXPECT_NEAR(pulled.time, std::exp(0.007) / 0.1 - 10, 2e-4);
  EXPECT_LT(pull(weld(mat_100("", fmt::format("0.,{}", strength))), {-0.1, 0, 0}, 0.2).time, 0);
}

// EFAIL in tension: the strain is εₚ + (σ₀ + EH εₚ)/E.
TEST(SpotWeldRun, BreaksAtThePlasticStrain) {
  const Pulled pulled = pull(weld(mat_100("", "0.02")), {0.1, 0, 0});
  EXPECT_NEAR(pulled.time, (std::exp(0.02 + (10 + 50 * 0.02) / young) - 1) / 0.1, 2e-4);
  EXPECT_NEAR(pulled.force, (10 + 50 * 0.02) * area, 50 * 2e-5);
  EXPECT_NEAR(pull(weld(mat_100("10.,50.,0.,0.0321")), {0.1, 0, 0}).time, 0.0321, 1.1e-4);
}

// A yield curve in place of SIGY.
TEST(SpotWeldRun, YieldCurve) {
  const std::string curve = "*DEFINE_CURVE\n5\n0.,10.\n0.01,15.\n1.,15.\n";
  const Pulled pulled = pull(weld(mat_100("-5.", "0.02")) + curve, {0.1, 0, 0});
  EXPECT_NEAR(pulled.force, 15 * area, 1e-9);
  EXPECT_EQ(failure_of(weld(mat_100("-6.")) + curve).kind, Failure::Kind::bad_material);
}

// DT adds mass until L/c is as long; it counts in the mass of the nodes, in the step, and is reported.
TEST(SpotWeldRun, MassForTheTimeStep) {
  const double own = 1 / std::sqrt(young / density), mass = density * area;
  for (const double wanted : {0.5 * own, 3 * own}) {
    Structure beam = structure_of(weld(mat_100(fmt::format("10.,50.,{}", wanted))));
    const double factor = wanted > own ? 9 : 1;
    EXPECT_NEAR(beam.state.mass[0], factor * mass / 2, 1e-12);
    EXPECT_NEAR(beam.added_mass, (factor - 1) * mass, 1e-12);
    beam.beams.finish(beam.state.x.size());
    EXPECT_NEAR(beam.beams.update(beam.state).manual_step, std::max(wanted, own), 1e-12);
  }
  // *CONTROL_TIMESTEP: DT2MS = -0.2, TSSFAC 0.9
  const Structure beam = structure_of(weld(mat_100()) + "*CONTROL_TIMESTEP\n0.,0.9,0,0.,-0.2\n");
  const double factor = std::pow(0.2 * 0.9 / (0.9 * own), 2);
  EXPECT_GT(factor, 1);
  EXPECT_NEAR(beam.state.mass[0] / (factor * mass / 2), 1, 0.03);
}

TEST(SpotWeld, HostileCards) {
  const auto refused = [](const std::string& deck, Failure::Kind kind, std::string_view text) {
    const Failure failure = failure_of(deck);
    EXPECT_EQ(failure.kind, kind) << failure.message;
    EXPECT_NE(failure.message.find(text), std::string::npos) << failure.message;
    EXPECT_GT(failure.place.line, 0u);
  };
  refused(weld(mat_100("", "0.,0.,0.,0.,0.,0.,0.,-3.")), Failure::Kind::bad_material, "NF is -3");
  refused(weld(mat_100("", "0.,0.,0.,0.,0.,0.,0.,1e9")), Failure::Kind::bad_material, "NF is 1e+09");
  refused(weld(mat_100("", "-0.5")), Failure::Kind::bad_material, "EFAIL is -0.5");
  refused(weld(mat_100("10.,50.,-1.")), Failure::Kind::bad_material, "DT is -1");
  refused(weld(mat_100("10.,50.,0.,-1.")), Failure::Kind::bad_material, "TFAIL is -1");
  refused(weld(mat_100("", "0.,0.,-7.")), Failure::Kind::not_calculated, "curve over the rate");
  refused(weld(mat_100("0.,0.")), Failure::Kind::bad_material, "yield stress");
  refused(weld("*MAT_SPOTWELD_DAMAGE-FAILURE\n1,2.,1000.,0.25,10.,50.\n0.\n\n"), Failure::Kind::bad_material,
          "variant SPOTWELD_DAMAGE-FAILURE");
  refused(weld("*MAT_100_DA\n1,2.,1000.,0.25,10.,50.\n0.\n\n"), Failure::Kind::bad_material, "variant 100_DA");
  std::string resultant = weld(mat_100());
  resultant.replace(resultant.find("1,9,1.,2,1\n0.4,0.4"), 18, "1,1,1.,2,1\n0.4,0.4");
  refused(resultant, Failure::Kind::bad_material, "set ELFORM to 9");
  refused(plate(1, 1, {1, 1, 0}) + "*PART\np\n1,1,1\n" + shell_section + mat_100(), Failure::Kind::bad_material,
          "spotweld beams (ELFORM 9) and solids");
}

std::string line_beam(int part, const Vector& middle, const Vector& half, int material) {
  const Vector a = middle - half, b = middle + half;
  return fmt::format("*NODE\n{},{},{},{}\n{},{},{},{}\n", 10 * part + 1, a.x(), a.y(), a.z(), 10 * part + 2, b.x(),
                     b.y(), b.z()) +
         fmt::format("*ELEMENT_BEAM\n{0},{0},{1},{2}\n*PART\nb\n{0},{3},{3}\n", part, 10 * part + 1, 10 * part + 2,
                     material);
}

const std::string general = "*CONTACT_AUTOMATIC_GENERAL\n0\n0.\n1.,1.\n0\n0.,0,0,1\n";

/// Speed of the upper beam, material 2, after it came down on the lower one, material 1.
double speed_after(const std::string& materials, const ContactScene::Prepare& more = {},
                   const std::string& contact = general) {
  ContactScene scene(
      line_beam(1, {0, 0, 0}, {0.5, 0, 0}, 1) + line_beam(2, {0, 0, 0.25}, {0, 0.5, 0}, 2) +
          "*SECTION_BEAM\n1,1,1.,2,1\n0.2,0.2\n*SECTION_BEAM\n2,9,1.,2,1\n0.2,0.2\n" + materials + contact,
      [&](Structure& s) {
        for (const std::uint32_t n : {2u, 3u}) s.state.v[n].z() = -0.5;
        if (more) more(s);
      },
      [] {
        StepSettings settings;
        settings.greatest_step = 1e-3;
        settings.energy_tolerance = 0;
        return settings;
      }());
  EXPECT_TRUE(scene.stepper) << scene.why_not;
  if (!scene.stepper) return 0;
  while (scene.state().time < 0.6) scene.step();
  EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 5e-3);
  return scene.state().v[2].z();
}

// Beams of a null material are contact lines: they weigh, carry nothing and do not limit the step.
TEST(BeamContact, NullBeamsMeet) {
  const double after = speed_after("*MAT_NULL\n1,1.,0.,0.,0.,0.,1000.,0.25\n*MAT_NULL\n2,1.,0.,0.,0.,0.,1000.,0.25\n");
  EXPECT_NEAR(after, 0, 0.02) << "equal masses exchange their velocities";
  Structure null = structure_of(weld("*MAT_NULL\n1,2.,0.,0.,0.,0.,1e9,0.25\n"));
  EXPECT_NEAR(null.state.mass[0], density * area / 2, 1e-12);
  null.beams.finish(null.state.x.size());
  EXPECT_FALSE(std::isfinite(null.beams.update(null.state).manual_step));
}

// Spotweld beams meet others with CPARM8 = 2 on card E and pass through them without it: the MPP card has no say.
TEST(BeamContact, SpotweldBeamsMeetWithCparm8) {
  const std::string materials = "*MAT_ELASTIC\n1,1.,1000.,0.25\n*MAT_SPOTWELD\n2,1.,1000.,0.25,1e9,1.\n\n";
  const auto after = [&](const std::string& mpp, const std::string& cparm8) {
    return speed_after(materials, {},
                       "*CONTACT_AUTOMATIC_GENERAL" + mpp + "\n0\n0.\n1.,1.\n0\n0.,0,0,1\n0\n\n0," + cparm8 + "\n");
  };
  EXPECT_NEAR(after("", "2"), 0, 0.02) << "equal masses exchange their velocities";
  for (const char* other : {"0", "1"}) EXPECT_EQ(after("", other), -0.5) << other;
  EXPECT_EQ(after("_MPP\n0,0,0,0,0,0,0,2", "0"), -0.5);
}

// A beam that has failed is no obstacle any more.
TEST(BeamContact, FailedBeamsLeaveTheContact) {
  const std::string upper = "*MAT_ELASTIC\n2,1.,1000.,0.25\n";
  const auto torn = [](Structure& s) {  // within 0.02, before the other one arrives
    s.state.v[0].x() = -2;
    s.state.v[1].x() = 2;
  };
  const std::string lower = "*MAT_PLASTIC_KINEMATIC\n1,1.,1000.,0.25,1.,0.,1.\n0.,0.,";
  EXPECT_GT(speed_after(lower + "0.5\n" + upper), -0.1) << "it holds";
  EXPECT_NEAR(speed_after(lower + "0.01\n" + upper, torn), -0.5, 1e-12);
}

}  // namespace
}  // namespace gapcheck::solver::spotweld_test
