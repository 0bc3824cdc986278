#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/parallel.hpp"

namespace gapcheck {

/// std::vector::reserve() for large arrays: all threads together write to the new memory first. The system clears a
/// page when it is first written to, and that takes longer than what most loops do with it. An array that grows again
/// and again gets twice the room each time.
template <class T>
void reserve_in_parallel(std::vector<T>& array, std::size_t size) {
  constexpr std::size_t page = 4096, pages_at_once = 512, worth_it = std::size_t{4} << 20;
  if (size <= array.capacity()) return;
  array.reserve(std::max(size, array.empty() ? size : 2 * array.capacity()));
  if (size * sizeof(T) < worth_it) return;
  auto* const memory = reinterpret_cast<volatile unsigned char*>(array.data());
  const std::size_t begin = array.size() * sizeof(T), pages = (size * sizeof(T) - begin) / page;
  parallel_for(pages, pages_at_once, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) memory[begin + i * page] = 0;
  });
}

/// std::vector::resize() for large arrays, see there.
template <class T>
void resize_in_parallel(std::vector<T>& array, std::size_t size) {
  reserve_in_parallel(array, size);
  array.resize(size);
}

/// std::vector(size) for large arrays.
template <class T>
[[nodiscard]] std::vector<T> large_array(std::size_t size) {
  std::vector<T> array;
  resize_in_parallel(array, size);
  return array;
}

}  // namespace gapcheck
