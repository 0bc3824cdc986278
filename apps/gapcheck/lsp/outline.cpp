#include "lsp/outline.hpp"

#include <algorithm>

#include "keyword/highest_ids.hpp"
#include "keyword/keyword_line.hpp"

namespace gapcheck::app::lsp {

std::vector<Keyword> outline(const Text& text) {
  std::vector<Keyword> keywords;
  keyword::Format format = keyword::Format::standard;
  for (std::size_t p = 0; p < text.pieces().size(); ++p) {
    const Piece& piece = *text.pieces()[p];
    for (const Piece::Mark& mark : piece.marks) {
      std::size_t next = 0;
      const keyword::KeywordLine read = keyword::read_keyword_line(next_line(piece.bytes, mark.offset, next), format);
      const std::uint32_t line = text.first_line(p) + mark.line;
      if (!keywords.empty()) keywords.back().end = line;
      keywords.push_back({read.name, read.format, line, text.lines()});
      if (read.name == "END") return keywords;
    }
  }
  return keywords;
}

const Keyword* keyword_at(std::span<const Keyword> outline, std::uint32_t line) {
  const auto after = std::upper_bound(outline.begin(), outline.end(), line,
                                      [](std::uint32_t at, const Keyword& keyword) { return at < keyword.line; });
  if (after == outline.begin()) return nullptr;
  const Keyword& keyword = *std::prev(after);
  return line < keyword.end ? &keyword : nullptr;
}

bool is_mesh(const Keyword& keyword) { return keyword::is_node_or_element(keyword.name); }

}  // namespace gapcheck::app::lsp
