#include "options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "audit/registry.hpp"
#include "base/file_writer.hpp"
#include "base/nearest_name.hpp"
#include "base/number.hpp"
#include "commands.hpp"
#include "common/version.hpp"
#include "output.hpp"
#include "report/export/finding_grid.hpp"
#include "report/format/formats.hpp"
#include "report/html/html.hpp"
#include "report/html/html_index.hpp"
#include "report/item/describe.hpp"
#include "report/text/rule_table.hpp"

namespace gapcheck::app {
namespace {

std::string check_rule(const std::string& text, bool of_runs) {
  for (const auto& rule : audit::rules())
    if (rule.of_runs() == of_runs && audit::selected(rule, {text}, {})) return "";
  return fmt::format("'{}' is not a rule on {}; gapcheck rules lists them{}", text, of_runs ? "runs" : "decks",
                     did_you_mean(audit::nearest_rule(text, of_runs)));
}

}  // namespace

std::string check_deck_rule(const std::string& text) { return check_rule(text, false); }
std::string check_run_rule(const std::string& text) { return check_rule(text, true); }

std::string check_amount(const std::string& text) {
  // All of the text, as CLI11 itself reads numbers.
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (!text.empty() && end == text.c_str() + text.size() && std::isfinite(value) && value >= 0) return "";
  return "'" + text + "' is not a number of 0 or more";
}

std::string check_id(const std::string& text) {
  return parse_integer(text) ? "" : "'" + text + "' is not a whole number";
}

void add_output(CLI::App& command, OutputOptions& options) {
  const std::vector<CLI::Option*> added{
      command.add_option("--format", options.format, "Of the results")
          ->check(CLI::IsMember({"text", "json", "sarif", "junit", "github", "gitlab", "csv"}))
          ->capture_default_str(),
      command.add_option("--output", options.output, "Write the results there instead of to standard output")
          ->type_name("FILE"),
      command.add_option("--html", options.html, "Write a page for a browser too: tables and a picture")
          ->type_name("FILE"),
      command.add_option("--top", options.text.top, "Lines per rule; with --all, deepest nodes per contact")
          ->check(CLI::Range(0, std::numeric_limits<int>::max()).description(""))
          ->each([&options](const std::string&) { options.limit_per_rule = true; })
          ->type_name("N")
          ->capture_default_str(),
      command.add_flag("--all", options.text.all, "No bound on lines, and each contact with its deepest nodes"),
      command.add_flag("--list", options.text.list, "The same with every node and every finding"),
      command.add_option("--group-by", options.group_by, "How findings are grouped into lines")
          ->check(CLI::IsMember({"severity", "rule", "contact", "part", "file"}))
          ->capture_default_str(),
      command.add_option("--fail-on", options.fail_on, "Least severity that gives exit code 1")
          ->check(CLI::IsMember({"error", "warning", "note", "never"}))
          ->capture_default_str(),
      command.add_flag("--stats", options.text.stats, "Show counters and times"),
      command.add_flag("--quiet", options.text.quiet, "Only the last line, and no warnings")};
  for (CLI::Option* option : added) option->group("Output");
}

namespace {

/// The rules as shown in formats.
std::vector<report::RuleText> rule_texts() {
  std::vector<report::RuleText> texts;
  for (const RuleIdentity& rule : audit::rules())
    texts.push_back({rule.id, rule.name, rule.severity, rule.summary, audit::page(rule)});
  return texts;
}

/// The lowest severity that counts; none for "never".
std::optional<Severity> limit_of(const std::string& fail_on) {
  for (const Severity severity : {Severity::note, Severity::warning, Severity::error})
    if (report::name(severity) == fail_on) return severity;
  return std::nullopt;
}

report::GroupBy group_by(const std::string& text) {
  using enum report::GroupBy;
  for (const auto& [name, value] :
       {std::pair("rule", rule), std::pair("contact", contact), std::pair("part", part), std::pair("file", file)})
    if (text == name) return value;
  return severity;
}

void write_text(const report::Reports& reports, const OutputOptions& options, Output& output) {
  report::TextOptions text = options.text;
  text.color = output.color();
  text.width = output.width();
  text.group_by = group_by(options.group_by);
  if (options.limit_per_rule) text.per_rule = std::max<std::size_t>(text.top, 1);  // at least one: nothing is dropped
  const std::string_view between = text.quiet ? "" : "\n";
  for (std::size_t i = 0; i < reports.all.size(); ++i) {
    if (i > 0) output.write(between);
    output.write(report::text(reports.all[i], text));
  }
  if (!reports.several()) return;
  output.write(between);
  output.write(report::text_of_all(reports, text));
}

/// In one of the machine-readable formats.
void write_format(const report::Reports& reports, const OutputOptions& options,
                  std::span<const report::FindingFixes> fixes, const report::Sink& sink) {
  const std::size_t top = options.text.list ? std::numeric_limits<std::size_t>::max() : options.text.top;
  const std::optional<Severity> limit = limit_of(options.fail_on);
  if (options.format == "json") report::json(reports, sink, options.text.stats);
  if (options.format == "sarif") report::sarif(reports, version(), rule_texts(), sink, fixes);
  if (options.format == "junit") report::junit(reports, limit ? &*limit : nullptr, top, sink);
  if (options.format == "github") report::github(reports, top, sink);
  if (options.format == "gitlab") report::gitlab(reports, sink);
  if (options.format == "csv") report::csv(reports, sink);
}

/// Formats without a place for findings left out on purpose must not hide that there are any.
void say_ignored(const report::Reports& reports, const OutputOptions& options) {
  std::size_t ignored = 0;
  for (const Report& report : reports.all) ignored += report.ignored.size();
  if (ignored == 0 || options.text.quiet || (options.format != "csv" && options.format != "gitlab")) return;
  print(Diagnostic{Severity::note, "", 0,
                   fmt::format("{} ignored, not in the {}: see --format text", ignored, options.format)});
}

}  // namespace

Status write_page(const Report& report, const OutputOptions& options, const report::NodePosition& position) {
  if (options.html.empty()) return {};
  report::HtmlOptions page;
  page.version = version();
  return write_file(options.html, report::html(report, position, page));
}

Status write(const report::Reports& reports, const OutputOptions& options,
             std::span<const report::FindingFixes> fixes) {
  say_ignored(reports, options);
  Output output(options.output);
  if (options.format == "text") {
    write_text(reports, options, output);
  } else {
    write_format(reports, options, fixes, [&output](std::string_view piece) { return output.write(piece); });
    if (options.text.stats)
      for (const Report& report : reports.all) {
        if (reports.several()) std::fputs((report::printable_path(report.input) + "\n").c_str(), stderr);
        std::fputs(report::statistics(report).c_str(), stderr);
      }
  }
  return output.close();
}

int exit_code(const Report& report, const std::string& fail_on) {
  const report::Totals totals = report::counting_totals(report);
  const std::optional<Severity> limit = limit_of(fail_on);
  std::size_t counted = 0;
  if (limit) counted += totals.errors;
  if (limit && *limit <= Severity::warning) counted += totals.warnings;
  if (limit && *limit <= Severity::note) counted += totals.notes;
  return counted > 0 ? findings : clean;
}

void add_overview(CLI::App& command, OverviewOptions& options) {
  const std::vector<CLI::Option*> added{
      command
          .add_option("--html-index", options.html_index, "Write a page with a line for each deck and for each rule")
          ->type_name("FILE"),
      command
          .add_option("--summary", options.summary, "Write a table: each rule, in how many decks, how many findings")
          ->type_name("FILE")};
  for (CLI::Option* option : added) option->group("Output");
}

void write(const report::Reports& reports, const OverviewOptions& options, Failures& failures) {
  if (!options.html_index.empty())
    failures.add(write_file(options.html_index, report::html_index(reports, options.html_index, version())));
  if (!options.summary.empty()) failures.add(write_file(options.summary, report::rule_table(reports)));
}

void add_exports(CLI::App& command, ExportOptions& options) {
  const std::vector<CLI::Option*> added{
      command.add_option("--key", options.key, "Write a keyword file with one beam per penetration")->type_name("FILE"),
      command.add_option("--ani", options.ani, "Write an Animator 3 session that shows the nodes")->type_name("FILE"),
      command.add_option("--a4sel", options.a4sel, "Write an Animator 4 session with groups of the nodes")
          ->type_name("FILE"),
      command.add_option("--medina", options.medina, "Write a Medina protocol")->type_name("FILE"),
      command.add_option("--mnode", options.medina_node, "First id of new nodes in the Medina protocol")
          ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000'000}).description(""))
          ->type_name("N")
          ->capture_default_str(),
      command.add_option("--vtu", options.vtu, "Write the mesh for ParaView, with depths and vectors of penetrations")
          ->type_name("FILE"),
      command.add_option("--sets", options.sets, "Write a keyword file with sets of nodes and segments, rule by rule")
          ->type_name("FILE"),
      command.add_option("--set-id", options.set_id, "First id of these sets; without it, above those of the deck")
          ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000'000}).description(""))
          ->type_name("N")};
  for (CLI::Option* option : added) option->group("Files for post-processors");
}

void write(const Report& report, const ExportOptions& options, const report::NodePosition& position,
           Failures& failures) {
  const auto write = [&failures](const std::string& path, const auto& text) {
    if (!path.empty()) failures.add(write_file(path, text()));
  };
  if (!options.key.empty()) {
    Output output(options.key);
    report::keyword_beams(report, position, [&output](std::string_view piece) { return output.write(piece); });
    failures.add(output.close());
  }
  write(options.ani, [&] { return report::animator_session(report, false); });
  write(options.a4sel, [&] { return report::animator_session(report, true); });
  write(options.medina, [&] { return report::medina_protocol(report, position, options.medina_node); });
  write(options.vtu, [&] { return report::vtu(report::finding_grid(report, position)); });
  write(options.sets, [&] { return report::keyword_sets(report, options.set_id); });
}

void add_plain_report(CLI::App& command, const std::vector<std::string>& formats, std::string& format,
                      std::string& output, std::size_t& top, const std::string& listed, bool& quiet) {
  command.add_option("--format", format, fmt::format("Of the report: {}", fmt::join(formats, ", ")))
      ->check(CLI::IsMember(formats))
      ->capture_default_str();
  command.add_option("--output", output, "Write the report to a file instead of standard output")->type_name("FILE");
  command.add_option("--top", top, listed + " that the text lists")
      ->check(CLI::Range(0, 1'000'000'000).description(""))
      ->type_name("N")
      ->capture_default_str();
  command.add_flag("--quiet", quiet, "Only the last line, and no warnings");
}

void add_jobs(CLI::App& command, std::size_t& jobs) {
  command.add_option("--jobs", jobs, "Threads; 0: as many as the machine has")
      ->check(CLI::Range(0, 4096).description(""))
      ->type_name("N")
      ->capture_default_str();
}

void add_common(CLI::App& command, CommonOptions& options, const std::string& quiet) {
  command.add_flag("--quiet", options.quiet, quiet);
  command.add_flag("--stats", options.stats, "Show counters, on standard error");
  add_jobs(command, options.jobs);
  command.set_version_flag("--version", version_line("gapcheck"));
}

void add_includes(CLI::App& command, keyword::ReadOptions& read, std::string& missing) {
  command.add_option("--param", read.parameters, "Value of a parameter, in place of the deck's; repeatable")
      ->take_all()
      ->allow_extra_args(false)
      ->check(CLI::Validator([](const std::string& text) { return keyword::parameter_fault(text); }, ""))
      ->type_name("NAME=VALUE");
  command.add_option("-I", read.include_directories, "Further directory for *INCLUDE")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("DIR");
  command.add_option("--missing-includes", missing, "What to do about missing include files")
      ->check(CLI::IsMember({"error", "skip"}))
      ->capture_default_str();
}

}  // namespace gapcheck::app
