#include "report/text/check_c_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "report/item/contact_keyword.hpp"
#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"
#include "report/item/sums.hpp"
#include "report/text/check_c_tables.hpp"
#include "report/text/text_run.hpp"

namespace gapcheck::report {
namespace {

std::string nodes(std::uint64_t count) { return fmt::format("{} node{}", count, count == 1 ? "" : "s"); }

std::string heading(const ContactSummary& contact, const CheckCOptions& options) {
  std::string line = fmt::format("interface {}", contact.id);
  if (options.title && !contact.title.empty()) line += fmt::format(" \"{}\"", printable(contact.title));
  if (options.type_code) line += "  type " + (contact.type.empty() ? "?" : printable(contact.type));
  if (options.type_keyword) line += "  " + contact_keyword(contact);
  return line + '\n';
}

/// ", top 5" if a table does not hold all of the nodes.
std::string shown(std::size_t count, std::size_t limit) {
  return limit < count ? fmt::format(", top {}", limit) : std::string();
}

/// The penetrating nodes of one kind: how many, the deepest, the table.
void append_kind(const Report& report, std::span<const Penetration* const> all, PenetrationKind kind,
                 std::string_view words, const CheckCOptions& options, std::string& out) {
  std::vector<const Penetration*> records;
  const Penetration* deepest = nullptr;
  for (const Penetration* record : all) {
    if (record->kind != kind) continue;
    records.push_back(record);
    if (deepest == nullptr || record->depth > deepest->depth) deepest = record;
  }
  if (records.empty()) return;
  const std::size_t limit = options.list ? records.size() : options.top;
  out += fmt::format("  {}: {}", words, nodes(records.size()));
  if (deepest->depth > 0) out += fmt::format(", deepest {:.4E} at node {}", deepest->depth, deepest->node);
  out += shown(records.size(), limit) + '\n';
  if (limit > 0) append_penetrations(report, records, limit, options.pid, out);
}

void append_tie_warnings(std::span<const TieFailure> failures, const CheckCOptions& options, std::string& out) {
  for (const TieReason reason : tie_reasons) {
    const auto records = in_view_order(failures, reason);
    if (records.empty()) continue;
    const std::size_t limit = options.list ? records.size() : options.top;
    out += fmt::format("  {}: {}, {}{}\n", name(reason), nodes(records.size()), what_happened(reason),
                       shown(records.size(), limit));
    if (limit > 0) append_ties(records, limit, options.pid, out);
  }
}

void append_histograms(const Report& report, std::span<const Penetration> records, std::span<const TieFailure> ties,
                       const CheckCOptions& options, std::string& out) {
  std::vector<double> depths, remaining, separations;
  for (const Penetration& record : records) {
    if (record.depth > 0) depths.push_back(record.depth);
    if (knows_remaining(report, record)) remaining.push_back(record.remaining());
  }
  for (const TieFailure& failure : ties)
    if (failure.distance >= 0) separations.push_back(failure.distance);
  append_buckets("buckets of penetration", depths, out);
  if (options.rsort) append_buckets("buckets of remaining distance", remaining, out);
  append_buckets("buckets of separation", separations, out);
}

void append_interface(const Report& report, std::uint32_t position, const CheckCOptions& options, std::string& out) {
  const ContactSummary& contact = report.contacts[position];
  const auto records = records_of(report, position);
  const auto ties = ties_of(report, position);
  const std::uint64_t unlisted = unlisted_penetrations(contact);
  const bool warned = !records.empty() || !ties.empty() || unlisted > 0;
  if (!warned && !options.all) return;
  out += '\n' + heading(contact, options);
  if (options.timestep && report.run) append_surface_timesteps(*report.run, position, out);
  if (!warned) out += "  no warnings\n";
  const auto order = in_view_order(report, records, options.rsort);
  append_kind(report, order, PenetrationKind::initial, "pen", options, out);
  append_kind(report, order, PenetrationKind::released, "below, too deep for contact", options, out);
  append_kind(report, order, PenetrationKind::edge_zone, "edge zone, not listed by the solver", options, out);
  append_kind(report, order, PenetrationKind::segment, "segments with SOFT = 2, not listed by the solver", options,
              out);
  append_kind(report, order, PenetrationKind::mortar, "mortar segments, not listed by the solver", options, out);
  append_kind(report, order, PenetrationKind::edge, "edges, not listed by the solver", options, out);
  if (unlisted > 0) out += fmt::format("  pen, counted without a list: {}\n", nodes(unlisted));
  if (const std::string said = summary_line(contact); !said.empty()) out += "  " + said + '\n';
  append_tie_warnings(ties, options, out);
  if (options.bucket) append_histograms(report, records, ties, options, out);
  if (options.psum && records.size() + ties.size() > 0) append_part_sums(order, ties, out);
}

void append_total_of_interfaces(const Report& report, std::string& out) {
  std::uint64_t penetrations = report.penetrations.size(), untied_nodes = 0;
  std::set<std::uint32_t> interfaces;
  for (std::uint32_t i = 0; i < report.contacts.size(); ++i) {
    const std::uint64_t unlisted = unlisted_penetrations(report.contacts[i]);
    penetrations += unlisted;
    if (unlisted > 0) interfaces.insert(i);
  }
  for (const Penetration& record : report.penetrations) interfaces.insert(record.contact);
  for (const TieFailure& failure : report.tie_failures) {
    interfaces.insert(failure.contact);
    untied_nodes += untied(failure.reason);
  }
  out += fmt::format("\ntotal: {} penetrating, {} with tie warnings ({} untied), in {} of {} interfaces\n",
                     nodes(penetrations), nodes(report.tie_failures.size()), untied_nodes, interfaces.size(),
                     report.contacts.size());
}

}  // namespace

Report top_only(const Report& picked, const CheckCOptions& options) {
  Report top = picked;
  top.penetrations.clear();
  top.tie_failures.clear();
  for (std::uint32_t i = 0; i < picked.contacts.size(); ++i) {
    const auto take = [&](const auto& order, auto& list) {
      for (std::size_t k = 0; k < std::min(options.top, order.size()); ++k) list.push_back(*order[k]);
    };
    take(in_view_order(picked, records_of(picked, i), options.rsort), top.penetrations);
    for (const TieReason reason : tie_reasons) take(in_view_order(ties_of(picked, i), reason), top.tie_failures);
  }
  return top;
}

std::string check_c_text(const Report& picked, const CheckCOptions& options) {
  std::string out = printable_path(picked.input) + '\n';
  if (picked.run) out += run_line(*picked.run);
  for (std::uint32_t i = 0; i < picked.contacts.size(); ++i) append_interface(picked, i, options, out);
  if (picked.run) {
    append_rigidwalls(*picked.run, options.list ? picked.run->rigidwalls.size() : options.top, out);
    append_messages(picked, options.list, "-list", out);
    if (options.timestep) append_timestep_limits(*picked.run, out);
  }
  append_total_of_interfaces(picked, out);
  return out;
}

}  // namespace gapcheck::report
