// What the deck says about all shells of a part: formulation, warping, plies, reference surface, thinning, viscosity.
#include "solver/build/build_shells.hpp"

#include <gtest/gtest.h>

#include "solver/structure_of.hpp"

namespace gapcheck::solver::build_shells_test {
namespace {

constexpr const char* mesh =
    "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,2.,0.,0.\n*MAT_ELASTIC\n1,2.,1000.,0.3\n"
    "*MAT_ELASTIC\n2,4.,500.,0.2\n";
constexpr const char* quad = "*ELEMENT_SHELL\n1,1,1,2,3,4\n";
constexpr const char* triangle = "*ELEMENT_SHELL\n1,1,1,2,3,3\n";

struct Built {
  Structure structure;
  std::string warnings;
  [[nodiscard]] const ShellProperties& first() const { return structure.shells.properties(0); }
};

Built built(const std::string& text) {
  const model::Read read = model::read_text(text);
  EXPECT_EQ(read.errors(), 0u) << read.text();
  Built result;
  Diagnostics diagnostics;
  auto structure = build_structure(read.model, {}, diagnostics);
  EXPECT_TRUE(structure) << text;
  if (structure) result.structure = std::move(structure).value();
  for (const Diagnostic& one : diagnostics.sorted()) result.warnings += one.message + "\n";
  return result;
}

Built plain(const std::string& more, const std::string& elform = "2", const std::string& nloc = "",
            const std::string& elements = quad) {
  return built(std::string(mesh) + elements + "*PART\np\n1,1,1\n*SECTION_SHELL\n1," + elform + ",0.8333,3\n0.1,,,," +
               nloc + "\n" + more);
}

TEST(BuildShells, WarpingStiffness) {
  const auto projection = [](const std::string& more, const char* elform = "2") {
    const Built one = plain(more, elform);
    EXPECT_EQ(one.warnings, "") << more;
    return one.first().projection;
  };
  EXPECT_EQ(projection(""), ShellProjection::none);
  EXPECT_EQ(projection("*CONTROL_SHELL\n20.,1,-1,0,2\n"), ShellProjection::none);
  EXPECT_EQ(projection("*CONTROL_SHELL\n20.,1,-1,0,2,2,1,1\n"), ShellProjection::none);
  EXPECT_EQ(projection("*CONTROL_SHELL\n20.,1,-1,0,2,1\n"), ShellProjection::drill);
  EXPECT_EQ(projection("*CONTROL_SHELL\n20.,1,-1,0,2,1,1,1\n"), ShellProjection::full);
  EXPECT_EQ(projection("", "10"), ShellProjection::drill);
  EXPECT_EQ(projection("*CONTROL_SHELL\n20.,1,-1,0,2,2,1,1\n", "10"), ShellProjection::full);
  EXPECT_TRUE(plain("", "10").first().sides_shear);
  EXPECT_FALSE(plain("*CONTROL_SHELL\n20.,1,-1,0,2,1\n").first().sides_shear);
}

TEST(BuildShells, Axes) {
  for (const char* inn : {"", "1", "3"})
    EXPECT_EQ(plain(std::string("*CONTROL_ACCURACY\n1,") + inn + "\n").first().axes, ShellAxes::side) << inn;
  for (const char* inn : {"2", "4", "-2", "-4"})
    EXPECT_EQ(plain(std::string("*CONTROL_ACCURACY\n1,") + inn + "\n").first().axes, ShellAxes::invariant) << inn;
}

// ELFORM of sections that give none.
TEST(BuildShells, Theory) {
  EXPECT_EQ(plain("*CONTROL_SHELL\n20.,1,-1,0,16\n", "").first().form, ShellForm::full);
  EXPECT_EQ(plain("*CONTROL_SHELL\n20.,1,-1,0,16\n", "2").first().form, ShellForm::one_point);
  EXPECT_EQ(plain("", "").first().form, ShellForm::one_point);
}

TEST(BuildShells, FormsOfTriangles) {
  EXPECT_EQ(plain("", "4", "", triangle).warnings, "");
  EXPECT_EQ(plain("", "3", "", triangle).warnings, "section 1: ELFORM 3 is calculated as the C0 triangle (ELFORM 4)\n");
  const Built kirchhoff = plain("", "17", "", triangle);
  EXPECT_EQ(kirchhoff.warnings, "");
  EXPECT_TRUE(kirchhoff.first().discrete_kirchhoff);
  EXPECT_EQ(kirchhoff.structure.shells.points_in_plane(0), 3u);
  EXPECT_FALSE(plain("", "4", "", triangle).first().discrete_kirchhoff);
  EXPECT_EQ(plain("", "17").warnings, "section 1: ELFORM 17 is calculated as the one-point shell (ELFORM 2)\n");
  EXPECT_EQ(plain("", "4").warnings, "section 1: ELFORM 4 is calculated as the one-point shell (ELFORM 2)\n");
}

TEST(BuildShells, Thinning) {
  const auto thins = [](const std::string& card, const std::string& card3 = "") {
    const ShellProperties all =
        plain("*SET_PART_LIST\n7\n1\n*CONTROL_SHELL\n20.,1,-1," + card + "\n\n" + card3 + "\n").first();
    return std::pair(all.thins, all.thins_by_flow);
  };
  EXPECT_EQ(thins("0"), std::pair(false, false));
  EXPECT_EQ(thins("1"), std::pair(true, false));
  EXPECT_EQ(thins("2"), std::pair(false, false)) << "thick shells only";
  EXPECT_EQ(thins("3"), std::pair(true, false));
  EXPECT_EQ(thins("4"), std::pair(true, true));
  EXPECT_EQ(thins("1", "7"), std::pair(true, false));
  EXPECT_EQ(thins("1", "-7"), std::pair(false, false));
  EXPECT_EQ(thins("1", "0,7"), std::pair(true, true));
}

TEST(BuildShells, BulkViscosity) {
  const auto viscosity = [](int type) {
    return plain("*CONTROL_BULK_VISCOSITY\n1.2,0.05," + std::to_string(type) + "\n").first().viscosity;
  };
  EXPECT_FALSE(viscosity(1).on());
  EXPECT_FALSE(plain("").first().viscosity.on());
  EXPECT_EQ(viscosity(-1).quadratic, 1.2);
  EXPECT_EQ(viscosity(-1).linear, 0.05);
  EXPECT_FALSE(viscosity(-1).in_energy);
  EXPECT_TRUE(viscosity(-2).in_energy);
  EXPECT_EQ(plain("*CONTROL_BULK_VISCOSITY\n1.2,0.05,2\n").warnings,
            "*CONTROL_BULK_VISCOSITY: TYPE 2 is for plane solids; it is calculated as 1\n");
}

TEST(BuildShells, Lobatto) {
  EXPECT_EQ(plain("*CONTROL_SHELL\n20.\n1.,1\n").first().layers[0].place, -1);
  EXPECT_GT(plain("*CONTROL_SHELL\n20.\n1.,0\n").first().layers[0].place, -1);
}

// Nodes on the upper side, on a surface of the element's own.
TEST(BuildShells, ReferenceSurface) {
  EXPECT_EQ(plain("", "2", "1").first().reference, 1);
  EXPECT_EQ(plain("", "16", "-1").first().reference, -1);
  const char* offset = "*ELEMENT_SHELL_OFFSET\n1,1,1,2,3,4\n0.02\n2,1,2,5,3,3\n\n";
  const Built own = plain("", "2", "1", offset);
  EXPECT_NEAR(own.structure.shells.properties(0).reference, -0.4, 1e-12) << "the mid-surface is 0.02 above the nodes";
  EXPECT_EQ(own.structure.shells.properties(1).reference, 1);
  EXPECT_EQ(failure_of(std::string(mesh) +
                       "*ELEMENT_SHELL_OFFSET\n1,1,1,2,3,4\n1e9\n*PART\np\n1,1,1\n*SECTION_SHELL\n1,2\n0.1\n")
                .kind,
            Failure::Kind::bad_element);
}

TEST(BuildShells, Plies) {
  const Built one = built(std::string(mesh) + quad + "*PART_COMPOSITE\nc\n1,2,0.9,-1.\n1,0.1,0.,0,2,0.3,45.,0\n");
  EXPECT_EQ(one.warnings, "");
  const ShellProperties& all = one.first();
  ASSERT_EQ(all.layers.size(), 2u);
  EXPECT_NEAR(all.layers[0].place, -0.75, 1e-15);
  EXPECT_NEAR(all.layers[0].weight, 0.5, 1e-15);
  EXPECT_NEAR(all.layers[1].place, 0.25, 1e-15);
  EXPECT_EQ(all.layer_materials[0].young, 1000);
  EXPECT_EQ(all.layer_materials[1].young, 500);
  EXPECT_EQ(all.reference, -1);
  EXPECT_EQ(all.shear_factor, 0.9);
  double mass = 0;
  for (const double share : one.structure.state.mass) mass += share;
  EXPECT_NEAR(mass, 0.1 * 2 + 0.3 * 4, 1e-12);
}

TEST(BuildShells, PliesThatAreNotCalculated) {
  const std::string begin = std::string(mesh) + quad + "*PART_COMPOSITE\nc\n1,2\n1,0.1,0.,0,";
  EXPECT_EQ(failure_of(begin + "3,0.3,0.,0\n").kind, Failure::Kind::missing_material);
  EXPECT_EQ(failure_of(begin + "2,-0.3,0.,0\n").kind, Failure::Kind::missing_material);
  const Failure rubber = failure_of(begin + "3,0.3,0.,0\n*MAT_MOONEY-RIVLIN_RUBBER\n3,1.,0.49,1.,0.1\n");
  EXPECT_EQ(rubber.kind, Failure::Kind::bad_material);
  EXPECT_EQ(rubber.message, "material 3 is not calculated in plies of composites, but part 1 has one of it");
}

TEST(BuildShells, ControlsWithoutEffectAreNamed) {
  EXPECT_EQ(plain("*CONTROL_ACCURACY\n1,4\n").warnings, "");
  EXPECT_EQ(plain("*CONTROL_ACCURACY\n1,4\n", "2", "", triangle).warnings,
            "*CONTROL_ACCURACY: INN = 4 is calculated as -4 in triangles: their first axis lies along the side from "
            "node 1 to 2\n");
  EXPECT_EQ(plain("*CONTROL_ACCURACY\n1,-4\n", "2", "", triangle).warnings, "");
  EXPECT_EQ(plain("*CONTROL_ACCURACY\n1,3\n").warnings, "");
  EXPECT_EQ(plain("*CONTROL_SHELL\n20.\n\n\n1,1,0,0,0,7\n").warnings,
            "*CONTROL_SHELL: the drilling constraint of DRCPSID is not calculated\n");
  EXPECT_EQ(plain("*CONTROL_SHELL\n20.,1,-2,0,2,1\n").warnings,
            "*CONTROL_SHELL: IRNXX = -2 is calculated as -1: normals follow from the shape\n");
}

}  // namespace
}  // namespace gapcheck::solver::build_shells_test
