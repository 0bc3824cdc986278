#include "keyword/scan.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "keyword/text/line_ends.hpp"

namespace gapcheck::keyword {
namespace {

constexpr std::size_t file_piece_size = std::size_t{1} << 21;

struct FilePiece {
  std::vector<Mark> marks;  // lines counted from the start of the piece
  std::uint32_t lines = 0;
};

/// Most comments need no closer check: blanks, then no letter that could begin the name.
bool may_be_directive(std::string_view bytes, std::size_t dollar) {
  std::size_t at = dollar + 1;
  while (at < bytes.size() && (bytes[at] == ' ' || bytes[at] == '\t')) ++at;
  return at < bytes.size() && (bytes[at] == 'g' || bytes[at] == 'G');
}

std::optional<Mark::Kind> kind_of(std::string_view from_line_start) {
  if (from_line_start.front() == '*') return Mark::Kind::keyword;
  if (from_line_start.front() == '$')
    return directive_text(from_line_start) ? std::optional(Mark::Kind::directive) : std::nullopt;
  if (from_line_start.starts_with("-----BEGIN PGP MESSAGE-----")) return Mark::Kind::encrypted_begin;
  if (from_line_start.starts_with("-----END PGP MESSAGE-----")) return Mark::Kind::encrypted_end;
  return std::nullopt;
}

/// The first line start at or after `offset`.
std::size_t line_start(std::string_view bytes, std::size_t offset) {
  if (offset == 0) return 0;
  const auto end = bytes.find('\n', offset - 1);
  return end == std::string_view::npos ? bytes.size() : end + 1;
}

FilePiece scan_piece(std::string_view bytes, std::size_t begin, std::size_t end) {
  FilePiece piece;
  std::size_t offset = begin;
  const bool templates = bytes.substr(begin, end - begin).find("<<") != std::string_view::npos;
  while (offset < end) {
    const char first = bytes[offset];
    const std::size_t newline = std::min(bytes.find('\n', offset), bytes.size());
    if (first == '*' || first == '-' || (first == '$' && may_be_directive(bytes, offset)))
      if (const auto kind = kind_of(bytes.substr(offset))) piece.marks.push_back({*kind, piece.lines, offset});
    if ((first == '*' || first == '$') && foreign_break(bytes.substr(offset, newline - offset)) != bytes.npos)
      piece.marks.push_back({Mark::Kind::foreign_break, piece.lines, offset});
    if (templates && first != '*' && first != '$' &&
        bytes.substr(offset, newline - offset).find("<<") != std::string_view::npos)
      piece.marks.push_back({Mark::Kind::template_field, piece.lines, offset});
    ++piece.lines;
    offset = newline + 1;
  }
  return piece;
}

}  // namespace

std::vector<Mark> find_marks(std::string_view bytes) {
  const std::size_t count = (bytes.size() + file_piece_size - 1) / file_piece_size;
  std::vector<FilePiece> pieces(count);
  parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      pieces[i] = scan_piece(bytes, line_start(bytes, i * file_piece_size),
                             i + 1 == count ? bytes.size() : line_start(bytes, (i + 1) * file_piece_size));
  });
  std::vector<Mark> marks;
  std::uint32_t line = 1;
  for (FilePiece& piece : pieces) {
    for (Mark mark : piece.marks) {
      mark.line += line;
      marks.push_back(mark);
    }
    line += piece.lines;
    piece = {};
  }
  return marks;
}

std::optional<std::string_view> directive_text(std::string_view line) {
  constexpr std::string_view name = "gapcheck:";
  if (!line.starts_with('$')) return std::nullopt;
  const auto start = line.find_first_not_of(" \t", 1);
  if (start == std::string_view::npos) return std::nullopt;
  line.remove_prefix(start);
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  const bool named = line.size() >= name.size() &&
                     std::equal(name.begin(), name.end(), line.begin(), [&](char a, char b) { return a == lower(b); });
  return named ? std::optional(line.substr(name.size())) : std::nullopt;
}

std::string_view line_at(std::string_view bytes, std::size_t offset, std::size_t& next) {
  const auto end = std::min(bytes.find('\n', offset), bytes.size());
  next = std::min(end + 1, bytes.size());
  return without_returns(bytes.substr(offset, end - offset));
}

}  // namespace gapcheck::keyword
