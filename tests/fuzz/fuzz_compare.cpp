// Two texts with a line of equals signs between them: as logs of two runs, and as their result files. A run agrees with
// itself.
#include <cmath>

#include "fuzz.hpp"
#include "report/compare/compare.hpp"
#include "report/compare/compare_curves.hpp"
#include "report/compare/compare_html.hpp"
#include "report/compare/plot_svg.hpp"
#include "report/compare/sae_filter.hpp"
#include "results/log/solver_log.hpp"
#include "samples.hpp"

namespace gapcheck::fuzz::compare_target {
namespace {

Report log_of(std::string_view text) {
  Diagnostics diagnostics;
  return results::read_solver_log_text(text, "messag", {}, diagnostics);
}

std::vector<report::Curve> curves_of(std::string_view text) {
  Diagnostics diagnostics;
  results::RunResults run;
  run.glstat = results::read_glstat(text, "glstat", diagnostics);
  run.rcforc = results::read_rcforc(text, "rcforc", diagnostics);
  run.sleout = results::read_sleout(text, "sleout", diagnostics);
  run.nodout = results::read_nodout(text, "nodout", diagnostics);
  return report::curves(run);
}

void draw(const std::vector<report::Curve>& curves) {
  report::Plot plot{"title", "time", "value", {}};
  for (const report::Curve& curve : curves) plot.lines.push_back({curve.name, curve.times, curve.values});
  if (!plot.lines.empty()) static_cast<void>(report::plot_svg(plot));
}

}  // namespace

GAPCHECK_FUZZ_TARGET(compare) {
  const auto texts = parts(input);
  const std::string_view second_text = texts.size() > 1 ? texts[1] : texts[0];
  const Report first = log_of(texts[0]), second = log_of(second_text);
  const auto first_curves = curves_of(texts[0]), second_curves = curves_of(second_text);
  const auto curves = report::compare_curves(first_curves, second_curves, {});
  require(texts[0] != second_text || curves.differ == 0);
  for (const Report* other : {&second, &sample_audit()}) {
    const auto compared = report::compare(first, *other, 1e-6);
    static_cast<void>(report::comparison_text(compared, first, *other, 3, {&curves}));
    static_cast<void>(report::comparison_json(compared, first, *other, {&curves}));
    static_cast<void>(report::comparison_html(compared, first, *other, {&curves}, {first_curves, second_curves}, "0"));
  }
  require(report::compare(first, first, 0).equal());
  draw(first_curves);
  for (const report::Curve& curve : first_curves) {
    const auto smooth = report::filtered(curve, {60, 1e-3});
    require(!smooth || curve.times.size() < 2 || smooth.value().times.size() >= curve.times.size());
  }
}

}  // namespace gapcheck::fuzz::compare_target
