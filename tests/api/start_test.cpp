// The start of a run is that of the rooms, and of the program.
#include "solver/start/start.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <gapcheck/audit.hpp>
#include <gapcheck/start.hpp>
#include <string>

#include "api/new_folder.hpp"
#include "report/format/start_report.hpp"

namespace gapcheck::api_test::start_test {
namespace {

/// As the rooms follow it.
StartReport internal(const std::string& path) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck(path, {}, diagnostics);
  EXPECT_TRUE(deck.ok());
  const auto model = model::read_model(deck.value(), diagnostics);
  EXPECT_TRUE(model.ok());
  contact::SurfaceStore surfaces(model.value());
  StartReport report = solver::follow_start(deck.value(), model.value(), surfaces, diagnostics).report;
  report.input = path;
  return report;
}

TEST(ApiStart, GivesWhatTheRoomsGive) {
  for (const char* name : {"contact_chain.k", "ignore_1.k", "deep_node_released.k", "workshop/rebound_thin.k"}) {
    SCOPED_TRACE(name);
    const StartReport expected = internal(data(name));
    const auto result = api::start_deck(data(name));
    ASSERT_TRUE(result.ok()) << result.error().message;
    const api::Start& start = result.value();
    EXPECT_EQ(api::text(start), report::start_text(expected, {}));
    EXPECT_EQ(api::json(start), report::start_json(expected));
    EXPECT_EQ(start.clean, starts_clean(expected));
    ASSERT_EQ(start.moves.size(), expected.moves.size());
    for (std::size_t i = 0; i < expected.moves.size(); ++i) {
      EXPECT_EQ(start.moves.node[i], expected.moves[i].node);
      EXPECT_EQ(start.moves.contact[i], expected.moves[i].contact);
      EXPECT_EQ(api::name(start.moves.cause[i]), gapcheck::name(expected.moves[i].cause));
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(start.moves.from[3 * i + k], expected.moves[i].from[static_cast<int>(k)]);
        EXPECT_EQ(start.moves.to[3 * i + k], expected.moves[i].to[static_cast<int>(k)]);
      }
    }
    ASSERT_EQ(start.contacts.size(), expected.contacts.size());
    for (std::size_t c = 0; c < expected.contacts.size(); ++c)
      EXPECT_EQ(start.contacts[c].score, score(expected.contacts[c]));
    EXPECT_EQ(start.expected.has_value(), expected.expected.has_value());
  }
}

TEST(ApiStart, NodesAddUpToTheCountsOfTheirContacts) {
  for (const char* name : {"contact_chain.k", "ignore_1.k", "snlog_1.k", "deep_node_released.k"}) {
    SCOPED_TRACE(name);
    const auto result = api::start_deck(data(name));
    ASSERT_TRUE(result.ok());
    const api::StartNodes& nodes = result.value().nodes;
    EXPECT_GT(nodes.size(), 0u);
    for (std::size_t c = 0; c < result.value().contacts.size(); ++c) {
      std::uint64_t kept = 0, forced = 0, released = 0;
      double deepest_kept = 0, deepest_forced = 0, way_out = 0, energy = 0;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes.contact[i] != c) continue;
        const api::Outcome outcome = nodes.outcome[i];
        (outcome == api::Outcome::kept ? kept : outcome == api::Outcome::forced ? forced : released) += 1;
        double& deepest = outcome == api::Outcome::kept     ? deepest_kept
                          : outcome == api::Outcome::forced ? deepest_forced
                                                            : way_out;
        deepest = std::max(deepest, nodes.depth[i]);
        energy += nodes.energy[i];
      }
      const api::StartContact& contact = result.value().contacts[c];
      EXPECT_EQ(kept, contact.kept);
      EXPECT_EQ(forced, contact.forced);
      EXPECT_EQ(released, contact.released);
      EXPECT_EQ(deepest_kept, contact.deepest_kept);
      EXPECT_EQ(deepest_forced, contact.deepest_forced);
      EXPECT_EQ(way_out, contact.way_out);
      EXPECT_NEAR(energy, contact.energy, 1e-12 * contact.energy);
    }
  }
}

TEST(ApiStart, MovesLeadFromTheDeckToTheStart) {
  const auto result = api::start_deck(data("ignore_0.k"));
  ASSERT_TRUE(result.ok());
  const api::Start& start = result.value();
  const api::StartPositions& all = start.positions;
  ASSERT_EQ(start.moves.size(), 18u);
  EXPECT_EQ(start.moved, 18u);
  std::size_t moved = 0;
  for (std::size_t n = 0; n < all.size(); ++n) {
    const auto at = std::find(start.moves.node.begin(), start.moves.node.end(), all.node[n]);
    const auto i = static_cast<std::size_t>(at - start.moves.node.begin());
    const bool is_moved = at != start.moves.node.end();
    moved += is_moved ? 1 : 0;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(all.start[3 * n + k], is_moved ? start.moves.to[3 * i + k] : all.deck[3 * n + k]);
      if (is_moved) {
        EXPECT_EQ(all.deck[3 * n + k], start.moves.from[3 * i + k]);
      }
    }
  }
  EXPECT_EQ(moved, 18u);
}

TEST(ApiStart, PicturesAreThoseOfAnAuditWithTheMoves) {
  const auto without = api::start_deck(data("ignore_0.k"));
  ASSERT_TRUE(without.ok());
  EXPECT_EQ(api::html(without.value()), "");
  EXPECT_EQ(api::vtu(without.value()), "");
  api::StartOptions options;
  options.picture = options.mesh = true;
  const auto with = api::start_deck(data("ignore_0.k"), options);
  ASSERT_TRUE(with.ok());
  EXPECT_NE(api::html(with.value()).find("18 nodes are moved before the first cycle"), std::string::npos);
  EXPECT_NE(api::vtu(with.value()).find("Name=\"move\""), std::string::npos);
}

TEST(ApiStart, ADeckThatRunsRefuseIsFollowedAsFarAsPossible) {
  const NewFolder folder;
  const std::string deck =
      folder.file("deck.k", content(data("ignore_0.k")).insert(9, "*AIRBAG_PARTICLE\n1,1,0,0,0,0,0,0\n"));
  const auto result = api::start_deck(deck);
  ASSERT_TRUE(result.ok()) << result.error().message;
  ASSERT_FALSE(result.value().refused.empty());
  EXPECT_EQ(result.value().refused.front().line, 2u);
  EXPECT_EQ(result.value().refused.front().file, deck);
}

TEST(ApiStart, WhatCannotBeFollowedIsAnErrorWithFileAndLine) {
  const NewFolder folder;
  EXPECT_FALSE(api::start_deck(folder / "none.k").ok());
  const std::string deck = folder.file("deck.k", content(data("two_plates.k")).insert(9, "*INCLUDE\nmissing.k\n"));
  const auto incomplete = api::start_deck(deck);
  ASSERT_FALSE(incomplete.ok());
  EXPECT_EQ(incomplete.error().file, deck);
  EXPECT_EQ(incomplete.error().line, 3u);
}

TEST(ApiStart, TheCallerMayStopIt) {
  api::StartOptions options;
  int asked = 0;
  options.watch = [&asked] { return ++asked < 2; };
  const auto stopped = api::start_deck(data("contact_chain.k"), options);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().message, "following the start was stopped");
  EXPECT_EQ(asked, 2);
  options.watch = [] { return true; };
  EXPECT_TRUE(api::start_deck(data("contact_chain.k"), options).ok());
}

}  // namespace
}  // namespace gapcheck::api_test::start_test
