#pragma once
#include <CLI/App.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/compare/compare_curves.hpp"

namespace gapcheck::app {

/// What the user wants to know of the curves of two runs.
struct CurveArguments {
  double tolerance = 1e-3;
  std::vector<std::string> names;  ///< --curves
  bool none = false;               ///< --no-curves
  std::string svg;                 ///< directory; empty: no plots
};
void add_curve_options(CLI::App& command, CurveArguments& arguments);

/// The result files of two directories as curves. Faults of the files are printed.
class CurvesOfBoth {
 public:
  /// `contacts`: curves of others are left out; empty: all stay. Where one of the two is no directory, or has no file
  /// with curves, nothing is compared.
  CurvesOfBoth(const std::string& first, const std::string& second, const std::vector<std::int64_t>& contacts,
               const CurveArguments& arguments, bool quiet);
  /// nullptr: nothing to compare.
  [[nodiscard]] const report::CurveComparison* comparison() const { return comparison_ ? &*comparison_ : nullptr; }
  /// False: a file is at fault, or the user named curves or plots that there are none of, which has been said.
  [[nodiscard]] bool complete() const { return complete_; }
  /// Plots the `top` curves that differ most, or that the user named; false after a failure, which has been said.
  [[nodiscard]] bool write_plots(std::size_t top) const;

 private:
  [[nodiscard]] std::vector<report::Curve> read(const std::string& path, const std::vector<std::int64_t>& contacts,
                                                bool quiet);
  [[nodiscard]] std::string plot(const report::CurvePair& pair) const;

  const CurveArguments& arguments_;
  std::string first_name_, second_name_;
  std::vector<report::Curve> first_, second_;
  std::optional<report::CurveComparison> comparison_;
  bool complete_ = true;
};

}  // namespace gapcheck::app
