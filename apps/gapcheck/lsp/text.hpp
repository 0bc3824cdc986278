#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gapcheck::app::lsp {

/// A place in a text: line and byte in it, both from 0.
struct Place {
  std::uint32_t line = 0, byte = 0;
  friend auto operator<=>(const Place&, const Place&) = default;
};

/// Some lines of a text, the last with its line end unless it is the last of the text.
struct Piece {
  /// A line that starts with `*`.
  struct Mark {
    std::uint32_t line = 0;  ///< in the piece
    std::size_t offset = 0;
  };
  explicit Piece(std::string text);
  std::string bytes;
  std::uint32_t newlines = 0;
  std::vector<Mark> marks;
  static constexpr std::uint32_t step = 64;
  std::vector<std::size_t> starts;  ///< of every 64th line
  std::uint32_t rows = 0;           ///< data lines behind the last mark, or all: lines that are no comments
};

/// The text of a document in pieces that never change. An edit makes a new text that shares all other pieces, so it
/// takes the same short time in a file of any size, and other threads can go on with the old one.
class Text {
 public:
  Text() = default;
  explicit Text(std::string_view bytes);
  /// Line ends and one more: there is a line behind the last line end.
  [[nodiscard]] std::uint32_t lines() const { return newlines_ + 1; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Without its line end; empty where there is no such line. Valid as long as a text with this piece.
  [[nodiscard]] std::string_view line(std::uint32_t number) const;
  /// How a line ends, "\n" or "\r\n"; where it has no end, as the line before it.
  [[nodiscard]] std::string_view line_end(std::uint32_t number) const;
  /// The text with [begin, end) replaced; places behind the end of their line or of the text mean these ends.
  [[nodiscard]] Text edited(Place begin, Place end, std::string_view replacement) const;
  [[nodiscard]] std::string bytes() const;

  [[nodiscard]] const std::vector<std::shared_ptr<const Piece>>& pieces() const { return pieces_; }
  /// The line that a piece starts with.
  [[nodiscard]] std::uint32_t first_line(std::size_t piece) const { return first_lines_[piece]; }
  /// Calls visit(line number, line) for the lines [first, last) until it returns false.
  template <class Visit>
  void for_each_line(std::uint32_t first, std::uint32_t last, const Visit& visit) const;
  /// Where a line starts: a piece and an offset in it.
  struct Spot {
    std::size_t piece = 0, offset = 0;
  };
  [[nodiscard]] Spot start_of(std::uint32_t line) const;
  /// Calls visit(line) for the lines from there on until it returns false.
  template <class Visit>
  void for_each_line(Spot from, const Visit& visit) const;

 private:
  explicit Text(std::vector<std::shared_ptr<const Piece>> pieces);
  [[nodiscard]] Spot spot(Place place) const;
  std::vector<std::shared_ptr<const Piece>> pieces_;
  std::vector<std::uint32_t> first_lines_;  ///< by piece
  std::uint32_t newlines_ = 0;
  std::size_t size_ = 0;
};

/// The line of `bytes` at `offset` without its line end; `next` is where the following one starts.
[[nodiscard]] std::string_view next_line(std::string_view bytes, std::size_t offset, std::size_t& next);

template <class Visit>
void Text::for_each_line(std::uint32_t first, std::uint32_t last, const Visit& visit) const {
  if (first >= last || first > newlines_) return;
  for_each_line(start_of(first), [&](std::string_view line) { return visit(first, line) && ++first < last; });
}

template <class Visit>
void Text::for_each_line(Spot at, const Visit& visit) const {
  for (; at.piece < pieces_.size(); ++at.piece, at.offset = 0) {
    const std::string_view bytes = pieces_[at.piece]->bytes;
    while (at.offset < bytes.size())
      if (!visit(next_line(bytes, at.offset, at.offset))) return;
  }
}

}  // namespace gapcheck::app::lsp
