#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "report/compare/compare.hpp"

namespace gapcheck::report {

/// Plots that one page of compare holds at most: a page of thousands is slow to open.
inline constexpr std::size_t most_page_plots = 200;

/// The curves of two runs that were compared, as CurveComparison's positions mean them.
struct ComparedCurves {
  const std::vector<Curve>&first, &second;
};

/// One curve of both runs over each other; `first_name`, `second_name`: the runs'.
[[nodiscard]] std::string pair_svg(const CurvePair& pair, const ComparedCurves& curves, const std::string& first_name,
                                   const std::string& second_name);

/// A page with the verdict, a table of all curves with their norms and ratings, plots of those that differ most (at
/// most most_page_plots; the page says how many it leaves out), and the parts' motion. It loads nothing and has no
/// scripts; names are escaped. Deterministic.
[[nodiscard]] std::string comparison_html(const Comparison& comparison, const Report& first, const Report& second,
                                          const RunComparison& runs, const ComparedCurves& curves,
                                          std::string_view version);

}  // namespace gapcheck::report
