#include "report/html/html_index.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

#include "report/baseline/rule_counts.hpp"
#include "report/item/describe.hpp"
#include "report/item/finding_groups.hpp"
#include "report/item/item.hpp"
#include "report/write/percent_encoding.hpp"
#include "report/write/plain_page.hpp"
#include "report/write/xml_text.hpp"

namespace gapcheck::report {
namespace {

/// The way from the index to a page.
std::string link_between(const std::string& index, const std::string& page) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path from = fs::absolute(index, error).lexically_normal().parent_path();
  const fs::path to = fs::absolute(page, error).lexically_normal();
  const fs::path way = to.lexically_relative(from);
  return percent_encoded((way.empty() ? to : way).string());
}

/// "1 deck", "2 decks".
std::string number_of_things(std::size_t number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

/// What represents a group, as lists show it.
Item representative(const Report& report, const FindingGroup& group) {
  if (group.deepest != nullptr) return item_of(report, *group.deepest);
  if (group.widest != nullptr) return item_of(report, *group.widest);
  return item_of(*group.first);
}

struct IndexRow {
  int rank = 0;  ///< gravest first
  std::string text;
};

IndexRow row_of(const Report& report, const std::string& index) {
  constexpr std::size_t longest = 400;
  const Totals sum = totals(report);
  const int rank = sum.errors > 0 ? 1 : sum.warnings > 0 ? 2 : sum.notes > 0 ? 3 : 4;
  constexpr std::string_view classes[] = {"unread", "error", "warning", "note", "clean"};
  constexpr std::string_view verdicts[] = {"not audited", "errors", "warnings", "notes", "nothing found"};
  const std::string link = report.page.empty() ? std::string() : link_between(index, report.page);
  std::string deck = xml_text(report.input), worst;
  if (!link.empty()) deck = fmt::format("<a href=\"{}\">{}</a>", link, deck);
  if (const auto groups = finding_groups(report); !groups.empty()) {
    const Item item = representative(report, groups.front());
    worst = xml_text(fmt::format("{} {}: ", item.id, item.rule));
    if (groups.front().contact != 0) worst += fmt::format("contact {}: ", groups.front().contact);
    worst += xml_text(shortened(item.message, longest));
    if (!link.empty()) worst = fmt::format("<a href=\"{}#f{}\">{}</a>", link, number_of(report, groups.front()), worst);
  }
  const auto at = static_cast<std::size_t>(rank);
  return {rank, fmt::format("<tr><td>{}</td><td class=\"{}\">{}</td><td class=\"number\">{}</td>"
                            "<td class=\"number\">{}</td><td class=\"number\">{}</td><td>{}</td></tr>\n",
                            deck, classes[at], verdicts[at], sum.errors, sum.warnings, sum.notes, worst)};
}

IndexRow row_of(const Unread& unread) {
  return {0, fmt::format("<tr><td>{}</td><td class=\"unread\">not audited</td><td></td><td></td><td></td>"
                         "<td>{}</td></tr>\n",
                         xml_text(unread.deck), xml_text(unread.reason))};
}

/// The rules under a heading; nothing if none has found anything.
std::string rules_table(const Reports& reports) {
  const auto rules = rule_counts(reports.all);
  if (rules.empty()) return "";
  const bool with_baseline = baseline_counts(reports).has_value();
  std::string table = "<h1>Rules</h1>\n<table>\n<tr><th>rule</th><th>severity</th>";
  const auto title = [&](std::string_view text) { table += fmt::format("<th class=\"number\">{}</th>", text); };
  const auto cell = [&](std::size_t number) { table += fmt::format("<td class=\"number\">{}</td>", number); };
  for (const char* text : {"decks", "findings"}) title(text);
  if (with_baseline)
    for (const char* text : {"new", "worse", "unchanged", "gone"}) title(text);
  for (const RuleCount& rule : rules) {
    table += fmt::format("</tr>\n<tr><td>{} {}</td><td class=\"{}\">{}</td>", xml_text(rule.id), xml_text(rule.rule),
                         name(rule.severity), name(rule.severity));
    const BaselineCounts& counts = rule.baseline;
    for (const std::size_t number : {rule.decks, rule.findings}) cell(number);
    if (with_baseline)
      for (const std::size_t number : {counts.fresh, counts.worse, counts.unchanged, counts.gone}) cell(number);
  }
  return table + "</tr>\n</table>\n";
}

}  // namespace

std::string html_index(const Reports& reports, const std::string& path, std::string_view version) {
  std::vector<IndexRow> rows;
  Totals sum;
  for (const Unread& unread : reports.unread) rows.push_back(row_of(unread));
  for (const Report& report : reports.all) {
    rows.push_back(row_of(report, path));
    sum += totals(report);
  }
  std::stable_sort(rows.begin(), rows.end(), [](const IndexRow& a, const IndexRow& b) { return a.rank < b.rank; });
  std::string page(plain_page_head);
  page += fmt::format("<h1>{}: {}, {}, {}{}</h1>\n", number_of_things(rows.size(), "deck"),
                      number_of_things(sum.errors, "error"), number_of_things(sum.warnings, "warning"),
                      number_of_things(sum.notes, "note"),
                      reports.unread.empty() ? "" : fmt::format("; {} not audited", reports.unread.size()));
  page +=
      "<table>\n<tr><th>deck</th><th>verdict</th><th class=\"number\">errors</th><th class=\"number\">warnings</th>"
      "<th class=\"number\">notes</th><th>worst finding</th></tr>\n";
  for (const IndexRow& row : rows) page += row.text;
  page += "</table>\n" + rules_table(reports);
  return page + fmt::format("<p>gapcheck {}</p>\n</body>\n</html>\n", xml_text(version));
}

}  // namespace gapcheck::report
