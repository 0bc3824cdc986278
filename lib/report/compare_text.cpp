#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <span>

#include "report/compare.hpp"
#include "report/describe.hpp"
#include "report/table.hpp"

namespace gapcheck::report {
namespace {

std::string note(const ContactComparison& contact) {
  if (contact.not_checked) return "not checked in one of them";
  std::string text = contact.counts_only ? "only numbers of nodes are known" : "";
  const auto add = [&](std::string_view part) { text += (text.empty() ? "" : ", ") + std::string(part); };
  if (contact.missing_in_first) add("not in A");
  if (contact.missing_in_second) add("not in B");
  return text;
}

std::string depth(double value) {
  if (value < 0) return "-";
  return value > 0 ? fmt::format("{:.6g}", value) : "?";
}

void append_contacts(const Comparison& comparison, std::string& out) {
  constexpr std::array columns{Column{"contact"}, Column{"type"},   Column{"agree"},      Column{"depth differs"},
                               Column{"only A"},  Column{"only B"}, Column{"by at most"}, Column{"", Align::left}};
  append_table(
      columns, comparison.contacts.size(),
      [&](std::size_t i, auto& row) {
        const ContactComparison& c = comparison.contacts[i];
        row = {fmt::format("{}", c.id),
               c.type.empty() ? "-" : printable(c.type),
               fmt::format("{}", c.agree),
               fmt::format("{}", c.depth_differs),
               fmt::format("{}", c.only_first),
               fmt::format("{}", c.only_second),
               fmt::format("{:.3g}", c.largest_difference),
               note(c)};
      },
      "  ", out);
}

/// The largest differences of one contact, which stand together.
void append_differences(std::span<const Difference> differences, std::size_t top, std::string& out) {
  constexpr std::array columns{Column{"node"}, Column{"A"}, Column{"B"}};
  const std::size_t rows = std::min(top, differences.size());
  out += fmt::format("\ncontact {}: {} node{} differ{}", differences.front().contact, differences.size(),
                     differences.size() == 1 ? "" : "s", differences.size() == 1 ? "s" : "");
  out += rows < differences.size() ? fmt::format(", largest {}\n", rows) : "\n";
  if (rows == 0) return;
  append_table(
      columns, rows,
      [&](std::size_t i, auto& row) {
        row = {fmt::format("{}", differences[i].node), depth(differences[i].first), depth(differences[i].second)};
      },
      "  ", out);
}

nlohmann::ordered_json contact_json(const ContactComparison& c) {
  nlohmann::ordered_json json{{"id", c.id}};
  if (!c.title.empty()) json["title"] = c.title;
  if (!c.type.empty()) json["type"] = c.type;
  json["agree"] = c.agree;
  json["depth_differs"] = c.depth_differs;
  json["only_first"] = c.only_first;
  json["only_second"] = c.only_second;
  json["largest_difference"] = c.largest_difference;
  if (c.missing_in_first) json["missing_in_first"] = true;
  if (c.missing_in_second) json["missing_in_second"] = true;
  if (c.not_checked) json["not_checked"] = true;
  if (c.counts_only) json["counts_only"] = true;
  return json;
}

}  // namespace

std::string comparison_text(const Comparison& comparison, const Report& first, const Report& second, std::size_t top) {
  std::string out = fmt::format("A: {}\nB: {}\n\n", printable(first.input), printable(second.input));
  append_contacts(comparison, out);
  std::span<const Difference> rest = comparison.differences;
  while (!rest.empty()) {
    const auto end =
        std::find_if(rest.begin(), rest.end(), [&](const Difference& d) { return d.contact != rest.front().contact; });
    const auto length = static_cast<std::size_t>(end - rest.begin());
    append_differences(rest.first(length), top, out);
    rest = rest.subspan(length);
  }
  const auto open = std::count_if(comparison.contacts.begin(), comparison.contacts.end(),
                                  [](const ContactComparison& c) { return c.not_checked; });
  std::uint64_t agree = 0;
  for (const ContactComparison& contact : comparison.contacts) agree += contact.agree;
  out += comparison.equal() ? "\nno differences" : "\nthe two differ";
  out += fmt::format(", {} node{} agree{}", agree, agree == 1 ? "" : "s", agree == 1 ? "s" : "");
  if (open > 0) out += fmt::format(", {} contact{} not compared", open, open == 1 ? "" : "s");
  return out + '\n';
}

std::string comparison_json(const Comparison& comparison, const Report& first, const Report& second) {
  nlohmann::ordered_json json{{"schema", "gapcheck-compare/1"},
                              {"first", {{"source", first.source}, {"input", first.input}}},
                              {"second", {{"source", second.source}, {"input", second.input}}},
                              {"equal", comparison.equal()},
                              {"contacts", nlohmann::ordered_json::array()},
                              {"differences", nlohmann::ordered_json::array()}};
  for (const ContactComparison& contact : comparison.contacts) json["contacts"].push_back(contact_json(contact));
  for (const Difference& d : comparison.differences) {
    nlohmann::ordered_json entry{{"contact", d.contact}, {"node", d.node}};
    if (d.first >= 0) entry["first"] = d.first;
    if (d.second >= 0) entry["second"] = d.second;
    json["differences"].push_back(std::move(entry));
  }
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

}  // namespace gapcheck::report
