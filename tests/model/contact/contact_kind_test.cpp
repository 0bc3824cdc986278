// What the table of kinds says about a type, against what the manual says of all types with such a keyword or code.
#include "model/contact/contact_kind.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

namespace gapcheck::model::contact_kind_test {
namespace {

bool one_of(std::string_view code, std::initializer_list<std::string_view> codes) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

/// A tie of these keeps its offset with a moment; the manual gives the plain form alone these options.
bool beam_offset(const ContactKind& kind) { return kind.name.ends_with("TIEBREAK_BEAM_OFFSET"); }

TEST(ContactKind, AbilitiesByCode) {
  for (const ContactKind& kind : contact_kinds()) {
    const std::string code = printed(kind.code);
    const auto expect = [&](Ability ability, bool able, const char* what) {
      EXPECT_EQ(kind.can(ability), able) << kind.name << ' ' << what;
    };
    const auto has = [&](std::string_view word) { return kind.name.find(word) != std::string_view::npos; };
    const bool plain = !beam_offset(kind);
    expect(Ability::soft_2, plain && one_of(code, {"3", "a3", "4", "13", "a13", "14", "15", "10", "a10"}), "SOFT = 2");
    expect(Ability::reads_ignore,
           plain && one_of(code, {"a3", "a5", "a10", "13", "a13", "14", "15", "16", "26", "i26"}), "IGNORE");
    expect(Ability::edges, one_of(code, {"26", "i26"}), "edges");
    expect(Ability::interior_edges, code == "i26", "inner edges");
    expect(Ability::edges_only, has("EDGEONLY"), "edges alone");
    expect(Ability::friction_table, plain && one_of(code, {"a3", "a5", "a10", "4", "13", "15", "26", "i26"}),
           "FS = -2");
    expect(Ability::part_friction, plain && one_of(code, {"a3", "a5", "a10", "4", "13", "a13", "15", "26", "i26"}),
           "FS = -1");
    expect(Ability::tells_surfaces, kind.name.starts_with("AUTOMATIC_"), "forces by surfaces");
    expect(Ability::interference, has("INTERFERENCE"), "interference");
    expect(Ability::measures_constraints, kind.name == "FORCE_TRANSDUCER_CONSTRAINT", "constraint forces");
    expect(Ability::thickness_curve, code == "a13", "LCIDAB");
    expect(Ability::torsion, has("TORSION"), "torsion");
  }
}

/// Families by the first word, treatment by what stands on both sides of TO (contact rules, section 1).
TEST(ContactKind, TreatmentAndFamilyByTheWords) {
  for (const ContactKind& kind : contact_kinds()) {
    const auto has = [&](std::string_view word) { return kind.name.find(word) != std::string_view::npos; };
    const auto starts = [&](std::string_view word) { return kind.name.starts_with(word); };
    const bool other =
        starts("RIGID_") || starts("DRAWBEAD") || starts("FORCE_TRANSDUCER") || kind.name == "SINGLE_EDGE";
    const bool tied = starts("TIED_") || starts("TIEBREAK_") || starts("SPOTWELD");
    const Family family = other                                                 ? Family::other
                          : tied                                                ? Family::tied
                          : starts("CONSTRAINT_")                               ? Family::constraint
                          : starts("FORMING_")                                  ? Family::forming
                          : starts("AUTOMATIC_") || starts("AIRBAG_")           ? Family::automatic
                          : starts("ERODING_") || kind.name == "SINGLE_SURFACE" ? Family::automatic
                                                                                : Family::old;
    EXPECT_EQ(kind.family, family) << kind.name;
    const bool none = starts("DRAWBEAD") || starts("FORCE_TRANSDUCER") || kind.name == "SINGLE_EDGE";
    const bool single = has("SINGLE_SURFACE") || has("GENERAL");
    const bool one_way = tied || has("ONE_WAY") || has("NODES_TO") || has("BEAMS_TO");
    EXPECT_EQ(kind.treatment, none      ? Treatment::none
                              : single  ? Treatment::single_surface
                              : one_way ? Treatment::one_way
                                        : Treatment::two_way)
        << kind.name;
  }
}

TEST(ContactKind, TiesAndOffsetsByTheWords) {
  for (const ContactKind& kind : contact_kinds()) {
    const auto has = [&](std::string_view word) { return kind.name.find(word) != std::string_view::npos; };
    const auto ends = [&](std::string_view word) { return kind.name.ends_with(word); };
    EXPECT_EQ(kind.offset, ends("_BEAM_OFFSET")          ? TieOffset::beam
                           : ends("_CONSTRAINED_OFFSET") ? TieOffset::constrained
                           : ends("_OFFSET")             ? TieOffset::penalty
                                                         : TieOffset::none)
        << kind.name;
    const bool automatic = kind.name.starts_with("AUTOMATIC_");
    const TieForm tie = ends("TIEBREAK_DAMPING")            ? TieForm::automatic_tiebreak_damping
                        : ends("TIEBREAK_USER")             ? TieForm::automatic_tiebreak_user
                        : has("TIEBREAK") && automatic      ? TieForm::automatic_tiebreak
                        : has("TIEBREAK") && ends("_ONLY")  ? TieForm::tiebreak_only
                        : has("TIEBREAK")                   ? TieForm::tiebreak
                        : ends("TIED_WELD")                 ? TieForm::weld
                        : ends("_TIED")                     ? TieForm::automatic_tied
                        : ends("_FAILURE")                  ? TieForm::with_failure
                        : kind.name.starts_with("TIED_")    ? TieForm::permanent
                        : kind.name.starts_with("SPOTWELD") ? TieForm::permanent
                                                            : TieForm::none;
    EXPECT_EQ(kind.tie, tie) << kind.name;
    EXPECT_EQ(kind.breaks(), has("TIEBREAK")) << kind.name;
    EXPECT_EQ(kind.automatic_tiebreak(), has("TIEBREAK") && automatic) << kind.name;
  }
}

TEST(ContactKind, CodesByTheWordsAndTheLetterOfTheOffset) {
  const struct {
    const char *name, *code;
  } cases[] = {{"SLIDING_ONLY", "1"},
               {"TIED_SURFACE_TO_SURFACE", "2"},
               {"TIED_SURFACE_TO_SURFACE_OFFSET", "o2"},
               {"SURFACE_TO_SURFACE", "3"},
               {"AUTOMATIC_SURFACE_TO_SURFACE", "a3"},
               {"FORMING_SURFACE_TO_SURFACE", "m3"},
               {"SINGLE_SURFACE", "4"},
               {"NODES_TO_SURFACE", "5"},
               {"AUTOMATIC_NODES_TO_SURFACE", "a5"},
               {"FORMING_NODES_TO_SURFACE", "m5"},
               {"TIED_NODES_TO_SURFACE_BEAM_OFFSET", "b6"},
               {"TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET", "c7"},
               {"SPOTWELD", "7"},
               {"SPOTWELD_BEAM_OFFSET", "b7"},
               {"TIEBREAK_NODES_TO_SURFACE", "8"},
               {"TIEBREAK_SURFACE_TO_SURFACE", "9"},
               {"ONE_WAY_SURFACE_TO_SURFACE", "10"},
               {"AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", "a10"},
               {"FORMING_ONE_WAY_SURFACE_TO_SURFACE", "m10"},
               {"AUTOMATIC_SINGLE_SURFACE", "13"},
               {"AIRBAG_SINGLE_SURFACE", "a13"},
               {"ERODING_SURFACE_TO_SURFACE", "14"},
               {"ERODING_SINGLE_SURFACE", "15"},
               {"ERODING_NODES_TO_SURFACE", "16"},
               {"CONSTRAINT_SURFACE_TO_SURFACE", "17"},
               {"CONSTRAINT_NODES_TO_SURFACE", "18"},
               {"RIGID_NODES_TO_RIGID_BODY", "20"},
               {"RIGID_BODY_ONE_WAY_TO_RIGID_BODY", "21"},
               {"SINGLE_EDGE", "22"},
               {"DRAWBEAD", "23"},
               {"FORCE_TRANSDUCER_PENALTY", "25"},
               {"AUTOMATIC_GENERAL", "26"},
               {"AUTOMATIC_GENERAL_INTERIOR", "i26"}};
  for (const auto& test : cases) {
    const ContactKind* kind = find_contact_kind(test.name);
    ASSERT_NE(kind, nullptr) << test.name;
    EXPECT_EQ(printed(kind->code, kind->offset), test.code) << test.name;
  }
  EXPECT_EQ(find_contact_kind("AUTOMATIC_SINGLE"), nullptr);
  EXPECT_EQ(printed(ContactCode::unknown), "?");
}

TEST(ContactKind, PrintedCodesNameTheMostCommonKeyword) {
  const struct {
    const char *code, *keyword;
  } cases[] = {{"3", "SURFACE_TO_SURFACE"},
               {"a3", "AUTOMATIC_SURFACE_TO_SURFACE"},
               {"m5", "FORMING_NODES_TO_SURFACE"},
               {"o2", "TIED_SURFACE_TO_SURFACE_OFFSET"},
               {"b6", "TIED_NODES_TO_SURFACE_BEAM_OFFSET"},
               {"c7", "TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET"},
               {"i26", "AUTOMATIC_GENERAL_INTERIOR"},
               {"*", "MORTAR"},
               {"", ""},
               {"x3", ""},
               {"99", ""},
               {"o", ""}};
  for (const auto& test : cases) EXPECT_EQ(keyword_of_printed(test.code), test.keyword) << test.code;
  EXPECT_EQ(recommended_keyword(ContactCode::automatic_single), "*CONTACT_AUTOMATIC_SINGLE_SURFACE");
}

TEST(ContactKind, MortarFormsAreThoseOfAutomaticAndFormingTypes) {
  for (const ContactKind& kind : contact_kinds())
    EXPECT_EQ(has_mortar_form(kind), kind.name.starts_with("AUTOMATIC_") || kind.name.starts_with("FORMING_"))
        << kind.name;
}

// A family's name and what follows a line under it: no word that only begins like it.
TEST(ContactKind, FamiliesWithCardsOfTheirOwn) {
  for (const char* name : {"ENTITY", "2D_AUTOMATIC_SINGLE_SURFACE", "1D", "GUIDED_CABLE_SET", "INTERIOR_ID"})
    EXPECT_TRUE(has_own_layout(name)) << name;
  for (const char* name : {"", "ENTITYS", "2DAUTOMATIC", "A_B", "AUTOMATIC_ENTITY", "NODES_TO_SURFACE"})
    EXPECT_FALSE(has_own_layout(name)) << name;
  for (const char* name : {"ADD_WEAR", "AUTO_MOVE", "INTERIOR", "INTERIOR_ID"}) EXPECT_TRUE(only_modifies(name));
  for (const char* name : {"ENTITY", "INTERIORS", "AUTO"}) EXPECT_FALSE(only_modifies(name)) << name;
}

}  // namespace
}  // namespace gapcheck::model::contact_kind_test
