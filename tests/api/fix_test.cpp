// Decks are corrected as the command line corrects them; nothing is written.
#include "audit/fix/fix.hpp"

#include <gtest/gtest.h>

#include <gapcheck/audit.hpp>
#include <gapcheck/fix.hpp>
#include <string>

#include "api/new_folder.hpp"
#include "report/format/fix_report.hpp"

namespace gapcheck::api_test::fix_test {
namespace {

TEST(ApiFix, TwoPlatesAreFreed) {
  const std::string deck = data("two_plates.k"), before = content(deck);
  const auto result = api::fix_deck(deck);
  ASSERT_TRUE(result.ok()) << result.error().message;
  const api::Fix& fix = result.value();
  EXPECT_TRUE(fix.solved);
  EXPECT_EQ(fix.moved.size(), 32u);
  ASSERT_EQ(fix.contacts.size(), 1u);
  EXPECT_EQ(fix.contacts[0].before.penetrations, 18u);
  EXPECT_EQ(fix.contacts[0].after.penetrations, 0u);
  ASSERT_EQ(fix.changed.size(), 1u);
  EXPECT_EQ(fix.changed[0].path, deck);
  EXPECT_EQ(fix.changed[0].place, "two_plates.k");
  EXPECT_EQ(fix.changed[0].lines, 32u);
  EXPECT_EQ(content(deck), before);
  const auto corrected = api::audit_text(fix.changed[0].text, "corrected.k");
  ASSERT_TRUE(corrected.ok());
  EXPECT_EQ(corrected.value().penetrations.size(), 0u);
}

TEST(ApiFix, GivesWhatTheRoomsGive) {
  Diagnostics diagnostics;
  const std::string path = data("two_plates_tilted.k");
  const auto deck = keyword::read_deck(path, {}, diagnostics);
  ASSERT_TRUE(deck.ok());
  auto expected = audit::fix_penetrations(deck.value(), {}, diagnostics);
  const auto fix = api::fix_deck(path);
  ASSERT_TRUE(expected.ok() && fix.ok());
  FixReport& report = expected.value().report;
  report.input = path;
  report.dry_run = true;
  ASSERT_EQ(fix.value().moved.size(), report.moved.size());
  for (std::size_t i = 0; i < report.moved.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(fix.value().moved[i].to[axis], report.moved[i].to[axis]);
  EXPECT_EQ(fix.value().total_move, report.total_move);
  EXPECT_EQ(fix.value().proposals.size(), report.proposals.size());
  EXPECT_EQ(api::text(fix.value()), report::fix_text(report, {}));
  EXPECT_EQ(api::json(fix.value()), report::fix_json(report));
}

TEST(ApiFix, IncludedFilesKeepTheirPlace) {
  const auto fix = api::fix_deck(data("include_parameter.k"));
  ASSERT_TRUE(fix.ok()) << fix.error().message;
  for (const api::ChangedFile& file : fix.value().changed)
    EXPECT_TRUE(file.place == "include_parameter.k" || file.place == "include/plates_mesh.k") << file.place;
}

TEST(ApiFix, LockedPartsStay) {
  api::FixOptions options;
  options.locks = {{api::Lock::Of::parts, 1, 2}};
  const auto fix = api::fix_deck(data("two_plates.k"), options);
  ASSERT_TRUE(fix.ok());
  EXPECT_FALSE(fix.value().solved);
  EXPECT_TRUE(fix.value().changed.empty());
  ASSERT_EQ(fix.value().unfixed.size(), 18u);
  EXPECT_EQ(fix.value().unfixed[0].reason, "locked");
  EXPECT_EQ(fix.value().unfixed[0].contact, 1);
  EXPECT_FALSE(fix.value().proposals.empty());
  EXPECT_FALSE(fix.value().proposals[0].alternatives.empty());
}

TEST(ApiFix, WhatCannotBeCorrectedIsAnError) {
  const NewFolder folder;
  const auto message = [](const std::string& deck, const api::FixOptions& options = {}) {
    const auto fix = api::fix_deck(deck, options);
    return fix.ok() ? std::string("accepted") : fix.error().message;
  };
  EXPECT_NE(message(folder / "none.k").find("cannot be opened"), std::string::npos);
  EXPECT_NE(message(folder.path()).find("is a directory"), std::string::npos);
  EXPECT_NE(message(folder.file("empty.k", "")).find("is empty"), std::string::npos);
  api::FixOptions options;
  options.locks = {{api::Lock::Of::parts, 77, 77}};
  EXPECT_NE(message(data("two_plates.k"), options).find("77"), std::string::npos);
  options.locks = {{api::Lock::Of::nodes, 7, 3}};
  EXPECT_NE(message(data("two_plates.k"), options).find("locks: "), std::string::npos);
  options = {};
  options.priorities = {{1, 0}};
  EXPECT_NE(message(data("two_plates.k"), options).find("priorities: "), std::string::npos);
}

TEST(ApiFix, AnIncompleteDeckIsAnErrorWithItsDiagnostics) {
  const NewFolder folder;
  const std::string deck = folder.file("deck.k", content(data("two_plates.k")).insert(9, "*INCLUDE\nmissing.k\n"));
  const auto fix = api::fix_deck(deck);
  ASSERT_FALSE(fix.ok());
  EXPECT_NE(fix.error().message.find("includes are missing"), std::string::npos) << fix.error().message;
  ASSERT_FALSE(fix.error().diagnostics.empty());
  const api::Diagnostic& first = fix.error().diagnostics[0];
  EXPECT_EQ(first.severity, api::Severity::error);
  EXPECT_EQ(first.file, deck);
  EXPECT_EQ(first.line, 3u);
  EXPECT_NE(first.message.find("missing.k"), std::string::npos) << first.message;
}

TEST(ApiFix, TheCallerMayStopItAtAnyTime) {
  api::FixOptions options;
  int asked = 0;
  options.watch = [&asked] { return ++asked > 0; };
  ASSERT_TRUE(api::fix_deck(data("two_plates.k"), options).ok());
  const int all = asked;
  EXPECT_GT(all, 20);
  for (const int last : {1, 2, all / 2, all - 1, all}) {
    asked = 0;
    options.watch = [&asked, last] { return ++asked < last; };
    const auto fix = api::fix_deck(data("two_plates.k"), options);
    ASSERT_FALSE(fix.ok()) << last;
    EXPECT_EQ(fix.error().message, "the correction was stopped");
    EXPECT_EQ(asked, last) << "a no is not asked for again";
  }
}

}  // namespace
}  // namespace gapcheck::api_test::fix_test
