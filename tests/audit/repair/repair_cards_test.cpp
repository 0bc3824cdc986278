// What repairs write: each form of a keyword, read back.
#include "audit/repair/repair_cards.hpp"

#include "audit/fix/plates.hpp"
#include "audit/repair/run_repairs.hpp"

namespace gapcheck::audit_test::repair_cards_test {
namespace {

/// A deck with settings written into it, and its model.
struct Written {
  std::string text, error;
  model::Model model;
};

Written write(const std::string& text, const RepairSettings& settings) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(text, "deck.k", {}, diagnostics);
  const auto model = model::read_model(deck.value(), diagnostics);
  EXPECT_TRUE(model.ok() && !diagnostics.has_errors());
  audit::DeckEdits edits(deck.value());
  Written written;
  if (const Status status = audit::write_cards(deck.value(), model.value(), settings, edits); !status.ok()) {
    written.error = status.error().message;
    return written;
  }
  const auto texts = audit::changed_texts(deck.value(), edits.changed());
  written.text = texts.empty() ? text : texts.at("deck.k");
  Diagnostics again;
  const auto read = keyword::read_deck_text(written.text, "deck.k", {}, again);
  auto changed = model::read_model(read.value(), again);
  EXPECT_TRUE(changed.ok() && !again.has_errors()) << written.text;
  if (changed) written.model = std::move(changed).value();
  return written;
}

const std::string mesh = elastic_steel + Plate{.id = 1}.deck() + Plate{.id = 2, .z = 0.7}.deck();

std::string with_contact(const std::string& contact) { return "*KEYWORD\n" + mesh + contact + "*END\n"; }

RepairSettings sst(double a, double b) {
  RepairSettings settings;
  settings.contact_thickness[0] = {a, b};
  return settings;
}

RepairSettings ignore() {
  RepairSettings settings;
  settings.ignore = {0};
  return settings;
}

TEST(RepairCards, ContactThicknessWhateverCardsThereAre) {
  const std::string name = "*CONTACT_AUTOMATIC_SINGLE_SURFACE";
  for (const std::string& contact :
       {name + "\n         0         0         5\n", name + "\n         0         0         5\n\n",
        name + "\n         0         0         5\n\n\n",
        name + "\n$ one\n         0         0         5\n$ two\n\n$ three\n\n",
        name + "_ID\n         3a name\n         0         0         5\n\n        1.        2.\n         1\n",
        name + "_MPP\n         1\n&         1\n         0         0         5\n\n\n", name + "\n0,0,5\n\n1.,1.\n"}) {
    const Written written = write(with_contact(contact), sst(0.7, 0.25));
    ASSERT_EQ(written.error, "") << contact;
    EXPECT_EQ(written.model.contacts.at(0).sst, 0.7) << written.text;
    EXPECT_EQ(written.model.contacts.at(0).mst, 0.25) << written.text;
    EXPECT_EQ(written.model.contacts.at(0).a.type, 5) << written.text;
  }
}

TEST(RepairCards, OtherFieldsOfTheCardStay) {
  const Written written =
      write(with_contact("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0         0         5\n\n"
                         "       1.5       2.5       9.0       9.0       3.5       4.5\n         1       0.3\n"),
            sst(0.7, 0));
  const model::Contact& contact = written.model.contacts.at(0);
  EXPECT_EQ(contact.sfs, 1.5);
  EXPECT_EQ(contact.sfm, 2.5);
  EXPECT_EQ(contact.sst, 0.7);
  EXPECT_EQ(contact.mst, 0);
  EXPECT_EQ(contact.sfst, 3.5);
  EXPECT_EQ(contact.sfmt, 4.5);
  EXPECT_EQ(contact.soft, 1);
  EXPECT_EQ(contact.sofscl, 0.3);
}

TEST(RepairCards, IgnoreWhateverCardsThereAre) {
  const std::string name = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0         0         5\n\n\n";
  for (const std::string& cards :
       {std::string(), std::string("         2       0.2\n"), std::string("         2       0.2\n       0.3\n"),
        std::string("         2       0.2\n       0.3\n         2\n"),
        std::string("         2       0.2\n       0.3\n         2         0       0.5\n")}) {
    const Written written = write(with_contact(name + cards), ignore());
    ASSERT_EQ(written.error, "") << cards;
    const model::Contact& contact = written.model.contacts.at(0);
    EXPECT_EQ(contact.ignore, 1) << written.text;
    EXPECT_EQ(contact.soft, cards.empty() ? 0 : 2);
    EXPECT_EQ(contact.penmax, cards.find("0.3") == std::string::npos ? 0 : 0.3);
    EXPECT_EQ(contact.dprfac, cards.find("0.5") == std::string::npos ? 0 : 0.5);
  }
}

TEST(RepairCards, IgnoreInContactsThatEndEarly) {
  const std::string name = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0         0         5\n";
  for (const std::string& cards : {std::string(), std::string("\n"), std::string("\n\n")}) {
    const Written written = write(with_contact(name + cards), ignore());
    ASSERT_EQ(written.error, "");
    EXPECT_EQ(written.model.contacts.at(0).ignore, 1) << written.text;
    EXPECT_EQ(written.model.contacts.at(0).soft, 0) << written.text;
  }
  EXPECT_NE(write(with_contact("*CONTACT_ERODING_SINGLE_SURFACE\n         0         0         5\n\n\n"), ignore())
                .error.find("ends before card 4"),
            std::string::npos);
  const Written parameter = write(
      "*KEYWORD\n*PARAMETER\nIign            0\n" + mesh + name + "\n\n\n\n         1      &ign\n*END\n", ignore());
  EXPECT_NE(parameter.error.find("&ign is a parameter"), std::string::npos) << parameter.error;
}

TEST(RepairCards, IgnoreOfTheMppCardComesFirst) {
  const Written written = write(
      with_contact("*CONTACT_AUTOMATIC_SINGLE_SURFACE_MPP\n         0       200\n         0         0         5\n\n\n"),
      ignore());
  ASSERT_EQ(written.error, "");
  EXPECT_EQ(written.model.contacts.at(0).mpp_ignore.value_or(0) + written.model.contacts.at(0).ignore.value_or(0), 1);
}

// The type's own cards come before A.
TEST(RepairCards, IgnoreBehindTheCardsOfATiebreak) {
  const Written written = write(
      with_contact("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n         1         2         3         3\n\n\n"
                   "         2      10.0      20.0\n"),
      ignore());
  ASSERT_EQ(written.error, "");
  EXPECT_EQ(written.model.contacts.at(0).ignore, 1) << written.text;
  EXPECT_EQ(written.model.contacts.at(0).tiebreak_option, 2);
}

TEST(RepairCards, PartThicknessInEveryForm) {
  RepairSettings both, second;
  both.part_thickness = {{1, 0.7}, {2, 0.7}};
  second.part_thickness = {{2, 0.6}};
  const std::string sections = "*SECTION_SHELL\n         1         2\n        1.        1.        1.        1.\n";
  for (const std::string& parts :
       {std::string("*PART\none\n         1         1         1\ntwo\n         2         1         1\n"),
        std::string("*PART\none\n         1         1         1\n*PART\ntwo\n         2         1         1\n"),
        std::string("*PART\n$ a comment\none\n         1         1         1\n$ another\ntwo\n$ and one\n         2    "
                    "     1         1\nthree\n         3         1         1\n"),
        std::string(
            "*PART_CONTACT\none\n         1         1         1\n       0.1\ntwo\n         2         1         1\n"
            "       0.1       0.0       0.0       0.0       3.0\n"),
        std::string("*PART %\none\n         1         1         1\ntwo\n         2         1         1\n"),
        std::string("*PART\none\n1,1,1\ntwo\n2,1,1\n")}) {
    const std::string text = "*KEYWORD\n" + elastic_steel + sections + parts + "*NODE\n" + Plate{.id = 1}.nodes() +
                             "*ELEMENT_SHELL\n" + Plate{.id = 1}.elements() + "*END\n";
    for (const RepairSettings* settings : {&both, &second}) {
      const Written written = write(text, *settings);
      ASSERT_EQ(written.error, "") << parts;
      ASSERT_EQ(written.model.parts.size(), parts.find("three") == std::string::npos ? 2u : 3u) << written.text;
      for (const model::Part& part : written.model.parts) {
        const auto wanted = settings->part_thickness.find(part.id.value);
        const bool was_there = parts.starts_with("*PART_CONTACT");
        const double expected = wanted != settings->part_thickness.end() ? wanted->second
                                : was_there && part.id.value == 2        ? 3
                                                                         : 0;
        EXPECT_EQ(part.contact ? part.contact->optt : 0, expected) << part.id.value << "\n" << written.text;
        EXPECT_EQ(part.contact && part.contact->fs != 0, was_there);
        EXPECT_EQ(part.section_id, 1);
        EXPECT_EQ(part.title, part.id.value == 1 ? "one" : part.id.value == 2 ? "two" : "three");
      }
      EXPECT_EQ(written.text.find("*PART\n*PART"), std::string::npos) << "no keyword without cards";
    }
  }
}

TEST(RepairCards, PartsWithOtherOptionsAreLeftToTheUser) {
  RepairSettings settings;
  settings.part_thickness = {{5, 0.7}};
  const Written written =
      write("*KEYWORD\n" + mesh + "*PART_PRINT\nfive\n         5         1         1\n         1\n*END\n", settings);
  EXPECT_NE(written.error.find("has to be written by hand"), std::string::npos) << written.error;
}

TEST(RepairCards, SectionThickness) {
  RepairSettings settings;
  settings.section_thickness = {{8, 0.5}};
  for (const std::string& cards :
       {std::string("*SECTION_SHELL\n         8         2\n       1.0\n"),
        std::string("*SECTION_SHELL\n         8         2\n       1.0       1.0       1.0       1.0\n"),
        std::string("*SECTION_SHELL_TITLE\na title\n         7         2\n       2.0\nanother\n         8         2\n  "
                    "     1.0\n")}) {
    const Written written = write("*KEYWORD\n" + mesh + cards + "*END\n", settings);
    ASSERT_EQ(written.error, "") << cards;
    for (const model::Section& section : written.model.sections)
      if (section.id == 8) {
        for (const double t : section.thickness) EXPECT_EQ(t, 0.5) << written.text;
      } else if (section.id == 7) {
        EXPECT_EQ(section.thickness[0], 2.0);
      }
  }
}

TEST(RepairCards, ExclusionsAndTiesComeBeforeTheEnd) {
  RepairSettings settings;
  settings.excluded = {{1, 1, 2}};
  settings.tied = {{1, 2, 1}};
  for (const std::string& end : {std::string("*END\n"), std::string("*End\nbehind it\n"),
                                 std::string("*END  of the deck\n"), std::string(), std::string("*END")}) {
    const Written written = write("*KEYWORD\n" + mesh + single_surface + end, settings);
    ASSERT_EQ(written.error, "");
    EXPECT_EQ(written.model.exclusions.size(), 2u) << written.text;
    ASSERT_EQ(written.model.contacts.size(), 2u) << written.text;
    EXPECT_EQ(written.model.contacts[1].id.value, 2);
    EXPECT_EQ(written.model.contacts[1].a.id, 2);
    EXPECT_EQ(written.model.contacts[1].b.id, 1);
  }
}

// Windows' line ends stay, and new lines have them too.
TEST(RepairCards, LineEndsStay) {
  std::string text = with_contact("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0         0         5\n"), returns;
  for (const char c : text) returns += c == '\n' ? std::string("\r\n") : std::string(1, c);
  RepairSettings settings = sst(0.7, 0);
  settings.part_thickness = {{1, 0.5}};
  settings.excluded = {{1, 1, 2}};
  const Written written = write(returns, settings);
  ASSERT_EQ(written.error, "");
  for (std::size_t at = written.text.find('\n'); at != std::string::npos; at = written.text.find('\n', at + 1))
    EXPECT_EQ(written.text[at - 1], '\r') << at;
  std::string without = written.text;
  std::erase(without, '\r');
  EXPECT_EQ(write(text, settings).text, without);
}

TEST(RepairCards, LongFormat) {
  const std::string text =
      "*KEYWORD LONG=Y\n*MAT_ELASTIC\n" +
      std::string("                   1            7.85e-9             210000                 0.3\n") +
      "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n                   0                   0                   5\n*END\n";
  RepairSettings settings = sst(0.7, 0.25);
  settings.ignore = {0};
  const Written written = write(text, settings);
  ASSERT_EQ(written.error, "");
  EXPECT_EQ(written.model.contacts.at(0).sst, 0.7) << written.text;
  EXPECT_EQ(written.model.contacts.at(0).mst, 0.25) << written.text;
  EXPECT_EQ(written.model.contacts.at(0).ignore, 1) << written.text;
}

TEST(RepairCards, CardsThatWereMisreadStay) {
  const Written written = write(
      with_contact("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0         0         5\n\n\n\n\n\n\n\n\n\n         9\n"),
      sst(0.7, 0));
  EXPECT_NE(written.error.find("are not those of its type"), std::string::npos) << written.error;
}

}  // namespace
}  // namespace gapcheck::audit_test::repair_cards_test
