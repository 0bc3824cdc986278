#pragma once
// Slow, obvious readers of rows and numbers, for tests and fuzzers.
#include <cctype>
#include <cstdlib>
#include <string>

#include "base/number.hpp"
#include "keyword/card.hpp"
#include "keyword/rows.hpp"

namespace gapcheck::keyword {

/// read_rows() with every row through Card.
inline Rows read_by_card(const Deck& deck, const Block& block, const CardLayout& layout, Diagnostics& diagnostics) {
  Rows rows;
  CardReader reader(deck, block, diagnostics);
  for (; !reader.at_end(); reader.skip()) {
    if (trimmed(reader.peek()).empty()) continue;
    const Card card = reader.peek(layout);
    ++rows.count;
    rows.lines.push_back(card.line());
    for (std::size_t i = 0; i < layout.fields.size(); ++i)
      if (layout.fields[i].type == FieldType::integer) rows.integers.push_back(card.integer(i));
    for (std::size_t i = 0; i < layout.fields.size(); ++i)
      if (layout.fields[i].type == FieldType::real) rows.reals.push_back(card.real(i));
  }
  return rows;
}

/// read_fixed_real() by the C library. Fortran's exponents are put into the form of C.
inline double by_strtod(std::string field) {
  for (std::size_t i = 1; i < field.size(); ++i) {
    if (field[i] == 'd' || field[i] == 'D') field[i] = 'e';
    if ((field[i] == '+' || field[i] == '-') && (field[i - 1] == '.' || std::isdigit(field[i - 1]) != 0))
      field.insert(i, "e");
  }
  return std::strtod(field.c_str(), nullptr);
}

}  // namespace gapcheck::keyword
