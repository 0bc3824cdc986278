#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "keyword/deck.hpp"
#include "keyword/layout.hpp"

namespace gapcheck::keyword {

/// Where a field of a layout is in a line: the number of values before it in free format, and its columns.
struct Cell {
  std::size_t slot = 0, column = 0, width = 0;
};

/// Position of one field of a layout. In the i10 format 8-wide fields are 10 wide, in the long format every field is
/// at least 20 wide; columns that the layout leaves unused count as values of their own.
[[nodiscard]] Cell locate(const CardLayout& layout, Format format, std::size_t field);

/// An error about a parameter without a value; all lines that need it become one. `where`: "*NODE, field x".
void report_missing_parameter(std::string_view name, const std::string& file, std::uint32_t line,
                              const std::string& where, Diagnostics& diagnostics);

/// One line split into fields. Resolves free format, field widths, parameters and id offsets. A field that should be a
/// number but is not is reported once, with file, line and field name, and reads as its default.
///
/// A comma makes a line free format, unless it is in parentheses, after the last field, inside a last field that is
/// text, or the card is a single text (titles, file names). Texts are views into the deck.
class Card {
 public:
  /// Longer lines are reported and cut off.
  static constexpr std::size_t max_line = 10000;
  /// Numbers beyond this size are reported.
  static constexpr double max_real = 1e30;

  /// No card: every field is blank.
  Card() = default;
  /// Cuts one line of the block.
  Card(const Deck& deck, const Block& block, const CardLayout& layout, std::string_view raw, std::uint32_t line,
       Diagnostics& diagnostics);
  /// False when the block ended before this line; then all fields are blank.
  [[nodiscard]] bool present() const { return present_; }
  [[nodiscard]] std::uint32_t line() const { return line_; }
  [[nodiscard]] std::size_t size() const { return layout_->fields.size(); }
  [[nodiscard]] bool blank(std::size_t field) const;
  /// Integer with the include's id offset added where the layout says so (zero and blank stay as they are).
  [[nodiscard]] std::int64_t integer(std::size_t field, std::int64_t default_value = 0) const;
  [[nodiscard]] double real(std::size_t field, double default_value = 0) const;
  /// Trimmed text of the field.
  [[nodiscard]] std::string_view text(std::size_t field) const;
  /// Trimmed characters of the field as written in the line: a parameter's name, not its value.
  [[nodiscard]] std::string_view written(std::size_t field) const { return raw_text(field); }
  /// The whole line, without its line end.
  [[nodiscard]] std::string_view raw_line() const { return raw_; }
  [[nodiscard]] bool free_format() const { return free_format_; }
  /// Where the field is in a line of this card's format.
  [[nodiscard]] Cell cell(std::size_t field) const { return locate(*layout_, block_->format, field); }
  // The same by field name; a name that the layout lacks reads as blank.
  [[nodiscard]] bool blank(std::string_view field) const { return blank(layout_->index(field)); }
  [[nodiscard]] std::int64_t integer(std::string_view field, std::int64_t default_value = 0) const {
    return integer(layout_->index(field), default_value);
  }
  [[nodiscard]] double real(std::string_view field, double default_value = 0) const {
    return real(layout_->index(field), default_value);
  }
  [[nodiscard]] std::string_view text(std::string_view field) const { return text(layout_->index(field)); }

 private:
  friend class CardReader;
  [[nodiscard]] std::string_view raw_text(std::size_t field) const;
  [[nodiscard]] std::string_view fixed_text(const Cell& cell) const;
  [[nodiscard]] std::string_view free_text(std::size_t field) const;
  [[nodiscard]] bool is_free_format() const;
  [[nodiscard]] std::optional<ParameterValue> substituted(std::size_t field, std::string_view raw) const;
  [[nodiscard]] std::optional<ParameterValue> evaluated(std::size_t field, std::string_view expression) const;
  void report_missing(std::size_t field, std::string_view name) const;
  void warn_if_cut(std::size_t field, std::string_view raw) const;
  void report(std::size_t field, const std::string& problem) const;
  void report_not_a_number(std::size_t field, std::string_view raw, const std::string& problem) const;
  bool present_ = false;
  std::uint32_t line_ = 0;
  static inline const CardLayout no_layout{};
  const CardLayout* layout_ = &no_layout;
  const Deck* deck_ = nullptr;
  const Block* block_ = nullptr;
  Diagnostics* diagnostics_ = nullptr;
  std::string_view raw_;
  bool free_format_ = false;
  mutable std::uint64_t reported_ = 0;  ///< one bit per field
};

/// Iterates over the data lines of one block; comment lines are skipped.
class CardReader {
 public:
  /// Deck, block and diagnostics must outlive the reader and its cards.
  CardReader(const Deck& deck, const Block& block, Diagnostics& diagnostics);
  [[nodiscard]] bool at_end() const;
  /// The next data line without its line end; empty at the end.
  [[nodiscard]] std::string_view peek() const;
  [[nodiscard]] std::uint32_t peek_line() const;
  /// Of the data line that was passed last; that of the keyword before the first.
  [[nodiscard]] std::uint32_t last_line() const { return last_line_; }
  /// The next data line, split by the layout.
  Card next(const CardLayout& layout);
  /// The next data line, split by the layout but not consumed.
  [[nodiscard]] Card peek(const CardLayout& layout) const;
  void skip();
  [[nodiscard]] const Block& block() const { return *block_; }
  /// File name for messages.
  [[nodiscard]] const std::string& file() const;
  [[nodiscard]] Diagnostics& diagnostics() const { return *diagnostics_; }

 private:
  void advance();
  const Deck* deck_;
  const Block* block_;
  Diagnostics* diagnostics_;
  std::string_view rest_, current_;
  std::uint32_t line_ = 0, next_line_ = 0, last_line_ = 0;
  bool end_ = false;
};

}  // namespace gapcheck::keyword
