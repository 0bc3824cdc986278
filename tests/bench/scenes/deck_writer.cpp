#include "scenes/deck_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace gapcheck::bench {
namespace {

/// Right-aligned in `width` columns; digits that do not fit are a fault of the caller.
void append_integer(std::string& text, std::uint64_t value, std::size_t width) {
  std::array<char, 24> digits;
  digits.fill(' ');
  std::size_t at = digits.size();
  do digits[--at] = static_cast<char>('0' + value % 10);
  while ((value /= 10) > 0);
  text.append(digits.data() + digits.size() - width, width);
}

void append_coordinate(std::string& text, double value) {
  // Integers of micro-units are quick to write, and coordinates of decks are such decimals anyway.
  const double size = std::abs(value);
  if (!(size < 1e8)) {
    fmt::format_to(std::back_inserter(text), "{:16.8E}", value);
    return;
  }
  auto micro = static_cast<std::uint64_t>(std::llround(size * 1e6));
  const bool negative = value < 0 && micro > 0;
  std::array<char, 16> field;
  field.fill(' ');
  std::size_t at = field.size();
  for (int decimal = 0; decimal < 6; ++decimal, micro /= 10) field[--at] = static_cast<char>('0' + micro % 10);
  field[--at] = '.';
  do field[--at] = static_cast<char>('0' + micro % 10);
  while ((micro /= 10) > 0);
  if (negative) field[--at] = '-';
  text.append(field.data(), field.size());
}

}  // namespace

void DeckWriter::text(std::string_view cards) {
  block_ = Block::none;
  text_ += cards;
  row_done();
}

int DeckWriter::part(int section) {
  ++parts_;
  text(fmt::format("*PART\npart {}\n{:10}{:10}{:10}\n", parts_, parts_, section, 1));
  return parts_;
}

int DeckWriter::node(const Vector& at) {
  open(Block::nodes, "*NODE\n");
  append_integer(text_, static_cast<std::uint64_t>(++nodes_), 8);
  for (int i = 0; i < 3; ++i) append_coordinate(text_, at[i]);
  row_done();
  return nodes_;
}

void DeckWriter::shell(int part, const std::array<int, 4>& nodes) {
  open(Block::shells, "*ELEMENT_SHELL\n");
  append_integer(text_, static_cast<std::uint64_t>(++shells_), 8);
  append_integer(text_, static_cast<std::uint64_t>(part), 8);
  for (const int node : nodes) append_integer(text_, static_cast<std::uint64_t>(node), 8);
  row_done();
}

void DeckWriter::brick(int part, const std::array<int, 8>& nodes) {
  open(Block::bricks, "*ELEMENT_SOLID\n");
  append_integer(text_, static_cast<std::uint64_t>(++bricks_), 8);
  append_integer(text_, static_cast<std::uint64_t>(part), 8);
  for (const int node : nodes) append_integer(text_, static_cast<std::uint64_t>(node), 8);
  row_done();
}

void DeckWriter::flush() {
  if (!text_.empty()) sink_(text_);
  text_.clear();
}

void DeckWriter::open(Block block, std::string_view keyword) {
  if (block_ == block) return;
  block_ = block;
  text_ += keyword;
}

void DeckWriter::row_done() {
  if (block_ != Block::none) text_ += '\n';
  if (text_.size() >= piece) flush();
}

}  // namespace gapcheck::bench
