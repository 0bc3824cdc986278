#include "keyword/rows.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <utility>

#include "base/parallel.hpp"
#include "keyword/text/fixed_field.hpp"

namespace gapcheck::keyword {
namespace {

/// Text and numbers of a piece stay in the cache of one core.
constexpr std::size_t body_piece_size = std::size_t{1} << 16;

/// A part of the block's body that starts at a line start.
struct BodyPiece {
  std::size_t begin = 0, end = 0;
  std::uint32_t first_line = 0, lines = 0;
  std::size_t first_row = 0, rows = 0;
};

bool is_blank(std::string_view line) {
  // Most lines end in a number: one check is enough.
  return line.empty() || (line.back() <= ' ' && line.find_first_not_of(" \t\r") == std::string_view::npos);
}

/// The line that starts at `at`, without its end; `next` becomes the start of the following one.
std::string_view line_from(std::string_view body, std::size_t at, std::size_t& next) {
  const char* start = body.data() + at;
  const void* newline = std::memchr(start, '\n', body.size() - at);
  std::size_t length =
      newline != nullptr ? static_cast<std::size_t>(static_cast<const char*>(newline) - start) : body.size() - at;
  next = at + length + 1;
  while (length > 0 && start[length - 1] == '\r') --length;
  return {start, length};
}

bool is_row(std::string_view line) { return !line.starts_with('$') && !is_blank(line); }

#ifdef __SSE2__

/// Counts lines and rows of whole lines at once from the characters before and after the line ends. False: some line
/// might be blank, which this method cannot detect.
bool count_fast(std::string_view text, std::uint32_t& lines, std::size_t& rows) {
  const __m128i newline = _mm_set1_epi8('\n'), blank = _mm_set1_epi8(' '), dollar = _mm_set1_epi8('$');
  const auto bits = [](__m128i match) { return static_cast<std::uint32_t>(_mm_movemask_epi8(match)); };
  if (text.empty() || text.back() != '\n') return false;
  std::uint32_t before_start = 1, before_solid = 0;  // the byte before the next ones
  std::size_t at = 0, ends = 0, comments = 0;
  while (at + 16 <= text.size()) {
    __m128i sums = _mm_setzero_si128();  // of 16 columns, each of which holds up to 255
    for (int i = 0; i < 255 && at + 16 <= text.size(); ++i, at += 16) {
      const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(text.data() + at));
      const __m128i is_end = _mm_cmpeq_epi8(bytes, newline);
      const std::uint32_t end = bits(is_end), solid = bits(_mm_cmpgt_epi8(bytes, blank));
      if ((end & ~(solid << 1 | before_solid)) != 0) return false;
      std::uint32_t comment = bits(_mm_cmpeq_epi8(bytes, dollar)) & (end << 1 | before_start);
      for (; comment != 0; comment &= comment - 1) ++comments;
      sums = _mm_sub_epi8(sums, is_end);
      before_start = end >> 15;
      before_solid = solid >> 15;
    }
    const __m128i halves = _mm_sad_epu8(sums, _mm_setzero_si128());
    ends += static_cast<std::size_t>(_mm_cvtsi128_si64(halves) + _mm_cvtsi128_si64(_mm_srli_si128(halves, 8)));
  }
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '\n' && before_solid == 0) return false;
    if (c == '$' && before_start != 0) ++comments;
    before_start = c == '\n' ? 1 : 0;
    before_solid = c > ' ' ? 1 : 0;
    ends += before_start;
  }
  lines = static_cast<std::uint32_t>(ends);
  rows = ends - comments;
  return true;
}

#else

bool count_fast(std::string_view, std::uint32_t&, std::size_t&) { return false; }

#endif

/// Counts the lines of a piece, and those that are neither comment nor blank.
void count(std::string_view body, BodyPiece& piece) {
  if (count_fast(body.substr(piece.begin, piece.end - piece.begin), piece.lines, piece.rows)) return;
  piece.lines = 0;
  piece.rows = 0;
  for (std::size_t at = piece.begin; at < piece.end; ++piece.lines)
    if (is_row(line_from(body, at, at))) ++piece.rows;
}

std::vector<BodyPiece> cut(std::string_view body) {
  std::vector<BodyPiece> pieces;
  for (std::size_t begin = 0; begin < body.size();) {
    const std::size_t newline = body.find('\n', std::min(begin + body_piece_size, body.size()) - 1);
    const std::size_t end = newline == std::string_view::npos ? body.size() : newline + 1;
    BodyPiece piece;
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
  // The comparison is also false for inf and nan, which from_chars accepts but decks do not use.
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
      const RowColumn column{cell.column, cell.width, offsets[static_cast<std::size_t>(field.id)]};
      (field.type == FieldType::integer ? integer_columns_ : real_columns_).push_back(column);
      (field.type == FieldType::integer ? integer_fields_ : real_fields_).push_back(i);
      (field.type == FieldType::integer ? integer_slots_ : real_slots_).push_back(cell.slot);
      slots_ = cell.slot + 1;
      numbers_ = numbers_ && field.type != FieldType::text;
      if (column.offset > max_safe_offset || column.offset < -max_safe_offset) safe_offsets_ = false;
    }
    end_ = end;
    aligned_ = gapless_ && safe_offsets_ && !integer_columns_.empty();
  }

  [[nodiscard]] const std::vector<RowColumn>& integer_columns() const { return integer_columns_; }
  [[nodiscard]] const std::vector<RowColumn>& real_columns() const { return real_columns_; }

  /// Reads the rows of one piece; `rows` has room for them and one more, since a line may turn out not to be one.
  /// False: the deck's parameters take part in the numbers.
  bool read(const BodyPiece& piece, Rows& rows, Diagnostics& diagnostics) const {
    bool alone = true;
    const std::string_view body = block_.body;
    std::int64_t* integers = rows.integers.data();
    double* reals = rows.reals.data();
    std::uint32_t* lines = rows.lines.data();
    std::uint32_t number = piece.first_line;
    const std::uint32_t* const room = lines + rows.lines.size();
    for (std::size_t at = piece.begin; at < piece.end; ++number) {
      if (lines == room) {  // rows were counted a moment ago
        diagnostics.error(deck_.file(block_.file).path, number,
                          "the file has changed while it was read; read it again");
        return false;
      }
      std::size_t next = 0;
      if (!read_aligned(at, next, integers, reals)) {
        const std::string_view line = line_from(body, at, next);
        if (!is_row(line)) {
          at = next;
          continue;
        }
        if (!read_plain(line, integers, reals) && !read_separated(line, integers, reals)) {
          alone = alone && line.find('&') == std::string_view::npos;
          read_card(line, number, integers, reals, diagnostics);
        }
      }
      at = next;
      *lines++ = number;
      integers += integer_columns_.size();
      reals += real_columns_.size();
    }
    return alone;
  }

 private:
  /// Offsets up to this size cannot overflow a plain number.
  static constexpr auto max_safe_offset = std::int64_t{1} << 61;
  static constexpr std::size_t most_slots = 32;
  static std::int64_t with_offset(const RowColumn& column, std::int64_t id) {
    return id == 0 ? 0 : id > 0 ? id + column.offset : id - column.offset;
  }

  /// The fastest way: all fields have full width, each a plain number; then the line cannot end before them. False if
  /// that does not hold, or if the body ends too close.
  bool read_aligned(std::size_t at, std::size_t& next, std::int64_t* integers, double* reals) const {
    const std::string_view body = block_.body;
    if (!aligned_ || at < reach || body.size() - at < end_ + reach) return false;
    const char* const line = body.data() + at;
    for (const RowColumn& column : integer_columns_) {
      if (!read_fixed_integer(line + column.begin, column.width, *integers)) return false;
      *integers = with_offset(column, *integers);
      ++integers;
    }
    // Zero or blank: perhaps the whole line is.
    if (integers[-static_cast<std::ptrdiff_t>(integer_columns_.size())] == 0) return false;
    for (const RowColumn& column : real_columns_) {
      if (!read_fixed_real(line + column.begin, column.width, *reals) || !(std::abs(*reals) <= Card::max_real))
        return false;
      ++reals;
    }
    if (line[end_] == '\n') {
      next = at + end_ + 1;
      return true;
    }
    line_from(body, at + end_, next);
    return next - at <= Card::max_line;
  }

  /// The fast way for plain numbers in fixed columns; false for anything else, which Card decides.
  bool read_plain(std::string_view line, std::int64_t* integers, double* reals) const {
    if (line.size() > Card::max_line || !safe_offsets_) return false;
    // In unused columns a comma makes the line free format, and a tab moves what follows.
    if (!gapless_ && line.find_first_of(",\t") != std::string_view::npos) return false;
    const char* const data = line.data();
    for (const RowColumn& column : integer_columns_) {
      const std::size_t begin = std::min(column.begin, line.size());
      std::int64_t& value = *integers++;
      if (!plain_integer(data + begin, data + std::min(begin + column.width, line.size()), value)) return false;
      value = with_offset(column, value);
    }
    for (const RowColumn& column : real_columns_) {
      const std::size_t begin = std::min(column.begin, line.size());
      if (!plain_real(data + begin, data + std::min(begin + column.width, line.size()), *reals++)) return false;
    }
    return true;
  }

  /// The fast way for plain numbers between commas; false for anything else, which Card decides.
  bool read_separated(std::string_view line, std::int64_t* integers, double* reals) const {
    if (line.size() > Card::max_line || !safe_offsets_ || !numbers_ || slots_ > most_slots) return false;
    const char* const data = line.data();
    std::array<const char*, most_slots + 1> begin;  // of the slots; each ends before the comma ahead of the next
    std::size_t found = 0;
    begin[found++] = data;
    for (const char* at = data; at != data + line.size() && found <= slots_; ++at) {
      if (*at == ',') begin[found++] = at + 1;
      // What is in brackets is one field, and a tab moves what follows.
      if (*at == '(' || *at == '[' || *at == '\t') return false;
    }
    // Behind all fields a comma separates nothing.
    if (found == 1 || static_cast<std::size_t>(begin[1] - data) > end_) return false;
    if (found <= slots_) begin[found] = data + line.size() + 1;
    const auto cell = [&](std::size_t slot, const auto& take) {
      return slot < found ? take(begin[slot], begin[slot + 1] - 1) : take(data, data);
    };
    for (std::size_t i = 0; i < integer_slots_.size(); ++i) {
      std::int64_t& value = integers[i];
      if (!cell(integer_slots_[i], [&](const char* at, const char* end) { return plain_integer(at, end, value); }))
        return false;
      value = with_offset(integer_columns_[i], value);
    }
    for (std::size_t i = 0; i < real_slots_.size(); ++i)
      if (!cell(real_slots_[i], [&](const char* at, const char* end) { return plain_real(at, end, reals[i]); }))
        return false;
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
  std::vector<RowColumn> integer_columns_, real_columns_;
  std::vector<std::size_t> integer_fields_, real_fields_;
  std::vector<std::size_t> integer_slots_, real_slots_;  ///< in free format, how many values are before each
  std::size_t slots_ = 0;                                ///< in free format
  bool numbers_ = true;                                  ///< no field is text
  std::size_t end_ = 0;                                  ///< column after the last field
  bool gapless_ = true, safe_offsets_ = true, aligned_ = false;
};

/// Where the tables of the block's file are kept for later decks; nullptr: nowhere.
KeptRows* kept_rows(const Deck& deck, const Block& block) {
  const SourceFile& file = deck.file(block.file);
  if (file.kept == nullptr || block.body.empty() || file.bytes.empty()) return nullptr;
  const std::less_equal<const char*> not_after;
  const bool of_file = not_after(file.bytes.data(), block.body.data()) &&
                       not_after(block.body.data() + block.body.size(), file.bytes.data() + file.bytes.size());
  return of_file ? &file.kept->rows : nullptr;
}

/// A table that was kept, handed over like a block that is read.
void hand_over(const RowTable& table, const MakeRoom& make_room, const TakeRows& take) {
  make_room(table.count);
  parallel_for(table.pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) take(table.pieces[i].first, *table.pieces[i].rows);
  });
}

/// The rows without the room behind them.
std::shared_ptr<const Rows> copy_of(const Rows& rows) {
  const auto first = [](const auto& all, std::size_t count) {
    return std::vector(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
  };
  Rows copy{rows.count, rows.integer_columns, rows.real_columns, {}, {}, {}};
  copy.integers = first(rows.integers, rows.count * rows.integer_columns);
  copy.reals = first(rows.reals, rows.count * rows.real_columns);
  copy.lines = first(rows.lines, rows.count);
  return std::make_shared<const Rows>(std::move(copy));
}

/// Counts lines and rows of all pieces, and numbers them.
std::vector<BodyPiece> counted_pieces(const Block& block) {
  std::vector<BodyPiece> pieces = cut(block.body);
  parallel_for(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) count(block.body, pieces[i]);
  });
  std::uint32_t line = block.line + 1;
  std::size_t rows = 0;
  for (BodyPiece& piece : pieces) {
    piece.first_line = line;
    piece.first_row = rows;
    line += piece.lines;
    rows += piece.rows;
  }
  return pieces;
}

}  // namespace

void read_rows_in_pieces(const Deck& deck, const Block& block, const CardLayout& layout, Diagnostics& diagnostics,
                         const MakeRoom& make_room, const TakeRows& take) {
  const RowReader reader(deck, block, layout);
  KeptRows* const kept = kept_rows(deck, block);
  KeptRows::Key key;
  if (kept != nullptr) {
    const auto position = static_cast<std::size_t>(block.body.data() - deck.file(block.file).bytes.data());
    key = {position, reader.integer_columns(), reader.real_columns()};
    if (const RowTable* table = kept->find(key)) return hand_over(*table, make_room, take);
  }
  const std::vector<BodyPiece> pieces = counted_pieces(block);
  const std::size_t count = pieces.empty() ? 0 : pieces.back().first_row + pieces.back().rows;
  make_room(count);
  std::vector<Diagnostics> reports(pieces.size());
  const bool keep = kept != nullptr && kept->keeps();
  RowTable table{count, std::vector<RowTable::Piece>(keep ? pieces.size() : 0)};
  std::atomic<bool> text_alone{true};
  parallel_for(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
    Rows rows;
    rows.integer_columns = reader.integer_columns().size();
    rows.real_columns = reader.real_columns().size();
    for (std::size_t i = begin; i < end; ++i) {
      rows.count = pieces[i].rows;
      const std::size_t room = std::max(rows.count + 1, rows.lines.size());
      rows.integers.resize(room * rows.integer_columns);
      rows.reals.resize(room * rows.real_columns);
      rows.lines.resize(room);
      if (!reader.read(pieces[i], rows, reports[i])) text_alone = false;
      if (rows.count > 0) take(pieces[i].first_row, rows);
      if (keep) table.pieces[i] = {pieces[i].first_row, copy_of(rows)};
    }
  });
  const auto silent = [](const Diagnostics& report) { return report.sorted().empty(); };
  if (keep && text_alone && std::all_of(reports.begin(), reports.end(), silent))
    kept->keep(std::move(key), std::move(table));
  // The list keeps only the first reports, so they must come in the order of the file.
  for (const Diagnostics& report : reports) diagnostics.take(report);
}

Rows read_rows(const Deck& deck, const Block& block, const CardLayout& layout, Diagnostics& diagnostics) {
  Rows rows;
  for (const Field& field : layout.fields)
    ++(field.type == FieldType::integer ? rows.integer_columns : rows.real_columns);
  const auto make_room = [&](std::size_t count) {
    rows.count = count;
    rows.integers.resize(count * rows.integer_columns);
    rows.reals.resize(count * rows.real_columns);
    rows.lines.resize(count);
  };
  const auto take = [&](std::size_t first, const Rows& piece) {
    const auto copy = [&](const auto& from, auto& to, std::size_t columns) {
      std::copy_n(from.data(), piece.count * columns, to.data() + first * columns);
    };
    copy(piece.integers, rows.integers, rows.integer_columns);
    copy(piece.reals, rows.reals, rows.real_columns);
    copy(piece.lines, rows.lines, 1);
  };
  read_rows_in_pieces(deck, block, layout, diagnostics, make_room, take);
  return rows;
}

}  // namespace gapcheck::keyword
