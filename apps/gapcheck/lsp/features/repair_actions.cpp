#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lsp/features/features.hpp"
#include "lsp/repair_job.hpp"
#include "report/item/describe.hpp"

namespace gapcheck::app::lsp {
namespace {

/// How much of a card is shown.
constexpr std::size_t card_shown = 100;

/// A line with single blanks between what is written in it.
std::string condensed(std::string_view line) {
  std::string text;
  for (const char c : line) {
    const bool blank = c == ' ' || c == '\t' || c == '\r';
    if (!blank)
      text += c;
    else if (!text.empty() && text.back() != ' ')
      text += ' ';
  }
  if (text.ends_with(' ')) text.pop_back();
  return text;
}

/// The lines that a repair puts in, without comments: "*CONTACT_EXCLUDE_INTERACTION | 1 1 | 1 2 3 3".
std::string card_of(const Repair& repair) {
  std::string card;
  for (const RepairLine& line : repair.lines)
    for (std::size_t at = 0, end = 0; at <= line.after.size(); at = end + 1) {
      end = std::min(line.after.find('\n', at), line.after.size());
      const std::string text = condensed(std::string_view(line.after).substr(at, end - at));
      if (text.empty() || text.starts_with('$') || text == condensed(line.before)) continue;
      card += (card.empty() ? "" : " | ") + text;
    }
  return report::shortened(card, card_shown);
}

/// The edits of a repair by URI; null if one of its files is not as it was.
json changes_of(const Repair& repair, const DeckRepairs& repairs, Encoding encoding, const ChangeableFile& changeable) {
  std::map<std::string, std::vector<FixedLine>> lines;  // by path as read
  for (const RepairLine& line : repair.lines) lines[line.file].push_back({line.line - 1, line.before, line.after});
  json changes = json::object();
  for (const auto& [path, edits] : lines) {
    const auto file = repairs.files.find(path);
    const LinesAt at = file == repairs.files.end() ? LinesAt() : changeable(file->second, edits);
    if (at.uri.empty()) return nullptr;
    changes[at.uri] = line_edits(edits, encoding, at.open);
  }
  return changes;
}

}  // namespace

json repair_actions(const Question& question, const std::vector<LineFinding>& findings, std::uint32_t first,
                    std::uint32_t behind, const DeckRepairs& repairs, const ChangeableFile& changeable) {
  json actions = json::array();
  std::set<const Repair*> offered;
  for (const LineFinding& finding : findings) {
    if (finding.line < first || finding.line >= behind || !finding.repair) continue;
    for (const Repair* repair : audit::repairs_for(repairs.plan, *finding.repair)) {
      if (!offered.insert(repair).second) continue;
      json changes = changes_of(*repair, repairs, question.encoding, changeable);
      if (changes.is_null()) continue;
      actions.push_back({{"title", fmt::format("{}: {}", repair->text, card_of(*repair))},
                         {"kind", "quickfix"},
                         {"edit", {{"changes", std::move(changes)}}}});
    }
  }
  return actions;
}

}  // namespace gapcheck::app::lsp
