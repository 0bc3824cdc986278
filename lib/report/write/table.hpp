#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gapcheck::report {

enum class Align : unsigned char { left, right };

struct Column {
  std::string_view title;
  Align align = Align::right;
};

template <std::size_t N>
using Row = std::array<std::string, N>;

/// An id as shown in tables; 0 is none.
inline std::string id_or_dash(std::int64_t id) { return id == 0 ? "-" : fmt::format("{}", id); }

/// Appends one line of cells, two blanks between them, nothing after the last.
template <std::size_t N, class Cells>
void append_line(const std::array<Column, N>& columns, const std::array<std::size_t, N>& widths, const Cells& cells,
                 std::string_view indent, std::string& out) {
  out += indent;
  for (std::size_t i = 0; i < N; ++i) {
    const std::string_view cell = cells(i);
    const std::size_t padding = widths[i] - std::min(widths[i], cell.size());
    if (i > 0) out += "  ";
    if (columns[i].align == Align::right) out.append(padding, ' ');
    out += cell;
    if (columns[i].align == Align::left) out.append(padding, ' ');
  }
  out.erase(out.find_last_not_of(' ') + 1);
  out += '\n';
}

/// Appends a table with a title line and `count` rows; fill(i, row) writes the ASCII cells of row i and is called twice
/// for each row, so a million rows need no memory besides the output.
template <std::size_t N, class Fill>
void append_table(const std::array<Column, N>& columns, std::size_t count, const Fill& fill, std::string_view indent,
                  std::string& out) {
  std::array<std::size_t, N> widths{};
  for (std::size_t i = 0; i < N; ++i) widths[i] = columns[i].title.size();
  Row<N> row;
  for (std::size_t i = 0; i < count; ++i) {
    fill(i, row);
    for (std::size_t k = 0; k < N; ++k) widths[k] = std::max(widths[k], row[k].size());
  }
  append_line(
      columns, widths, [&](std::size_t k) { return columns[k].title; }, indent, out);
  for (std::size_t i = 0; i < count; ++i) {
    fill(i, row);
    append_line(
        columns, widths, [&](std::size_t k) { return std::string_view(row[k]); }, indent, out);
  }
}

}  // namespace gapcheck::report
