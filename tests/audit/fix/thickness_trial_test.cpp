#include "audit/fix/thickness_trial.hpp"

#include "audit/fix/plates.hpp"
#include "audit/fix/proposals.hpp"
#include "audit/fix/run_fix.hpp"
#include "audit/run.hpp"

namespace gapcheck::audit_test::thickness_trial_test {
namespace {

model::Model read(const std::string& text) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(text, "deck.k", {}, diagnostics);
  auto model = model::read_model(deck.value(), diagnostics);
  EXPECT_TRUE(model.ok() && !diagnostics.has_errors());
  return std::move(model).value();
}

contact::InitialState state_of(const model::Model& model) {
  contact::SurfaceStore surfaces(model);
  contact::InitialCounters counters;
  contact::InitialOptions options;
  options.nodes_stay = true;
  return contact::initialise_contacts(model, surfaces, options, counters);
}

double optt(const std::string& text, std::int64_t a, std::int64_t b) {
  model::Model model = read(text);
  const contact::InitialState state = state_of(model);
  std::vector<Penetration> records;
  for (const Penetration& p : state.penetrations)
    if (std::minmax(p.part, p.element_part) == std::minmax(a, b)) records.push_back(p);
  audit::ThicknessTrial trial(model);
  const double found = trial.free_optt(ContactIndex{0}, a, b, records, state.penetrations);
  for (const model::Part& part : model.parts) EXPECT_FALSE(part.contact.has_value());
  return found;
}

TEST(ThicknessTrial, TheDistanceOfTwoPlates) {
  EXPECT_NEAR(optt(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}), 1, 2), 0.7, 1e-12);
  EXPECT_NEAR(optt(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 1.0 / 3}), 1, 2), 0.3333, 1e-12);
}

// Solids have no thickness: the plate alone has OPTT, and half of it must fit in between.
TEST(ThicknessTrial, APlateOnABlock) {
  for (const bool plate_first : {true, false}) {
    std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n";
    for (int k = 0; k < 8; ++k)
      nodes += fmt::format("{:8}{:16}{:16}{:16}\n", 9001 + k, k % 4 == 1 || k % 4 == 2 ? 15 : 0, k % 4 > 1 ? 15 : 0,
                           k > 3 ? 0 : -5);
    solids += fmt::format("{:8}{:8}{:8}{:8}{:8}{:8}{:8}{:8}{:8}{:8}\n", 9001, 9, 9001, 9002, 9003, 9004, 9005, 9006,
                          9007, 9008);
    const std::string text =
        "*KEYWORD\n" + elastic_steel +
        "*PART\nblock\n         9         9         1\n*SECTION_SOLID\n         9         1\n" + nodes + solids +
        Plate{.id = 2, .z = 0.2}.deck() + "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n         1\n" +
        (plate_first ? "         2         9" : "         9         2") + "         3         3\n\n\n*END\n";
    EXPECT_NEAR(optt(text, 9, 2), 0.4, 1e-12) << plate_first;
  }
}

TEST(ThicknessTrial, WhatAnotherPartHidesIsSearched) {
  // The small plate 3 hangs 0.3 above plate 1 and 0.4 below plate 2: its nodes are listed against plate 1 alone, though
  // plates 2 and 3 penetrate as well.
  const std::string text =
      plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7}, Plate{.id = 3, .z = 0.3, .x = 6, .y = 6, .nx = 1, .ny = 1});
  model::Model model = read(text);
  const auto proposals = audit::propose(model, state_of(model));
  ASSERT_GE(proposals.size(), 2u);
  std::size_t tried = 0;
  for (const FixProposal& p : proposals) {
    if (p.thickness == 0) continue;
    ++tried;
    for (model::Part& part : model.parts) {
      part.contact.reset();
      if (part.id.value == p.part || part.id.value == p.other_part) part.contact.emplace().optt = p.thickness;
    }
    for (const Penetration& left : state_of(model).penetrations)
      EXPECT_NE(std::minmax(left.part, left.element_part), std::minmax(p.part, p.other_part))
          << p.part << " " << p.other_part;
  }
  EXPECT_GE(tried, 2u);
}

TEST(ThicknessTrial, NoneThatBringsOthersTogether) {
  // Part 2 is thin: the thickness that frees it from part 1 would let it penetrate part 3, 0.3 above it.
  const std::string text = plates_deck(Plate{.id = 1, .thickness = 1.4}, Plate{.id = 2, .z = 0.7, .thickness = 0.1},
                                       Plate{.id = 3, .z = 1.0, .thickness = 0.1});
  EXPECT_EQ(optt(text, 1, 2), 0);
}

TEST(ThicknessTrial, SectionsThatCount) {
  const auto sections = [](const std::string& text) {
    model::Model model = read(text);
    const contact::InitialState state = state_of(model);
    audit::ThicknessTrial trial(model);
    return trial.sections(ContactIndex{0}, 1, 2, state.penetrations, 0.7);
  };
  const std::string plain = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7});
  const auto found = sections(plain);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->thickness.size(), 2u);
  EXPECT_NEAR(found->thickness.at(1), 0.7, 1e-12);
  EXPECT_EQ(found->other_parts, 0u);
  // A thinner part stays; SST replaces the sections' thickness.
  EXPECT_FALSE(sections(plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7, .thickness = 0.5})));
  std::string card = plain;
  card.replace(card.find("\n\n\n*END"), 7, "\n\n        1.        1.        1.\n*END");
  EXPECT_FALSE(sections(card));
}

// SFT of a part replaces SFST and SFMT: 0.9 × 0.7777 is at most 0.7, and 0.95 × 0.7368.
TEST(ThicknessTrial, SectionsWithTheScaleOfThePart) {
  const auto sections = [](double scale_b) {
    std::string text = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7});
    const std::string first = "*PART\nplate\n         1         1         1\n";
    text.replace(text.find(first), first.size(),
                 "*PART_CONTACT\nplate\n         1         1         1\n" + std::string(50, ' ') + "       0.9\n");
    text.replace(text.find("\n\n\n*END"), 7, fmt::format("\n\n{:40}{:10}{:10}\n*END", "", 0.95, scale_b));
    model::Model model = read(text);
    const contact::InitialState state = state_of(model);
    audit::ThicknessTrial trial(model);
    return trial.sections(ContactIndex{0}, 1, 2, state.penetrations, 0.7);
  };
  const auto found = sections(0.95);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->thickness.at(1), 0.7777, 1e-12);
  EXPECT_NEAR(found->thickness.at(2), 0.7368, 1e-12);
  EXPECT_FALSE(sections(0.8));  // part 2 has no scale of its own
}

// The cards do what they promise when they stand in the deck.
TEST(ThicknessTrial, SectionsOfTheProposalEndThePenetrations) {
  std::string text = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 0.7});
  const FixRun run = fix_text(text);
  const FixProposal& p = run.report().proposals.at(0);
  const auto thinner = std::find_if(p.alternatives.begin(), p.alternatives.end(), [](const FixAlternative& a) {
    return a.card.find("*SECTION_SHELL") != std::string::npos;
  });
  ASSERT_NE(thinner, p.alternatives.end());
  EXPECT_NE(thinner->text.find("softer"), std::string::npos);
  const std::string row = thinner->card.substr(thinner->card.find("       0.7"), 41);
  const std::string old = fmt::format("{:10}{:10}{:10}{:10}\n", 1.0, 1.0, 1.0, 1.0);
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += row.size())
    text.replace(at, old.size(), row);
  audit::AuditOptions options;
  options.select = {"GC101", "GC102"};
  EXPECT_TRUE(run_text(text, options).report.penetrations.empty());
}

TEST(ThicknessTrial, SstIsThatOfTheRule) {
  const std::string text = plates_deck(Plate{.id = 1}, Plate{.id = 2, .z = 1.0 / 3});
  audit::AuditOptions options;
  options.select = {"GC308"};
  const AuditRun audit = run_text(text, options);
  ASSERT_EQ(audit.report.findings.size(), 1u);
  EXPECT_NE(audit.report.findings[0].message.find("SST <= 0.3333"), std::string::npos);
  EXPECT_NE(fix_text(text).report().proposals.at(0).alternatives.at(0).text.find("SST = 0.3333"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::audit_test::thickness_trial_test
