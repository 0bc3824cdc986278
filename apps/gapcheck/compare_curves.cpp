#include "compare_curves.hpp"

#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/file_writer.hpp"
#include "common/file_guard.hpp"
#include "options.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "report/compare/sae_filter.hpp"
#include "results/curves/run_results.hpp"

namespace gapcheck::app {
namespace {

namespace fs = std::filesystem;

/// "rcforc_contact_3_side_A_x-force.svg".
std::string file_name(std::string name) {
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '-') letter = '_';
  return name + ".svg";
}

std::vector<report::Curve> read(const std::string& path, const std::vector<std::int64_t>& contacts, bool quiet,
                                Failures& failures) {
  Diagnostics diagnostics;
  std::vector<report::Curve> list = report::curves(results::read_run_results(path, true, diagnostics));
  print(diagnostics, quiet);
  failures.count(diagnostics);
  if (!contacts.empty())
    std::erase_if(list, [&](const report::Curve& curve) {
      return curve.contact != 0 && std::find(contacts.begin(), contacts.end(), curve.contact) == contacts.end();
    });
  return list;
}

/// Filters all curves; one that cannot be filtered is a failure and stays as it is.
void filter_curves(const CurveArguments& arguments, std::vector<report::Curve>& list, Failures& failures) {
  if (arguments.filter.empty()) return;
  const report::SaeFilter filter{report::channel_class(arguments.filter), report::seconds_in(arguments.time_unit)};
  for (report::Curve& curve : list) {
    auto result = report::filtered(curve, filter);
    if (!result) return failures.add(result.error());
    curve = std::move(result).value();
  }
}

}  // namespace

Status check_curve_options(const CurveArguments& arguments) {
  const std::string& filter = arguments.filter;
  if (!filter.empty() && report::channel_class(filter) == 0)
    return plain_error(fmt::format("--filter {}: not a class; there are CFC60, CFC180, CFC600 and CFC1000", filter));
  if (filter.empty() != arguments.time_unit.empty())
    return plain_error(filter.empty()
                           ? "--time-unit says nothing without --filter"
                           : "--filter: a class is a frequency in Hz; say with --time-unit s, ms or us what the "
                             "times of the two runs are in");
  return {};
}

void add_curve_options(CLI::App& command, CurveArguments& arguments) {
  const std::vector<CLI::Option*> options{
      command.add_option("--curve-tol", arguments.tolerance, "Curves may differ by this share of the larger one")
          ->check(CLI::Validator(check_amount, ""))
          ->type_name("X")
          ->capture_default_str(),
      add_list(command, "--curves", arguments.names, "Only curves with one of these texts in their name")
          ->type_name("TEXTS"),
      command.add_flag("--no-curves", arguments.none, "Do not compare curves"),
      command.add_option("--svg", arguments.svg, "Plot the curves that differ most, or those of --curves, into DIR")
          ->type_name("DIR"),
      command.add_option("--html", arguments.html, "Write the comparison with plots of the curves to a page")
          ->type_name("FILE"),
      command.add_option("--filter", arguments.filter, "Filter the curves of both: CFC60, CFC180, CFC600 or CFC1000")
          ->type_name("CFC"),
      command.add_option("--time-unit", arguments.time_unit, "Of the model, for --filter")
          ->check(CLI::IsMember({"s", "ms", "us"}))};
  for (CLI::Option* option : options) option->group("Curves of two directories");
}

RunsOfBoth::RunsOfBoth(const std::string& first, const std::string& second, const std::vector<std::int64_t>& contacts,
                       const CurveArguments& arguments, bool quiet, Failures& failures)
    : arguments_(arguments), first_name_(first), second_name_(second) {
  std::error_code failed;
  if (!arguments.none && fs::is_directory(first, failed) && fs::is_directory(second, failed)) {
    compare_curves(contacts, quiet, failures);
    if (arguments.names.empty()) compare_motion(quiet, failures);
  }
  const auto must_exist = [&](bool asked, const char* option) {
    if (!asked || (comparison_ && !comparison_->pairs.empty())) return;
    failures.add(plain_error(fmt::format("{}: there are no such curves that both A and B have", option)));
  };
  must_exist(!arguments.names.empty(), "--curves");
  must_exist(!arguments.svg.empty() && arguments.names.empty(), "--svg");
  must_exist(!arguments.filter.empty() && arguments.names.empty(), "--filter");
}

void RunsOfBoth::compare_curves(const std::vector<std::int64_t>& contacts, bool quiet, Failures& failures) {
  first_ = read(first_name_, contacts, quiet, failures);
  second_ = read(second_name_, contacts, quiet, failures);
  if (first_.empty() && second_.empty()) return;
  filter_curves(arguments_, first_, failures);
  filter_curves(arguments_, second_, failures);
  comparison_ = report::compare_curves(first_, second_, {arguments_.tolerance, arguments_.names});
}

void RunsOfBoth::compare_motion(bool quiet, Failures& failures) {
  const Progress progress("reading the d3plots", !quiet);
  Diagnostics diagnostics;
  motion_ = report::compare_motion(first_name_, second_name_, arguments_.tolerance, diagnostics);
  print(diagnostics, quiet);
  failures.count(diagnostics);
}

Status RunsOfBoth::write_plots(std::size_t top) const {
  if (arguments_.svg.empty() || !comparison_) return {};
  const bool named = !arguments_.names.empty();
  std::vector<PlannedOutput> outputs;
  for (const report::CurvePair& pair : comparison_->pairs) {
    if (outputs.size() == top || (!named && pair.verdict != report::CurvePair::Verdict::differs)) break;
    outputs.push_back({"--svg", (fs::path(arguments_.svg) / file_name(pair.name)).string()});
  }
  std::vector<ReadInput> read;
  for (const std::string& directory : {first_name_, second_name_}) add_run_files(directory, read);
  if (Status free = check_outputs(read, outputs); !free.ok()) return free;
  std::error_code failed;
  fs::create_directories(arguments_.svg, failed);
  for (std::size_t i = 0; i < outputs.size(); ++i)
    if (Status plotted =
            write_file(outputs[i].path, report::pair_svg(comparison_->pairs[i], curves(), first_name_, second_name_));
        !plotted.ok())
      return plotted;
  return {};
}

}  // namespace gapcheck::app
