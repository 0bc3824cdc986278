#include "report/compare/compare_html.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/compare/plot_svg.hpp"
#include "report/write/plain_page.hpp"
#include "report/write/xml_text.hpp"

namespace gapcheck::report {
namespace {

constexpr std::string_view plot_style = R"(<style>
figure { display: inline-block; width: min(720px, 100%); margin: 8px 8px 8px 0; }
svg { width: 100%; height: auto; }
pre { overflow-x: auto; }
</style>
)";

/// A cell with a number, in the row of a table.
std::string number_cell(std::string_view text) { return fmt::format("<td class=\"number\">{}</td>", text); }

std::string score_cell(const std::optional<Rating>& rating, double score) {
  return number_cell(rating ? fmt::format("{:.3f}", score) : "-");
}

std::string curve_row(const CurvePair& pair, bool plotted, std::size_t position) {
  using enum CurvePair::Verdict;
  const std::string_view verdict = pair.verdict == agrees ? "agrees" : pair.verdict == differs ? "differs" : "no times";
  const std::string_view colour = pair.verdict == agrees ? "clean" : pair.verdict == differs ? "error" : "note";
  const Rating rating = pair.rating.value_or(Rating{});
  std::string name = xml_text(pair.name);
  if (plotted) name = fmt::format("<a href=\"#c{}\">{}</a>", position, name);
  return fmt::format("<tr><td>{}</td><td class=\"{}\">{}</td>", name, colour, verdict) +
         score_cell(pair.rating, rating.overall()) + score_cell(pair.rating, rating.corridor) +
         score_cell(pair.rating, rating.phase) + score_cell(pair.rating, rating.magnitude) +
         score_cell(pair.rating, rating.slope) + number_cell(fmt::format("{:.2e}", pair.relative_difference)) +
         number_cell(fmt::format("{:.2e}", pair.l2_difference)) +
         number_cell(fmt::format("{:.5g}", pair.largest_first)) +
         number_cell(fmt::format("{:.5g}", pair.largest_second)) + "</tr>\n";
}

bool has_plot(const CurvePair& pair) { return pair.verdict != CurvePair::Verdict::no_common_times; }

std::string curve_section(const CurveComparison& compared, const ComparedCurves& curves, const std::string& first_name,
                          const std::string& second_name) {
  std::string out = fmt::format("<h1>Curves: {} agree, {} differ by more than {:g} of the larger one</h1>\n",
                                compared.agree, compared.differ, compared.tolerance);
  out +=
      "<p>Ratings after ISO/TS 18571, B against A: corridor, phase, magnitude, slope; 1 is the same curve.</p>\n"
      "<table>\n<tr><th>curve</th><th></th><th class=\"number\">rating</th><th class=\"number\">corridor</th>"
      "<th class=\"number\">phase</th><th class=\"number\">magnitude</th><th class=\"number\">slope</th>"
      "<th class=\"number\">relative</th><th class=\"number\">L2</th><th class=\"number\">largest A</th>"
      "<th class=\"number\">largest B</th></tr>\n";
  const std::size_t plots = std::min(most_page_plots, compared.pairs.size());
  for (std::size_t i = 0; i < compared.pairs.size(); ++i)
    out += curve_row(compared.pairs[i], i < plots && has_plot(compared.pairs[i]), i);
  out += "</table>\n";
  for (std::size_t i = 0; i < plots; ++i)
    if (has_plot(compared.pairs[i]))
      out += fmt::format("<figure id=\"c{}\">\n{}</figure>\n", i,
                         pair_svg(compared.pairs[i], curves, first_name, second_name));
  if (plots < compared.pairs.size())
    out += fmt::format("<p>{} more curves have no plot here.</p>\n", compared.pairs.size() - plots);
  return out;
}

std::string motion_section(const MotionComparison& motion) {
  constexpr std::size_t most_lines = 4;
  std::string out =
      fmt::format("<h1>Motion: {} of {} parts differ by more than {:g} of the largest displacement, {:.5g}</h1>\n",
                  motion.differ, motion.parts.size(), motion.tolerance, motion.largest_displacement);
  out +=
      "<table>\n<tr><th class=\"number\">part</th><th class=\"number\">nodes</th><th class=\"number\">by at most</th>"
      "<th class=\"number\">at time</th><th class=\"number\">node</th><th class=\"number\">mean at the end</th></tr>\n";
  for (const PartMotion& part : motion.parts)
    out += "<tr>" + number_cell(fmt::format("{}", part.part)) + number_cell(fmt::format("{}", part.nodes)) +
           number_cell(fmt::format("{:.5g}", part.largest_distance)) + number_cell(fmt::format("{:.6g}", part.time)) +
           number_cell(fmt::format("{}", part.node)) +
           number_cell(fmt::format("{:.5g}", part.mean.empty() ? 0 : part.mean.back())) + "</tr>\n";
  Plot plot{"largest distance of the parts' nodes", "time", "distance (units of the model)", {}};
  for (std::size_t i = 0; i < std::min(most_lines, motion.parts.size()); ++i)
    plot.lines.push_back({fmt::format("part {}", motion.parts[i].part), motion.times, motion.parts[i].largest});
  return out + "</table>\n<figure>\n" + plot_svg(plot) + "</figure>\n";
}

}  // namespace

std::string pair_svg(const CurvePair& pair, const ComparedCurves& curves, const std::string& first_name,
                     const std::string& second_name) {
  const Curve &a = curves.first[pair.first], &b = curves.second[pair.second];
  return plot_svg({pair.name,
                   "time",
                   a.quantity + " (units of the model)",
                   {{"A: " + first_name, a.times, a.values}, {"B: " + second_name, b.times, b.values}}});
}

std::string comparison_html(const Comparison& comparison, const Report& first, const Report& second,
                            const RunComparison& runs, const ComparedCurves& curves, std::string_view version) {
  std::string page(plain_page_head);
  page += plot_style;
  page += fmt::format("<h1>{}</h1>\n<p>A: {}<br>B: {}</p>\n",
                      comparison.equal() && runs.equal() ? "No differences" : "The two differ", xml_text(first.input),
                      xml_text(second.input));
  if (runs.curves != nullptr) page += curve_section(*runs.curves, curves, first.input, second.input);
  if (runs.motion != nullptr) page += motion_section(*runs.motion);
  constexpr std::size_t records_shown = 10;
  page += fmt::format("<h1>Contacts</h1>\n<pre>{}</pre>\n",
                      xml_text(comparison_text(comparison, first, second, records_shown)));
  return page + fmt::format("<p>gapcheck {}</p>\n</body>\n</html>\n", xml_text(version));
}

}  // namespace gapcheck::report
