#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "report/baseline/baseline.hpp"
#include "report/item/causes.hpp"
#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"
#include "report/item/finding_groups.hpp"
#include "report/item/sums.hpp"
#include "report/text/check_c_tables.hpp"
#include "report/text/check_c_view.hpp"
#include "report/text/paint.hpp"
#include "report/text/text_baseline.hpp"
#include "report/text/text_contact.hpp"
#include "report/text/text_groups.hpp"
#include "report/text/text_ignored.hpp"
#include "report/text/text_portability.hpp"
#include "report/text/text_run.hpp"
#include "report/write/table.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report {
namespace {

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

/// "12 nodes, 3 shells": kinds that the model lacks are left out, except nodes and contacts.
std::string model_line(const ModelCounts& model) {
  std::string line = count(model.nodes, "node");
  const auto add = [&](std::uint64_t number, std::string_view noun) {
    if (number > 0) line += ", " + count(number, noun);
  };
  add(model.shells, "shell");
  add(model.solids, "solid");
  add(model.thick_shells, "thick shell");
  add(model.beams, "beam");
  add(model.discrete, "discrete element");
  add(model.masses, "mass element");
  add(model.particles, "particle");
  add(model.parts, "part");
  return line + ", " + count(model.contacts, "contact");
}

std::string finding_place(const Finding& finding) {
  if (finding.file.empty()) return "";
  if (finding.line == 0) return printable_path(finding.file) + ": ";
  return fmt::format("{}:{}: ", printable_path(finding.file), finding.line);
}

void append_finding_line(const Finding& finding, std::string& out) {
  out += "  " + finding_place(finding);
  if (finding.contact != 0) out += fmt::format("contact {}: ", finding.contact);
  out += printable(finding.message) + '\n';
}

/// The findings of one rule, which are consecutive.
void append_findings_of_rule(std::span<const Finding> findings, const Paint& paint, std::string& out) {
  const Finding& first = findings.front();
  out += fmt::format("\n{}", paint.bold(printable(first.id) + ' ' + printable(first.rule)));
  std::string_view before = " ";
  for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
    const auto n =
        std::count_if(findings.begin(), findings.end(), [&](const auto& f) { return f.severity == severity; });
    if (n > 0)
      out += before, out += paint.severity(severity, count(static_cast<std::uint64_t>(n), name(severity))),
          before = ", ";
  }
  out += '\n';
  for (const Finding& finding : findings) append_finding_line(finding, out);
}

void append_findings_by_rule(std::span<const Finding> findings, const Paint& paint, std::string& out) {
  while (!findings.empty()) {
    const auto end = std::find_if(findings.begin(), findings.end(),
                                  [&](const Finding& finding) { return finding.id != findings.front().id; });
    const auto length = static_cast<std::size_t>(end - findings.begin());
    append_findings_of_rule(findings.first(length), paint, out);
    findings = findings.subspan(length);
  }
}

/// "1 error, 2 warnings, 0 notes" in the colour of the most severe.
std::string numbers_of(const Totals& sum, const Paint& paint) {
  if (sum.errors + sum.warnings + sum.notes == 0) return paint("32", "nothing found");
  const Severity gravest = sum.errors > 0 ? Severity::error : sum.warnings > 0 ? Severity::warning : Severity::note;
  return paint.severity(gravest, fmt::format("{}, {}, {}", count(sum.errors, "error"), count(sum.warnings, "warning"),
                                             count(sum.notes, "note")));
}

/// "as if SST=0.5, OPTT=0"; empty for the deck as it is.
std::string as_if(const Report& report) {
  return report.as_if.empty() ? std::string() : fmt::format("as if {}", fmt::join(report.as_if, ", "));
}

/// "53 contacts, 20 tied, 3 not judged".
std::string contacts_line(const Report& report) {
  std::string line = count(report.contacts.size(), "contact");
  const auto number = [&](const auto& is) {
    return static_cast<std::size_t>(std::count_if(report.contacts.begin(), report.contacts.end(), is));
  };
  if (const std::size_t tied = number([](const ContactSummary& contact) { return contact.ties_judged; }); tied > 0)
    line += fmt::format(", {} tied", tied);
  const std::size_t open = number([](const ContactSummary& contact) { return !contact.not_checked.empty(); });
  return open > 0 ? line + fmt::format(", {} not judged", open) : line;
}

/// The line that --quiet keeps.
std::string verdict(const Report& report, const Paint& paint) {
  std::string line = printable_path(report.input) + ": " + numbers_of(totals(report), paint);
  if (const std::size_t n = consequences(report); n > 0) line += fmt::format(" ({} may follow from others)", n);
  line += " in " + contacts_line(report);
  if (const std::string assumed = as_if(report); !assumed.empty()) line += ", " + assumed;
  if (const std::size_t n = report.ignored.size(); n > 0) line += fmt::format(", {} ignored", n);
  if (report.baseline) line += "; against the baseline: " + summary(*report.baseline);
  return line + '\n';
}

void append_total(const Report& report, const Sums& total, std::string& out) {
  const auto number = [&](PenetrationKind kind, std::string_view noun) { return count(total.of(kind), noun); };
  out += fmt::format("\ntotal  {}, {}, {} in the edge zone", number(PenetrationKind::initial, "penetration"),
                     number(PenetrationKind::released, "released node"), number(PenetrationKind::edge_zone, "node"));
  const auto more = [&](PenetrationKind kind, std::string_view noun) {
    if (total.of(kind) > 0) out += ", " + number(kind, noun);
  };
  more(PenetrationKind::segment, "segment penetration");
  more(PenetrationKind::mortar, "mortar penetration");
  more(PenetrationKind::edge, "edge penetration");
  std::uint64_t unlisted = 0;
  for (const ContactSummary& contact : report.contacts) unlisted += unlisted_penetrations(contact);
  if (unlisted > 0) out += fmt::format(", {} without a list of nodes", count(unlisted, "penetration"));
  if (total.deepest != nullptr) out += fmt::format("; deepest {:.6g}", total.deepest->depth);
  out += '\n';
}

}  // namespace

std::string statistics(const Report& report) {
  std::vector<std::pair<std::string, std::string>> lines = report.statistics;
  const auto time = [&](std::string_view what, double seconds) {
    lines.emplace_back(what, fmt::format("{:.3f} s", seconds));
  };
  time("time: reading", report.timing.read_s);
  time("time: model", report.timing.model_s);
  time("time: surfaces", report.timing.surface_s);
  time("time: search", report.timing.search_s);
  time("time: total", report.timing.total_s);
  std::size_t width = 0;
  for (const auto& line : lines) width = std::max(width, line.first.size());
  std::string out;
  for (const auto& [what, value] : lines)
    out += fmt::format("  {:<{}}  {}\n", printable(what), width, printable(value));
  return out;
}

namespace {

/// Contacts in the order of interest: those with records or without a judgement first.
std::vector<std::uint32_t> contacts_by_interest(const Report& report) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < report.contacts.size(); ++i) order.push_back(i);
  std::stable_partition(order.begin(), order.end(), [&](std::uint32_t i) {
    const ContactSummary& contact = report.contacts[i];
    return !records_of(report, i).empty() || !ties_of(report, i).empty() || !contact.not_checked.empty();
  });
  return order;
}

/// A line for each contact, at most `limit`.
std::vector<std::string> contact_lines(const Report& report, std::size_t limit, std::size_t width) {
  std::vector<std::string> lines;
  const auto order = contacts_by_interest(report);
  // The last line may have to say how many more there are.
  const std::size_t shown = order.size() <= limit ? order.size() : limit - 1;
  for (std::size_t i = 0; i < shown; ++i) {
    const ContactSummary& contact = report.contacts[order[i]];
    std::string line = fmt::format("contact {}", contact.id);
    if (!contact.title.empty()) line += fmt::format(" \"{}\"", printable(contact.title));
    if (!contact.type.empty()) line += fmt::format(" ({})", printable(contact.type));
    line += ": " + contact_result(report, order[i], sums(records_of(report, order[i])), Paint{false});
    lines.push_back(cut(std::move(line), width));
  }
  if (shown < order.size()) lines.push_back(count(order.size() - shown, shown == 0 ? "contact" : "more contact"));
  return lines;
}

/// The contact's and the elements' time step in one line; empty: unknown.
std::string timestep_line(const Report& report) {
  const Timesteps* steps = timesteps(report);
  if (steps == nullptr || (!report.run && steps->contact_timestep <= 0)) return "";
  std::string limits;
  append_timestep_limits(*steps, limits);
  if (limits.starts_with('\n')) limits.erase(0, 1);
  return limits;
}

constexpr std::size_t contacts_in_short = 6;
constexpr std::size_t lines_of_a_rule = 6;
constexpr std::size_t sum_lines_in_short = 3;
constexpr std::size_t portability_lines_in_short = 20;
constexpr std::size_t page_width = 110;

void append(const std::vector<std::string>& lines, std::string& out) {
  for (const std::string& line : lines) out += line + '\n';
}

std::size_t lines_in(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// What follows the findings: contacts, time steps, sums by rule.
std::string end_of_short(const Report& report, std::span<const FindingGroup> groups, const TextOptions& options,
                         const Paint& paint) {
  std::string out;
  const bool all = options.all || options.list;
  if (!all && !report.contacts.empty()) {
    out += '\n';
    append(contact_lines(report, contacts_in_short, options.width), out);
  }
  if (const std::string limits = timestep_line(report); !limits.empty()) out += '\n' + limits;
  auto sums = rule_sum_lines(groups, options.width > 0 ? options.width : page_width, paint);
  if (!all && sums.size() > sum_lines_in_short) sums.resize(sum_lines_in_short), sums.back() += " …";
  if (!sums.empty()) out += "\nby rule\n";
  append(sums, out);
  return out;
}

/// Ignored findings and those against the baseline.
std::string changes(const Report& report, const TextOptions& options) {
  std::string out;
  append_ignored(report, options.top, options.list, out);
  append_baseline(report, options.list ? no_limit : options.top, out);
  return out;
}

}  // namespace

std::string text(const Report& report, const TextOptions& options) {
  const Paint paint{options.color};
  std::string last = verdict(report, paint);
  if (options.quiet) return last;
  const bool all = options.all || options.list;
  std::string out = paint.bold(printable_path(report.input)) + '\n';
  out += report.run ? run_line(*report.run) : "  " + model_line(report.model) + '\n';
  if (const std::string assumed = as_if(report); !assumed.empty()) out += "  " + assumed + '\n';
  const auto groups = finding_groups(report);
  if (const auto lines = verdict_lines(report, groups, options.width, paint); !lines.empty())
    out += '\n', append(lines, out);
  const std::string end = end_of_short(report, groups, options, paint), changed = changes(report, options);
  if (!groups.empty()) {
    const std::size_t used = lines_in(out) + lines_in(end) + lines_in(changed) + 3;  // two blank lines, the last one
    const std::size_t left = std::max<std::size_t>(options.lines, used + 3) - used;
    out += '\n';
    const LineLimits limits{all ? no_limit : left, options.per_rule.value_or(all ? no_limit : lines_of_a_rule)};
    append(group_lines(report, groups, options, limits, paint), out);
  }
  Sums total;
  for (std::uint32_t i = 0; all && i < report.contacts.size(); ++i)
    total += append_contact_block(report, i, options, paint, out);
  if (options.list) append_findings_by_rule(report.findings, paint, out);
  if (report.run) {
    append_rigidwalls(*report.run, options.list ? report.run->rigidwalls.size() : options.top, out);
    append_messages(report, options.list, "--list", out);
  }
  if (all && report.contacts.size() > 1) append_total(report, total, out);
  out += end + changed;
  append_portability(report, all ? no_limit : portability_lines_in_short, out);
  if (options.stats) out += "\nstatistics\n" + statistics(report);
  return out + '\n' + last;
}

std::string text_of_all(const Reports& reports, const TextOptions& options) {
  Totals sum;
  for (const Report& report : reports.all) sum += totals(report);
  const Paint paint{options.color};
  std::string line = fmt::format("{}: {}", count(reports.all.size(), "deck"), numbers_of(sum, paint));
  std::size_t ignored = 0;
  for (const Report& report : reports.all) ignored += report.ignored.size();
  if (ignored > 0) line += fmt::format(", {} ignored", ignored);
  if (const auto counts = baseline_counts(reports)) line += "; against the baselines: " + summary(*counts);
  if (!reports.unread.empty())
    line += "; " + paint.severity(Severity::error, fmt::format("{} more not audited", reports.unread.size()));
  return line + '\n';
}

}  // namespace gapcheck::report
