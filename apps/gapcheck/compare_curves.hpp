#pragma once
#include <CLI/App.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "common/failures.hpp"
#include "report/compare/compare_curves.hpp"
#include "report/compare/compare_html.hpp"
#include "report/compare/compare_motion.hpp"

namespace gapcheck::app {

/// The user's options for the curves of two runs.
struct CurveArguments {
  double tolerance = 1e-3;
  std::vector<std::string> names;  ///< --curves
  bool none = false;               ///< --no-curves
  std::string svg;                 ///< directory; empty: no plots
  std::string html;                ///< file; empty: no page
  std::string filter, time_unit;   ///< --filter, --time-unit; empty: not filtered
};
void add_curve_options(CLI::App& command, CurveArguments& arguments);

/// The result files of two directories: curves, and the nodes of their d3plots.
class RunsOfBoth {
 public:
  /// `contacts`: only their curves are compared; empty: all. If one of the two is not a directory, or has no file
  /// with curves or d3plot, these are not compared; the d3plots only if no curves are named. Faulty files, and curves
  /// or plots that are asked for and do not exist, are failures.
  RunsOfBoth(const std::string& first, const std::string& second, const std::vector<std::int64_t>& contacts,
             const CurveArguments& arguments, bool quiet, Failures& failures);
  [[nodiscard]] report::RunComparison comparison() const {
    return {comparison_ ? &*comparison_ : nullptr, motion_ ? &*motion_ : nullptr};
  }
  [[nodiscard]] report::ComparedCurves curves() const { return {first_, second_}; }
  /// Plots the `top` curves that differ most, or those named by the user.
  [[nodiscard]] Status write_plots(std::size_t top) const;

 private:
  void compare_curves(const std::vector<std::int64_t>& contacts, bool quiet, Failures& failures);
  void compare_motion(bool quiet, Failures& failures);

  const CurveArguments& arguments_;
  std::string first_name_, second_name_;
  std::vector<report::Curve> first_, second_;
  std::optional<report::CurveComparison> comparison_;
  std::optional<report::MotionComparison> motion_;
};

/// An error if --filter is not a class, or if it or --time-unit lacks the other one.
[[nodiscard]] Status check_curve_options(const CurveArguments& arguments);

}  // namespace gapcheck::app
