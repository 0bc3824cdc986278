#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "report/baseline/baseline.hpp"
#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"
#include "report/item/sums.hpp"
#include "report/text/check_c_tables.hpp"
#include "report/text/check_c_view.hpp"
#include "report/text/text_baseline.hpp"
#include "report/text/text_ignored.hpp"
#include "report/text/text_run.hpp"
#include "report/write/table.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report {
namespace {

constexpr std::size_t findings_in_full = 10;
constexpr std::size_t pairs_in_full = 20;

/// ANSI colours, or nothing.
struct Paint {
  bool on;
  [[nodiscard]] std::string operator()(std::string_view code, std::string_view text) const {
    return on ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : std::string(text);
  }
  [[nodiscard]] std::string bold(std::string_view text) const { return (*this)("1", text); }
  [[nodiscard]] std::string severity(Severity severity, std::string_view text) const {
    return (*this)(severity == Severity::error ? "31" : severity == Severity::warning ? "33" : "36", text);
  }
};

std::string count(std::uint64_t number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

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

constexpr std::array node_columns{
    Column{"node"},
    Column{"part"},
    Column{"element"},
    Column{"part"},
    Column{"penetration"},
    Column{"remaining"},
    Column{"distance"},
    Column{"ratio"},
    Column{"s"},
    Column{"t"},
    Column{"feature", Align::left},
    Column{"outcome", Align::left},
    Column{"moved to", Align::left},
};

constexpr std::array pair_columns{
    Column{"part of node"}, Column{"part of segment"}, Column{"nodes"},
    Column{"deepest"},      Column{"distance"},        Column{"thickness from", Align::left},
};

void fill_node(const Penetration& record, Row<node_columns.size()>& row) {
  const auto real = [](double value) { return fmt::format("{:.6g}", value); };
  const auto& n = record.segment;
  row[0] = fmt::format("{}", record.node);
  row[1] = id_or_dash(record.part);
  row[2] = record.element != 0 ? fmt::format("{}", record.element)
           : n[0] != 0         ? fmt::format("{}-{}-{}-{}", n[0], n[1], n[2], n[3])
                               : "-";
  row[3] = id_or_dash(record.element_part);
  row[4] = real(record.depth);
  row[5] = real(record.remaining());
  row[6] = real(record.contact_distance);
  row[7] = record.contact_distance > 0 ? fmt::format("{:.3f}", record.depth / record.contact_distance) : "-";
  row[8] = std::isfinite(record.s) ? fmt::format("{:.3f}", record.s) : "-";
  row[9] = std::isfinite(record.t) ? fmt::format("{:.3f}", record.t) : "-";
  row[10] = name(record.feature);
  row[11] = record.kind == PenetrationKind::edge_zone ? "not listed" : std::string(name(record.outcome));
  const Vector& x = record.moved_to;
  row[12] = record.outcome == Outcome::moved || x != record.original
                ? fmt::format("{}{:.6g} {:.6g} {:.6g}", record.recommended() ? "recommended: " : "", x[0], x[1], x[2])
                : "";
  if (record.element != 0 || n[0] != 0) return;
  // A line of a log that names little more than the node.
  if (record.depth == 0) row[4] = "-";
  if (record.contact_distance == 0) row[5] = row[6] = "-";
  row[8] = row[9] = row[10] = "-";
}

/// The tables of a contact.
enum class Table { nodes, edges, edge_zone };

Table table_of(PenetrationKind kind) {
  if (kind == PenetrationKind::edge_zone) return Table::edge_zone;
  return kind == PenetrationKind::edge ? Table::edges : Table::nodes;
}

/// The first `limit` records of one table, already deepest first.
std::vector<const Penetration*> deepest(std::span<const Penetration> records, Table table, std::size_t limit) {
  std::vector<const Penetration*> picked;
  for (const Penetration& record : records) {
    if (picked.size() >= limit) break;
    if (table_of(record.kind) == table) picked.push_back(&record);
  }
  return picked;
}

void append_node_table(std::span<const Penetration> records, Table table, std::size_t total, std::string_view what,
                       const TextOptions& options, std::string& out) {
  const std::size_t limit = options.list ? total : std::min(total, options.top);
  if (limit == 0) return;
  const auto picked = deepest(records, table, limit);
  out += picked.size() < total ? fmt::format("\n  {}, deepest {} of {}\n", what, picked.size(), total)
                               : fmt::format("\n  {}\n", what);
  append_table(
      node_columns, picked.size(), [&](std::size_t i, auto& row) { fill_node(*picked[i], row); }, "    ", out);
}

void fill_pair(const PartPair& pair, Row<pair_columns.size()>& row) {
  fmt::memory_buffer cause;
  append_cause(*pair.deepest, cause);
  row = {id_or_dash(pair.part),
         id_or_dash(pair.element_part),
         fmt::format("{}", pair.nodes),
         fmt::format("{:.6g}", pair.deepest->depth),
         fmt::format("{:.6g}", pair.deepest->contact_distance),
         fmt::to_string(cause)};
}

void append_part_pairs(const std::vector<PartPair>& pairs, std::string_view title, const TextOptions& options,
                       std::string& out) {
  const std::size_t shown = options.list ? pairs.size() : std::min(pairs.size(), pairs_in_full);
  out += fmt::format("\n  {}\n", title);
  append_table(
      pair_columns, shown, [&](std::size_t i, auto& row) { fill_pair(pairs[i], row); }, "    ", out);
  if (shown < pairs.size()) out += fmt::format("    … and {} more\n", pairs.size() - shown);
}

std::string contact_title(const ContactSummary& contact, const Paint& paint) {
  std::string line = paint.bold(fmt::format("contact {}", contact.id));
  if (!contact.title.empty()) line += fmt::format(" \"{}\"", printable(contact.title));
  if (!contact.type.empty()) line += fmt::format("  type {}", printable(contact.type));
  if (!contact.keyword.empty()) line += "  " + printable(contact.keyword);
  if (!contact.file.empty()) line += "  " + printable_path(contact.file);
  if (!contact.file.empty() && contact.line != 0) line += fmt::format(":{}", contact.line);
  return line + '\n';
}

/// `unlisted`: penetrating nodes that a log counts without listing them.
std::string result_line(const Report& report, const Sums& sum, std::uint64_t unlisted, const Paint& paint) {
  if (unlisted > 0)
    return (sum.penetrations() > 0 ? result_line(report, sum, 0, paint) + ", " : "") +
           paint.severity(Severity::warning, count(unlisted, "penetration") + " without a list of nodes");
  std::string line = sum.penetrations() == 0 ? "no penetrations" : "";
  const auto add = [&](PenetrationKind kind, std::string_view noun) {
    if (const std::size_t number = sum.of(kind); number > 0)
      line += (line.empty() ? "" : ", ") + paint.severity(rule_of(report, kind).severity, count(number, noun));
  };
  add(PenetrationKind::initial, "penetration");
  add(PenetrationKind::released, "released node");
  add(PenetrationKind::segment, "segment penetration");
  add(PenetrationKind::mortar, "mortar penetration");
  add(PenetrationKind::edge, "edge penetration");
  if (sum.deepest != nullptr) line += fmt::format(", deepest {:.6g} at node {}", sum.deepest->depth, sum.deepest->node);
  if (const std::size_t number = sum.of(PenetrationKind::edge_zone); number > 0)
    line += ", " + paint.severity(rule_of(report, PenetrationKind::edge_zone).severity,
                                  count(number, "node") + " in the edge zone");
  return line;
}

/// "50 tracked nodes, 32 segments: "; unknown values of solver files are left out.
std::string size_of(const Report& report, const ContactSummary& contact) {
  const bool deck = report.source == "deck";
  std::string text;
  if (deck || contact.tracked_nodes != 0) text = count(contact.tracked_nodes, "tracked node");
  if (deck || contact.segments != 0) text += (text.empty() ? "" : ", ") + count(contact.segments, "segment");
  return text.empty() ? text : text + ": ";
}

/// These parts are unknown.
bool unknown(const std::vector<PartPair>& pairs) {
  return std::all_of(pairs.begin(), pairs.end(), [](const PartPair& p) { return p.part == 0 && p.element_part == 0; });
}

/// One table per reason why nodes of a tied contact need attention.
void append_tie_sections(const Report& report, std::span<const TieFailure> failures, const TextOptions& options,
                         const Paint& paint, std::string& out) {
  for (const TieReason reason : tie_reasons) {
    const auto records = in_view_order(failures, reason);
    if (records.empty()) continue;
    const std::size_t limit = options.list ? records.size() : options.top;
    out += fmt::format("\n  {}: {}, {}", paint.severity(rule_of(report, *records.front()).severity, name(reason)),
                       count(records.size(), "node"), what_happened(reason));
    out += limit < records.size() ? fmt::format(", first {} of {}\n", limit, records.size()) : "\n";
    if (limit > 0) append_ties(records, limit, true, out);
  }
}

/// Returns the sums of the contact's records.
Sums append_contact_block(const Report& report, std::uint32_t position, const TextOptions& options, const Paint& paint,
                          std::string& out) {
  const ContactSummary& contact = report.contacts[position];
  const auto records = records_of(report, position);
  Sums sum = sums(records);
  out += '\n' + contact_title(contact, paint);
  const auto ties = ties_of(report, position);
  const std::uint64_t unlisted = unlisted_penetrations(contact);
  if (!records.empty() || unlisted > 0 || (contact.not_checked.empty() && !contact.ties_judged && ties.empty()))
    out += "  " + size_of(report, contact) + result_line(report, sum, unlisted, paint) + '\n';
  if (const std::string said = summary_line(contact); !said.empty()) out += "  " + said + '\n';
  if (const Timesteps* steps = timesteps(report)) append_surface_timesteps(*steps, position, out);
  if (contact.ties > 0 || contact.ties_judged) out += fmt::format("  {} tied\n", count(contact.ties, "node"));
  if (contact.untied > 0) out += fmt::format("  {} untied\n", count(contact.untied, "node"));
  if (contact.out_of_reach > 0)
    out += fmt::format("  {} out of reach, not meant to tie\n", count(contact.out_of_reach, "node"));
  if (contact.judged_nearest > 0)
    out += fmt::format("  judged in part: {} nodes and edges, by the nearest of too many\n", contact.judged_nearest);
  if (!contact.not_checked.empty()) out += "  not checked: " + printable(contact.not_checked) + '\n';
  append_node_table(records, Table::nodes, sum.nodes(), "penetrating nodes", options, out);
  if (report.source == "deck" ? !sum.pairs.empty() : !unknown(sum.pairs))
    append_part_pairs(sum.pairs, "by part", options, out);
  append_node_table(records, Table::edges, sum.of(PenetrationKind::edge), "penetrating edges", options, out);
  if (!sum.edge_pairs.empty()) append_part_pairs(sum.edge_pairs, "edges by part", options, out);
  append_node_table(records, Table::edge_zone, sum.of(PenetrationKind::edge_zone), "nodes in the edge zone", options,
                    out);
  append_tie_sections(report, ties, options, paint, out);
  return sum;
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

/// The findings of one rule, which are consecutive. Lines that represent many do not give way to single ones.
void append_findings_of_rule(std::span<const Finding> findings, const TextOptions& options, const Paint& paint,
                             std::string& out) {
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
  std::size_t single = 0, summed = 0, shown = 0;
  for (const Finding& finding : findings) {
    std::size_t& kind = finding.count > 1 ? summed : single;
    if (!options.list && kind >= findings_in_full) continue;
    append_finding_line(finding, out);
    ++kind, ++shown;
  }
  if (shown < findings.size()) out += fmt::format("  … and {} more\n", findings.size() - shown);
}

void append_findings_by_rule(std::span<const Finding> findings, const TextOptions& options, const Paint& paint,
                             std::string& out) {
  while (!findings.empty()) {
    const auto end = std::find_if(findings.begin(), findings.end(),
                                  [&](const Finding& finding) { return finding.id != findings.front().id; });
    const auto length = static_cast<std::size_t>(end - findings.begin());
    append_findings_of_rule(findings.first(length), options, paint, out);
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

/// The line that --quiet keeps.
std::string verdict(const Report& report, const Paint& paint) {
  std::string line = printable_path(report.input) + ": " + numbers_of(totals(report), paint);
  line += " in " + count(report.contacts.size(), "contact");
  if (const std::string assumed = as_if(report); !assumed.empty()) line += ", " + assumed;
  const auto open =
      static_cast<std::size_t>(std::count_if(report.contacts.begin(), report.contacts.end(),
                                             [](const auto& contact) { return !contact.not_checked.empty(); }));
  if (open > 0) line += fmt::format(", {} not checked", open);
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

std::string text(const Report& report, const TextOptions& options) {
  const Paint paint{options.color};
  if (options.quiet) return verdict(report, paint);
  std::string out = paint.bold(printable_path(report.input)) + '\n';
  out += report.run ? run_line(*report.run) : "  " + model_line(report.model) + '\n';
  if (const std::string assumed = as_if(report); !assumed.empty()) out += "  " + assumed + '\n';
  Sums total;
  for (std::uint32_t i = 0; i < report.contacts.size(); ++i) {
    const Sums sum = append_contact_block(report, i, options, paint, out);
    for (std::size_t k = 0; k < total.count.size(); ++k) total.count[k] += sum.count[k];
    if (sum.deepest != nullptr && (total.deepest == nullptr || sum.deepest->depth > total.deepest->depth))
      total.deepest = sum.deepest;
  }
  append_findings_by_rule(report.findings, options, paint, out);
  if (report.run) {
    append_rigidwalls(*report.run, options.list ? report.run->rigidwalls.size() : options.top, out);
    append_messages(report, options.list, "--list", out);
  }
  const Timesteps* steps = timesteps(report);
  if (steps != nullptr && (report.run || steps->contact_timestep > 0)) append_timestep_limits(*steps, out);
  if (report.contacts.size() > 1) append_total(report, total, out);
  append_ignored(report, options.top, options.list, out);
  append_baseline(report, options.list ? std::numeric_limits<std::size_t>::max() : options.top, out);
  if (options.stats) out += "\nstatistics\n" + statistics(report);
  out += '\n' + verdict(report, paint);
  return out;
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
