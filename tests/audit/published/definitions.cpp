#include "audit/published/cases.hpp"

namespace gapcheck::audit_test::published_definitions {
namespace {

const std::string all_parts = "0,0,5,0";

/// Four plates above each other, parts 1 to 4; part sets 11 = {1, 2} and 12 = {1}.
RuleDeck plates() {
  RuleDeck deck;
  for (int part = 1; part <= 4; ++part)
    deck.shell_part(part, 1).plate(100 * part, part, 1, 1, Vector(0, 0, 9.0 * part), 5, 5);
  return deck.raw("SET_PART_LIST", "11\n1,2\n").raw("SET_PART_LIST", "12\n1\n");
}

RuleDeck with(const std::string& keyword, const std::string& card1, const std::string& cards = "0.\n1.,1.\n") {
  return plates().contact(1, keyword, card1, cards);
}

/// A bumper (part 1) in a car (set 11), a barrier (part 3), and a transducer for each against the barrier.
RuleDeck two_transducers(const std::string& ftall) {
  RuleDeck deck = with("AUTOMATIC_SINGLE_SURFACE", all_parts);
  deck.contact(2, "FORCE_TRANSDUCER_PENALTY", "1,3,3,3").contact(3, "FORCE_TRANSDUCER_PENALTY", "11,3,2,3");
  return deck.raw("CONTROL_CONTACT", "\n\n\n\n\n,,,," + ftall + "\n");
}

/// IGNORE on *CONTROL_CONTACT and on card C of the contact.
RuleDeck ignore_twice(int control, int card_c) {
  RuleDeck deck = with("AUTOMATIC_SINGLE_SURFACE", all_parts, fmt::format("0.\n1.,1.\n0\n\n,{}\n", card_c));
  return deck.raw("CONTROL_CONTACT", fmt::format("\n\n\n{}\n", control));
}

/// A contact with all its optional cards and one more line in front of them.
RuleDeck all_cards(const std::string& more) {
  RuleDeck deck = plates();
  return deck.raw("CONTACT_AUTOMATIC_SINGLE_SURFACE", all_parts + "\n0.\n1.,1.\n" + more + "0\n\n,1\n\n\n\n,1.\n");
}

/// The MPP card of a contact of type 26 has CPARM8 = 2; card E follows it or not.
RuleDeck spotweld_bolt(const std::string& card_e) {
  return with("AUTOMATIC_GENERAL_MPP", "0,0,0,0,0,0,0,2\n" + all_parts, "0.\n1.,1.\n0\n\n,1\n\n" + card_e + "\n");
}

RuleDeck born(const std::string& birth_and_death) {
  RuleDeck deck = with("AUTOMATIC_SINGLE_SURFACE", all_parts, ",,,,,," + birth_and_death + "\n1.,1.\n");
  return deck.raw("CONTROL_TERMINATION", "0.1\n");
}

}  // namespace

std::vector<PublishedCase> cases() {
  const std::string interference = "0.\n1.,1.\n1,2\n";
  return {
      {"GC402", "has 1 line behind", all_cards("1,1,1\n"), all_cards("")},
      {"GC403", "did you mean *CONTACT_ONE_WAY_SURFACE_TO_SURFACE_INTERFERENCE?",
       with("ONE_WAY_SURFACE_TO_SURFACE_INTERFACE", "1,2,3,3", interference),
       with("ONE_WAY_SURFACE_TO_SURFACE_INTERFERENCE", "1,2,3,3", interference)},
      {"GC403", "did you mean *CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE?",
       with("ONE_WAY_AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3"),
       with("AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", "1,2,3,3")},
      {"GC404", "has one surface, and SURFB = 2 is ignored", with("AUTOMATIC_GENERAL", "1,2,3,3"),
       with("AUTOMATIC_GENERAL", "11,0,2,0")},
      {"GC405", "SURFA and SURFB of *CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID are the same",
       with("AUTOMATIC_SURFACE_TO_SURFACE", "1,12,3,2"), with("AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3")},
      {"GC409", "IGNORE = 2 on card C and 1 on *CONTROL_CONTACT: 2 counts", ignore_twice(1, 2), ignore_twice(1, 0)},
      {"GC413", "transducer 3 measures forces that transducer 2 measures too", two_transducers("0"),
       two_transducers("1")},
      {"GC414", "BT = 5 is not before the end of the run (0.1)", born("5.,1e20"), born("0.,1e20")},
      {"GC423", "CPARM8 = 2 is on the MPP card, and not on card E: an SMP run leaves", spotweld_bolt("0,0"),
       spotweld_bolt("0,2")},
  };
}

namespace {

/// Two steel plates and a rubber one in one contact, card 2 of it, and tables of friction with these ids.
RuleDeck steel_and_rubber(const std::string& card2, const std::vector<int>& tables = {}) {
  RuleDeck deck;
  deck.raw("MAT_MOONEY-RIVLIN_RUBBER", "3,1.1e-9,0.499,0.6,0.15");
  const int materials[] = {1, 1, 3};
  for (int part = 1; part <= 3; ++part)
    deck.shell_part(part, 1, materials[part - 1]).plate(100 * part, part, 1, 1, Vector(0, 0, 9.0 * part), 5, 5);
  for (const int id : tables) deck.raw("DEFINE_FRICTION", fmt::format("{},0.1,0.1\n1,3,0.8,0.8,,,3,3\n", id));
  return deck.contact(4, "AUTOMATIC_SINGLE_SURFACE", all_parts, card2 + "\n1.,1.\n");
}

/// FS = -1 and a part with this friction on *PART_CONTACT.
RuleDeck friction_of_parts(const std::string& fs) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).raw("SECTION_SHELL", "2,2\n1.\n");
  deck.raw("PART_CONTACT", "two\n2,2,1\n" + fs + "\n").plate(101, 2, 2, 2, Vector(0, 0, 9), 5, 5);
  return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", all_parts, "-1.\n1.,1.\n");
}

}  // namespace

std::vector<PublishedCase> friction_cases() {
  return {
      {"GC406", "FS = 0.2 and FD = 0 are ignored", with("TIED_SURFACE_TO_SURFACE", "1,2,3,3", "0.2\n1.,1.\n"),
       with("TIED_SURFACE_TO_SURFACE", "1,2,3,3")},
      {"GC407", "no part of this contact has any: it slides without friction", friction_of_parts("0.,0."),
       friction_of_parts("0.2,0.1")},
      {"GC408", "FD = 1 names no table of friction (FS = -2)", steel_and_rubber("-2.,1.", {2}),
       steel_and_rubber("-2.,1.", {1})},
      {"GC426", "metal on metal (parts 1 and 2), metal on rubber (parts 1 and 3)", steel_and_rubber("0.2"),
       steel_and_rubber("-2.,1.", {1})},
  };
}

}  // namespace gapcheck::audit_test::published_definitions
