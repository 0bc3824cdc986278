#include "results/curves/glstat.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "results/read.hpp"
#include "results/said.hpp"

namespace gapcheck::results::glstat_test {
namespace {

std::string two_states() {
  GlobalState state;
  state.total = 2;
  std::string text = glstat_text(state);
  state.time = 0.5;
  state.kinetic = 3;
  return text + glstat_text(state);
}

// The rows that R16 prints behind the block, from a public file.
TEST(Glstat, AddedMass) {
  GlobalState state;
  state.mass_scaling = true;
  state.added_mass = 2.8468e-4;
  state.added_percent = 22936;
  const std::string text = glstat_text(state);
  EXPECT_TRUE(
      text.ends_with("\n\n\n added mass.....................   0.28468E-03\n"
                     " percentage increase............   0.22936E+05\n"))
      << text;
  EXPECT_EQ(read_glstat(text).at(0).added_mass, 2.8468e-4);
  EXPECT_EQ(read_glstat(text).at(0).added_percent, 22936);
  state.added_mass = 0;
  EXPECT_NE(glstat_text(state).find("mass.....................   0.00000E+00\n"), std::string::npos);
  EXPECT_EQ(glstat_text({}).find("added mass"), std::string::npos);
  EXPECT_FALSE(read_glstat(glstat_text({})).at(0).mass_scaling);
}

TEST(ReadGlstat, AStateWithoutItsTotalIsLeftOut) {
  const std::string text = two_states();
  Diagnostics diagnostics;
  EXPECT_EQ(read_glstat(text.substr(0, text.rfind(" total energy....")), "glstat", diagnostics).size(), 1u);
  EXPECT_NE(said(diagnostics).find("a state ends before it is complete"), std::string::npos);
  EXPECT_EQ(read_glstat(text).size(), 2u);
}

TEST(ReadGlstat, AStateThatEndsBehindItsTotal) {
  const std::string text = two_states();
  const auto before_ratio = [](const std::string& all) { return all.substr(0, all.rfind(" total energy / initial")); };
  Diagnostics diagnostics, alone;
  EXPECT_EQ(read_glstat(before_ratio(text), "glstat", diagnostics).size(), 1u);
  EXPECT_NE(said(diagnostics).find("a state ends before it is complete"), std::string::npos);
  const auto states = read_glstat(before_ratio(glstat_text({})), "glstat", alone);
  ASSERT_EQ(states.size(), 1u);
  EXPECT_TRUE(std::isnan(states[0].ratio));
  EXPECT_TRUE(std::isnan(states[0].ratio_without_eroded));
}

TEST(ReadGlstat, NumbersThatAreNone) {
  std::string text = two_states(), printed = text;
  const std::size_t at = text.rfind(" 3.00000E+00");
  text.replace(at, 12, " ***********");
  printed.replace(at, 12, "         NaN");
  Diagnostics stars, none;
  EXPECT_TRUE(std::isnan(read_glstat(text, "glstat", stars).back().kinetic));
  EXPECT_NE(said(stars).find("a number cannot be read"), std::string::npos);
  EXPECT_TRUE(std::isnan(read_glstat(printed, "glstat", none).back().kinetic));
  EXPECT_EQ(said(none), "") << "the run itself says that there is none";
}

TEST(ReadGlstat, ErodedEnergyAndBothRatios) {
  std::string text = two_states();
  const std::string row = "energy ratio w/o eroded energy.   1.0";
  text.replace(text.rfind(row), row.size(), "energy ratio w/o eroded energy.   7.0");
  EXPECT_EQ(read_glstat(text).back().ratio, 1);
  EXPECT_EQ(read_glstat(text).back().ratio_without_eroded, 7);
  GlobalState state;
  state.eroded_internal = 2;
  state.eroded_hourglass = 3;
  EXPECT_EQ(read_glstat(glstat_text(state)).at(0).eroded_internal, 2);
  EXPECT_EQ(read_glstat(glstat_text(state)).at(0).eroded_hourglass, 3);
}

TEST(ReadGlstat, RealRun) {
  const std::string path = std::string(GAPCHECK_ROOT) + "/../shared/decks/tied_plate_with_run/glstat";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no decks beside the project";
  Diagnostics diagnostics;
  const auto states = read_glstat(read_bytes(path), path, diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  ASSERT_EQ(states.size(), 1u);
  EXPECT_EQ(states[0].time_step, 0.1);
  EXPECT_EQ(states[0].total, 2e-20);
}

}  // namespace
}  // namespace gapcheck::results::glstat_test
