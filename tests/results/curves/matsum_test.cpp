#include "results/curves/matsum.hpp"

#include <gtest/gtest.h>

#include "results/read.hpp"
#include "results/said.hpp"

namespace gapcheck::results::matsum_test {
namespace {

std::string two_states() {
  PartState first, second;
  first.part = 1;
  first.internal = 1.25;
  first.kinetic = 3e-110;
  first.hourglass = -0.5;
  first.eroded_internal = 0.75;
  first.eroded_hourglass = 8;
  first.momentum = {0, -2e-3, 4};
  second.part = 123456;
  second.velocity = {1, 2, 3};
  return matsum_header({"t", "p"}, {{1, "middle"}, {123456, "left"}}) + matsum_text(0, std::vector{first, second}) +
         matsum_text(9.9981e-4, std::vector{first, second});
}

TEST(ReadMatsum, IsReadBack) {
  Diagnostics diagnostics;
  const PartHistory history = read_matsum(two_states(), "matsum", diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  EXPECT_EQ(history.titles.size(), 2u);
  ASSERT_EQ(history.states.size(), 2u);
  EXPECT_EQ(history.states[1].time, 9.9981e-4);
  ASSERT_EQ(history.states[1].parts.size(), 2u);
  const PartState& first = history.states[1].parts[0];
  EXPECT_EQ(first.part, 1);
  EXPECT_EQ(first.internal, 1.25);
  EXPECT_EQ(first.kinetic, 3e-110);
  EXPECT_EQ(first.hourglass, -0.5);
  EXPECT_EQ(first.eroded_internal, 0.75);
  EXPECT_EQ(first.eroded_hourglass, 8);
  EXPECT_EQ(first.momentum, Vector(0, -2e-3, 4));
  EXPECT_EQ(history.states[1].parts[1].part, 123456);
  EXPECT_EQ(history.states[1].parts[1].velocity, Vector(1, 2, 3));
}

TEST(ReadMatsum, ShortRowsAndMassIncreaseOfTheSolver) {
  const std::string text =
      "       Maximum mass increase in solid elements      =   0.2122E-07 ID=   36456\n"
      " time =   9.9981E-04\n"
      " mat.#=    1             inten=   1.0000E+00     kinen=   2.0000E+00     eroded_ie=   0.0000E+00     eroded_ke= "
      "  "
      "0.0000E+00\n"
      "                         hgeng=   3.0000E+00\n";
  Diagnostics diagnostics;
  const PartHistory history = read_matsum(text, "matsum", diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  ASSERT_EQ(history.states.size(), 1u);
  ASSERT_EQ(history.states[0].parts.size(), 1u);
  EXPECT_EQ(history.states[0].parts[0].kinetic, 2);
  EXPECT_EQ(history.states[0].parts[0].hourglass, 3);
}

TEST(ReadMatsum, FilesThatAreCutOff) {
  const std::string text = two_states();
  Diagnostics diagnostics, words;
  const std::size_t last_row = text.rfind("                         hgeng");
  EXPECT_EQ(read_matsum(text.substr(0, last_row), "matsum", diagnostics).states.size(), 1u);
  EXPECT_NE(said(diagnostics).find("a state ends before it is complete"), std::string::npos);
  EXPECT_TRUE(read_matsum("time = x\n mat.#= y\n inten= 1.0\n", "matsum", words).states.empty());
  EXPECT_EQ(said(words), "error 1: a number cannot be read and is left out, and so it is in 1 more places\n");
}

TEST(ReadMatsum, RealRun) {
  const std::string path = std::string(GAPCHECK_ROOT) + "/../shared/decks/tied_plate_with_run/matsum";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no decks beside the project";
  Diagnostics diagnostics;
  const PartHistory history = read_matsum(read_bytes(path), path, diagnostics);
  EXPECT_EQ(said(diagnostics), "");
  ASSERT_EQ(history.states.size(), 1u);
  EXPECT_EQ(history.states[0].parts.size(), 3u);
}

}  // namespace
}  // namespace gapcheck::results::matsum_test
