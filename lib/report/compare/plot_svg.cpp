#include "report/compare/plot_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "report/write/xml_text.hpp"

namespace gapcheck::report {
namespace {

/// The whole drawing.
struct Canvas {
  static constexpr double width = 720, height = 420;
};

/// The rectangle in the canvas that the axes span.
struct Frame {
  static constexpr double left = 84, right = 700, top = 40, bottom = 372;
};

/// Values between two pixels, with round values in between. Works on halves, so no range overflows.
class Axis {
 public:
  Axis(double from, double to) : from_(from), to_(to) {}

  void add(std::span<const double> values) {
    for (const double value : values) {
      low_ = std::min(low_, value);
      high_ = std::max(high_, value);
    }
  }

  /// A range of some width around the values.
  void settle() {
    if (low_ > high_) low_ = high_ = 0;
    const double size = std::max(std::abs(low_), std::abs(high_));
    double margin = 0.02 * (high_ / 2 - low_ / 2);
    if (margin <= 1e-12 * size) margin = size > 0 ? 0.05 * size : 1;
    low_ = std::max(low_ - margin, -limit);
    high_ = std::min(high_ + margin, limit);
  }

  [[nodiscard]] double operator()(double value) const {
    const double share = (value / 2 - low_ / 2) / (high_ / 2 - low_ / 2);
    return from_ + (to_ - from_) * std::clamp(share, 0.0, 1.0);
  }

  /// Multiples of 1, 2 or 5 times a power of ten, about six of them.
  [[nodiscard]] std::vector<double> ticks() const {
    const double raw = (high_ / 2 - low_ / 2) / 3;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    const double step = power * (raw <= power ? 1 : raw <= 2 * power ? 2 : raw <= 5 * power ? 5 : 10);
    std::vector<double> values;
    if (!(step > 0) || !std::isfinite(step)) return values;
    const double first = std::ceil(low_ / step);
    for (int i = 0; i < 12 && (first + i) * step <= high_; ++i) values.push_back((first + i) * step + 0.0);
    return values;
  }

 private:
  static constexpr double limit = std::numeric_limits<double>::max() / 4;
  double from_, to_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
};

/// Positions of the points to draw: all, or first, lowest, highest and last of each of 600 groups.
std::vector<std::size_t> thinned(std::span<const double> y) {
  constexpr std::size_t groups = 600;
  std::vector<std::size_t> kept;
  const std::size_t size = y.size(), per_group = std::max<std::size_t>(1, (size + groups - 1) / groups);
  for (std::size_t begin = 0; begin < size; begin += per_group) {
    const auto first = y.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = y.begin() + static_cast<std::ptrdiff_t>(std::min(size, begin + per_group));
    const auto [lowest, highest] = std::minmax_element(first, last);
    const auto place = [&](auto it) { return static_cast<std::size_t>(it - y.begin()); };
    std::array places{place(first), place(lowest), place(highest), place(last - 1)};
    std::sort(places.begin(), places.end());
    kept.insert(kept.end(), places.begin(), std::unique(places.begin(), places.end()));
  }
  return kept;
}

std::string line(double x1, double y1, double x2, double y2, std::string_view style) {
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>\n", x1, y1, x2, y2, style);
}

std::string svg_text(double x, double y, std::string_view anchor, std::string_view words) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, xml_text(words));
}

std::string_view stroke(std::size_t position) {
  constexpr std::array<std::string_view, 4> strokes{
      R"(stroke="#9aa7b5" stroke-width="4")", R"(stroke="#c0392b" stroke-width="1.4")",
      R"(stroke="#1f6fb2" stroke-width="1.4")", R"(stroke="#2e8b57" stroke-width="1.4")"};
  return strokes[position % strokes.size()];
}

std::string grid(const Axis& x, const Axis& y) {
  std::string out;
  constexpr std::string_view style = R"(stroke="#dddddd")";
  for (const double value : x.ticks())
    out += line(x(value), Frame::top, x(value), Frame::bottom, style) +
           svg_text(x(value), Frame::bottom + 16, "middle", fmt::format("{:.6g}", value));
  for (const double value : y.ticks())
    out += line(Frame::left, y(value), Frame::right, y(value), style) +
           svg_text(Frame::left - 6, y(value) + 4, "end", fmt::format("{:.6g}", value));
  return out + fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#333333\"/>\n",
                           Frame::left, Frame::top, Frame::right - Frame::left, Frame::bottom - Frame::top);
}

std::string polyline(const PlotLine& plot_line, std::size_t position, const Axis& x, const Axis& y) {
  std::string out = "<polyline fill=\"none\" stroke-linejoin=\"round\" " + std::string(stroke(position)) + " points=\"";
  for (const std::size_t i : thinned(plot_line.y))
    out += fmt::format("{:.1f},{:.1f} ", x(plot_line.x[i]), y(plot_line.y[i]));
  return out + "\"/>\n";
}

}  // namespace

std::string plot_svg(const Plot& plot) {
  Axis x(Frame::left, Frame::right), y(Frame::bottom, Frame::top);
  for (const PlotLine& plot_line : plot.lines) {
    x.add(plot_line.x);
    y.add(plot_line.y);
  }
  x.settle();
  y.settle();
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
      Canvas::width, Canvas::height);
  out += svg_text((Frame::left + Frame::right) / 2, Frame::top - 18, "middle", plot.title) + grid(x, y);
  for (std::size_t i = 0; i < plot.lines.size(); ++i) out += polyline(plot.lines[i], i, x, y);
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    const double at = Frame::top + 14 + 17 * static_cast<double>(i);
    out += line(Frame::left + 10, at, Frame::left + 34, at, stroke(i)) +
           svg_text(Frame::left + 40, at + 4, "start", plot.lines[i].label);
  }
  out += svg_text((Frame::left + Frame::right) / 2, Canvas::height - 10, "middle", plot.x_label);
  out += fmt::format("<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                     (Frame::top + Frame::bottom) / 2, xml_text(plot.y_label));
  return out + "</svg>\n";
}

}  // namespace gapcheck::report
