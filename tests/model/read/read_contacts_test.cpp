// Contacts of includes in other units, and the cards of the types.
#include <fstream>
#include <string>
#include <tuple>
#include <utility>

#include "model/read.hpp"

namespace gapcheck::model::read_contacts_test {
namespace {

const std::string cards_1_to_3 = "1,2,2,3\n0.1,0.2,0.3,0.4,20.,1,5.,8.\n1.1,1.2,1.3,1.4,1.5,1.6,1.7,1.8\n";

/// The only contact of an include whose unit of mass is 3 of the model's, of time 5, of length 7; sets move by 100.
Contact included(const std::string& block) {
  const std::string path = testing::TempDir() + "/read_contacts_include.k";
  std::ofstream(path) << block;
  const Read read = read_text("*INCLUDE_TRANSFORM\n" + path + "\n,,1000,,100\n,,\n3.,5.,7.\n\n");
  EXPECT_EQ(read.model.contacts.size(), 1u) << read.text();
  return read.model.contacts.empty() ? Contact{} : read.model.contacts[0];
}

TEST(ReadContacts, LengthsAndTimesOfIncludes) {
  const Contact contact = included("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + cards_1_to_3 + "\n,,,,,,0.5,0.25\n");
  EXPECT_EQ(contact.a.id, 101);
  EXPECT_EQ(contact.b.id, 1002);
  EXPECT_DOUBLE_EQ(contact.birth, 25);
  EXPECT_DOUBLE_EQ(contact.death, 40);
  EXPECT_DOUBLE_EQ(contact.sst, 7 * 1.3);
  EXPECT_DOUBLE_EQ(contact.mst, 7 * 1.4);
  EXPECT_DOUBLE_EQ(contact.sldthk, 3.5);
  EXPECT_DOUBLE_EQ(contact.dc, 0.3 * 5 / 7);         // one over a velocity
  EXPECT_DOUBLE_EQ(contact.vc, 0.4 * 3 / (7 * 25));  // a stress
  // Without dimension.
  EXPECT_EQ(contact.fs, 0.1);
  EXPECT_EQ(contact.fd, 0.2);
  EXPECT_EQ(contact.vdc, 20);
  EXPECT_EQ(contact.sfs, 1.1);
  EXPECT_EQ(contact.sfm, 1.2);
  EXPECT_EQ(contact.sfst, 1.5);
  EXPECT_EQ(contact.sfmt, 1.6);
  EXPECT_EQ(contact.sldstf, 0.25);
}

// The step of DTSTIF is a time; below zero it is not.
TEST(ReadContacts, StepOfIncludesInOtherUnits) {
  const std::string block = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + cards_1_to_3 + "\n\n,,";
  EXPECT_DOUBLE_EQ(included(block + ",2e-6\n").dtstif, 1e-5);
  EXPECT_DOUBLE_EQ(included(block + ",-0.5\n").dtstif, -0.5);
}

// Mortar contacts have MPAR1, a time or a pressure, and MPAR2, a length, in place of DPRFAC and DTSTIF.
TEST(ReadContacts, MortarParametersOfIncludesInOtherUnits) {
  const std::string block = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n" + cards_1_to_3 + "\n\n1,";
  EXPECT_DOUBLE_EQ(included(block + "4,2.,3.\n").dprfac, 10);
  EXPECT_DOUBLE_EQ(included(block + "-3,2.,3.\n").dprfac, 10);
  EXPECT_DOUBLE_EQ(included(block + "4,2.,3.\n").dtstif, 21);
  EXPECT_DOUBLE_EQ(included(block + "2,2.\n").dprfac, 2 * 3. / (7 * 25));
  EXPECT_DOUBLE_EQ(included(block + "3,-2.\n").dprfac, -2) << "the number of a curve";
}

// Friction of parts, tables and controls has the same units as that of a contact.
TEST(ReadContacts, FrictionOfIncludesInOtherUnits) {
  const std::string path = testing::TempDir() + "/read_friction_include.k";
  std::ofstream(path)
      << "*DEFINE_FRICTION\n1,0.1,0.2,0.3,0.4\n1,1,0.1,0.2,0.6,0.8\n*CONTROL_CONTACT\n\n\n0.1,0.2,,0.4\n"
         "*PART_CONTACT\np\n1,1,1\n0.1,0.2,0.3,0.4\n";
  const Model model = read_text("*INCLUDE_TRANSFORM\n" + path + "\n\n,,\n3.,5.,7.\n\n").model;
  constexpr double decay = 5. / 7, stress = 3. / (7 * 25);
  const FrictionTable& table = model.friction_tables.at(1);
  EXPECT_DOUBLE_EQ(table.others.dc, 0.3 * decay);
  EXPECT_DOUBLE_EQ(table.others.vc, 0.4 * stress);
  EXPECT_DOUBLE_EQ(table.rows.at(0).law.dc, 0.6 * decay);
  EXPECT_DOUBLE_EQ(table.rows.at(0).law.vc, 0.8 * stress);
  EXPECT_EQ(table.rows.at(0).law.fs, 0.1);
  EXPECT_EQ(table.rows.at(0).law.fd, 0.2);
  EXPECT_DOUBLE_EQ(model.controls.vfc, 0.4 * stress);
  EXPECT_DOUBLE_EQ(model.parts.at(0).contact->dc, 0.3 * decay);
  EXPECT_DOUBLE_EQ(model.parts.at(0).contact->vc, 0.4 * stress);
}

TEST(ReadContacts, WithDeathByACurveBirthIsItsNumber) {
  const Contact contact = included("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n,,,,,,4.,-9999.\n\n");
  EXPECT_EQ(contact.birth, 4);
  EXPECT_EQ(contact.death, curve_of_times);
}

/// PENMAX is a length in old types and in mortar contacts, a multiple of the thickness in the others.
TEST(ReadContacts, PenmaxOfIncludesInOtherUnits) {
  for (const auto& [name, factor] :
       {std::pair{"SURFACE_TO_SURFACE", 7.}, std::pair{"AUTOMATIC_SURFACE_TO_SURFACE", 1.},
        std::pair{"AUTOMATIC_SURFACE_TO_SURFACE_MORTAR", 7.}, std::pair{"ERODING_SINGLE_SURFACE", 1.}}) {
    const std::string extra = std::string(name).starts_with("ERODING") ? "\n" : "";
    const Contact contact = included("*CONTACT_" + std::string(name) + "\n" + cards_1_to_3 + extra + "\n0.4\n");
    EXPECT_NEAR(contact.penmax, 0.4 * factor, 1e-12) << name;
  }
}

// A force is a mass times a length by a time squared, a stress a force by a length squared.
TEST(ReadContacts, StrengthsOfTiebreaksOfIncludes) {
  constexpr double force = 3 * 7 / 25.0, stress = force / 49;
  const auto strength = [](const char* name, const char* card) {
    return included("*CONTACT_" + std::string(name) + "\n" + cards_1_to_3 + card + "\n").tiebreak;
  };
  const TiebreakStrength nodes = strength("TIEBREAK_NODES_TO_SURFACE", "10.,20.,1.,1.5");
  EXPECT_DOUBLE_EQ(nodes.normal, 10 * force);
  EXPECT_DOUBLE_EQ(nodes.shear, 20 * force);
  EXPECT_EQ(nodes.normal_power, 1);
  EXPECT_EQ(nodes.shear_power, 1.5);
  const TiebreakStrength surfaces = strength("TIEBREAK_SURFACE_TO_SURFACE", "10.,20.");
  EXPECT_DOUBLE_EQ(surfaces.normal, 10 * stress);
  EXPECT_DOUBLE_EQ(surfaces.shear, 20 * stress);
  EXPECT_FALSE(surfaces.thickness_offsets);
  const TiebreakStrength offsets = strength("TIEBREAK_SURFACE_TO_SURFACE", "10.,20.,5,1");
  EXPECT_EQ(offsets.curve, 5);
  EXPECT_TRUE(offsets.thickness_offsets);
  // PARAM is a length with OPTION = 6 and 8 alone.
  const TiebreakStrength damage = strength("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "6,10.,20.,0.5");
  EXPECT_DOUBLE_EQ(damage.normal, 10 * stress);
  EXPECT_DOUBLE_EQ(damage.shear, 20 * stress);
  EXPECT_DOUBLE_EQ(damage.param, 3.5);
  EXPECT_EQ(strength("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "5,10.,20.,0.5").param, 0.5);
  EXPECT_DOUBLE_EQ(strength("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "8,10.,20.,0.5").param, 3.5);
  const TiebreakStrength law = strength("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "9,10.,20.,-1.5,30.,40.,0.5,60.");
  EXPECT_EQ(law.param, -1.5);
  EXPECT_DOUBLE_EQ(law.normal_energy, 30 * stress * 7);
  EXPECT_DOUBLE_EQ(law.shear_energy, 40 * stress * 7);
  EXPECT_EQ(law.stiffness_ratio, 0.5);
  EXPECT_DOUBLE_EQ(law.stiffness, 60 * stress / 7);
  EXPECT_EQ(damage.stiffness_ratio, 1) << "CT2CN is 1 by default";
}

/// FS and FD of TIED_..._FAILURE are stresses; those of other contacts have no unit.
TEST(ReadContacts, StressesAtFailureOfIncludes) {
  constexpr double stress = 3 * 7 / 25.0 / 49;
  const std::string cards = "1,2,3,3\n10.,20.\n1.,1.\n";
  const Contact failing = included("*CONTACT_TIED_SURFACE_TO_SURFACE_FAILURE\n" + cards);
  EXPECT_DOUBLE_EQ(failing.fs, 10 * stress);
  EXPECT_DOUBLE_EQ(failing.fd, 20 * stress);
  EXPECT_EQ(included("*CONTACT_TIED_SURFACE_TO_SURFACE\n" + cards).fs, 10);
}

TEST(ReadContacts, ForceCurvesOfRigidBodies) {
  constexpr double force = 3 * 7 / 25.0;
  const RigidForce law =
      included("*CONTACT_RIGID_BODY_ONE_WAY_TO_RIGID_BODY\n" + cards_1_to_3 + "11,2,10.,,12,0.5,13\n").rigid;
  EXPECT_EQ(law.curve, 11);
  EXPECT_EQ(law.method, 2);
  EXPECT_DOUBLE_EQ(law.unloading, 10 * force / 7);
  EXPECT_EQ(law.damping_curve, 12);
  EXPECT_EQ(law.damping_scale, 0.5);
  EXPECT_EQ(law.unloading_curve, 13);
}

TEST(ReadContacts, SidesThatArePrinted) {
  for (const auto& [fields, a, b] :
       {std::tuple{"0,0", false, false}, std::tuple{"1,0", true, false}, std::tuple{"0,1", false, true}}) {
    const Read read = read_text("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3,0,0," + std::string(fields) + "\n\n\n");
    ASSERT_EQ(read.model.contacts.size(), 1u);
    EXPECT_EQ(read.model.contacts[0].print_a, a) << fields;
    EXPECT_EQ(read.model.contacts[0].print_b, b) << fields;
  }
}

TEST(ReadContacts, CurvesOfInterference) {
  const Read read = read_text("*CONTACT_SURFACE_TO_SURFACE_INTERFERENCE\n" + cards_1_to_3 + "11,12\n");
  ASSERT_EQ(read.model.contacts.size(), 1u);
  EXPECT_EQ(read.model.contacts[0].interference_curve_relaxation, 11);
  EXPECT_EQ(read.model.contacts[0].interference_curve, 12);
}

}  // namespace
}  // namespace gapcheck::model::read_contacts_test
