#include "report/text/check_c_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "report/write/table.hpp"

namespace gapcheck::report {
namespace {

constexpr std::string_view table_indent = "    ";

std::string real(double value) { return fmt::format("{:.4E}", value); }

/// "22124 22164 22165 22125"; a triangle has three nodes; the running number where the nodes are unknown.
std::string segment_text(const Penetration& record) {
  const auto& n = record.segment;
  if (n[0] == 0) return record.segment_number == 0 ? "-" : fmt::format("#{}", record.segment_number);
  std::string text = fmt::format("{} {} {}", n[0], n[1], n[2]);
  if (n[3] != n[2]) text += fmt::format(" {}", n[3]);
  return text;
}

/// The same columns without the one at `place`.
template <class Cells, std::size_t N = std::tuple_size_v<Cells>>
std::array<typename Cells::value_type, N - 1> without(const Cells& cells, std::size_t place) {
  std::array<typename Cells::value_type, N - 1> rest{};
  for (std::size_t i = 0, k = 0; i < N; ++i)
    if (i != place) rest[k++] = cells[i];
  return rest;
}

/// A table whose second column holds parts; it is left out if not requested.
template <std::size_t N, class Cells>
void append_with_part(const std::array<Column, N>& columns, bool pid, std::size_t rows, const Cells& cells,
                      std::string& out) {
  if (pid)
    return append_table(
        columns, rows, [&](std::size_t i, Row<N>& row) { row = cells(i); }, table_indent, out);
  append_table(
      without(columns, 1), rows, [&](std::size_t i, Row<N - 1>& row) { row = without(cells(i), 1); }, table_indent,
      out);
}

}  // namespace

std::vector<const Penetration*> in_view_order(const Report& report, std::span<const Penetration> records, bool rsort) {
  std::vector<const Penetration*> order;
  order.reserve(records.size());
  for (const Penetration& record : records) order.push_back(&record);
  const auto key = [&](const Penetration* p) {
    const bool unknown = rsort && !knows_remaining(report, *p);
    const double amount = rsort && !unknown ? p->remaining() : -p->depth;
    return std::tuple(unknown, std::isnan(amount) ? 0 : amount, p->node);  // NaN has no place in an order
  };
  std::stable_sort(order.begin(), order.end(), [&](const auto* a, const auto* b) { return key(a) < key(b); });
  return order;
}

std::vector<const TieFailure*> in_view_order(std::span<const TieFailure> failures, TieReason reason) {
  std::vector<const TieFailure*> order;
  for (const TieFailure& failure : failures)
    if (failure.reason == reason) order.push_back(&failure);
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) {
    return std::tuple(b->distance, a->node) < std::tuple(a->distance, b->node);
  });
  return order;
}

std::span<const TieFailure> ties_of(const Report& report, std::uint32_t contact) {
  const auto [first, last] =
      std::equal_range(report.tie_failures.begin(), report.tie_failures.end(), TieFailure{.contact = contact},
                       [](const TieFailure& a, const TieFailure& b) { return a.contact < b.contact; });
  return {first, last};
}

std::array<std::size_t, bucket_count> buckets(std::span<const double> values, double largest) {
  std::array<std::size_t, bucket_count> counts{};
  for (const double value : values) {
    const double tenth = largest > 0 ? value / largest * bucket_count : 0;
    ++counts[tenth > 0 ? static_cast<std::size_t>(std::min(tenth, double{bucket_count - 1})) : 0];
  }
  return counts;
}

void append_penetrations(const Report& report, std::span<const Penetration* const> records, std::size_t limit, bool pid,
                         std::string& out) {
  constexpr std::array columns{Column{"node"}, Column{"part"}, Column{"segment nodes", Align::left},
                               Column{"penetration"}, Column{"remaining"}};
  const auto cells = [&](std::size_t i) {
    const Penetration& p = *records[i];
    return Row<columns.size()>{fmt::format("{}", p.node), id_or_dash(p.part), segment_text(p),
                               p.depth > 0 ? real(p.depth) : "-",
                               knows_remaining(report, p) ? real(p.remaining()) : "-"};
  };
  append_with_part(columns, pid, std::min(limit, records.size()), cells, out);
}

void append_ties(std::span<const TieFailure* const> failures, std::size_t limit, bool pid, std::string& out) {
  constexpr std::array columns{Column{"node"}, Column{"part"}, Column{"segment"}, Column{"separation"},
                               Column{"tie distance"}};
  const auto cells = [&](std::size_t i) {
    const TieFailure& t = *failures[i];
    return Row<columns.size()>{fmt::format("{}", t.node), id_or_dash(t.part), id_or_dash(t.segment_number),
                               t.distance >= 0 ? real(t.distance) : "-", t.allowed >= 0 ? real(t.allowed) : "-"};
  };
  // Solver files do not give the tie distance.
  const std::size_t rows = std::min(limit, failures.size());
  if (std::any_of(failures.begin(), failures.end(), [](const TieFailure* t) { return t->allowed >= 0; }))
    return append_with_part(columns, pid, rows, cells, out);
  append_with_part(
      without(columns, 4), pid, rows, [&](std::size_t i) { return without(cells(i), 4); }, out);
}

void append_buckets(std::string_view title, std::span<const double> values, std::string& out) {
  if (values.empty()) return;
  constexpr std::array columns{Column{"from"}, Column{"to"}, Column{"nodes"}};
  const double largest = *std::max_element(values.begin(), values.end());
  const auto counts = buckets(values, largest);
  const auto border = [&](std::size_t i) { return real(largest * static_cast<double>(i) / bucket_count); };
  out += fmt::format("  {}\n", title);
  append_table(
      columns, bucket_count,
      [&](std::size_t i, auto& row) {
        row = {border(i), border(i + 1), fmt::format("{}", counts[i])};
      },
      table_indent, out);
}

void append_part_sums(std::span<const Penetration* const> records, std::span<const TieFailure> ties, std::string& out) {
  struct Sum {
    std::size_t penetrations = 0, ties = 0;
    double deepest = 0;
  };
  std::map<std::int64_t, Sum> sums;
  for (const Penetration* record : records) {
    Sum& sum = sums[record->part];
    ++sum.penetrations;
    sum.deepest = std::max(sum.deepest, record->depth);
  }
  for (const TieFailure& failure : ties) ++sums[failure.part].ties;
  constexpr std::array columns{Column{"part"}, Column{"penetrations"}, Column{"deepest"}, Column{"tie warnings"}};
  auto entry = sums.begin();
  out += "  by part\n";
  append_table(
      columns, sums.size(),
      [&](std::size_t i, auto& row) {
        if (i == 0) entry = sums.begin();
        const auto& [part, sum] = *entry++;
        row = {id_or_dash(part), fmt::format("{}", sum.penetrations), sum.deepest > 0 ? real(sum.deepest) : "-",
               fmt::format("{}", sum.ties)};
      },
      table_indent, out);
}

}  // namespace gapcheck::report
