#include "report/compare/plot_svg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace gapcheck::report::plot_svg_test {
namespace {

/// Coordinates of the points of each line.
std::vector<std::vector<std::pair<double, double>>> lines_of(const std::string& svg) {
  std::vector<std::vector<std::pair<double, double>>> lines;
  for (std::size_t at = svg.find("points=\""); at != std::string::npos; at = svg.find("points=\"", at + 1)) {
    const std::string text = svg.substr(at + 8, svg.find('"', at + 8) - at - 8);
    auto& line = lines.emplace_back();
    const std::regex point(R"((-?[0-9.]+),(-?[0-9.]+))");
    for (std::sregex_iterator it(text.begin(), text.end(), point), end; it != end; ++it)
      line.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  }
  return lines;
}

/// Opening and closing tags pair up, and no script is among them.
void expect_well_formed(const std::string& svg) {
  std::vector<std::string> open;
  const std::regex tag(R"(<(/?)([a-z]+)[^<>]*?(/?)>)");
  for (std::sregex_iterator it(svg.begin(), svg.end(), tag), end; it != end; ++it) {
    EXPECT_NE((*it)[2], "script");
    if ((*it)[1].length() > 0) {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), (*it)[2]);
      open.pop_back();
    } else if ((*it)[3].length() == 0) {
      open.push_back((*it)[2]);
    }
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(std::count(svg.begin(), svg.end(), '<'), std::count(svg.begin(), svg.end(), '>'));
}

TEST(PlotSvg, LinesAxesLegend) {
  const std::vector<double> x{0, 1, 2}, a{0, 10, 0}, b{0, -10, 0};
  const std::string svg = plot_svg({"kinetic <energy>", "time", "energy", {{"A & C", x, a}, {"B\x01", x, b}}});
  expect_well_formed(svg);
  for (const char* text : {">kinetic &lt;energy&gt;<", ">A &amp; C<", ">B?<", ">time<", ">energy<", ">10<", ">-10<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  const auto lines = lines_of(svg);
  ASSERT_EQ(lines.size(), 2u);
  ASSERT_EQ(lines[0].size(), 3u);
  EXPECT_LT(lines[0][0].first, lines[0][1].first);
  EXPECT_LT(lines[0][1].second, lines[1][1].second) << "up is up";
  EXPECT_NEAR(lines[0][0].second - lines[0][1].second, lines[1][1].second - lines[0][0].second, 0.11);
}

TEST(PlotSvg, ManyPointsAreThinnedButPeaksStay) {
  std::vector<double> x, y;
  for (int i = 0; i < 1'000'000; ++i) {
    x.push_back(i);
    y.push_back(i == 777'777 ? 5 : 0);
  }
  const std::string svg = plot_svg({"", "", "", {{"", x, y}}});
  EXPECT_LT(svg.size(), 100'000u);
  const auto lines = lines_of(svg);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_LT(
      std::min_element(lines[0].begin(), lines[0].end(), [](auto p, auto q) { return p.second < q.second; })->second,
      60);
}

TEST(PlotSvg, AnyRange) {
  const std::vector<double> x{0, 1}, huge{-1.7e308, 1.7e308}, flat{3, 3}, tiny{0, 5e-324};
  for (const auto* y : {&huge, &flat, &tiny, &x}) {
    const std::string svg = plot_svg({"", "", "", {{"", x, *y}, {"", *y, x}}});
    expect_well_formed(svg);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
  }
  expect_well_formed(plot_svg({"", "", "", {{"", {}, {}}}}));
}

}  // namespace
}  // namespace gapcheck::report::plot_svg_test
