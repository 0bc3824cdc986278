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

namespace gapcheck::app {

/// The user's options for the curves of two runs.
struct CurveArguments {
  double tolerance = 1e-3;
  std::vector<std::string> names;  ///< --curves
  bool none = false;               ///< --no-curves
  std::string svg;                 ///< directory; empty: no plots
};
void add_curve_options(CLI::App& command, CurveArguments& arguments);

/// The result files of two directories as curves.
class CurvesOfBoth {
 public:
  /// `contacts`: only their curves are compared; empty: all. If one of the two is not a directory, or has no file
  /// with curves, nothing is compared. Faulty files, and curves or plots that are asked for and do not exist, are
  /// failures.
  CurvesOfBoth(const std::string& first, const std::string& second, const std::vector<std::int64_t>& contacts,
               const CurveArguments& arguments, bool quiet, Failures& failures);
  /// nullptr: nothing to compare.
  [[nodiscard]] const report::CurveComparison* comparison() const { return comparison_ ? &*comparison_ : nullptr; }
  /// Plots the `top` curves that differ most, or those named by the user.
  [[nodiscard]] Status write_plots(std::size_t top) const;

 private:
  [[nodiscard]] std::string plot(const report::CurvePair& pair) const;

  const CurveArguments& arguments_;
  std::string first_name_, second_name_;
  std::vector<report::Curve> first_, second_;
  std::optional<report::CurveComparison> comparison_;
};

}  // namespace gapcheck::app
