#include "model/contact/contact.hpp"

#include "model/read.hpp"

namespace gapcheck::model::contact_test {
namespace {

const std::string cards_1_to_3 =
    "         1         2         2         3         7         8\n"
    "       0.1       0.2       0.3       0.4      20.0         1       1.0       2.0\n"
    "       1.1       1.2       1.3       1.4       1.5       1.6       1.7       1.8\n";

const Contact& only(const Read& read) {
  EXPECT_EQ(read.model.contacts.size(), 1u) << read.text();
  return read.model.contacts.at(0);
}

void expect_cards_1_to_3(const Contact& contact) {
  EXPECT_EQ(contact.a.id, 1);
  EXPECT_EQ(contact.a.type, 2);
  EXPECT_EQ(contact.a.box, 7);
  EXPECT_TRUE(contact.a.given);
  EXPECT_EQ(contact.b.id, 2);
  EXPECT_EQ(contact.b.type, 3);
  EXPECT_EQ(contact.b.box, 8);
  EXPECT_EQ(contact.fs, 0.1);
  EXPECT_EQ(contact.fd, 0.2);
  EXPECT_EQ(contact.dc, 0.3);
  EXPECT_EQ(contact.vc, 0.4);
  EXPECT_EQ(contact.vdc, 20);
  EXPECT_EQ(contact.penchk, 1);
  EXPECT_EQ(contact.birth, 1);
  EXPECT_EQ(contact.death, 2);
  EXPECT_EQ(contact.sfs, 1.1);
  EXPECT_EQ(contact.sfm, 1.2);
  EXPECT_EQ(contact.sst, 1.3);
  EXPECT_EQ(contact.mst, 1.4);
  EXPECT_EQ(contact.sfst, 1.5);
  EXPECT_EQ(contact.sfmt, 1.6);
  EXPECT_EQ(contact.fsf, 1.7);
  EXPECT_EQ(contact.vsf, 1.8);
}

TEST(Contacts, AllCards) {
  const Read read = read_text(
      "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MPP_ID\n        42a title, with a comma\n"
      "         1       200                   2         0    1.0005\n"
      "&                 1\n" +
      cards_1_to_3 +
      "         2       0.2         5     1.025         3         5        10\n"
      "       0.9         1         2         1         1                 0.3       0.4\n"
      "         2         2       0.1     1.e-6\n"
      "         1       0.5                                     1         1         1\n"
      "         1                   1         1\n"
      "\n"
      "                 1.0\n");
  const Contact& contact = only(read);
  EXPECT_EQ(contact.id, ContactId{42});
  EXPECT_FALSE(contact.default_id);
  EXPECT_EQ(contact.title, "a title, with a comma");
  EXPECT_EQ(contact.keyword, "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE");
  EXPECT_EQ(contact.written, "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MPP_ID");
  expect_cards_1_to_3(contact);
  EXPECT_EQ(contact.mpp_ignore, 1);
  EXPECT_EQ(contact.parmax, 1.0005);
  EXPECT_EQ(contact.soft, 2);
  EXPECT_EQ(contact.sofscl, 0.2);
  EXPECT_EQ(contact.lcidab, 5);
  EXPECT_EQ(contact.maxpar, 1.025);
  EXPECT_EQ(contact.sbopt, 3);
  EXPECT_EQ(contact.depth, 5);
  EXPECT_EQ(contact.bsort, 10);
  EXPECT_EQ(contact.penmax, 0.9);
  EXPECT_EQ(contact.thkopt, 1);
  EXPECT_EQ(contact.shlthk, 2);
  EXPECT_EQ(contact.snlog, 1);
  EXPECT_EQ(contact.isym, 1);
  EXPECT_EQ(contact.sldthk, 0.3);
  EXPECT_EQ(contact.sldstf, 0.4);
  EXPECT_EQ(contact.igap, 2);
  EXPECT_EQ(contact.ignore, 2);
  EXPECT_EQ(contact.dprfac, 0.1);
  EXPECT_EQ(contact.dtstif, 1e-6);
  EXPECT_EQ(contact.dtpchk, 0.5);
  EXPECT_EQ(contact.tcso, 1);
  EXPECT_EQ(contact.tiedid, 1);
  EXPECT_EQ(contact.shledg, 1);
  EXPECT_EQ(contact.sharec, 1);
  EXPECT_EQ(contact.ipback, 1);
  EXPECT_EQ(contact.srnde, 1);
  EXPECT_EQ(contact.shloff, 1.0);
  EXPECT_EQ(contact.optional_cards, 7u);
  EXPECT_EQ(read.errors() + read.warnings(), 0u) << read.text();
}

TEST(Contacts, DefaultsWhereBlank) {
  const Read read = read_text("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0                   5\n\n\n");
  const Contact& contact = only(read);
  EXPECT_EQ(contact.id, ContactId{1});
  EXPECT_TRUE(contact.default_id);
  EXPECT_TRUE(contact.a.given);
  EXPECT_FALSE(contact.b.given);
  EXPECT_EQ(contact.sfs, 1.0);
  EXPECT_EQ(contact.vsf, 1.0);
  EXPECT_EQ(contact.sst, 0.0);
  EXPECT_EQ(contact.death, 1e20);
  EXPECT_EQ(contact.sofscl, 0.1);
  EXPECT_EQ(contact.depth, 2);
  EXPECT_EQ(contact.igap, 1);
  EXPECT_FALSE(contact.ignore.has_value());
  EXPECT_FALSE(contact.mpp_ignore.has_value());
  EXPECT_EQ(contact.optional_cards, 0u);
  EXPECT_EQ(read.text(), "");
}

TEST(Contacts, AWrittenZeroIsGiven) {
  const Read read = read_text("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n\n\n\n\n         0         0\n");
  EXPECT_EQ(only(read).ignore, 0);
  EXPECT_EQ(only(read).optional_cards, 3u);
}

TEST(Contacts, CardsOfTheTypeStandBeforeCardA) {
  const std::string a = "         1\n";
  const struct {
    const char* name;
    const char* cards;
  } cases[] = {
      {"AUTOMATIC_SURFACE_TO_SURFACE", ""},
      {"ERODING_SINGLE_SURFACE", "1,1,1\n"},
      {"SURFACE_TO_SURFACE_INTERFERENCE", "1,2\n"},
      {"CONSTRAINT_NODES_TO_SURFACE", "0.5\n"},
      {"RIGID_BODY_TWO_WAY_TO_RIGID_BODY", "1,1\n"},
      {"TIEBREAK_NODES_TO_SURFACE", "1.,1.\n"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "6,1.,1.\n"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "13,1.,1.\n1.\n2.\n"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_DAMPING", "6,1.,1.\n0.1\n"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_MORTAR", "9,1.,1.\n"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_USER", "101\n1.\n1.\n"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_TIED_WELD", "1.,1.,1.,9\n1.\n2.\n"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_THERMAL", "1.,2.\n"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_THERMAL_FRICTION", "1.,2.\n3\n"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_ORTHO_FRICTION", "1.\n2.\n3.\n4.\n"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_THERMAL_ORTHO_FRICTION", "1.\n1.\n2.\n3.\n4.\n"},
      {"DRAWBEAD", "1,2\n"},
      {"DRAWBEAD", "1,2,0.,0.,0,0,0,2\n1,2\n3,4\n"},
      {"DRAWBEAD_INITIALIZE", "1,2\n5\n"},
  };
  for (const auto& test : cases) {
    const Read read = read_text("*CONTACT_" + std::string(test.name) + "\n" + cards_1_to_3 + test.cards + a);
    const Contact& contact = only(read);
    EXPECT_TRUE(contact.known) << test.name;
    expect_cards_1_to_3(contact);
    EXPECT_EQ(contact.soft, 1) << test.name << "\n" << test.cards;
    EXPECT_EQ(contact.optional_cards, 1u) << test.name;
    EXPECT_EQ(read.errors() + read.warnings(), 0u) << test.name << read.text();
  }
}

TEST(Contacts, TiebreakOption) {
  const Read read = read_text("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_MORTAR\n" + cards_1_to_3 + "9\n");
  EXPECT_EQ(only(read).tiebreak_option, 9);
}

TEST(Contacts, CardOfErodingTypes) {
  const Contact contact =
      only(read_text("*CONTACT_ERODING_NODES_TO_SURFACE\n" + cards_1_to_3 + "         1         2         3\n"));
  EXPECT_EQ(contact.symmetry_faces, 1);
  EXPECT_EQ(contact.erosop, 2);
  EXPECT_EQ(contact.iadj, 3);
  EXPECT_EQ(only(read_text("*CONTACT_ERODING_SINGLE_SURFACE\n0,0,5\n\n\n")).erosop, 0);
}

TEST(Contacts, TiebreakStrengths) {
  const auto strength = [](const std::string& name, const std::string& card) {
    const Read read = read_text("*CONTACT_" + name + "\n" + cards_1_to_3 + card + "\n         1\n");
    EXPECT_EQ(only(read).soft, 1) << name;
    return only(read).tiebreak;
  };
  const TiebreakStrength nodes = strength("TIEBREAK_NODES_TO_SURFACE", "3.,4.,1.,1.5");
  EXPECT_EQ(nodes.normal, 3);
  EXPECT_EQ(nodes.shear, 4);
  EXPECT_EQ(nodes.normal_power, 1);
  EXPECT_EQ(nodes.shear_power, 1.5);
  const TiebreakStrength surface = strength("TIEBREAK_SURFACE_TO_SURFACE", "3.,4.,7");
  EXPECT_EQ(surface.normal, 3);
  EXPECT_EQ(surface.shear_power, 2);
  EXPECT_EQ(surface.curve, 7);
  const TiebreakStrength damage = strength("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "6,5.,6.,0.2");
  EXPECT_EQ(damage.normal, 5);
  EXPECT_EQ(damage.shear, 6);
  EXPECT_EQ(damage.param, 0.2);
}

TEST(Contacts, MissingCards) {
  const Read none = read_text("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n*NODE\n1\n");
  EXPECT_FALSE(only(none).cards.any);
  EXPECT_EQ(only(none).cards.missing, "card 1 (SURFA, SURFB)");
  const Read one = read_text("*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n3\n0,0,5\n");
  EXPECT_EQ(only(one).id, ContactId{3});
  EXPECT_TRUE(only(one).cards.any);
  EXPECT_TRUE(only(one).cards.missing.starts_with("card 2")) << only(one).cards.missing;
  const Read two = read_text("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n\n");
  EXPECT_TRUE(only(two).cards.missing.starts_with("card 3")) << only(two).cards.missing;
  const Read type = read_text("*CONTACT_ERODING_SINGLE_SURFACE\n0,0,5\n\n\n");
  EXPECT_EQ(only(type).cards.missing, "card 4 (ISYM, EROSOP, IADJ)");
  const Read thermal = read_text("*CONTACT_TIED_SURFACE_TO_SURFACE_THERMAL\n" + cards_1_to_3);
  EXPECT_EQ(only(thermal).cards.missing, "the THERMAL card");
  const Read transducer = read_text("*CONTACT_FORCE_TRANSDUCER_PENALTY\n0,0,5\n");
  EXPECT_EQ(only(transducer).cards.missing, "");
  EXPECT_EQ(none.errors(), 1u) << none.text();
  for (const Read* read : {&one, &two, &type, &transducer}) EXPECT_EQ(read->text(), "");
}

TEST(Contacts, ALineInThePlaceOfCard4) {
  const std::string head = "*CONTACT_ERODING_SINGLE_SURFACE\n0,0,5\n\n\n";
  for (const char* line : {"1,1,1\n", "\n", "1,1,1,0,0.0\n", "         1         1         1\n", "1.0,1.\n"})
    EXPECT_EQ(only(read_text(head + line)).cards.misread, 0u) << line;
  for (const char* line :
       {"2,0.1\n", "2,0,0,1.025\n", "2,,,,,3\n", "         2       0.1         0     1.025\n", "x\n"}) {
    const Contact contact = only(read_text(head + line));
    EXPECT_EQ(contact.cards.misread, 5u) << line;
    EXPECT_EQ(contact.cards.expected, "card 4 (ISYM, EROSOP, IADJ)");
  }
  const Read parameter = read_text("*PARAMETER\nI one 1\n" + head + "&one,&one\n");
  EXPECT_EQ(only(parameter).cards.misread, 0u);
}

TEST(Contacts, MoreLinesThanCards) {
  const Read read = read_text("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n\n\n\n\n\n\n\n\n\n\n1\n2\n\n");
  EXPECT_EQ(only(read).optional_cards, 7u);
  EXPECT_EQ(only(read).cards.surplus, 2u);
  EXPECT_EQ(only(read).cards.first_surplus, 13u);
}

TEST(Contacts, BirthAndDeathAsWritten) {
  const Read read = read_text("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n,,,,,,-1.,-9999.\n\n");
  EXPECT_EQ(only(read).birth, -1);
  EXPECT_EQ(only(read).death, curve_of_times);
}

TEST(Contacts, Numbering) {
  const std::string plain = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n\n\n";
  const Read read =
      read_text(plain + plain + "*CONTACT_INTERIOR\n1\n*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n2\n0,0,5\n\n\n" +
                "*CONTACT_ENTITY\n1\n" + "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n2\n0,0,5\n\n\n");
  std::vector<std::int64_t> ids, orders;
  for (const Contact& contact : read.model.contacts) {
    ids.push_back(contact.id.value);
    orders.push_back(contact.order);
  }
  EXPECT_EQ(ids, (std::vector<std::int64_t>{1, 7, 0, 2, 4, 2}));
  EXPECT_EQ(orders, (std::vector<std::int64_t>{1, 2, 0, 3, 4, 5}));
  EXPECT_EQ(read.warnings(), 1u) << read.text();
  EXPECT_EQ(read.faults(Fault::Kind::duplicate_id), 1u) << read.text();
}

TEST(Contacts, UnknownAndOwnLayoutAreListed) {
  const Read read =
      read_text("*CONTACT_NO_SUCH_THING_ID\n         7title\nwhatever\n*CONTACT_2D_AUTOMATIC_SINGLE_SURFACE\nx\n");
  ASSERT_EQ(read.model.contacts.size(), 2u);
  EXPECT_FALSE(read.model.contacts[0].known);
  EXPECT_EQ(read.model.contacts[0].id, ContactId{7});
  EXPECT_EQ(read.model.contacts[0].title, "title");
  EXPECT_TRUE(read.model.contacts[1].own_layout);
  EXPECT_EQ(read.errors(), 0u) << read.text();
}

TEST(Contacts, ReferencesAreChecked) {
  const Read read = read_text("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + cards_1_to_3 +
                              "*CONTACT_NODES_TO_SURFACE\n5,6,4,0\n\n\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n9,0,9\n\n\n"
                              "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,2\n\n\n");
  const std::string text = read.text();
  for (const char* message :
       {"contact 1: part set 1 of SURFA is not defined", "contact 1: part 2 of SURFB is not defined",
        "contact 1: box 7 of SURFA is not defined", "contact 1: box 8 of SURFB is not defined",
        "contact 2: node set 5 of SURFA is not defined", "contact 2: segment set 6 of SURFB is not defined"})
    EXPECT_NE(text.find(message), std::string::npos) << message << "\n" << text;
  EXPECT_EQ(read.model.faults.size(), 6u) << text;
  EXPECT_EQ(read.warnings(), 1u) << text;
}

TEST(Contacts, Exclusions) {
  const Read read = read_text(
      "*CONTACT_EXCLUDE_INTERACTION\n         1         5\n         3         4         2         3\n6,7,3,3\n");
  EXPECT_TRUE(read.model.contacts.empty());
  ASSERT_EQ(read.model.exclusions.size(), 1u) << read.text();
  EXPECT_EQ(read.model.exclusions[0].contact, 5);
  ASSERT_EQ(read.model.exclusions[0].pairs.size(), 2u);
  EXPECT_EQ(read.model.exclusions[0].pairs[0].b, 4);
  EXPECT_EQ(read.model.exclusions[0].pairs[0].type_a, 2);
  EXPECT_EQ(read.model.exclusions[0].pairs[1].a, 6);
}

TEST(Contacts, AirbagThicknessIsTheCurveAtTimeZero) {
  const std::string curve = "*DEFINE_CURVE\n4\n-1.,1.\n1.,2.\n";
  const Read read = read_text(curve + "*CONTACT_AIRBAG_SINGLE_SURFACE\n0\n\n\n0,0.1,4\n" +
                              "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n\n\n0,0.1,4\n");
  EXPECT_EQ(read.text(), "");
  EXPECT_EQ(read.model.contacts.at(0).airbag_thickness, 1.5);
  EXPECT_EQ(read.model.contacts.at(1).airbag_thickness, 0);
  const Read missing = read_text("*CONTACT_AIRBAG_SINGLE_SURFACE\n0\n\n\n0,0.1,4\n");
  EXPECT_EQ(missing.faults(Fault::Kind::unknown_reference), 1u);
}

TEST(FrictionTables, LawsAndPairs) {
  const Read read = read_text(
      "*DEFINE_FRICTION_TITLE\nwheels\n5,0.1,0.2\n1,2,0.3,0.2,5.,6.\n1,3,0.4,0.,0.,0.,,PSET\n*DEFINE_FRICTION\n6\n"
      "*DEFINE_FRICTION_ORIENTATION\n7\n");
  ASSERT_EQ(read.model.friction_tables.size(), 2u) << read.text();
  const FrictionTable& wheels = read.model.friction_tables.at(5);
  EXPECT_EQ(wheels.others.fs, 0.1);
  EXPECT_EQ(wheels.others.fd, 0.2);
  ASSERT_EQ(wheels.rows.size(), 2u);
  EXPECT_EQ(wheels.rows[0].j, 2);
  EXPECT_EQ(wheels.rows[0].law.fs, 0.3);
  EXPECT_EQ(wheels.rows[0].law.fd, 0.2);
  EXPECT_EQ(wheels.rows[0].law.dc, 5);
  EXPECT_EQ(wheels.rows[0].law.vc, 6);
  EXPECT_FALSE(wheels.rows[0].j_is_set);
  EXPECT_FALSE(wheels.rows[1].i_is_set);
  EXPECT_TRUE(wheels.rows[1].j_is_set);
  EXPECT_TRUE(read.model.friction_tables.at(6).rows.empty());
}

TEST(Controls, DefaultsAndValues) {
  const Read none = read_text("*NODE\n1\n");
  EXPECT_FALSE(none.model.controls.contact_given);
  EXPECT_EQ(none.model.controls.xpene, 4.0);
  const Read read = read_text(
      "*CONTROL_CONTACT\n       0.2       0.0         1         2         3         0         4         2\n"
      "         0         0         0         0       5.0         1         1\n"
      "       0.3       0.2       0.0       0.5       0.6       0.7\n"
      "         2\n"
      "         0\n"
      "         1         0         0         0         1\n"
      "*CONTROL_SHELL\n      20.0         1        -1         1\n\n         0         0         2\n"
      "*CONTROL_TIMESTEP\n       0.0      0.67         2       0.0    -1.e-6\n*CONTROL_TERMINATION\n      0.12\n");
  const Controls& controls = read.model.controls;
  EXPECT_TRUE(controls.contact_given && controls.shell_given);
  EXPECT_EQ(controls.slsfac, 0.2);
  EXPECT_EQ(controls.shlthk, 2);
  EXPECT_EQ(controls.penopt, 3);
  EXPECT_EQ(controls.orien, 4);
  EXPECT_EQ(controls.enmass, 2);
  EXPECT_EQ(controls.xpene, 5.0);
  EXPECT_EQ(controls.ssthk, 1);
  EXPECT_EQ(controls.ecdt, 1);
  EXPECT_EQ(controls.sfric, 0.3);
  EXPECT_EQ(controls.dfric, 0.2);
  EXPECT_EQ(controls.vfc, 0.5);
  EXPECT_EQ(controls.endtim, 0.12);
  EXPECT_EQ(controls.th, 0.6);
  EXPECT_EQ(controls.th_sf, 0.7);
  EXPECT_EQ(controls.ignore, 2);
  EXPECT_EQ(controls.shledg, 1);
  EXPECT_EQ(controls.ftall, 1);
  EXPECT_EQ(controls.istupd, 1);
  EXPECT_EQ(controls.cntco, 2);
  EXPECT_EQ(controls.tssfac, 0.67);
  EXPECT_EQ(controls.isdo, 2);
  EXPECT_EQ(controls.dt2ms, -1e-6);
  EXPECT_EQ(read.text(), "");
  const Read short_one = read_text("*CONTROL_CONTACT\n\n\n*CONTROL_SHELL\n*CONTROL_TIMESTEP\n");
  EXPECT_EQ(short_one.model.controls.slsfac, 0.1);
  EXPECT_EQ(short_one.model.controls.tssfac, 0.9);
  EXPECT_EQ(short_one.text(), "");
}

}  // namespace
}  // namespace gapcheck::model::contact_test
