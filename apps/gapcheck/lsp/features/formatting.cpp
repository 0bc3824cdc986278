#include <algorithm>
#include <optional>
#include <string>

#include "base/number.hpp"
#include "lsp/features/features.hpp"

namespace gapcheck::app::lsp {
namespace {

constexpr std::uint32_t most_lines = 200'000;

/// The line with its fields in their columns: numbers at the right end, texts at the left. As it is where a field is
/// too wide for its columns, or something stands where the card has no field.
std::string in_columns(const keyword::Card& card, const keyword::CardLayout& layout) {
  const std::string_view line = card.raw_line();
  std::string result, kept;
  for (std::size_t i = 0; i < layout.fields.size(); ++i) {
    const std::string_view written = card.written(i);
    const keyword::Cell cell = card.cell(i);
    for (const char c : written)
      if (c != ' ') kept += c;
    if (written.size() > cell.width) return std::string(line);
    if (written.empty()) continue;
    const bool text = layout.fields[i].type == keyword::FieldType::text;
    if (!text && written.find(' ') != std::string_view::npos) return std::string(line);
    const std::size_t begin = text ? cell.column : cell.column + cell.width - written.size();
    if (result.size() > begin) return std::string(line);
    result.resize(begin, ' ');
    result += written;
  }
  std::string all;
  for (const char c : line)
    if (c != ' ' && c != '\t' && !(card.free_format() && c == ',')) all += c;
  return all == kept ? result : std::string(line);
}

}  // namespace

json format_lines(const Question& question, std::uint32_t first, std::uint32_t behind) {
  json edits = json::array();
  const Text& text = question.text();
  const FileView& file = question.file();
  behind = std::min({behind, text.lines(), first + std::min(most_lines, text.lines())});
  const Keyword* keyword = nullptr;
  std::optional<LineCards> cards;
  keyword::Block block;
  Diagnostics ignored;
  text.for_each_line(first, behind, [&](std::uint32_t number, std::string_view line) {
    const Keyword* own = keyword_at(*file.outline, number);
    if (own == nullptr) return true;
    if (own != keyword) {
      keyword = own;
      cards.emplace(text, *keyword).skip_to(number);
      block = file.scope.block(*keyword);
      if (number == keyword->line) return true;
    }
    if (line.starts_with('$') || number == keyword->line) return true;
    const keyword::CardLayout* layout = cards->next(line);
    if (layout == nullptr || trimmed(line).empty()) return true;
    const keyword::Card card(file.scope.deck(), block, *layout, line, number + 1, ignored);
    const std::string formatted = in_columns(card, *layout);
    if (formatted != line)
      edits.push_back({{"range", range_in(line, number, 0, line.size(), question.encoding)}, {"newText", formatted}});
    return true;
  });
  return edits;
}

}  // namespace gapcheck::app::lsp
