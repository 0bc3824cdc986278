#pragma once
#include <algorithm>
#include <array>
#include <cstddef>

#include "base/triple.hpp"
#include "base/vector.hpp"

// Arrays by element, for batches of elements (quad_batch.cpp, brick_batch.cpp).
namespace gapcheck::solver {

/// Elements beyond the last one repeat it: what is calculated of them does not matter, but must not be slow.
template <std::size_t Capacity>
void pad(std::array<double, Capacity>& row, std::size_t size) {
  std::fill(row.begin() + static_cast<std::ptrdiff_t>(size), row.end(), row[size - 1]);
}
template <class Row, std::size_t N>
void pad(std::array<Row, N>& rows, std::size_t size) {
  for (Row& row : rows) pad(row, size);
}

template <std::size_t Capacity>
void put(std::array<std::array<double, Capacity>, 3>& rows, std::size_t i, const Vector& p) {
  store(rows, i, {p.x(), p.y(), p.z()});
}
template <std::size_t Capacity>
[[nodiscard]] Vector get(const std::array<std::array<double, Capacity>, 3>& rows, std::size_t i) {
  return {rows[0][i], rows[1][i], rows[2][i]};
}

}  // namespace gapcheck::solver
