// What of a deck's contacts other programs do not read.
#include "audit/portability/portability.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "audit/run.hpp"

namespace gapcheck::audit_test::portability_test {
namespace {

const std::string plates =
    "*NODE\n1\n2,9.\n3,9.,9.\n4,0.,9.\n*ELEMENT_SHELL\n1,1,1,2,3,4\n*PART\na\n1,1,1\n*SECTION_SHELL\n1,2\n1.\n"
    "*MAT_ELASTIC\n1,7.8e-9,210000.,.3\n";
constexpr std::uint32_t first_line = 16;  ///< of what follows these

/// The notes on contacts behind the plates, each as "kind NAME count line", other meanings with "!".
std::vector<std::string> notes(const std::string& contacts, std::vector<std::int64_t> chosen = {}) {
  audit::AuditOptions options;
  options.portability = true;
  options.contacts = std::move(chosen);
  const AuditRun run = run_text(plates + contacts + "*END\n", options);
  EXPECT_TRUE(run.report.portability.has_value());
  std::vector<std::string> lines;
  if (run.report.portability)
    for (const PortabilityNote& note : run.report.portability->notes) {
      EXPECT_EQ(note.program, "Altair Radioss");
      EXPECT_TRUE(note.source.starts_with("https://help.altair.com/") || note.source.find(".help.altair.com/") < 20)
          << note.source;
      lines.push_back(fmt::format("{} {}{} {} {}", name(note.kind), note.name, note.other_meaning ? "!" : "",
                                  note.count, note.line - first_line));
    }
  return lines;
}

using List = std::vector<std::string>;

TEST(Portability, OnlyOnRequest) {
  const AuditRun run = run_text(plates + "*CONTACT_ERODING_SINGLE_SURFACE\n\n\n\n\n*END\n");
  EXPECT_FALSE(run.report.portability.has_value());
}

TEST(Portability, KeywordsOnceWithTheirNumber) {
  EXPECT_EQ(
      notes("*CONTACT_ERODING_SINGLE_SURFACE_ID\n7\n\n\n\n\n*CONTACT_SPOTWELD\n1,1,3,3\n\n\n"
            "*CONTACT_ERODING_SINGLE_SURFACE_MPP\n\n\n\n\n\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n\n\n\n\n"),
      (List{"keyword CONTACT_ERODING_SINGLE_SURFACE 2 0",
            "keyword CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK 1 16"}));
}

// Keywords with cards of their own, changes of other contacts and exclusions are contact input too.
TEST(Portability, OtherContactKeywords) {
  const std::string deck =
      "*CONTACT_2D_AUTOMATIC_SINGLE_SURFACE\n1\n\n\n*CONTACT_INTERIOR\n1\n*CONTACT_EXCLUDE_INTERACTION\n1\n1,1,3,3\n"
      "*CONTACT_SPOTWELD_ID\n4\n1,1,3,3\n";
  EXPECT_EQ(notes(deck), (List{"keyword CONTACT_2D_AUTOMATIC_SINGLE_SURFACE 1 0", "keyword CONTACT_INTERIOR 1 4",
                               "keyword CONTACT_EXCLUDE_INTERACTION 1 7"}));
  EXPECT_EQ(notes(deck, {4}), List{}) << "what was not chosen";
}

TEST(Portability, OptionWords) {
  EXPECT_EQ(notes("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n7\n1,1,3,3\n"), List{});
  EXPECT_EQ(notes("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TITLE\n7,x\n1,1,3,3\n"), List{"option TITLE 1 0"});
  EXPECT_EQ(notes("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_ID_MPP\n7\n1,300\n&,5\n1,1,3,3\n"
                  "*CONTACT_AUTOMATIC_SINGLE_SURFACE_MPP\n1\n1\n"),
            (List{"option MPP 2 0", "option MORTAR 1 0"}))
      << "of options the cards are not looked at";
  EXPECT_EQ(
      notes("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_SMOOTH\n1,1,3,3\n"
            "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_THERMAL_FRICTION\n1,1,3,3\n\n\n9,9\n8,8\n"
            "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ORTHO_FRICTION\n1,1,3,3\n\n\n1.\n2.\n3.\n4.\n,.5\n"),
      (List{"option SMOOTH 1 0", "option THERMAL_FRICTION 1 2", "option ORTHO_FRICTION 1 8", "field SOFSCL 1 16"}));
}

TEST(Portability, FieldsThatAreReadAndFieldsThatAreNot) {
  EXPECT_EQ(
      notes("*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n1,1,3,3\n.2,.1,.5,,,,1.,2.\n2.,2.,.5,.5,.9,.9,.5\n\n\n,,,1e-7\n"),
      List{});
  EXPECT_EQ(
      notes("*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n1,1,3,3,9,,1\n,,,4.,20.,1\n,,,,,,,2.\n1,.2,,,3\n.4\n,1\n"),
      (List{"field SABOXID 1 1", "field SAPR 1 1", "field VC 1 2", "field VDC 1 2", "field PENCHK 1 2", "field VSF 1 3",
            "field SOFT! 1 4", "field SOFSCL 1 4", "field SBOPT 1 4", "field PENMAX 1 5", "field IGNORE 1 6"}));
  // Cards D to G have fields that gapcheck itself does not use.
  EXPECT_EQ(notes("*CONTACT_AUTOMATIC_GENERAL\n1,,3\n\n,,,.5\n\n\n\n2\n,,,,.5,1\n,,,3.\n,.1\n"),
            (List{"field MST 1 3", "field Q2TRI 1 7", "field FRICSF 1 8", "field ICOR 1 8", "field FSTOL 1 9",
                  "field SHLOFF 1 10"}));
}

TEST(Portability, TheSameFieldIsCountedAndDefaultsAreNot) {
  const std::string contact = "*CONTACT_AUTOMATIC_GENERAL\n1,,3\n,,,,,,,1e20\n1.,1.,,,1.,1.,1.,1.\n";
  EXPECT_EQ(notes(contact + ",.1,,1.025,2,2,,1\n\n1\n\n,,,,1.\n,,,2.\n"), List{});
  EXPECT_EQ(notes(contact + ",.2\n" + contact + ",.3,,,,5\n"), (List{"field SOFSCL 2 4", "field DEPTH 1 9"}));
}

// SOFT is read by the page of one keyword and not by that of the other.
TEST(Portability, AFieldCanBeBoth) {
  EXPECT_EQ(notes("*CONTACT_AUTOMATIC_GENERAL\n1,,3\n\n\n1\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,,3\n\n\n2\n"),
            (List{"field SOFT! 1 4", "field SOFT 1 9"}));
}

TEST(Portability, Ties) {
  EXPECT_EQ(notes("*CONTACT_TIED_SHELL_EDGE_TO_SURFACE\n1,1,3,3\n.1\n,,-.5\n"), List{"field FS 1 2"});
  EXPECT_EQ(notes("*CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET\n1,1,3,3\n\n\n"),
            List{"keyword CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET 1 0"});
  EXPECT_EQ(notes("*CONTACT_TIEBREAK_NODES_TO_SURFACE\n1,1,3,3\n\n,,-.5\n100.,50.,2.,3.\n,.5\n"),
            (List{"field NFLF 1 4", "field SFLF 1 4", "field MES 1 4", "field SOFSCL 1 5"}));
}

// Fields that cannot be read are reported once, by the reader of the model; a cut block has no fields.
TEST(Portability, BrokenCards) {
  audit::AuditOptions options;
  options.portability = true;
  const AuditRun run =
      run_text(plates + "*CONTACT_AUTOMATIC_GENERAL\n1,,3\n,,,abc\n\n,&none\n*CONTACT_SPOTWELD\n*END\n", options);
  EXPECT_EQ(run.errors(), 3U) << describe(run.diagnostics);
  ASSERT_TRUE(run.report.portability.has_value());
  EXPECT_TRUE(run.report.portability->notes.empty());
}

TEST(Portability, ParametersCountByTheirValues) {
  EXPECT_EQ(notes("*PARAMETER\nRnull,0.,Rsome,.3\n*CONTACT_AUTOMATIC_GENERAL\n1,,3\n,,,&null,&some\n\n"),
            List{"field VDC 1 4"});
}

}  // namespace
}  // namespace gapcheck::audit_test::portability_test
