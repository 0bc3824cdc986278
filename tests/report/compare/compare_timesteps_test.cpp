#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/compare/compare.hpp"
#include "report/sample.hpp"

namespace gapcheck::report::compare_timesteps_test {
namespace {

Report with_steps(std::vector<SurfaceTimestep> steps) {
  Report report;
  report.source = "deck";
  report.contacts = {make_contact(7, 1, "CONTACT_X", "a3", 0, 0), make_contact(3, 2, "CONTACT_Y", "13", 0, 0)};
  report.predicted.emplace();
  report.predicted->surface_timesteps = std::move(steps);
  return report;
}

SurfaceTimestep side(std::uint32_t contact, char letter, double step, std::int64_t node) {
  return {contact, letter, "a3", step, node, 1};
}

TEST(CompareTimesteps, WithinWhatIsPrinted) {
  const Report first = with_steps({side(0, 'A', 1.23449e-4, 5), side(0, 'B', 2e-4, 6), side(1, 'A', 1e16, 1)});
  const Report second = with_steps({side(0, 'A', 1.234e-4, 5), side(0, 'B', 2e-4, 8), side(1, 'A', 1e16, 2)});
  const Comparison comparison = compare(first, second, 0);
  EXPECT_TRUE(comparison.equal());
  EXPECT_EQ(comparison.timesteps.agree, 2U);
  EXPECT_EQ(comparison.timesteps.other_node, 1U);
  ASSERT_EQ(comparison.timesteps.differences.size(), 1U);
  EXPECT_EQ(comparison.timesteps.differences[0].contact, 7);
  EXPECT_EQ(comparison.timesteps.differences[0].side, 'B');
  EXPECT_EQ(comparison.timesteps.differences[0].node_second, 8);
}

TEST(CompareTimesteps, OneUnitOfTheLastDigitDiffers) {
  const Report first = with_steps({side(0, 'A', 1.234e-4, 5), side(1, 'A', 1e16, 1)});
  const Report second = with_steps({side(0, 'A', 1.235e-4, 5), side(1, 'A', 3e-4, 1)});
  const Comparison comparison = compare(first, second, 0);
  EXPECT_FALSE(comparison.equal());
  EXPECT_EQ(comparison.timesteps.differ, 2U);
  const std::string text = comparison_text(comparison, first, second, 10);
  EXPECT_NE(text.find("surface time steps: 2 compared, 2 differ\n"), std::string::npos) << text;
  EXPECT_NE(text.find("1.234E-04"), std::string::npos) << text;
  EXPECT_NE(text.find("no limit"), std::string::npos) << text;
  const auto json = nlohmann::json::parse(comparison_json(comparison, first, second));
  EXPECT_EQ(json["timesteps"]["differ"], 2);
  EXPECT_EQ(json["timesteps"]["differences"][1]["second"], 1.235e-4);
  EXPECT_FALSE(json["equal"]);
}

TEST(CompareTimesteps, SidesOfOneSourceAndOrder) {
  Report second = with_steps({side(0, 'A', 2e-4, 6), side(1, 'A', 1e-4, 5)});
  std::swap(second.contacts[0], second.contacts[1]);
  const Report first = with_steps({side(0, 'A', 1e-4, 5), side(0, 'B', 1e-4, 5), side(1, 'A', 2e-4, 6)});
  const Comparison comparison = compare(first, second, 0);
  EXPECT_TRUE(comparison.equal());
  EXPECT_EQ(comparison.timesteps.agree, 2U);
  EXPECT_EQ(comparison.timesteps.only_first, 1U);
  second.predicted.reset();
  EXPECT_EQ(compare(first, second, 0).timesteps.only_first, 0U);
}

}  // namespace
}  // namespace gapcheck::report::compare_timesteps_test
