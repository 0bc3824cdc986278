#pragma once
#include <span>
#include <string>
#include <vector>

namespace gapcheck::report {

/// One line of a plot; as many y as x, all finite.
struct PlotLine {
  std::string label;
  std::span<const double> x, y;
};

struct Plot {
  std::string title, x_label, y_label;
  std::vector<PlotLine> lines;
};

/// The plot as an SVG of 720 by 420: frame, grid at round values, lines (the first one wide and grey, so that a second
/// one on top of it is visible), legend. Lines with many points are thinned to what is visible: the extremes of each
/// column.
[[nodiscard]] std::string plot_svg(const Plot& plot);

}  // namespace gapcheck::report
