#include "report/text/text_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"
#include "report/text/check_c_tables.hpp"
#include "report/text/check_c_view.hpp"
#include "report/text/text_run.hpp"
#include "report/write/table.hpp"

namespace gapcheck::report {
namespace {

constexpr std::size_t pairs_in_full = 20;

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

/// "120 nodes tied, 3 untied".
std::string tie_line(const ContactSummary& contact, const Paint& paint) {
  std::string line = count(contact.ties, "node") + " tied";
  if (contact.untied > 0) line += ", " + paint.severity(Severity::warning, fmt::format("{} untied", contact.untied));
  if (contact.out_of_reach > 0)
    line += fmt::format(", {} out of reach, not meant to tie", count(contact.out_of_reach, "node"));
  return line;
}

/// The contact ties, or its nodes were judged as ties.
bool tied(const ContactSummary& contact) {
  return contact.ties + contact.untied + contact.out_of_reach > 0 || contact.ties_judged;
}

}  // namespace

std::string contact_result(const Report& report, std::uint32_t position, const Sums& sum, const Paint& paint) {
  const ContactSummary& contact = report.contacts[position];
  const std::uint64_t unlisted = unlisted_penetrations(contact);
  std::string line;
  const bool penetrations = !records_of(report, position).empty() || unlisted > 0;
  if (penetrations || (contact.not_checked.empty() && !contact.ties_judged && ties_of(report, position).empty()))
    line = size_of(report, contact) + result_line(report, sum, unlisted, paint);
  if (tied(contact)) line += (line.empty() ? size_of(report, contact) : "; ") + tie_line(contact, paint);
  if (contact.judged_nearest > 0)
    line += fmt::format("; judged in part: {} nodes and edges, by the nearest of too many", contact.judged_nearest);
  if (!contact.not_checked.empty())
    line += (line.empty() ? "not judged: " : "; not judged: ") + printable(contact.not_checked);
  return line;
}

Sums append_contact_block(const Report& report, std::uint32_t position, const TextOptions& options, const Paint& paint,
                          std::string& out) {
  const ContactSummary& contact = report.contacts[position];
  const auto records = records_of(report, position);
  Sums sum = sums(records);
  out += '\n' + contact_title(contact, paint);
  if (const std::string line = contact_result(report, position, sum, paint); !line.empty()) out += "  " + line + '\n';
  if (const std::string said = summary_line(contact); !said.empty()) out += "  " + said + '\n';
  if (const Timesteps* steps = timesteps(report)) append_surface_timesteps(*steps, position, out);
  append_node_table(records, Table::nodes, sum.nodes(), "penetrating nodes", options, out);
  if (report.source == "deck" ? !sum.pairs.empty() : !unknown(sum.pairs))
    append_part_pairs(sum.pairs, "by part", options, out);
  append_node_table(records, Table::edges, sum.of(PenetrationKind::edge), "penetrating edges", options, out);
  if (!sum.edge_pairs.empty()) append_part_pairs(sum.edge_pairs, "edges by part", options, out);
  append_node_table(records, Table::edge_zone, sum.of(PenetrationKind::edge_zone), "nodes in the edge zone", options,
                    out);
  append_tie_sections(report, ties_of(report, position), options, paint, out);
  return sum;
}

}  // namespace gapcheck::report
