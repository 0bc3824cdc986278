// Materials 002 and 034, and membranes (ELFORM 5 and 9).
#include "solver/build/material/build_orthotropic.hpp"

#include <cmath>

#include "contact/stiffness/stiffness.hpp"
#include "solver/output/state_balance.hpp"
#include "solver/run_scene.hpp"
#include "solver/stretched_element.hpp"

namespace gapcheck::solver::build_orthotropic_test {
namespace {

/// Stress of the first point of a square that is stretched by 1 % along x.
Symmetric stretched(const std::string& cards, int elform = 2) {
  RunSettings settings;
  settings.step.greatest_step = 5e-4;
  RunScene scene(stretched_square("*MAT_" + cards, {0.01, 0, 0, 0}, 1, elform), settings);
  if (!scene.prepared()) {
    ADD_FAILURE() << scene.message();
    return {};
  }
  scene.go();
  const StateBalance balance = state_balance(scene.run());
  EXPECT_NEAR(balance.created() / balance.largest, 0, 0.02);
  return scene.run().stepper().structure().shells.points(0)[0].stress;
}

// AOPT: 0 along side 1-2, 2 along A, 3 along V x normal; BETA turns in degrees.
TEST(OrthotropicCards, MaterialAxes) {
  const std::string moduli = "002\n1,1.,100.,40.,40.,0.1\n7.,3.,5.,";
  const double determinant = 1 - 0.01 * 2.5, along = std::log(1.01) * 100 / determinant,
               across = std::log(1.01) * 40 / determinant;
  EXPECT_NEAR(stretched(moduli + "0.\n")[xx], along, 1e-3);
  EXPECT_NEAR(stretched(moduli + "0.\n\n0.,0.,0.,0.,0.,0.,90.\n")[xx], across, 1e-3);
  EXPECT_NEAR(stretched(moduli + "2.\n0.,0.,0.,0.,1.,0.\n0.,0.,0.,1.,0.,0.\n")[xx], across, 1e-3);
  EXPECT_NEAR(stretched(moduli + "2.\n0.,0.,0.,1.,0.,0.\n0.,0.,0.,0.,1.,0.\n")[xx], along, 1e-3);
  EXPECT_NEAR(stretched(moduli + "3.\n\n0.,1.,0.\n")[xx], along, 1e-3);  // V x normal = x
  EXPECT_NEAR(stretched(moduli + "3.\n\n1.,0.,0.\n")[xx], across, 1e-3);
  EXPECT_NEAR(stretched(moduli + "0.\n", 16)[xx], along, 1e-3);
}

// 034 with EA and PRBA alone is isotropic; with CSE it carries no compression. In membranes and shells.
TEST(FabricCards, IsotropicAndOnlyTension) {
  for (const int elform : {2, 5, 9, 16}) {
    const Symmetric stress = stretched("034\n1,1.,100.,0.,0.,0.3\n\n\n\n\n", elform);
    EXPECT_NEAR(stress[xx], 100 / 0.91 * std::log(1.01), 1e-3) << elform;
    EXPECT_NEAR(stress[yy], 0.3 * stress[xx], 1e-9) << elform;
  }
  RunScene pressed(stretched_square("*MAT_034\n1,1.,100.,0.,0.,0.3\n0.,0.,0.,1.\n\n\n\n", {-0.01, 0, 0, 0}, 1, 9));
  pressed.go();
  EXPECT_EQ(pressed.run().stepper().structure().shells.points(0)[0].stress[xx], 0);
  EXPECT_NEAR(contact::contact_modulus(model::read_text("*MAT_034\n1,1.,100.,0.,0.,0.3\n").model.materials.at(0)),
              100 / 0.91, 1e-9);
}

/// A strip of 8 quads held at one end whose other end gets a velocity across it; returns the largest moment that the
/// nodes' rotations show, and the state of the energy.
struct Strip {
  double turned = 0, deflection = 0, created = 0;
};
Strip strip(int elform) {
  std::string deck = plate(8, 1, {1, 1, 0}) + fmt::format("*SECTION_SHELL\n1,{},,3\n0.2\n*PART\np\n1,1,1\n", elform) +
                     "*MAT_ELASTIC\n1,1.,1000.,0.3\n*CONTROL_TERMINATION\n1.\n*CONTROL_HOURGLASS\n4,0.05\n";
  for (const int node : {1, 10}) deck += fmt::format("*BOUNDARY_SPC_NODE\n{},0,1,1,1,1,1,1\n", node);
  for (const int node : {9, 18}) deck += fmt::format("*INITIAL_VELOCITY_NODE\n{},0.,0.,1.\n", node);
  RunScene scene(deck);
  EXPECT_TRUE(scene.prepared()) << scene.message();
  Strip result;
  scene.go();
  const StateBalance balance = state_balance(scene.run());
  result.created = balance.created() / balance.largest;
  for (const Vector& w : scene.state().w) result.turned = std::max(result.turned, w.norm());
  result.deflection = scene.state().x[8].z();
  return result;
}

// Membranes have no bending stiffness: nothing turns, and the free end flies on; shells hold it.
TEST(Membrane, DoesNotBend) {
  for (const int elform : {5, 9}) {
    const Strip membrane = strip(elform);
    EXPECT_EQ(membrane.turned, 0) << elform;
    EXPECT_NEAR(membrane.deflection, 1, 0.2) << elform;
    EXPECT_NEAR(membrane.created, 0, 0.02) << elform;
  }
  EXPECT_GT(strip(2).turned, 0.1);
  EXPECT_LT(strip(2).deflection, 0.9 * strip(5).deflection);
}

TEST(OrthotropicCards, Hostile) {
  const std::pair<const char*, const char*> cases[] = {
      {"002\n1,1.,100.,40.,40.,0.1\n7.,3.,5.\n", ""},
      {"002\n1,1.,100.,0.,40.,0.1\n7.,3.,5.\n", "EA and EB"},
      {"002\n1,1.,100.,40.,40.,0.9\n7.,3.,5.\n", "PRBA = 0.9"},
      {"002\n1,1.,100.,40.,40.,0.1\n7.,0.,5.\n", "GAB, GBC and GCA"},
      {"002\n1,1.,100.,40.,40.,0.1\n7.,3.,5.,1.\n", "AOPT = 1"},
      {"002\n1,1.,100.,40.,40.,0.1\n7.,3.,5.,-4.\n", "AOPT = -4"},
      {"002\n1,1.,100.,40.,40.,0.1\n7.,3.,5.,2.\n\n\n", "no direction"},
      {"002\n1,1.,100.,40.,40.,0.1\n7.,3.,5.,3.\n\n0.,0.,1.\n", "no direction"},
      {"002\n1,1.,100.,40.,40.,0.1\n7.,3.,5.,0.,1.\n", "G = 1"},
      {"002\n1,0.,100.,40.,40.,0.1\n7.,3.,5.\n", "out of range"},
      {"034\n1,1.,100.,0.,0.,0.3\n", ""},
      {"034\n1,1.,0.,0.,0.,0.3\n", "EA and EB"},
      {"034\n1,1.,100.,0.,0.,0.3\n0.,0.,0.,0.,5.,0.3,0.1\n", "EL = 5"},
      {"034\n1,1.,100.,0.,0.,0.3\n0.,0.,0.,0.,0.,0.,0.,0.05\n", "DAMP = 0.05"},
      {"034\n1,1.,100.,0.,0.,0.3\n\n0.,0.,0.,0.,0.,14.\n", "FORM = 14"},
      {"034\n1,1.,100.,0.,0.,0.3\n\n0.,0.,0.,0.,0.,0.,0.,0.5\n", "TSRFAC = 0.5"},
      {"001_FLUID\n1,1.,100.,0.,0.,0.,50.\n", "none of 001"},
  };
  for (const auto& [cards, says] : cases) {
    RunScene scene(stretched_square(std::string("*MAT_") + cards, {0.01, 0, 0, 0}, 0.01));
    const std::string said = scene.message() + scene.read().text();
    EXPECT_EQ(!scene.prepared() || scene.read().errors() > 0, std::string_view(says) != "") << cards << said;
    EXPECT_NE(said.find(says), std::string::npos) << cards << said;
  }
  RunScene solid(stretched_cube("*MAT_002\n1,1.,100.,40.,40.,0.1\n7.,3.,5.\n", {0.01, 0, 0, 0}, 0.01));
  EXPECT_NE(solid.message().find("for shells only"), std::string::npos) << solid.message();
}

}  // namespace
}  // namespace gapcheck::solver::build_orthotropic_test
