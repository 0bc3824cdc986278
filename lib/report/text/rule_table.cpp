#include "report/text/rule_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/baseline/rule_counts.hpp"
#include "report/item/describe.hpp"

namespace gapcheck::report {
namespace {

constexpr std::size_t unread_shown = 20;

/// Text of a deck between backticks, where nothing has a meaning in Markdown.
std::string in_backticks(const std::string& text) {
  std::string plain = printable(text);
  std::ranges::replace(plain, '`', '\'');
  std::ranges::replace(plain, '\n', ' ');
  return "`" + plain + "`";
}

void append_row(const RuleCount& rule, bool with_baseline, std::string& out) {
  out += fmt::format("| {} {} | {} | {} | {} |", rule.id, rule.rule, name(rule.severity), rule.decks, rule.findings);
  const BaselineCounts& counts = rule.baseline;
  if (with_baseline)
    out += fmt::format(" {} | {} | {} | {} |", counts.fresh, counts.worse, counts.unchanged, counts.gone);
  out += '\n';
}

}  // namespace

std::string rule_table(const Reports& reports) {
  std::string out = text_of_all(reports, {});
  const bool with_baseline = baseline_counts(reports).has_value();
  if (const auto rules = rule_counts(reports.all); !rules.empty()) {
    out += "\n| rule | severity | decks | findings |";
    out += with_baseline ? " new | worse | unchanged | gone |\n" : "\n";
    out += "|---|---|---:|---:|";
    out += with_baseline ? "---:|---:|---:|---:|\n" : "\n";
    for (const RuleCount& rule : rules) append_row(rule, with_baseline, out);
  }
  const std::size_t unread = reports.unread.size(), shown = std::min(unread, unread_shown);
  if (unread > 0) out += "\nNot audited:\n\n";
  for (const Unread& deck : reports.unread.first(shown)) {
    const bool named = deck.reason.find(deck.deck) != std::string::npos;
    out += fmt::format("- {}\n", in_backticks(named ? deck.reason : deck.deck + ": " + deck.reason));
  }
  if (unread > shown) out += fmt::format("- {} more\n", unread - shown);
  return out;
}

}  // namespace gapcheck::report
