#include "keyword/rows.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "base/parallel.hpp"

namespace gapcheck::keyword {
namespace {

constexpr std::size_t piece_size = std::size_t{1} << 18;

/// A part of the block's body that starts at a line start.
struct Piece {
  std::size_t begin = 0, end = 0;
  std::uint32_t first_line = 0, lines = 0;
  std::size_t first_row = 0, rows = 0;
};

struct Column {
  std::size_t begin = 0, width = 0;
  std::int64_t offset = 0;
};

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

/// Calls visit(line, number) for every line of the piece that is neither comment nor blank; gives the number of lines.
template <class Visit>
std::uint32_t for_each_row(std::string_view body, const Piece& piece, const Visit& visit) {
  std::uint32_t number = piece.first_line;
  for (std::size_t at = piece.begin; at < piece.end; ++number) {
    const char* start = body.data() + at;
    const void* newline = std::memchr(start, '\n', body.size() - at);
    const std::size_t length =
        newline != nullptr ? static_cast<std::size_t>(static_cast<const char*>(newline) - start) : body.size() - at;
    at += length + 1;
    std::string_view line(start, length);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (!line.starts_with('$') && !is_blank(line)) visit(line, number);
  }
  return number - piece.first_line;
}

std::vector<Piece> cut(std::string_view body) {
  std::vector<Piece> pieces;
  for (std::size_t begin = 0; begin < body.size();) {
    const std::size_t newline = body.find('\n', std::min(begin + piece_size, body.size()) - 1);
    const std::size_t end = newline == std::string_view::npos ? body.size() : newline + 1;
    Piece piece;
    piece.begin = begin;
    piece.end = end;
    pieces.push_back(piece);
    begin = end;
  }
  return pieces;
}

/// A whole number in plain form with blanks around it; blank is zero. False: not of this form.
bool plain_integer(const char* at, const char* end, std::int64_t& value) {
  value = 0;
  while (at != end && *at == ' ') ++at;
  if (at == end) return true;
  const bool negative = *at == '-';
  if (negative) ++at;
  const char* const first = at;
  std::int64_t magnitude = 0;
  for (unsigned digit = 0; at != end && (digit = static_cast<unsigned>(*at) - '0') < 10 && at - first < 18; ++at)
    magnitude = magnitude * 10 + static_cast<std::int64_t>(digit);
  if (at == first) return false;
  while (at != end && *at == ' ') ++at;
  value = negative ? -magnitude : magnitude;
  return at == end;
}

/// A real number in C form with blanks around it; blank is zero. False: not of this form.
bool plain_real(const char* at, const char* end, double& value) {
  value = 0;
  while (at != end && *at == ' ') ++at;
  if (at == end) return true;
  const auto [behind, error] = std::from_chars(at, end, value);
  // The comparison is also false for inf and nan, which from_chars takes and decks do not mean.
  if (error != std::errc{} || !(std::abs(value) <= Card::max_real)) return false;
  for (at = behind; at != end; ++at)
    if (*at != ' ') return false;
  return true;
}

/// Parses the rows of one block into place.
class RowReader {
 public:
  RowReader(const Deck& deck, const Block& block, const CardLayout& layout)
      : deck_(deck), block_(block), layout_(layout) {
    const auto& offsets = deck.transform(block.transform).offset;
    std::size_t end = 0;
    for (std::size_t i = 0; i < layout.fields.size(); ++i) {
      const Field& field = layout.fields[i];
      const Cell cell = locate(layout, block.format, i);
      if (cell.column != end) gapless_ = false;
      end = cell.column + cell.width;
      const Column column{cell.column, cell.width, offsets[static_cast<std::size_t>(field.id)]};
      (field.type == FieldType::integer ? integer_columns_ : real_columns_).push_back(column);
      (field.type == FieldType::integer ? integer_fields_ : real_fields_).push_back(i);
    }
  }

  [[nodiscard]] std::size_t integer_columns() const { return integer_columns_.size(); }
  [[nodiscard]] std::size_t real_columns() const { return real_columns_.size(); }

  void read(std::string_view line, std::uint32_t number, std::int64_t* integers, double* reals,
            Diagnostics& diagnostics) const {
    if (!read_plain(line, integers, reals)) read_card(line, number, integers, reals, diagnostics);
  }

 private:
  /// The fast way for plain numbers in fixed columns; false for anything else, which Card decides.
  bool read_plain(std::string_view line, std::int64_t* integers, double* reals) const {
    if (line.size() > Card::max_line) return false;
    // In unused columns a comma makes the line free format, and a tab moves what follows.
    if (!gapless_ && line.find_first_of(",\t") != std::string_view::npos) return false;
    const char* const data = line.data();
    for (const Column& column : integer_columns_) {
      const std::size_t begin = std::min(column.begin, line.size());
      std::int64_t& value = *integers++;
      if (!plain_integer(data + begin, data + std::min(begin + column.width, line.size()), value)) return false;
      if (column.offset != 0 && value != 0) {
        constexpr auto safe = std::int64_t{1} << 61;
        if (column.offset > safe || column.offset < -safe) return false;
        value += value > 0 ? column.offset : -column.offset;
      }
    }
    for (const Column& column : real_columns_) {
      const std::size_t begin = std::min(column.begin, line.size());
      if (!plain_real(data + begin, data + std::min(begin + column.width, line.size()), *reals++)) return false;
    }
    return true;
  }

  void read_card(std::string_view line, std::uint32_t number, std::int64_t* integers, double* reals,
                 Diagnostics& diagnostics) const {
    const Card card(deck_, block_, layout_, line, number, diagnostics);
    for (const std::size_t field : integer_fields_) *integers++ = card.integer(field);
    for (const std::size_t field : real_fields_) *reals++ = card.real(field);
  }

  const Deck& deck_;
  const Block& block_;
  const CardLayout& layout_;
  std::vector<Column> integer_columns_, real_columns_;
  std::vector<std::size_t> integer_fields_, real_fields_;
  bool gapless_ = true;
};

/// Hands on what one piece reported. The list keeps only the first reports, so they must come in the order of the file.
void hand_on(const Diagnostics& from, Diagnostics& to) {
  const auto list = from.sorted();
  for (const Diagnostic& diagnostic : list) to.add(diagnostic);
  for (std::size_t i = 0; i < from.dropped(); ++i) to.add(list.back());
}

}  // namespace

Rows read_rows(const Deck& deck, const Block& block, const CardLayout& layout, Diagnostics& diagnostics) {
  std::vector<Piece> pieces = cut(block.body);
  parallel_for(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      pieces[i].lines = for_each_row(block.body, pieces[i], [&](std::string_view, std::uint32_t) { ++pieces[i].rows; });
  });
  const RowReader reader(deck, block, layout);
  Rows rows;
  rows.integer_columns = reader.integer_columns();
  rows.real_columns = reader.real_columns();
  std::uint32_t line = block.line + 1;
  for (Piece& piece : pieces) {
    piece.first_line = line;
    piece.first_row = rows.count;
    line += piece.lines;
    rows.count += piece.rows;
  }
  rows.integers.resize(rows.count * rows.integer_columns);
  rows.reals.resize(rows.count * rows.real_columns);
  rows.lines.resize(rows.count);
  std::vector<Diagnostics> reports(pieces.size());
  parallel_for(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::size_t row = pieces[i].first_row;
      for_each_row(block.body, pieces[i], [&](std::string_view text, std::uint32_t number) {
        rows.lines[row] = number;
        reader.read(text, number, rows.integers.data() + row * rows.integer_columns,
                    rows.reals.data() + row * rows.real_columns, reports[i]);
        ++row;
      });
    }
  });
  for (const Diagnostics& report : reports) hand_on(report, diagnostics);
  return rows;
}

}  // namespace gapcheck::keyword
