#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

#include "keyword/known_keywords.hpp"
#include "lsp/features/features.hpp"
#include "lsp/uri.hpp"
#include "model/contact/contact_cards.hpp"
#include "model/contact/contact_name.hpp"
#include "model/unknown_keyword.hpp"

namespace gapcheck::app::lsp {
namespace {

json edit_action(const Question& question, std::string title, const char* kind, json edit) {
  return {{"title", std::move(title)},
          {"kind", kind},
          {"edit", {{"changes", {{uri_of(question.file().path), json::array({std::move(edit)})}}}}}};
}

/// Puts whole lines in front of a line, or at the end of the text, with the line ends that the text has there.
json insertion(const Question& question, std::uint32_t line, std::string_view lines) {
  const Text& text = question.text();
  const std::string_view line_end = text.line_end(line > 0 ? line - 1 : 0);
  std::string added;
  for (const char c : lines) c == '\n' ? added += line_end : added += c;
  if (line < text.lines()) return {{"range", lines_range(line, line)}, {"newText", std::move(added)}};
  // The last line has no end: it gets one, and the last of the new ones has none.
  const std::uint32_t last = text.lines() - 1;
  const std::size_t size = text.line(last).size();
  added.resize(added.size() - line_end.size());
  return {{"range", range_in(text.line(last), last, size, size, question.encoding)},
          {"newText", std::string(line_end) + added}};
}

/// The conditions of an ignore comment that fit a finding and little else.
std::string conditions(const LineFinding& finding) {
  std::string text;
  if (finding.contact > 0) text += fmt::format(" contact={}", finding.contact);
  if (finding.part > 0) text += fmt::format(" part={}", finding.part);
  if (finding.node > 0)
    text += fmt::format(" node={}", finding.node);
  else if (finding.element > 0)
    text += fmt::format(" element={}", finding.element);
  return text;
}

/// A comment as docs/ignores.md defines it, in front of the finding's line.
json ignore_action(const Question& question, const LineFinding& finding) {
  const std::string comment = fmt::format("$ gapcheck: ignore {}{} because ", finding.code, conditions(finding));
  return edit_action(question, fmt::format("Ignore this {} with a comment", finding.code), "quickfix",
                     insertion(question, finding.line, comment + "\n"));
}

/// The nearest known name in place of an unknown one, with its option words and the sign of its format.
void add_correction(const Question& question, const Keyword& keyword, json& actions) {
  const bool contact = keyword.name.starts_with("CONTACT_");
  const bool known = contact ? model::parse_contact_name(keyword.name).known()
                             : keyword::standing_of(keyword.name) == keyword::Standing::known;
  if (known) return;
  const std::string nearest = model::nearest_keyword({keyword.name, {}, 1, false});
  if (nearest.empty()) return;
  const std::string_view line = question.text().line(keyword.line);
  const json range = range_in(line, keyword.line, 1, 1 + keyword.name.size(), question.encoding);
  json action = edit_action(question, fmt::format("Change to *{}", nearest), "quickfix",
                            {{"range", range}, {"newText", nearest}});
  action["isPreferred"] = true;
  actions.push_back(std::move(action));
}

/// The cards that a contact lacks, blank, so that the defaults are in sight.
void add_missing_cards(const Question& question, const Keyword& keyword, json& actions) {
  if (!keyword.name.starts_with("CONTACT_")) return;
  const CardOrder order = card_order(question.text(), keyword);
  std::size_t rows = 0, needed = 0;
  std::uint32_t last = keyword.line;
  question.text().for_each_line(keyword.line + 1, keyword.end, [&](std::uint32_t number, std::string_view line) {
    if (line.starts_with('$') || (line.empty() && number + 1 == question.text().lines())) return true;
    ++rows;
    last = number;
    return true;
  });
  for (std::size_t i = 0; i < order.head.size(); ++i)
    if (order.head[i] == nullptr || order.head[i]->name.size() > 1) needed = i + 1;
  if (rows >= needed) return;
  std::string text;
  for (std::size_t i = rows; i < needed; ++i) {
    const keyword::CardLayout* card = order.head[i];
    if (card == nullptr) return;
    text += "$#";
    for (const keyword::Field& field : card->fields) {
      const std::size_t end = static_cast<std::size_t>(field.column) + field.width;
      if (text.size() - text.rfind('$') + field.name.size() > end) continue;
      text.append(end - (text.size() - text.rfind('$')) - field.name.size(), ' ');
      text += field.name;
    }
    text += "\n\n";
  }
  actions.push_back(edit_action(question, fmt::format("Add the missing cards of *{}, blank", keyword.name), "quickfix",
                                insertion(question, last + 1, text)));
}

}  // namespace

json code_actions(const Question& question, const std::vector<LineFinding>& findings, std::uint32_t first,
                  std::uint32_t behind) {
  json actions = json::array();
  if (const Keyword* keyword = keyword_at(*question.file().outline, first)) {
    if (first == keyword->line) add_correction(question, *keyword, actions);
    add_missing_cards(question, *keyword, actions);
  }
  std::set<std::string> said;
  bool penetrates = false;
  for (const LineFinding& finding : findings) {
    if (finding.line < first || finding.line >= behind || finding.code.empty()) continue;
    penetrates = penetrates || finding.penetrates;
    if (said.insert(finding.code + conditions(finding)).second) actions.push_back(ignore_action(question, finding));
  }
  if (penetrates)
    actions.push_back({{"title", "Move nodes until nothing penetrates (gapcheck fix)"},
                       {"kind", "quickfix"},
                       {"command",
                        {{"title", "gapcheck fix"},
                         {"command", "gapcheck.fix"},
                         {"arguments", json::array({uri_of(question.file().path)})}}}});
  return actions;
}

}  // namespace gapcheck::app::lsp
